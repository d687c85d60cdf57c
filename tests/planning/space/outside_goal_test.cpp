#include "clearway/planning/outside_goal.h"

#include <ompl/base/spaces/RealVectorStateSpace.h>

#include <boost/test/unit_test.hpp>
#include <future>
#include <random>
#include <stdexcept>
#include <vector>

#include "clearway/planning/validity_checker.h"
#include "planning/space/ompl_states.h"
#include "problem/outside.h"
#include "support/random_meshes.h"
#include "support/window_scene.h"

namespace clearway::planning {
BOOST_AUTO_TEST_SUITE(outside_goal_test)

/// A goal for the window's plate, in a space with these bounds.
struct Outdoors {
    Outdoors(Space theKind, const Box& bounds, const Outside& outside, double margin = 0)
        : kind(theKind), window(testing::windowScene()) {
        window.scene.obstacles[0].margin = margin;
        si = std::make_shared<ob::SpaceInformation>(makeSpace(kind, bounds, 1));
        si->setStateValidityChecker(std::make_shared<ValidityChecker>(si, window.scene));
        si->setup();
        goal = std::make_shared<OutsideGoal>(si, window.scene, outside, window.problem.start);
    }

    /// The box of the plate's corners where the state has them.
    Box partAt(const ob::State* state) const {
        Box box;
        const Pose X = poseOf(fromOmpl(kind, state));
        for (const Vector3& vertex : window.partMesh.vertices) box.extend(X * vertex);
        return box;
    }

    Space kind;
    testing::WindowScene window;
    ob::SpaceInformationPtr si;
    std::shared_ptr<OutsideGoal> goal;
};

const Box kWide(Vector3(-300, -300, -300), Vector3(300, 300, 300));
const Box kWall(Vector3(-2, -100, -100), Vector3(2, 100, 100));

BOOST_AUTO_TEST_CASE(drawn_states_are_valid_within_bounds_and_outside_on_the_side) {
    for (const Space kind : {Space::kSe3, Space::kSe2}) {
        for (const char* name : {"", "+x", "-y", "+z"}) {
            const Outside outside{sideNamed(name)};
            if (kind == Space::kSe2 && outside.side && outside.side->axis == 2) continue;
            const Outdoors f(kind, kWide, outside, 3);
            const ScratchState state(*f.si);
            BOOST_TEST_CONTEXT("side " << name) {
                for (int i = 0; i < 300; ++i) {
                    f.goal->sampleGoal(state.get());
                    BOOST_TEST_REQUIRE(f.goal->isSatisfied(state.get()));
                    BOOST_TEST_REQUIRE(f.goal->distanceGoal(state.get()) == 0);
                    BOOST_TEST_REQUIRE(f.si->satisfiesBounds(state.get()));
                    BOOST_TEST_REQUIRE(f.si->isValid(state.get()));
                    BOOST_TEST_REQUIRE(overlapOf(outside, f.partAt(state.get()), kWall) < 0);
                }
            }
        }
    }
}

BOOST_AUTO_TEST_CASE(states_move_out_until_the_gap_is_as_wide_as_asked_for_or_the_bounds_end) {
    for (const Space kind : {Space::kSe3, Space::kSe2}) {
        const Outdoors f(kind, kWide, {});
        const ScratchState state(*f.si);
        for (const double gap : {0.0, 50.0, 1000.0}) {
            for (int i = 0; i < 100; ++i) {
                f.goal->sampleGoal(state.get());
                const double before = -overlapOf({}, f.partAt(state.get()), kWall);
                const Vector3 from = fromOmpl(kind, state.get()).position;
                f.goal->moveOut(state.get(), gap);
                const Vector3 to = fromOmpl(kind, state.get()).position;
                BOOST_TEST_REQUIRE(f.si->satisfiesBounds(state.get()));
                BOOST_TEST_REQUIRE((to - from).cwiseAbs().maxCoeff() == (to - from).norm());
                const double after = -overlapOf({}, f.partAt(state.get()), kWall);
                if (before >= gap) {
                    BOOST_TEST_REQUIRE((to == from));
                } else if (to.cwiseAbs().maxCoeff() < 300) {
                    BOOST_TEST_REQUIRE(after == gap, boost::test_tools::tolerance(1e-9));
                } else {
                    BOOST_TEST_REQUIRE((after > before && after <= gap * (1 + 1e-9)));
                }
            }
        }
    }
}

BOOST_AUTO_TEST_CASE(a_state_that_is_not_outside_stays_where_it_is) {
    const Outdoors f(Space::kSe3, kWide, {});
    auto state = toOmpl(f.si->getStateSpace(), Space::kSe3, {{0, 0, 0}, {1, 0, 0, 0}});
    f.goal->moveOut(state.get(), 50);
    BOOST_TEST((fromOmpl(Space::kSe3, state.get()).position == Vector3(0, 0, 0)));
}

BOOST_AUTO_TEST_CASE(draws_differ_in_rotation_and_some_are_straight_ahead_of_the_start) {
    const Outdoors f(Space::kSe3, kWide, {sideNamed("+x")});
    const ScratchState state(*f.si);
    const PartState& start = f.window.problem.start;
    int straight = 0, turned = 0;
    for (int i = 0; i < 400; ++i) {
        f.goal->sampleGoal(state.get());
        const PartState drawn = fromOmpl(Space::kSe3, state.get());
        if (drawn.rotation.angularDistance(start.rotation) > 1e-6) {
            ++turned;
        } else if ((drawn.position - start.position).tail<2>().norm() == 0) {
            ++straight;
        }
    }
    BOOST_TEST(turned > 50);
    BOOST_TEST(turned < 150);
    BOOST_TEST(straight > 150);
    BOOST_TEST(straight < 250);
}

BOOST_AUTO_TEST_CASE(where_only_the_flat_part_fits_it_is_laid_flat) {
    Box bounds(Vector3(-80, -40, -40),
               Vector3(7.2, 40, 40));  // the wall ends at 2, the plate is 5 thick from its middle
    const Outdoors f(Space::kSe3, bounds, {sideNamed("+x")});
    const ScratchState state(*f.si);
    for (int i = 0; i < 100; ++i) {
        f.goal->sampleGoal(state.get());
        BOOST_TEST_REQUIRE(f.goal->isSatisfied(state.get()));
        BOOST_TEST_REQUIRE(f.si->isValid(state.get()));
    }
}

BOOST_AUTO_TEST_CASE(where_no_state_outside_is_valid_none_is_offered) {
    const Outdoors f(Space::kSe3, Box(Vector3(-80, -40, -40), Vector3(60, 40, 40)), {sideNamed("+x")}, 100);
    const ScratchState state(*f.si);
    f.goal->sampleGoal(state.get());
    BOOST_TEST(!f.si->satisfiesBounds(state.get()));
}

BOOST_AUTO_TEST_CASE(the_distance_is_how_far_the_boxes_overlap) {
    const Outdoors f(Space::kSe3, kWide, {sideNamed("+x")});
    const auto at = [&](double x) {
        PartState state = f.window.problem.start;
        state.position.x() = x;
        return toOmpl(f.si->getStateSpace(), Space::kSe3, state);
    };
    double distance = -1;
    BOOST_TEST(f.goal->distanceGoal(at(-60).get()) == 92, boost::test_tools::tolerance(1e-12));
    BOOST_TEST(!f.goal->isSatisfied(at(-60).get(), &distance));
    BOOST_TEST(distance == 92, boost::test_tools::tolerance(1e-12));
    BOOST_TEST(!f.goal->isSatisfied(at(32 - 1e-9).get()));
    BOOST_TEST(f.goal->isSatisfied(at(32 + 1e-9).get(), &distance));
    BOOST_TEST(distance == 0);
    const Outdoors any(Space::kSe3, kWide, {});
    BOOST_TEST(any.goal->isSatisfied(at(-60).get()));
}

BOOST_AUTO_TEST_CASE(threads_may_draw_from_one_goal) {
    const Outdoors f(Space::kSe3, kWide, {});
    const auto draw = [&] {
        const ScratchState state(*f.si);
        for (int i = 0; i < 500; ++i) {
            f.goal->sampleGoal(state.get());
            if (!f.goal->isSatisfied(state.get()) || !f.si->isValid(state.get())) return false;
        }
        return true;
    };
    std::vector<std::future<bool>> threads;
    for (int i = 0; i < 4; ++i) threads.push_back(std::async(std::launch::async, draw));
    for (auto& each : threads) BOOST_TEST(each.get());
}

BOOST_AUTO_TEST_CASE(a_goal_in_another_space_is_refused) {
    const auto window = testing::windowScene();
    const auto si = std::make_shared<ob::SpaceInformation>(std::make_shared<ob::RealVectorStateSpace>(3));
    BOOST_CHECK_THROW(OutsideGoal(si, window.scene, {}, {}), std::invalid_argument);
    BOOST_CHECK_THROW(OutsideGoal(nullptr, window.scene, {}, {}), std::invalid_argument);
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::planning
