#include "clearway/planning/sliding_rrt_connect.h"

#include <ompl/base/ProblemDefinition.h>
#include <ompl/base/goals/GoalState.h>
#include <ompl/base/spaces/SO3StateSpace.h>
#include <ompl/geometric/PathGeometric.h>

#include <boost/test/unit_test.hpp>
#include <stdexcept>
#include <utility>
#include <vector>

#include "clearway/planning/ompl_messages.h"
#include "planning/planners/planner_team.h"
#include "support/motion_window.h"
#include "support/planar_scenes.h"
#include "support/random_meshes.h"

namespace clearway::planning {
BOOST_AUTO_TEST_SUITE(sliding_rrt_connect_test)

using namespace clearway::testing;

/// A problem as OMPL states it.
struct Task {
    Task(const Problem& problem, const Scene& scene, const Box& bounds)
        : si(std::make_shared<ob::SpaceInformation>(
              makeSpace(problem.space, bounds, scene.part.radiusAboutOrigin()))),
          definition(std::make_shared<ob::ProblemDefinition>(si)) {
        si->setStateValidityChecker(std::make_shared<ValidityChecker>(si, scene));
        si->setMotionValidator(std::make_shared<MotionValidator>(si, scene));
        si->setup();
        definition->setStartAndGoalStates(toOmpl(si->getStateSpace(), problem.space, problem.start),
                                          toOmpl(si->getStateSpace(), problem.space, problem.goal));
    }

    template <class Tree>
    std::shared_ptr<Tree> planner() const {
        const auto made = std::make_shared<Tree>(si);
        made->setProblemDefinition(definition);
        made->setup();
        return made;
    }

    std::vector<std::vector<double>> solution() const {
        std::vector<std::vector<double>> states;
        const auto path = std::static_pointer_cast<og::PathGeometric>(definition->getSolutionPath());
        for (const ob::State* state : path->getStates()) {
            states.emplace_back();
            si->getStateSpace()->copyToReals(states.back(), state);
        }
        return states;
    }

    ob::SpaceInformationPtr si;
    ob::ProblemDefinitionPtr definition;
};

Task windowTask() {
    const WindowScene window = windowScene();
    return Task(window.problem, window.scene, Box(Vector3(-100, -60, -60), Vector3(100, 60, 60)));
}

Task gatesTask() {
    const PlanarScene gates = gatesScene();
    return Task(gates.problem, gates.scene, Box(Vector3(-100, -60, -1), Vector3(100, 60, 1)));
}

ob::PlannerTerminationCondition after(int iterations) {
    return ob::PlannerTerminationCondition([left = iterations]() mutable { return left-- <= 0; });
}

template <class Tree>
void checkSolves(const Task& task, int iterations) {
    const auto planner = task.planner<Tree>();
    BOOST_TEST_REQUIRE(bool(planner->solve(after(iterations)) == ob::PlannerStatus::EXACT_SOLUTION));
    const auto path = std::static_pointer_cast<og::PathGeometric>(task.definition->getSolutionPath());
    BOOST_TEST(path->check());
    BOOST_TEST(task.si->equalStates(path->getState(0), task.definition->getStartState(0)));
    const auto* goal = task.definition->getGoal()->as<ob::GoalState>();
    BOOST_TEST(task.si->equalStates(path->getStates().back(), goal->getState()));
}

BOOST_AUTO_TEST_CASE(a_path_through_a_window_and_through_gates_is_valid_from_start_to_goal) {
    const OmplMessages quiet;
    for (std::uint32_t seed = 1; seed <= 3; ++seed) {
        ompl::RNG::setSeed(seed);
        checkSolves<SlidingRRTConnect>(windowTask(), 20000);
        checkSolves<SlidingRRTConnect>(gatesTask(), 20000);
        checkSolves<PlannerTeam>(windowTask(), 100000);
        checkSolves<PlannerTeam>(gatesTask(), 100000);
    }
}

template <class Tree>
std::vector<std::vector<double>> pathOfSeed(std::uint32_t seed, int parts) {
    ompl::RNG::setSeed(seed);
    const Task task = windowTask();
    const auto planner = task.planner<Tree>();
    for (int i = 0; i < parts && !task.definition->hasExactSolution(); ++i) planner->solve(after(1000000));
    BOOST_TEST_REQUIRE(task.definition->hasExactSolution());
    return task.solution();
}

BOOST_AUTO_TEST_CASE(the_same_seed_gives_the_same_path) {
    const OmplMessages quiet;
    BOOST_TEST((pathOfSeed<SlidingRRTConnect>(4, 1) == pathOfSeed<SlidingRRTConnect>(4, 1)));
    BOOST_TEST((pathOfSeed<PlannerTeam>(4, 1) == pathOfSeed<PlannerTeam>(4, 1)));
}

BOOST_AUTO_TEST_CASE(a_further_call_goes_on_and_a_cleared_planner_begins_anew) {
    const OmplMessages quiet;
    ompl::RNG::setSeed(5);
    const Task task = windowTask();
    const auto planner = task.planner<SlidingRRTConnect>();
    planner->solve(after(4));
    ob::PlannerData first(task.si), second(task.si), third(task.si);
    planner->getPlannerData(first);
    planner->solve(after(4));
    planner->getPlannerData(second);
    BOOST_TEST(second.numVertices() > first.numVertices());
    BOOST_TEST(second.numStartVertices() == 1u);
    BOOST_TEST(second.numGoalVertices() == 1u);
    planner->clear();
    planner->getPlannerData(third);
    BOOST_TEST(third.numVertices() == 0u);
    task.definition->clearSolutionPaths();
    BOOST_TEST(bool(planner->solve(after(1000000)) == ob::PlannerStatus::EXACT_SOLUTION));
}

BOOST_AUTO_TEST_CASE(without_a_path_the_approximate_one_is_valid_and_comes_from_the_start) {
    const OmplMessages quiet;
    ompl::RNG::setSeed(6);
    WindowScene window = windowScene();
    window.scene.obstacles[0].margin = 8;  // the plate is 10 thick and the window 22 high
    const Task task(window.problem, window.scene, Box(Vector3(-100, -60, -60), Vector3(100, 60, 60)));
    for (int kind = 0; kind < 2; ++kind) {
        task.definition->clearSolutionPaths();
        const ob::PlannerPtr planner = kind == 0 ? ob::PlannerPtr(task.planner<SlidingRRTConnect>())
                                                 : ob::PlannerPtr(task.planner<PlannerTeam>());
        BOOST_TEST(bool(planner->solve(after(3000)) == ob::PlannerStatus::APPROXIMATE_SOLUTION));
        const auto path = std::static_pointer_cast<og::PathGeometric>(task.definition->getSolutionPath());
        BOOST_TEST(path->check());
        BOOST_TEST(task.si->equalStates(path->getState(0), task.definition->getStartState(0)));
        BOOST_TEST(task.definition->hasApproximateSolution());
        BOOST_TEST(task.definition->getSolutionDifference() > 0);
    }
}

BOOST_AUTO_TEST_CASE(a_team_of_several_threads_finds_a_path_and_names_its_finder) {
    const OmplMessages quiet;
    const Task task = windowTask();
    const auto planner = std::make_shared<PlannerTeam>(task.si);
    planner->setThreads(4);
    planner->setProblemDefinition(task.definition);
    planner->setup();
    BOOST_TEST(
        bool(planner->solve(ob::timedPlannerTerminationCondition(60)) == ob::PlannerStatus::EXACT_SOLUTION));
    const std::string finder = task.definition->getSolutions().front().plannerName_;
    BOOST_TEST((finder.find("RRTConnect") != std::string::npos), finder);
    const auto path = std::static_pointer_cast<og::PathGeometric>(task.definition->getSolutionPath());
    BOOST_TEST(path->check());
}

/// The first start is shut in, so that a path begins at the one that was added.
template <class Tree>
void checkTakesAddedStart() {
    WindowScene window = windowScene();
    const Mesh shell = translated(box({70, 50, 50}, 1), {-300, 0, 0});
    window.scene.obstacles.push_back({Model::build(shell)});
    PartState shutIn = window.problem.start;
    shutIn.position.x() = -300;
    const PartState start = std::exchange(window.problem.start, shutIn);
    const Task task(window.problem, window.scene, Box(Vector3(-400, -60, -60), Vector3(100, 60, 60)));
    const auto planner = task.planner<Tree>();
    BOOST_TEST(!bool(planner->solve(ob::timedPlannerTerminationCondition(0.1)) ==
                     ob::PlannerStatus::EXACT_SOLUTION));
    task.definition->clearSolutionPaths();
    task.definition->addStartState(toOmpl(task.si->getStateSpace(), Space::kSe3, start));
    BOOST_TEST(
        bool(planner->solve(ob::timedPlannerTerminationCondition(60)) == ob::PlannerStatus::EXACT_SOLUTION));
    const auto path = std::static_pointer_cast<og::PathGeometric>(task.definition->getSolutionPath());
    BOOST_TEST(task.si->equalStates(path->getState(0), task.definition->getStartState(1)));
}

BOOST_AUTO_TEST_CASE(a_start_that_is_added_between_solves_is_taken) {
    const OmplMessages quiet;
    checkTakesAddedStart<SlidingRRTConnect>();
    checkTakesAddedStart<PlannerTeam>();
}

BOOST_AUTO_TEST_CASE(a_space_or_a_checker_of_another_kind_is_refused_by_name) {
    const auto other = std::make_shared<ob::SpaceInformation>(std::make_shared<ob::SO3StateSpace>());
    other->setStateValidityChecker([](const ob::State*) { return true; });
    other->setup();
    SlidingRRTConnect planner(other);
    BOOST_CHECK_THROW(planner.setup(), std::invalid_argument);
    BOOST_CHECK_THROW(PlannerTeam(other).setup(), std::invalid_argument);
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::planning
