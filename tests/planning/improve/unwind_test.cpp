// Needless turns go, the clearance stays.
#include "planning/improve/unwind.h"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <memory>
#include <utility>

#include "clearway/planning/audit.h"
#include "support/motion_window.h"
#include "support/part_in_space.h"
#include "support/random_meshes.h"

namespace clearway::planning {
BOOST_AUTO_TEST_SUITE(unwind_test)

using Fixture = testing::MotionWindow;

/// In front of the wall, with turns to and fro about z by an angle.
og::PathGeometric swinging(const Fixture& f, double angle, double x) {
    og::PathGeometric path(f.si);
    for (int i = 0; i <= 8; ++i) {
        path.append(f.at({x, 5.0 * i - 20, 0}, i % 2 == 0 ? 0 : angle).get());
    }
    return path;
}

double turnedOf(const Fixture& f, const og::PathGeometric& path) {
    return audit(path, *f.validator).rotation;
}

BOOST_AUTO_TEST_CASE(turns_to_and_fro_are_taken_out_where_there_is_room) {
    const Fixture f;
    og::PathGeometric path = swinging(f, 0.5, -60);
    BOOST_TEST(turnedOf(f, path) > 3.9);
    unwind(path, *f.validator, 1, {});
    BOOST_TEST(turnedOf(f, path) < 1e-3);
    BOOST_TEST(audit(path, *f.validator).lowerClearance > 1);
    BOOST_TEST(windingLength(path, 10) == 40, boost::test_tools::tolerance(1e-3));
}

BOOST_AUTO_TEST_CASE(a_full_turn_in_the_plane_is_taken_out) {
    const Fixture f(0, {}, Space::kSe2);
    og::PathGeometric path(f.si);
    for (int i = 0; i <= 8; ++i) path.append(f.at({-60, 5.0 * i - 20, 0}, i * M_PI / 4).get());
    BOOST_TEST(turnedOf(f, path) == 2 * M_PI, boost::test_tools::tolerance(1e-9));
    unwind(path, *f.validator, 1, {});
    BOOST_TEST(turnedOf(f, path) < 1e-9);
    BOOST_TEST(windingLength(path, 10) == 40, boost::test_tools::tolerance(1e-9));
}

BOOST_AUTO_TEST_CASE(turns_that_keep_the_part_off_the_wall_stay) {
    const Fixture f;
    og::PathGeometric path(f.si);
    // The wall's face is at x = -2. The plate reaches 30 from its middle along one axis, 20 along the other one.
    path.append(f.at({-40, -20, 40}).get());
    for (const auto& [x, y] : {std::pair{-40.0, -20.0}, {-24.0, -20.0}, {-24.0, 20.0}, {-40.0, 20.0}}) {
        path.append(f.at({x, y, 40}, M_PI / 2).get());
    }
    path.append(f.at({-40, 20, 40}).get());
    const double before = audit(path, *f.validator).lowerClearance;
    BOOST_TEST_REQUIRE(before > 0);
    unwind(path, *f.validator, before, {});
    BOOST_TEST(audit(path, *f.validator).lowerClearance >= 0.9 * before);
    BOOST_TEST(turnedOf(f, path) > 0.9 * M_PI);
}

// Without its turn the rod would go on from its second place into the post.
BOOST_AUTO_TEST_CASE(a_turn_that_only_the_last_motion_needs_stays) {
    const testing::PartInSpace f(
        Scene(Model::build(testing::box({30, 1, 1})),
              Model::build(testing::translated(testing::box({0.5, 0.5, 5}), {29, 5, 0}))));
    og::PathGeometric path(f.si);
    path.append(f.at({-20, 0, 0}).get());
    path.append(f.at({0, 0, 0}, 0.3).get());
    path.append(f.at({0, 10, 0}).get());
    BOOST_TEST(audit(path, *f.validator).lowerClearance > 1);
    unwind(path, *f.validator, 1, {});
    BOOST_TEST(audit(path, *f.validator).lowerClearance > 1);
}

BOOST_AUTO_TEST_CASE(winding_is_length_plus_the_way_of_a_point_far_out) {
    const Fixture f;
    og::PathGeometric path(f.si);
    path.append(f.at({-60, 0, 0}).get());
    path.append(f.at({-60, 30, 40}).get());
    path.append(f.at({-60, 30, 40}, 0.5).get());
    BOOST_TEST(windingLength(path, 20) == 50 + 0.5 * 20, boost::test_tools::tolerance(1e-9));
}

BOOST_AUTO_TEST_CASE(of_two_ways_the_wider_one_is_better_or_else_the_one_that_winds_less) {
    const Fixture f;
    const auto way = [&](double clearance, double angle) {
        return WidePath{std::make_shared<og::PathGeometric>(swinging(f, angle, -60)), clearance};
    };
    BOOST_TEST(isBetterPath(way(2, 0.5), way(1, 0), 10));
    BOOST_TEST(!isBetterPath(way(1, 0), way(2, 0.5), 10));
    BOOST_TEST(isBetterPath(way(1, 0), way(1.01, 0.5), 10));
    BOOST_TEST(!isBetterPath(way(1.01, 0.5), way(1, 0), 10));
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::planning
