#include "problem/outside.h"

#include <boost/test/unit_test.hpp>
#include <limits>
#include <random>
#include <stdexcept>
#include <utility>

#include "clearway/problem.h"
#include "support/words.h"

namespace clearway {
BOOST_AUTO_TEST_SUITE(outside_test)

const Box kUnitBox(Vector3(0, 0, 0), Vector3(1, 1, 1));
const Box kPart(Vector3(-1, -2, -3), Vector3(1, 2, 3));

std::string refusalOf(const Problem& problem, const Box& environment, const Box& part) {
    return testing::refusalBy([&] { boundsOf(problem, environment, part); });
}

Problem outsideProblem(std::optional<BoxSide> side = std::nullopt) {
    Problem problem;
    problem.file = "a.cfg";
    problem.start.position = Vector3(0.5, 0.5, 0.5);
    problem.outside = Outside{side};
    return problem;
}

Eigen::Quaterniond randomRotation(std::mt19937_64& random) {
    std::normal_distribution<double> normal;
    return Eigen::Quaterniond(normal(random), normal(random), normal(random), normal(random)).normalized();
}

BOOST_AUTO_TEST_CASE(a_moved_box_is_the_least_box_around_the_moved_corners) {
    std::mt19937_64 random(1);
    for (int i = 0; i < 1000; ++i) {
        const Pose X{randomRotation(random).toRotationMatrix(), Vector3(10, -20, 30)};
        Box corners;
        for (int k = 0; k < 8; ++k) corners.extend(X * Vector3(kPart.corner(Box::CornerType(k))));
        const Box moved = movedBox(X, kPart);
        BOOST_TEST((moved.min() - corners.min()).cwiseAbs().maxCoeff() < 1e-13);
        BOOST_TEST((moved.max() - corners.max()).cwiseAbs().maxCoeff() < 1e-13);
    }
    BOOST_TEST(movedBox(Pose(), Box()).isEmpty());
}

BOOST_AUTO_TEST_CASE(the_overlap_is_the_least_straight_move_that_parts_the_boxes) {
    const Box part(Vector3(0.5, 0.25, -1), Vector3(2, 2, 2));
    const auto overlap = [&](const char* side) { return overlapOf({sideNamed(side)}, part, kUnitBox); };
    BOOST_TEST(overlap("+x") == 0.5);
    BOOST_TEST(overlap("-x") == 2);
    BOOST_TEST(overlap("+y") == 0.75);
    BOOST_TEST(overlap("-z") == 2);
    BOOST_TEST(overlapOf({}, part, kUnitBox) == 0.5);
    const Box beyond(Vector3(1.5, 0, 0), Vector3(2, 1, 1));
    BOOST_TEST(overlapOf({sideNamed("+x")}, beyond, kUnitBox) == -0.5);
    BOOST_TEST(overlapOf({sideNamed("+y")}, beyond, kUnitBox) == 1);
    BOOST_TEST(overlapOf({}, beyond, kUnitBox) == -0.5);
    BOOST_TEST(overlapOf({}, part, Box()) < 0);  // nothing surrounds it
}

BOOST_AUTO_TEST_CASE(no_direction_reaches_less_far_than_the_flattest_one) {
    std::mt19937_64 random(2);
    const Box off(Vector3(1, 2, -1), Vector3(3, 4, 1));  // does not hold the origin
    for (const Box& box : {kPart, off, Box(Vector3(-5, -1, -1), Vector3(0.25, 1, 1))}) {
        for (const int dimensions : {2, 3}) {
            const Vector3 flattest = flattestDirection(box, dimensions);
            BOOST_TEST(std::abs(flattest.norm() - 1) < 1e-15);
            if (dimensions == 2) BOOST_TEST(flattest.z() == 0);
            for (int i = 0; i < 10000; ++i) {
                Vector3 direction = randomRotation(random) * Vector3::UnitX();
                if (dimensions == 2) direction = Vector3(direction.x(), direction.y(), 0).normalized();
                BOOST_TEST_REQUIRE(supportAlong(direction, box) >= supportAlong(flattest, box) - 1e-12);
            }
        }
    }
    BOOST_TEST(supportAlong(flattestDirection(kPart, 3), kPart) == 1);
}

BOOST_AUTO_TEST_CASE(derived_bounds_hold_the_part_outside_however_it_is_turned) {
    std::mt19937_64 random(3);
    Problem problem = outsideProblem(sideNamed("+z"));
    problem.margin = 0.5;
    const Box above = boundsOf(problem, kUnitBox, kPart);
    BOOST_TEST(above.min() == Vector3(0, 0, 0));
    BOOST_TEST(above.max().head<2>() == Eigen::Vector2d(1, 1));
    for (int i = 0; i < 1000; ++i) {
        const Pose X{randomRotation(random).toRotationMatrix(), above.max()};
        BOOST_TEST_REQUIRE(overlapOf(*problem.outside, movedBox(X, kPart), kUnitBox) < -problem.margin);
    }
    problem.outside = Outside();
    const Box around = boundsOf(problem, kUnitBox, kPart);
    BOOST_TEST(around.min() == Vector3(1, 1, 1) - above.max().z() * Vector3(1, 1, 1));
    BOOST_TEST(around.max() == above.max().z() * Vector3(1, 1, 1));
    std::swap(problem.margin, problem.rules.margins["wall"]);
    BOOST_TEST(boundsOf(problem, kUnitBox, kPart).max() == around.max());
    problem.space = Space::kSe2;
    BOOST_TEST(boundsOf(problem, kUnitBox, kPart).max().z() == 0);
}

BOOST_AUTO_TEST_CASE(bounds_without_room_for_the_part_outside_are_refused) {
    Problem problem = outsideProblem(sideNamed("+z"));
    problem.volume = Box(Vector3(0, 0, 0), Vector3(1, 1, 2));
    const auto refused = [&](const Box& part, const std::vector<std::string>& words) {
        for (const std::string& word : words)
            BOOST_TEST(testing::holds(refusalOf(problem, kUnitBox, part), word), word);
    };
    refused(kPart, {"a.cfg", "no room for the part outside", "volume.max.z above 2"});
    problem.volume->max().z() = 2.001;  // enough for the part on its flattest side
    BOOST_TEST(refusalOf(problem, kUnitBox, kPart) == "accepted");
    problem.outside = Outside{sideNamed("-x")};
    refused(kPart, {"no room for the part outside", "volume.min.x below -1"});
    problem.outside = Outside();
    problem.volume->max().z() = 1;
    refused(kPart, {"volume.max.x above 2", "volume.min.x below -1", "volume.max.y above 2",
                    "volume.min.y below -1", "volume.max.z above 2", "volume.min.z below -1"});
    problem.space = Space::kSe2;  // in its plane the part cannot be put on its flattest side
    problem.volume->max().x() = 2.001;
    refused(Box(Vector3(-2, -2, -1), Vector3(2, 2, 1)), {"volume.max.x above 3 "});
    refused(Box(), {"expected the part's box"});
    problem = outsideProblem(sideNamed("+z"));
    problem.margin = 1e300;
    refused(kPart, {"a.cfg", "margin is 1e+300", "a million times the scene's size"});
}

BOOST_AUTO_TEST_CASE(a_goal_outside_that_has_contacts_is_refused) {
    Problem problem = outsideProblem();
    problem.rules.goalContact = ContactRule{{"wall"}, 1};
    BOOST_CHECK_THROW(obstaclesOf(problem, {}), std::invalid_argument);
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway
