// The planner that widens paths also straightens the ways they take.
#include "planning/planners/rising_floor.h"

#include <ompl/base/DiscreteMotionValidator.h>
#include <ompl/base/ScopedState.h>
#include <ompl/base/goals/GoalRegion.h>
#include <ompl/base/spaces/SE2StateSpace.h>

#include <algorithm>
#include <atomic>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "clearway/planning/audit.h"
#include "clearway/planning/problem_setup.h"
#include "clearway/planning/validity_checker.h"
#include "planning/improve/kept_clearance.h"
#include "planning/improve/unwind.h"
#include "support/planar_scenes.h"
#include "support/processor_time.h"

namespace clearway::planning {
BOOST_AUTO_TEST_SUITE(rising_floor_test)

namespace ob = ompl::base;
namespace og = ompl::geometric;

/// Through both wide gates, turning once about itself.
std::vector<PartState> spinning() {
    const auto at = [](double x, double y, double angle) {
        PartState state;
        state.position = {x, y, 0};
        state.rotation = Eigen::AngleAxisd(angle, Vector3::UnitZ());
        return state;
    };
    return {at(-80, 0, 0),    at(-80, 41, M_PI / 2), at(-60, 41, M_PI),       at(0, 41, M_PI),
            at(0, -41, M_PI), at(60, -41, M_PI),     at(80, -41, 1.5 * M_PI), at(80, 0, 2 * M_PI)};
}

/// The planner for the gates, set up but for what a test adds.
struct Gates {
    Gates() : setup(makeSetup(gates.problem, gates.scene)), planner(setup.getSpaceInformation()) {
        setup.setup();
        planner.setProblemDefinition(setup.getProblemDefinition());
        planner.setRange(60);
    }

    testing::PlanarScene gates = testing::gatesScene();
    og::SimpleSetup setup;
    RisingFloor planner;
};

BOOST_FIXTURE_TEST_CASE(of_ways_with_nearly_as_much_clearance_it_ends_with_one_that_winds_less, Gates) {
    const og::PathGeometric first = pathThrough(setup.getSpaceInformation(), spinning());
    const MotionValidator& validator = motionValidatorOf(setup.getSpaceInformation());
    const double radius = 0.5 * gates.scene.part.box().diagonal().norm();
    const auto kept = [&](const og::PathGeometric& path) {
        return keptClearance(path, validator, {0, testing::kWideGates, 0.01, {}});
    };
    const double clearance = kept(first);
    BOOST_TEST_REQUIRE(clearance > 9);
    planner.lookForShortPaths();
    planner.setup();
    planner.startFrom(first, {clearance, 0.05});
    // The ways are random: most runs meet a better one within a few seconds, one in fifteen not within 6 s.
    const double least = windingLength(first, radius) - M_PI * radius;
    for (int round = 0; round < 30 && !(round > 0 && windingLength(setup.getSolutionPath(), radius) < least);
         ++round) {
        testing::withProcessorTime(
            1, [&](double seconds) { return planner.solve(ob::timedPlannerTerminationCondition(seconds)); });
    }
    const og::PathGeometric& found = setup.getSolutionPath();
    BOOST_TEST_MESSAGE(clearance << ", then " << kept(found) << ", winding " << windingLength(first, radius)
                                 << ", then " << windingLength(found, radius));
    BOOST_TEST(kept(found) > 0.96 * clearance);
    BOOST_TEST(windingLength(found, radius) < least);
}

BOOST_FIXTURE_TEST_CASE(ways_sought_from_the_ends_of_a_known_path_lead_from_start_to_goal, Gates) {
    planner.lookForShortPaths();
    planner.setup();
    const og::PathGeometric first = pathThrough(setup.getSpaceInformation(), spinning());
    planner.startFrom(first, {0, 0.05});
    BOOST_TEST(!planner.hasWidenedSeveral());
    for (int second = 0; second < 60 && !planner.hasWidenedSeveral(); ++second) {
        const ob::PlannerTerminationCondition isOver = ob::timedPlannerTerminationCondition(1.0);
        planner.solve(
            ob::PlannerTerminationCondition([&] { return isOver() || planner.hasWidenedSeveral(); }));
    }
    BOOST_TEST(planner.hasWidenedSeveral());
    const og::PathGeometric& found = setup.getSolutionPath();
    BOOST_TEST(setup.getSpaceInformation()->equalStates(found.getState(0), first.getState(0)));
    BOOST_TEST(
        setup.getGoal()->isSatisfied(found.getState(static_cast<unsigned int>(found.getStateCount()) - 1)));
    BOOST_TEST(audit(found, motionValidatorOf(setup.getSpaceInformation())).isValid());
}

BOOST_FIXTURE_TEST_CASE(the_clearance_told_while_it_plans_never_falls_and_its_data_are_the_path, Gates) {
    planner.setup();
    const auto tell = planner.getPlannerProgressProperties().at("best cost REAL");
    BOOST_TEST(tell() == "");
    double last = 0;
    int gains = 0;
    bool hasFallen = false;
    std::mutex mutex;  // the planner's threads ask whether the time is over
    testing::withProcessorTime(1, [&](double seconds) {
        const ob::PlannerTerminationCondition isOver = ob::timedPlannerTerminationCondition(seconds);
        return planner.solve(ob::PlannerTerminationCondition([&] {
            const std::lock_guard<std::mutex> lock(mutex);
            const std::string told = tell();
            const double now = told.empty() ? 0 : std::stod(told);
            hasFallen = hasFallen || now < last;
            gains += now > last;
            last = now;
            return isOver();
        }));
    });
    BOOST_TEST(!hasFallen);
    BOOST_TEST(gains > 1);
    BOOST_TEST(last > testing::kNarrowGates / 2);
    ob::PlannerData data(setup.getSpaceInformation());
    planner.getPlannerData(data);
    const og::PathGeometric& found = setup.getSolutionPath();
    BOOST_TEST(data.numVertices() == found.getStateCount());
    BOOST_TEST(data.numEdges() == found.getStateCount() - 1);
    BOOST_TEST(data.numStartVertices() == 1u);
    BOOST_TEST(data.numGoalVertices() == 1u);
}

BOOST_AUTO_TEST_CASE(without_a_path_it_goes_on_with_the_trees_that_it_has) {
    testing::PlanarScene gates = testing::gatesScene();
    gates.scene.obstacles.front().margin = testing::kWideGates + 1;
    og::SimpleSetup setup = makeSetup(gates.problem, gates.scene);
    setup.setup();
    RisingFloor planner(setup.getSpaceInformation());
    planner.setProblemDefinition(setup.getProblemDefinition());
    planner.setup();
    const auto verticesAfter = [&](int asked) {
        std::atomic<int> left = asked;
        BOOST_TEST(planner.solve(ob::PlannerTerminationCondition([&] { return left-- <= 0; })) ==
                   ob::PlannerStatus::TIMEOUT);
        BOOST_TEST(!planner.clearance());
        ob::PlannerData data(setup.getSpaceInformation());
        planner.getPlannerData(data);
        return data.numVertices();
    };
    const unsigned int first = verticesAfter(100);
    BOOST_TEST(first > 2u);
    BOOST_TEST(verticesAfter(100) > first);
    planner.clear();
    ob::PlannerData cleared(setup.getSpaceInformation());
    planner.getPlannerData(cleared);
    BOOST_TEST(cleared.numVertices() == 0u);
    BOOST_TEST(verticesAfter(100) > 2u);
}

/// No path of the first scene keeps the margin of the second.
BOOST_AUTO_TEST_CASE(another_validity_checker_brings_another_scene) {
    testing::PlanarScene gates = testing::gatesScene();
    og::SimpleSetup setup = makeSetup(gates.problem, gates.scene);
    const ob::SpaceInformationPtr& si = setup.getSpaceInformation();
    si->setMotionValidator(std::make_shared<ob::DiscreteMotionValidator>(si));
    setup.setup();
    RisingFloor planner(si);
    planner.setProblemDefinition(setup.getProblemDefinition());
    planner.setRange(60);
    planner.setup();
    const auto isSolved = [&](double processorSeconds) {
        return testing::withProcessorTime(processorSeconds, [&](double seconds) {
                   return planner.solve(ob::timedPlannerTerminationCondition(seconds));
               }) == ob::PlannerStatus::EXACT_SOLUTION;
    };
    BOOST_TEST(isSolved(1));
    gates.scene.obstacles.front().margin = testing::kWideGates + 1;
    si->setStateValidityChecker(std::make_shared<ValidityChecker>(si, gates.scene));
    BOOST_TEST(!isSolved(0.2));
}

BOOST_FIXTURE_TEST_CASE(a_goal_that_no_state_can_be_drawn_from_is_told_at_once, Gates) {
    class Right : public ob::GoalRegion {
      public:
        using GoalRegion::GoalRegion;
        double distanceGoal(const ob::State* state) const override {
            return std::max(0.0, 80 - state->as<ob::SE2StateSpace::StateType>()->getX());
        }
    };
    setup.getProblemDefinition()->setGoal(std::make_shared<Right>(setup.getSpaceInformation()));
    planner.setup();
    BOOST_TEST(planner.solve(ob::timedPlannerTerminationCondition(60)) ==
               ob::PlannerStatus::UNRECOGNIZED_GOAL_TYPE);
}

/// A start with little room bounds the clearance. One with more is added, and the planner goes on.
BOOST_AUTO_TEST_CASE(a_start_that_is_added_between_solves_gives_more_clearance) {
    testing::PlanarScene gates = testing::gatesScene();
    gates.problem.start.position = {-40, 0, 0};
    og::SimpleSetup setup = makeSetup(gates.problem, gates.scene);
    setup.setup();
    RisingFloor planner(setup.getSpaceInformation());
    planner.setProblemDefinition(setup.getProblemDefinition());
    planner.setRange(60);
    planner.setup();
    const auto solve = [&] {
        testing::withProcessorTime(2, [&](double seconds) {
            planner.solve(ob::timedPlannerTerminationCondition(seconds));
            return 0;
        });
        return planner.clearance().value();
    };
    const double near = solve();
    ob::ScopedState<> added(setup.getStateSpace(), setup.getProblemDefinition()->getStartState(0));
    added->as<ob::SE2StateSpace::StateType>()->setX(-80);
    setup.getProblemDefinition()->addStartState(added);
    // The wide gates are found at random.
    double far = solve();
    for (int round = 0; round < 10 && !(far > near + 1); ++round) far = solve();
    BOOST_TEST(far > near + 1);
    const og::PathGeometric& path = setup.getSolutionPath();
    BOOST_TEST(path.getState(0)->as<ob::SE2StateSpace::StateType>()->getX() == -80);
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::planning
