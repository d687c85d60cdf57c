#include "demos/scenes/cembox_bay.h"

#include <boost/test/unit_test.hpp>

#include "demos/scenes/solids.h"

BOOST_AUTO_TEST_SUITE(cembox_bay_test)

using namespace clearway;
using namespace clearway::scenes;

PartState at(const Vector3& position, double turn = 0) {
    PartState state;
    state.position = position;
    state.rotation = Eigen::AngleAxisd(turn, Vector3::UnitZ());
    return state;
}

/// A block of side 2 about the point.
Piece block(const Vector3& centre) {
    return roundedBox(centre - Vector3::Ones(), centre + Vector3::Ones(), 0.5, 0.1, 2);
}

/// The room of a bar of 100 x 10 x 10 that moves up by 200.
KeptFree lifted(double margin) {
    KeptFree room({Box(Vector3(-50, -5, -5), Vector3(50, 5, 5))});
    room.addMotion(at({0, 0, 0}), at({0, 0, 200}), margin);
    return room;
}

BOOST_AUTO_TEST_CASE(what_stands_in_the_way_is_told_from_what_stands_beside_it) {
    const KeptFree room = lifted(4);
    BOOST_TEST(!room.isClearOf(block({0, 0, 100})));
    BOOST_TEST(!room.isClearOf(block({40, 7, 60})));
    BOOST_TEST(!room.isClearOf(block({0, 0, 208})));
    BOOST_TEST(room.isClearOf(block({0, 30, 100})));
    BOOST_TEST(room.isClearOf(block({70, 0, 100})));
    BOOST_TEST(room.isClearOf(block({0, 0, 230})));
}

/// The margin is kept everywhere; 2 mm beyond it are always enough.
BOOST_AUTO_TEST_CASE(the_margin_is_kept_and_hardly_exceeded) {
    for (const double margin : {0.0, 2.0, 10.0}) {
        const KeptFree room = lifted(margin);
        for (double z = -3; z < 203; z += 0.7) {
            BOOST_TEST(!room.isClearOf(block({10, 5 + 1 + margin - 0.01, z})));
            BOOST_TEST(room.isClearOf(block({10, 5 + 1 + margin + 2, z})));
        }
    }
}

BOOST_AUTO_TEST_CASE(a_turning_part_needs_its_circle) {
    KeptFree room({Box(Vector3(-50, -5, -5), Vector3(50, 5, 5))});
    room.addMotion(at({0, 0, 0}, 0), at({0, 0, 0}, M_PI_2), 1);
    BOOST_TEST(!room.isClearOf(block({30, 30, 0})));
    BOOST_TEST(!room.isClearOf(block({0, 48, 0})));
    BOOST_TEST(room.isClearOf(block({30, -30, 0})));
    BOOST_TEST(room.isClearOf(block({40, 40, 0})));
}

BOOST_AUTO_TEST_CASE(a_large_triangle_through_the_room_is_found) {
    Piece sheet = roundedBox({-500, -500, 0}, {500, 500, 1}, 2, 0.2, 2);
    BOOST_TEST(!lifted(1).isClearOf(sheet));
    for (Vector3& vertex : sheet.vertices) vertex.z() -= 20;
    BOOST_TEST(lifted(1).isClearOf(sheet));
}

BOOST_AUTO_TEST_SUITE_END()
