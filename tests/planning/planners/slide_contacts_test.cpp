// Steps keep the standoff from the contacts remembered, and are free of those forgotten.
#include "planning/planners/slide_contacts.h"

#include <boost/test/unit_test.hpp>

#include "support/motion_window.h"

namespace clearway::planning {
BOOST_AUTO_TEST_SUITE(slide_contacts_test)

using Fixture = testing::MotionWindow;
constexpr double kStandoff = 1, kReach = 100;

/// The plate beside the wall, whose face is at x = -2: the plate reaches 30 from its middle.
struct Beside : Fixture {
    SceneClearance clearance{window.scene};
    PartMoves moves{*space, window.scene.part};
    SlideContacts contacts{*si, clearance, moves, kStandoff};
    ob::ScopedState<> next{space};

    std::optional<bool> step(const Vector3& from, const Vector3& to) {
        return contacts.step(at(from).get(), at(to).get(), kReach, next.get());
    }
    Vector3 position() const { return partStateOfSe3(next.get()).position; }
};

BOOST_AUTO_TEST_CASE(without_contacts_a_step_leads_to_the_target_or_as_far_as_it_reaches) {
    Beside f;
    BOOST_TEST(f.contacts.areNone());
    BOOST_TEST(f.step({-90, 0, 40}, {-40, 0, 40}).value());
    BOOST_TEST((f.position() - Vector3(-40, 0, 40)).norm() < 1e-12);
    BOOST_TEST(!f.step({-90, 0, 40}, {60, 0, 40}).value());
    BOOST_TEST((f.position() - Vector3(10, 0, 40)).norm() < 1e-9);
}

BOOST_AUTO_TEST_CASE(a_step_keeps_the_standoff_from_the_plane_of_a_contact) {
    Beside f;
    const auto from = f.at({-34, 0, 40});  // a gap of 2
    const Pose X_environmentPart = f.moves.pose(from.get());
    const auto nearest = f.clearance.at(X_environmentPart, {}).nearest;
    const auto plane = contactPlaneOf(nearest, f.clearance.scene(), X_environmentPart);
    BOOST_TEST_REQUIRE(plane.has_value());
    f.contacts.lookAround(from.get());
    BOOST_TEST(!f.contacts.areNone());
    // Each step turns the part a little, too, so that the point of the contact stays back.
    for (const double way : {2.0, 3.0, 4.0}) {
        BOOST_TEST(!f.step({-34, 0, 40}, {-34 + way, way, 40}).value());
        BOOST_TEST(f.position().y() > 0.9 * way);
        const double gap = rowAt(*plane, f.moves, f.moves.pose(f.next.get())).gap;
        BOOST_TEST(gap == kStandoff, boost::test_tools::tolerance(0.05 * way));
    }
}

BOOST_AUTO_TEST_CASE(a_contact_left_behind_is_forgotten) {
    Beside f;
    f.contacts.lookAround(f.at({-33, 0, 40}).get());
    BOOST_TEST(f.step({-70, 0, 40}, {-60, 0, 40}).value());
    BOOST_TEST(f.contacts.areNone());
    f.contacts.lookAround(f.at({-70, 0, 40}).get());  // too far to be a contact
    BOOST_TEST(f.contacts.areNone());
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::planning
