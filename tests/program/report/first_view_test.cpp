#include "program/report/first_view.h"

#include <boost/test/unit_test.hpp>

#include "clearway/mesh.h"

namespace clearway::testing {
BOOST_AUTO_TEST_SUITE(first_view_test)

using namespace report;
using Eigen::Vector3f;

/// Rays past a plate from one corner to the other.
struct Plates {
    render::RayScene rays;

    explicit Plates(const std::vector<Box>& plates) {
        for (const Box& plate : plates)
            rays.addBody(rays.addShape(render::surfaceOf(boxMesh(plate), Vector3::Zero(), 1)), {});
        rays.finish();
    }
};

ViewRequest requestAlong(const Vector3f& along) {
    return {{Vector3f(-1, 0, 0), Vector3f(0, 0, 0), Vector3f(1, 0, 0)}, Vector3f::Zero(), 20, along};
}

const Box kFarAway(Vector3(500, 500, 500), Vector3(501, 501, 501));

BOOST_AUTO_TEST_CASE(where_nothing_is_hidden_the_usual_direction_is_chosen) {
    const Plates none({kFarAway});
    const ChosenView view = chooseView(none.rays, requestAlong(Vector3f::Zero()));
    BOOST_TEST(view.visible == 1);
    BOOST_TEST(view.direction.norm() == 1, boost::test_tools::tolerance(1e-5f));
    BOOST_TEST(view.direction.y() < -0.5f);
    BOOST_TEST(view.direction.z() > 0.3f);
}

BOOST_AUTO_TEST_CASE(the_view_is_on_the_side_of_a_wall_on_which_the_part_is) {
    const Plates wall({Box(Vector3(-100, -2, -100), Vector3(100, -1, 100))});
    const ChosenView view = chooseView(wall.rays, requestAlong(Vector3f::UnitX()));
    BOOST_TEST(view.visible == 1);
    BOOST_TEST(view.direction.y() > 0);
}

BOOST_AUTO_TEST_CASE(in_a_closed_box_little_is_visible) {
    const Plates closed({Box(Vector3(-3, -3, -3), Vector3(3, 3, 3))});
    BOOST_TEST(chooseView(closed.rays, requestAlong(Vector3f::UnitX())).visible == 0);
    BOOST_TEST(visibleShare(closed.rays, requestAlong(Vector3f::UnitX()), Vector3f::UnitZ()) == 0);
}

BOOST_AUTO_TEST_CASE(a_way_is_seen_from_its_side) {
    const Plates none({kFarAway});
    for (const Vector3f& along : {Vector3f(7, 0, 0), Vector3f(0, 7, 0), Vector3f(1, -1.7f, 1)})
        BOOST_TEST(std::abs(chooseView(none.rays, requestAlong(along)).direction.dot(along.normalized())) <
                   0.6f);
}

BOOST_AUTO_TEST_CASE(a_gap_is_looked_at_exactly_along_itself) {
    const double half = 0.001;
    const Plates gap(
        {Box(Vector3(-9, -9, half), Vector3(9, 9, 5)), Box(Vector3(-9, -9, -5), Vector3(9, 9, -half))});
    const ViewRequest seen{{Vector3f::Zero()}, Vector3f::Zero(), 40, Vector3f(0, 0, 0.002f), true};
    const ChosenView view = chooseView(gap.rays, seen);
    BOOST_TEST(view.visible == 1);
    BOOST_TEST(std::abs(view.direction.z()) < 1e-6f);
    const Plates shut(
        {Box(Vector3(-9, -9, half), Vector3(9, 9, 5)), Box(Vector3(-9, -9, -5), Vector3(9, 9, -half)),
         Box(Vector3(-9, -9, -1), Vector3(-8, 9, 1)), Box(Vector3(8, -9, -1), Vector3(9, 9, 1)),
         Box(Vector3(-9, -9, -1), Vector3(9, -8, 1)), Box(Vector3(-9, 8, -1), Vector3(9, 9, 1))});
    BOOST_TEST(chooseView(shut.rays, seen).visible == 0);
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::testing
