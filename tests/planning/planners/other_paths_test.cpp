#include "planning/planners/other_paths.h"

#include <ompl/base/goals/GoalState.h>

#include <boost/test/unit_test.hpp>

#include "clearway/planning/problem_setup.h"
#include "support/window_scene.h"

namespace clearway::planning {
BOOST_AUTO_TEST_SUITE(other_paths_test)

/// A straight path through the window, whose middle motion keeps little.
struct Straight {
    Straight() : setup(makeSetup(window.problem, window.scene)), path(setup.getSpaceInformation()) {
        setup.setup();
        path = pathThrough(si(), {at(-60), at(-45), at(45), at(60)});
    }

    static PartState at(double x) { return {{x, 0, 0}, {1, 0, 0, 0}}; }
    const ob::SpaceInformationPtr& si() const { return setup.getSpaceInformation(); }

    testing::WindowScene window = testing::windowScene();
    og::SimpleSetup setup;
    og::PathGeometric path;
};

BOOST_FIXTURE_TEST_CASE(motions_that_do_not_keep_the_floor_are_narrow, Straight) {
    const MotionValidator& validator = motionValidatorOf(si());
    const auto never = [] { return false; };
    const std::vector<unsigned int> middle = {2}, none;
    BOOST_TEST(narrowsOf(path, validator, 12, never) == middle, boost::test_tools::per_element());
    BOOST_TEST(narrowsOf(path, validator, 0, never) == none, boost::test_tools::per_element());
}

BOOST_FIXTURE_TEST_CASE(three_of_four_samples_have_the_part_beside_a_narrow_motion, Straight) {
    const Model& part = window.scene.part;
    BesideNarrows sampler(*si(), path, {2}, part);
    const PartMoves moves(*si()->getStateSpace(), part);
    const double radius = moves.radius();
    const ScratchState state(*si());
    int beside = 0;
    const int count = 4000;
    for (int i = 0; i < count; ++i) {
        sampler.sampleUniform(state.get());
        BOOST_TEST_REQUIRE(si()->satisfiesBounds(state.get()));
        const Vector3 centre = moves.centre(moves.pose(state.get()));
        beside += std::abs(centre.x()) <= 45 + radius && std::abs(centre.y()) <= radius &&
                  std::abs(centre.z()) <= radius;
    }
    BOOST_TEST(beside >= 3 * count / 4);
    BOOST_TEST(beside < count);
}

BOOST_FIXTURE_TEST_CASE(a_goal_at_the_end_of_a_path_draws_its_states_and_those_of_the_other_goal_by_turns,
                        Straight) {
    const auto other = std::make_shared<ob::GoalState>(si());
    other->setState(path.getState(0));
    const EndOfPath goal(si(), other, path, 2);
    BOOST_TEST(goal.maxSampleCount() == other->maxSampleCount() + 2);
    const ScratchState state(*si());
    for (const unsigned int expected : {2, 0, 3, 0, 0, 0}) {
        goal.sampleGoal(state.get());
        BOOST_TEST(si()->equalStates(state.get(), path.getState(expected)));
    }
    BOOST_TEST(goal.isSatisfied(path.getState(0)));
    BOOST_TEST(!goal.isSatisfied(path.getState(3)));
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::planning
