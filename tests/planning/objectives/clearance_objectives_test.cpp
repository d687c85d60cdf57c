#include "clearway/planning/clearance_objectives.h"

#include <ompl/base/goals/GoalState.h>
#include <ompl/base/objectives/MaximizeMinClearanceObjective.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/base/spaces/SE3StateSpace.h>
#include <ompl/geometric/PathGeometric.h>

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>
#include <vector>

#include "support/full_run.h"
#include "support/motion_scene.h"
#include "support/motion_window.h"
#include "support/ompl_log.h"
#include "support/part_in_space.h"
#include "support/random_meshes.h"
#include "support/words.h"

namespace clearway::planning {
BOOST_AUTO_TEST_SUITE(clearance_objectives_test)

using Fixture = testing::MotionWindow;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
const double kDiagonal = Vector3(60, 40, 10).norm();

double cost(const ob::OptimizationObjective& objective, const ob::ScopedState<>& a,
            const ob::ScopedState<>& b) {
    return objective.motionCost(a.get(), b.get()).value();
}

/// The most by which a certified clearance may be below the least clearance.
double resolutionOf(double clearance, double partDiagonal) {
    const double share = std::max(0.01 * clearance, std::min(0.1 * clearance, 1e-3 * partDiagonal));
    return std::max(share, 1e-5 * partDiagonal);
}

ob::ScopedState<> randomState(const Fixture& f, testing::Random& random) {
    return f.at(Vector3(-50, 0, 0) + random.inBox(40), random.uniform(0, 3), random.direction());
}

BOOST_AUTO_TEST_CASE(a_motions_cost_is_its_least_clearance_to_the_resolution) {
    for (const double margin : {0.0, 2.0}) {
        const Fixture f(margin);
        const MinClearanceObjective objective(f.si, f.window.scene);
        // Through the window, 11 from its upper and lower side; beside the wall, whose face is at -2.
        const double through = cost(objective, f.at({-60, 0, 0}), f.at({60, 0, 0}));
        BOOST_TEST(through <= 11 - margin);
        BOOST_TEST(through >= 11 - margin - resolutionOf(11 - margin, kDiagonal));
        const double near = cost(objective, f.at({-32.05 - margin, -20, 30}), f.at({-50, 20, 40}));
        BOOST_TEST(near <= 0.05);
        BOOST_TEST(near >= 0.05 - resolutionOf(0.05, kDiagonal));
        BOOST_TEST(cost(objective, f.at({-60, 0, 30}), f.at({20, 0, 30})) == -kInvalidMotionCost);
        BOOST_TEST(objective.counters().motions == 3u);
        BOOST_TEST(objective.counters().invalid == 1u);
    }
}

BOOST_AUTO_TEST_CASE(
    a_cost_never_exceeds_the_least_clearance_by_the_oracle_and_is_no_farther_below_than_said) {
    for (const auto& scene : testing::motionScenes()) {
        const MinClearanceObjective objective(scene->si, scene->scene);
        const double diagonal = scene->scene.part.box().diagonal().norm();
        testing::Random random(21);
        int valid = 0;
        for (int i = 0; i < testing::inForm(60, 30); ++i) {
            const double range = i % 3 == 0 ? 0.2 : 0.01, turn = 3 * range;
            const auto s1 = scene->state(scene->nearPath(random, range * diagonal, turn));
            const auto s2 = scene->state(scene->nearPath(random, range * diagonal, turn));
            const double found = cost(objective, s1, s2);
            if (found == -kInvalidMotionCost) continue;
            const double least = scene->leastTrueClearance(s1.get(), s2.get(), 1, 200, 2);
            BOOST_TEST_CONTEXT(scene->name << ", seed 21, motion " << i) {
                BOOST_TEST(found <= least);
                BOOST_TEST((found > 0) >= scene->validator->checkMotion(s1.get(), s2.get()));
                // The oracle looks at finitely many poses: the least may be between two of them.
                BOOST_TEST(found >= std::min(least, objective.cap()) - resolutionOf(least, diagonal) -
                                        1e-6 * diagonal);
            }
            ++valid;
        }
        BOOST_TEST(valid >= testing::inForm(5, 2), scene->name);
    }
}

/// The plate's faces are parallel to the wall's, so that many pairs of triangles are nearly the closest.
BOOST_AUTO_TEST_CASE(a_motion_and_its_reverse_cost_exactly_the_same_whatever_was_asked_before) {
    const Fixture f(0.5);
    const MinClearanceObjective least(f.si, f.window.scene);
    const ClearanceIntegralObjective integral(f.si, f.window.scene);
    const LengthWithClearanceObjective wanted(f.si, f.window.scene);
    testing::Random random(22);
    for (const ob::OptimizationObjective* objective :
         {static_cast<const ob::OptimizationObjective*>(&least),
          static_cast<const ob::OptimizationObjective*>(&integral),
          static_cast<const ob::OptimizationObjective*>(&wanted)}) {
        BOOST_TEST(objective->isSymmetric());
        for (int i = 0; i < testing::inForm(100, 40); ++i) {
            const bool isParallel = i % 2 == 0;
            const auto s1 = isParallel ? f.at(Vector3(-50, 0, 0) + random.inBox(15)) : randomState(f, random);
            const auto s2 = isParallel ? f.at(Vector3(-50, 0, 0) + random.inBox(15)) : randomState(f, random);
            const double there = cost(*objective, s1, s2);
            cost(*objective, s1, randomState(f, random));
            BOOST_TEST(cost(*objective, s2, s1) == there, objective->getDescription() << ", motion " << i);
        }
    }
}

BOOST_AUTO_TEST_CASE(a_cost_holds_for_both_directions_where_ompl_leaves_out_small_turns) {
    const Fixture f;
    const MinClearanceObjective objective(f.si, f.window.scene);
    const std::vector<double> few{1.5e-4}, all{1e-6, 5e-5, 1e-4, 1.5e-4, 3e-4};
    for (const double angle : testing::isFullRun() ? all : few) {
        // Along the wall, 0.02 from it, turned towards it at one end: the corner is 36 from the axis.
        const auto s1 = f.at({-32.02, -5, 30}),
                   s2 = f.at({-32.02, 5, 30}, angle, Vector3(0, 1, 1).normalized());
        const double found = cost(objective, s1, s2);
        BOOST_TEST(found > 0);
        BOOST_TEST(cost(objective, s2, s1) == found);
        for (const auto& [from, to] : {std::pair(&s1, &s2), std::pair(&s2, &s1)}) {
            const MotionReport report = f.report(*from, *to);
            BOOST_TEST(found <= report.upperClearance, "angle " << angle);
        }
    }
}

BOOST_AUTO_TEST_CASE(clearance_beyond_the_cap_is_as_good_as_the_cap) {
    const Fixture f;
    const MinClearanceObjective objective(f.si, f.window.scene);
    BOOST_TEST(objective.cap() == kInfinity);
    const auto far = f.at({-95, 0, -30});
    BOOST_TEST(objective.stateCost(far.get()).value() == 63, boost::test_tools::tolerance(1e-9));
    MinClearanceOptions options;
    options.cap = 5;
    const MinClearanceObjective capped(f.si, f.window.scene, options);
    const auto s1 = f.at({-60, 0, 30}), s2 = f.at({-50, 10, 20}, 0.5);
    BOOST_TEST(cost(objective, s1, s2) > 10);
    BOOST_TEST(cost(capped, s1, s2) == 5);
    BOOST_TEST(capped.stateCost(s1.get()).value() == 5);
    BOOST_TEST(capped.motionCostHeuristic(s1.get(), s2.get()).value() == 5);
    const auto close = f.at({-33, 0, 30});
    BOOST_TEST(capped.stateCost(close.get()).value() == 1, boost::test_tools::tolerance(1e-9));
    BOOST_TEST(cost(capped, s1, close) == 1, boost::test_tools::tolerance(0.11));
}

BOOST_AUTO_TEST_CASE(costs_combine_and_compare_as_ompls_own_bottleneck_does) {
    const Fixture f;
    const MinClearanceObjective ours(f.si, f.window.scene);
    const ob::MaximizeMinClearanceObjective theirs(f.si);
    const double costs[] = {-kInfinity, -kInvalidMotionCost, -1e-3, 0, 2, 2.5, 40, kInfinity};
    for (const double a : costs) {
        for (const double b : costs) {
            const ob::Cost c1(a), c2(b);
            BOOST_TEST(ours.isCostBetterThan(c1, c2) == theirs.isCostBetterThan(c1, c2));
            BOOST_TEST(ours.combineCosts(c1, c2).value() == theirs.combineCosts(c1, c2).value());
            BOOST_TEST(ours.isCostEquivalentTo(c1, c2) == theirs.isCostEquivalentTo(c1, c2));
        }
        BOOST_TEST(ours.isFinite(ob::Cost(a)) == theirs.isFinite(ob::Cost(a)));
        BOOST_TEST(ours.combineCosts(ob::Cost(a), ours.identityCost()).value() == a);
    }
    BOOST_TEST(ours.identityCost().value() == kInfinity);
    BOOST_TEST(ours.infiniteCost().value() == -kInfinity);
}

/// OMPL's default threshold of 0 would end every planner at its first path.
BOOST_AUTO_TEST_CASE(only_a_threshold_or_the_cap_satisfies) {
    const Fixture f;
    MinClearanceOptions options;
    options.cap = 50;
    MinClearanceObjective objective(f.si, f.window.scene, options);
    BOOST_TEST(!objective.isSatisfied(ob::Cost(0.9 * objective.cap())));
    BOOST_TEST(objective.isSatisfied(ob::Cost(objective.cap())));
    objective.setCostThreshold(ob::Cost(3));
    BOOST_TEST(!objective.isSatisfied(ob::Cost(3)));
    BOOST_TEST(objective.isSatisfied(ob::Cost(3.1)));
    objective.setCostThreshold(ob::Cost(2 * objective.cap()));
    BOOST_TEST(objective.isSatisfied(ob::Cost(objective.cap())));
}

BOOST_AUTO_TEST_CASE(a_path_costs_what_its_worst_motion_does_ends_included) {
    const Fixture f;
    const auto objective = std::make_shared<MinClearanceObjective>(f.si, f.window.scene);
    const auto start = f.at({-33, 0, 30}), between = f.at({-60, 0, 0}), goal = f.at({60, 0, 0});
    og::PathGeometric path(f.si, start.get());
    BOOST_TEST(path.cost(objective).value() == 1, boost::test_tools::tolerance(1e-9));
    path.append(between.get());
    path.append(goal.get());
    const double worst = std::min(cost(*objective, start, between), cost(*objective, between, goal));
    BOOST_TEST(path.cost(objective).value() == worst);
    BOOST_TEST(worst <= 1);
    BOOST_TEST(worst >= 1 - resolutionOf(1, kDiagonal));
    BOOST_TEST(objective->stateCost(f.at({0, 0, 30}).get()).value() == -kInvalidMotionCost);
    BOOST_TEST(objective->stateCost(f.at({-101, 0, 30}).get()).value() ==
               -kInvalidMotionCost);  // out of bounds
}

BOOST_AUTO_TEST_CASE(heuristics_are_never_worse_than_the_costs_they_stand_for) {
    const Fixture f;
    const MinClearanceObjective least(f.si, f.window.scene);
    const ClearanceIntegralObjective integral(f.si, f.window.scene);
    const LengthWithClearanceObjective wanted(f.si, f.window.scene);
    ob::GoalState goal(f.si);
    goal.setThreshold(0.5);
    testing::Random random(23);
    for (int i = 0; i < testing::inForm(100, 40); ++i) {
        const auto s1 = randomState(f, random), s2 = randomState(f, random);
        goal.setState(s2);
        for (const ob::OptimizationObjective* objective :
             {static_cast<const ob::OptimizationObjective*>(&least),
              static_cast<const ob::OptimizationObjective*>(&integral),
              static_cast<const ob::OptimizationObjective*>(&wanted)}) {
            const ob::Cost whole = objective->motionCost(s1.get(), s2.get());
            BOOST_TEST(objective->hasCostToGoHeuristic());
            BOOST_TEST(
                !objective->isCostBetterThan(whole, objective->motionCostHeuristic(s1.get(), s2.get())));
            BOOST_TEST(!objective->isCostBetterThan(whole, objective->costToGo(s1.get(), &goal)));
        }
        BOOST_TEST(wanted.costToGo(s1.get(), &goal).value() ==
                       std::max(0.0, f.si->distance(s1.get(), s2.get()) - 0.5),
                   boost::test_tools::tolerance(1e-12));
    }
}

BOOST_AUTO_TEST_CASE(an_objective_needs_no_setup) {
    const Fixture f;
    const auto space = makeSpace(Space::kSe3, Box(Vector3(-100, -60, -60), Vector3(100, 60, 60)), 1);
    const auto raw = std::make_shared<ob::SpaceInformation>(space);
    const MinClearanceObjective before(raw, f.window.scene), after(f.si, f.window.scene);
    const ClearanceIntegralObjective integralBefore(raw, f.window.scene), integralAfter(f.si, f.window.scene);
    const auto s1 = f.at({-60, 0, 0}), s2 = f.at({60, 0, 0}, 0.1);
    BOOST_TEST(!raw->isSetup());
    BOOST_TEST(cost(before, s1, s2) == cost(after, s1, s2));
    BOOST_TEST(cost(integralBefore, s1, s2) == cost(integralAfter, s1, s2));
}

BOOST_AUTO_TEST_CASE(what_cannot_be_judged_costs_the_worst_is_counted_and_logged_once) {
    const Fixture f;
    const MinClearanceObjective least(f.si, f.window.scene);
    const ClearanceIntegralObjective integral(f.si, f.window.scene);
    const auto fine = f.at({-60, 0, 0});
    auto noNumber = fine, noRotation = fine, notUnit = fine;
    noNumber->as<ob::SE3StateSpace::StateType>()->setX(std::nan(""));
    auto& zero = noRotation->as<ob::SE3StateSpace::StateType>()->rotation();
    zero.x = zero.y = zero.z = zero.w = 0;
    notUnit->as<ob::SE3StateSpace::StateType>()->rotation().w *= 1.001;
    testing::OmplLog log;
    for (const auto* wrong : {&noNumber, &noRotation, &notUnit}) {
        for (const auto& [a, b] : {std::pair(&fine, wrong), std::pair(wrong, &fine)}) {
            BOOST_TEST(cost(least, *a, *b) == -kInvalidMotionCost);
            BOOST_TEST(cost(integral, *a, *b) == kInvalidMotionCost);
        }
    }
    BOOST_TEST(least.counters().unusable == 6u);
    BOOST_TEST(integral.counters().unusable == 6u);
    BOOST_TEST(least.stateCost(noNumber.get()).value() == -kInvalidMotionCost);
    BOOST_TEST(integral.stateCost(noRotation.get()).value() == kInvalidMotionCost);
    BOOST_TEST(least.counters().unusable == 7u);
    BOOST_TEST(log.lines.size() == 2u);
}

BOOST_AUTO_TEST_CASE(another_space_works_through_callbacks) {
    const auto window = testing::windowScene();
    const auto space = std::make_shared<ob::RealVectorStateSpace>(1);  // along x, lying flat
    space->setBounds(-100, 100);
    const auto si = std::make_shared<ob::SpaceInformation>(space);
    testing::requireRefusedBy([&] { MinClearanceObjective(si, window.scene); }, {"is neither "});
    const auto xOf = [](const ob::State* state) {
        return state->as<ob::RealVectorStateSpace::StateType>()->values[0];
    };
    const StateToPose pose = [&](const ob::State* s) { return Pose{Matrix3::Identity(), {xOf(s), 0, 0}}; };
    const DisplacementBound bound = [&](const ob::State* a, const ob::State* b) {
        return std::abs(xOf(b) - xOf(a));
    };
    const MinClearanceObjective least(si, SharedScene(window.scene, pose, bound));
    const LengthWithClearanceObjective wanted(si, SharedScene(window.scene, pose, bound));
    ob::ScopedState<ob::RealVectorStateSpace> a(space), b(space);
    a[0] = -60, b[0] = 60;
    BOOST_TEST(cost(least, a, b) == 11, boost::test_tools::tolerance(0.011));
    // The objective wants less than 11.
    BOOST_TEST(cost(wanted, a, b) == 120, boost::test_tools::tolerance(0.1));
    testing::requireRefusedBy([&] { ClearanceIntegralObjective(si, SharedScene(window.scene, pose)); },
                              {"displacement bound is empty"});
}

/// A plate rests on a tray that is ignored until the plate has moved by 4.
BOOST_AUTO_TEST_CASE(obstacles_count_where_no_contact_zone_leaves_them_out) {
    const Mesh plate = testing::box({30, 20, 5}, 2);
    const Mesh tray = testing::translated(testing::box({40, 30, 5}, 2), {0, 0, -10});
    Scene scene(Model::build(plate), Model::build(tray));
    scene.obstacles[0].isIgnoredAtStart = true;
    scene.startContact = ContactZone{Pose{}, 4};
    const testing::PartInSpace f(scene);
    const MinClearanceObjective least(f.si, scene);
    const LengthWithClearanceObjective wanted(f.si, scene);
    const auto rest = f.at({0, 0, 0}), lifted = f.at({0, 0, 3}), up = f.at({0, 0, 30}), in = f.at({0, 0, -5});
    const double found = cost(least, rest, up);
    BOOST_TEST(found <= 4);
    BOOST_TEST(found >= 4 - resolutionOf(4, kDiagonal));
    BOOST_TEST(cost(least, up, rest) == found);
    BOOST_TEST(cost(least, rest, lifted) == least.cap());
    BOOST_TEST(cost(least, up, in) == -kInvalidMotionCost);
    BOOST_TEST(cost(wanted, rest, up) >= 30);
    BOOST_TEST(cost(wanted, rest, up) <= 30 * 11);
    BOOST_TEST(cost(wanted, up, in) == kInvalidMotionCost);
}

BOOST_AUTO_TEST_CASE(a_reach_bounds_the_clearance_told) {
    const Fixture f(2);
    const QueryRange range{Box(Vector3(-101, -61, -61), Vector3(101, 61, 61)),
                           f.window.scene.part.radiusAboutOrigin(), 6};
    const Mesh environment =
        testing::joined(f.window.wallMesh, testing::translated(f.window.wallMesh, {400, 0, 0}));
    const Scene reduced{f.window.scene.part, Model::build(environment, {}, range), 2};
    const MinClearanceObjective objective(f.si, reduced), whole(f.si, f.window.scene);
    BOOST_TEST(objective.cap() == 4);
    const auto s1 = f.at({-90, 0, 0}), s2 = f.at({-80, 0, 0}), close = f.at({-35, 0, 30});
    BOOST_TEST(cost(objective, s1, s2) <= 4);
    BOOST_TEST(cost(objective, s1, s2) >= 4 - resolutionOf(4, kDiagonal));
    BOOST_TEST(cost(objective, s1, close) == cost(whole, s1, close), boost::test_tools::tolerance(0.1));
    QueryRange small = range;
    small.cap = 2;
    const Scene tooSmall{f.window.scene.part, Model::build(environment, {}, small), 2};
    testing::requireRefusedBy([&] { MinClearanceObjective(f.si, tooSmall); },
                              {"a range that ends 0 beyond its margin"});
}

BOOST_AUTO_TEST_CASE(wrong_options_and_a_missing_scene_are_refused) {
    const Fixture f;
    for (const double wrong : {0.0, -1.0, std::nan(""), kInfinity}) {
        MinClearanceOptions least;
        least.cap = wrong;
        testing::requireRefusedBy([&] { MinClearanceObjective(f.si, f.window.scene, least); }, {"cap is "});
        ClearanceIntegralOptions integral;
        integral.reference = wrong;
        testing::requireRefusedBy([&] { ClearanceIntegralObjective(f.si, f.window.scene, integral); },
                                  {"reference is "});
        integral = {};
        integral.floor = wrong;
        testing::requireRefusedBy([&] { ClearanceIntegralObjective(f.si, f.window.scene, integral); },
                                  {"floor is "});
        integral = {};
        integral.resolution = wrong;
        testing::requireRefusedBy([&] { ClearanceIntegralObjective(f.si, f.window.scene, integral); },
                                  {"resolution is "});
        LengthWithClearanceOptions wanted;
        wanted.wanted = wrong;
        testing::requireRefusedBy([&] { LengthWithClearanceObjective(f.si, f.window.scene, wanted); },
                                  {"wanted clearance is "});
    }
    for (const double wrong : {-1.0, std::nan(""), kInfinity}) {
        LengthWithClearanceOptions wanted;
        wanted.strictness = wrong;
        testing::requireRefusedBy([&] { LengthWithClearanceObjective(f.si, f.window.scene, wanted); },
                                  {"strictness is "});
        if (wrong == kInfinity) continue;
        Scene scene = f.window.scene;
        scene.obstacles[0].margin = wrong;
        testing::requireRefusedBy([&] { MinClearanceObjective(f.si, scene); }, {"margin is "});
    }
    testing::requireRefusedBy([&] { MinClearanceObjective(nullptr, f.window.scene); },
                              {"space information is null"});
    testing::requireRefusedBy([&] { sceneOf(nullptr); }, {"space information is null"});
    testing::requireRefusedBy([&] { sceneOf(std::make_shared<ob::SpaceInformation>(f.space)); },
                              {"there is no scene"});
    BOOST_TEST(MinClearanceObjective(f.si, sceneOf(f.si)).scene().obstacles.size() == 1u);
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::planning
