#include "clearway/planning/why_no_path.h"

#include <algorithm>
#include <boost/test/unit_test.hpp>

#include <ompl/base/PlannerData.h>
#include <ompl/base/goals/GoalRegion.h>
#include <ompl/base/goals/GoalState.h>
#include <ompl/base/goals/GoalStates.h>
#include <ompl/base/spaces/SE3StateSpace.h>
#include <ompl/geometric/planners/rrt/RRT.h>

#include "clearway/planning/check_path.h"
#include "clearway/planning/ompl_messages.h"
#include "planning/plan/plan_setup.h"
#include "planning/space/ompl_states.h"
#include "support/door_scene.h"
#include "support/full_run.h"
#include "support/random_meshes.h"
#include "support/words.h"

namespace clearway::planning {
BOOST_AUTO_TEST_SUITE(why_no_path_test)

using testing::doorScene;
using Outcome = PlanReport::Outcome;

PlanOptions withIterations(std::uint64_t iterations, const std::string& planner = "") {
    PlanOptions options;
    options.iterations = iterations;
    options.planner = planner;
    return options;
}

WhyNoPath whyNot(const Problem& problem, const Scene& scene, const PlanOptions& options) {
    const PlanReport report = plan(problem, scene, options);
    BOOST_REQUIRE((report.outcome == Outcome::kNotFound));
    BOOST_REQUIRE(report.whyNoPath.has_value());
    return *report.whyNoPath;
}

struct ClosedBox {
    testing::DoorScene door = doorScene();
    Scene scene{Model::build(door.part), Model::build(door.box)};
};

/// A plate that fills the bounds which are derived from it, start and goal.
struct Barred {
    Barred() {
        problem.start.position = {0, 0, 0};
        problem.goal.position = {20, 0, 0};
    }
    Scene scene{Model::build(boxMesh({Vector3(-2, -2, -2), Vector3(2, 2, 2)})),
                Model::build(boxMesh({Vector3(9, -8, -8), Vector3(11, 8, 8)}, "plate"))};
    Problem problem;
};

BOOST_AUTO_TEST_CASE(a_part_in_a_closed_box_is_shut_in_at_the_start_and_its_goal_is_not) {
    const ClosedBox closed;
    const WhyNoPath why = whyNot(closed.door.problem, closed.scene, withIterations(3000));
    BOOST_TEST(why.diagonal == std::sqrt(48.0), boost::test_tools::tolerance(1e-12));
    BOOST_TEST(why.isShutIn(why.start));
    BOOST_TEST(why.start.states > 10u);
    // The origin stays within 2 of the middle along each axis, and a vertex is sqrt(12) from it.
    BOOST_TEST(why.start.farthest <= std::sqrt(12.0) + 2 * std::sqrt(12.0));
    BOOST_TEST(why.start.farthest > 1);
    BOOST_TEST(why.goal.farthest > 8);  // from x = 15 to where the door's other side stops the part
    BOOST_TEST(why.start.bounds.empty());
    BOOST_TEST(why.goal.bounds.empty());
}

BOOST_AUTO_TEST_CASE(what_stops_the_part_is_told_by_name_and_every_stopped_motion_once) {
    const ClosedBox closed;
    const WhyNoPath why = whyNot(closed.door.problem, closed.scene, withIterations(3000));
    std::size_t atStart = 0, atGoal = 0;
    for (const Blocker& blocker : why.blockers) {
        atStart += blocker.atStart;
        atGoal += blocker.atGoal;
        // Outside only the door and the bounds are in the way; inside everything else but the bounds.
        if (blocker.isBounds()) BOOST_TEST(blocker.atStart == 0u);
        if (blocker.name == "back") BOOST_TEST(blocker.atGoal == 0u);
    }
    BOOST_TEST(atStart == why.start.motionsStopped);
    BOOST_TEST(atGoal == why.goal.motionsStopped);
    BOOST_TEST(why.motionsTried == WhyNoPathOptions().motions);
    BOOST_TEST(2 * atStart > why.motionsTried * 9 / 10);  // hardly any target is within the box
    const auto door = std::find_if(why.blockers.begin(), why.blockers.end(),
                                   [](const Blocker& blocker) { return blocker.name == "door"; });
    BOOST_REQUIRE((door != why.blockers.end()));
    BOOST_TEST(door->atStart > 0u);
    BOOST_TEST(door->atGoal > 0u);
    BOOST_TEST(std::is_sorted(why.blockers.begin(), why.blockers.end(),
                              [](const Blocker& a, const Blocker& b) { return a.motions() > b.motions(); }));
}

BOOST_AUTO_TEST_CASE(derived_bounds_that_bar_the_way_are_told_and_wider_ones_let_the_part_pass) {
    Barred barred;
    const WhyNoPath why = whyNot(barred.problem, barred.scene, withIterations(2000));
    for (const auto& [end, name] : {std::pair(why.start, "least x"), std::pair(why.goal, "greatest x")}) {
        BOOST_TEST_REQUIRE(end.bounds.size() == 1u);
        BOOST_TEST(boundNamed(end.bounds[0]) == name);
    }
    BOOST_TEST(std::any_of(why.blockers.begin(), why.blockers.end(), [](const Blocker& blocker) {
        return blocker.isBounds() && blocker.atStart > 0 && blocker.atGoal > 0;
    }));
    barred.problem.volume = Box(Vector3(-5, -20, -20), Vector3(25, 20, 20));
    const PlanReport wide = plan(barred.problem, barred.scene, withIterations(20000));
    BOOST_TEST((wide.outcome == Outcome::kFound));
    BOOST_TEST(!wide.whyNoPath.has_value());
}

BOOST_AUTO_TEST_CASE(the_nearest_miss_leads_from_start_to_goal_and_one_of_its_motions_is_not_valid) {
    const ClosedBox closed;
    for (const char* planner : {"", "RRTConnect", "BiEST", "PRM", "RRT", "FMT", "SBL", "LBKPIECE1"}) {
        const WhyNoPath why = whyNot(closed.door.problem, closed.scene, withIterations(1500, planner));
        const PathCheck check = checkPath(closed.door.problem, closed.scene, why.nearest.path);
        BOOST_TEST_CONTEXT("planner '" << planner << "'") {
            BOOST_TEST(check.beginsAtStart());
            BOOST_TEST(check.endsAtGoal());
            BOOST_REQUIRE(check.audit.notValid.size() == 1u);
            BOOST_TEST(check.audit.notValid[0] == why.nearest.gap);
            BOOST_TEST(why.nearest.displacement ==
                           closed.scene.part.displacement(poseOf(why.nearest.path[why.nearest.gap]),
                                                          poseOf(why.nearest.path[why.nearest.gap + 1])),
                       boost::test_tools::tolerance(1e-6));
            BOOST_TEST(why.nearest.displacement <= 15 + 1e-6);  // no farther than start and goal are
            BOOST_TEST(!why.isJoined);
        }
    }
}

BOOST_AUTO_TEST_CASE(with_iterations_all_that_is_told_is_repeatable) {
    const ClosedBox closed;
    const WhyNoPath first = whyNot(closed.door.problem, closed.scene, withIterations(1000));
    const WhyNoPath second = whyNot(closed.door.problem, closed.scene, withIterations(1000));
    BOOST_TEST(first.start.states == second.start.states);
    BOOST_TEST(first.start.farthest == second.start.farthest);
    BOOST_TEST(first.goal.farthest == second.goal.farthest);
    BOOST_TEST(first.nearest.displacement == second.nearest.displacement);
    BOOST_REQUIRE(first.blockers.size() == second.blockers.size());
    for (std::size_t i = 0; i < first.blockers.size(); ++i) {
        BOOST_TEST(first.blockers[i].name == second.blockers[i].name);
        BOOST_TEST(first.blockers[i].atStart == second.blockers[i].atStart);
        BOOST_TEST(first.blockers[i].atGoal == second.blockers[i].atGoal);
    }
}

BOOST_AUTO_TEST_CASE(a_planner_without_a_tree_from_the_goal_says_nothing_about_the_goal) {
    const ClosedBox closed;
    const WhyNoPath why = whyNot(closed.door.problem, closed.scene, withIterations(1000, "RRT"));
    BOOST_TEST(why.start.hasTree);
    BOOST_TEST(!why.goal.hasTree);
    BOOST_TEST(why.goal.states == 1u);
    BOOST_TEST(!why.isShutIn(why.goal));
}

double xOf(const ob::State* state) {
    return state->as<ob::SE3StateSpace::StateType>()->getX();
}

/// A caller's goal: positions beyond an x.
class Beyond : public ob::Goal {
  public:
    Beyond(const ob::SpaceInformationPtr& si, double x) : Goal(si), x_(x) {}
    bool isSatisfied(const ob::State* state) const override { return xOf(state) >= x_; }

  private:
    double x_;
};

/// The same positions as a region, from which no state can be drawn.
class RegionBeyond : public ob::GoalRegion {
  public:
    RegionBeyond(const ob::SpaceInformationPtr& si, double x) : GoalRegion(si), x_(x) {}
    double distanceGoal(const ob::State* state) const override { return std::max(0.0, x_ - xOf(state)); }

  private:
    double x_;
};

/// Plans for a goal of the caller's in vain, by RRT, which takes any goal.
WhyNoPath whyNotTo(const std::function<ob::GoalPtr(const ob::SpaceInformationPtr&)>& makeGoal) {
    const ClosedBox closed;
    PlanReport report;
    const OmplMessages unobserved;
    const PlanSetup setup =
        makePlanSetup(closed.door.problem, closed.scene, withIterations(1), report, [] { return false; });
    const auto definition = std::make_shared<ob::ProblemDefinition>(setup.si);
    definition->addStartState(setup.definition->getStartState(0));
    definition->setGoal(makeGoal(setup.si));
    const auto planner = std::make_shared<og::RRT>(setup.si);
    planner->setRange(report.range);
    planner->setProblemDefinition(definition);
    planner->setup();
    int asked = 0;
    planner->solve(ob::PlannerTerminationCondition([&] { return ++asked > 1000; }));
    return whyNoPath({{planner}, definition, setup.auditor}, closed.door.problem);
}

BOOST_AUTO_TEST_CASE(a_callers_goal_that_draws_no_states_is_the_problems_goal_or_refused) {
    const double goal = doorScene().problem.goal.position.x();
    const auto requireMissed = [&](const WhyNoPath& why) {
        BOOST_TEST(why.start.states > 10u);
        BOOST_TEST(why.goal.states == 1u);
        BOOST_TEST(why.nearest.path.back().position.x() == goal);
        BOOST_TEST(why.nearest.displacement > 0);
        BOOST_TEST(why.nearest.displacement < 1e3);
    };
    requireMissed(whyNotTo([&](const auto& si) { return std::make_shared<Beyond>(si, goal - 1); }));
    requireMissed(whyNotTo([&](const auto& si) { return std::make_shared<RegionBeyond>(si, goal - 1); }));
    const auto requireRefused = [&](const auto& makeGoal) {
        testing::requireRefusedBy([&] { whyNotTo(makeGoal); }, {"no state of the goal is known"});
    };
    requireRefused([&](const auto& si) { return std::make_shared<Beyond>(si, goal + 1); });
    requireRefused([&](const auto& si) { return std::make_shared<RegionBeyond>(si, goal + 1); });
    requireRefused([](const auto& si) { return std::make_shared<ob::GoalStates>(si); });
    const WhyNoPath elsewhere = whyNotTo([&](const auto& si) {
        const auto states = std::make_shared<ob::GoalStates>(si);
        ob::ScopedState<ob::SE3StateSpace> state(si);
        state->setXYZ(goal + 1, 0, 0);
        state->rotation().setIdentity();
        states->addState(state);
        return states;
    });
    BOOST_TEST(elsewhere.nearest.path.back().position.x() == goal + 1);
}

/// Says that it grew chains of so many states, at random places about the start and about the goal.
class GrownAtRandom : public ob::Planner {
  public:
    GrownAtRandom(const ob::SpaceInformationPtr& si, ob::ProblemDefinitionPtr definition, std::size_t states)
        : Planner(si, "GrownAtRandom") {
        ompl::RNG random(7);
        const auto goal = std::dynamic_pointer_cast<ob::GoalState>(definition->getGoal());
        for (const ob::State* root :
             std::initializer_list<const ob::State*>{definition->getStartState(0), goal->getState()}) {
            auto& chain = chains_.emplace_back();
            for (std::size_t i = 0; i < states; ++i) {
                ob::ScopedState<ob::SE3StateSpace> state(si);
                state = root;
                if (i > 0) state->setX(xOf(root) + random.uniformReal(-2, 2));
                if (i > 0) state->setY(random.uniformReal(-2, 2));
                chain.push_back(state);
            }
        }
        definition_ = std::move(definition);
    }

    ob::PlannerStatus solve(const ob::PlannerTerminationCondition&) override {
        return ob::PlannerStatus::TIMEOUT;
    }

    void getPlannerData(ob::PlannerData& data) const override {
        data.addStartVertex(ob::PlannerDataVertex(chains_[0][0].get()));
        data.addGoalVertex(ob::PlannerDataVertex(chains_[1][0].get()));
        for (const auto& chain : chains_) {
            for (std::size_t i = 1; i < chain.size(); ++i) {
                data.addEdge(ob::PlannerDataVertex(chain[i - 1].get()),
                             ob::PlannerDataVertex(chain[i].get()));
            }
        }
    }

    double nearest(int chain, const ob::State* state) const {
        double least = 1e9;
        for (const auto& other : chains_[chain]) least = std::min(least, si_->distance(state, other.get()));
        return least;
    }

  private:
    ob::ProblemDefinitionPtr definition_;
    std::vector<std::vector<ob::ScopedState<ob::SE3StateSpace>>> chains_;
};

BOOST_AUTO_TEST_CASE(neither_end_of_the_nearest_miss_of_large_trees_has_a_nearer_state_in_the_other) {
    const ClosedBox closed;
    PlanReport report;
    const PlanSetup setup =
        makePlanSetup(closed.door.problem, closed.scene, withIterations(1), report, [] { return false; });
    for (const std::size_t states : {500, 15000}) {
        const auto planner = std::make_shared<GrownAtRandom>(setup.si, setup.definition, states);
        const WhyNoPath why = whyNoPath({{planner}, setup.definition, setup.auditor}, closed.door.problem);
        BOOST_TEST(why.start.states == states);
        BOOST_TEST(why.goal.states == states);
        BOOST_TEST(!why.blockers.empty());
        const auto stateOf = [&](std::size_t i) {
            return toOmpl(setup.si->getStateSpace(), closed.door.problem.space, why.nearest.path.at(i));
        };
        const auto before = stateOf(why.nearest.gap), after = stateOf(why.nearest.gap + 1);
        const double gap = setup.si->distance(before.get(), after.get());
        BOOST_TEST(planner->nearest(1, before.get()) >= gap * (1 - 1e-9));
        BOOST_TEST(planner->nearest(0, after.get()) >= gap * (1 - 1e-9));
    }
}

BOOST_AUTO_TEST_CASE(the_reason_is_told_in_time_however_large_the_trees_grew) {
    const ClosedBox closed;
    PlanOptions options;
    options.seconds = testing::isFullRun() ? 40 : 2;
    bool isOverrun = false;
    options.onOverrun = [&](const PlanReport&) { isOverrun = true; };
    const WhyNoPath why = whyNot(closed.door.problem, closed.scene, options);
    BOOST_TEST(!isOverrun);
    BOOST_TEST(why.motionsTried > 0u);
}

BOOST_AUTO_TEST_CASE(trees_that_a_valid_motion_joins_are_a_path) {
    ClosedBox open;
    open.scene.obstacles.clear();
    PlanOptions options = withIterations(1, "RRT");
    options.parameters = {{"goal_bias", "0"}};
    const PlanReport report = plan(open.door.problem, open.scene, options);
    BOOST_REQUIRE((report.outcome == Outcome::kFound));
    BOOST_TEST(report.audit.isValid());
    BOOST_TEST(report.foundBy == "the trees of several planners, joined");
    BOOST_TEST(!report.whyNoPath.has_value());
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::planning
