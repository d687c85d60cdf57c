#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <functional>

#include "clearway/planning/clearance_objectives.h"
#include "support/full_run.h"
#include "support/motion_scene.h"
#include "support/motion_window.h"
#include "support/random_meshes.h"

namespace clearway::planning {
BOOST_AUTO_TEST_SUITE(weighted_length_objectives_test)

using Fixture = testing::MotionWindow;
using Extra = std::function<double(double clearance)>;

double cost(const ob::OptimizationObjective& objective, const ob::ScopedState<>& a,
            const ob::ScopedState<>& b) {
    return objective.motionCost(a.get(), b.get()).value();
}

/// The length times the mean of 1 + extra at the middles of equal parts of the motion.
double weightedLength(const testing::MotionScene& scene, const ob::ScopedState<>& a,
                      const ob::ScopedState<>& b, int parts, const Extra& extra) {
    ob::ScopedState<> between(scene.space);
    double sum = 0;
    for (int i = 0; i < parts; ++i) {
        scene.space->interpolate(a.get(), b.get(), (i + 0.5) / parts, between.get());
        sum += 1 + extra(std::max(0.0, scene.checker->clearance(between.get())));
    }
    return scene.space->distance(a.get(), b.get()) * sum / parts;
}

struct Judged {
    int motions = 0;
    double worst = 0;  ///< the largest error of a cost, as a share of the truth
};

Judged judge(const testing::MotionScene& scene, const ob::OptimizationObjective& objective,
             const Extra& extra) {
    Judged judged;
    const double diagonal = scene.scene.part.box().diagonal().norm();
    testing::Random random(31);
    for (int i = 0; i < testing::inForm(40, 15); ++i) {
        const double reach = i % 3 == 0 ? 0.2 : 0.02, turn = 3 * reach;
        const auto s1 = scene.state(scene.nearPath(random, reach * diagonal, turn));
        const auto s2 = scene.state(scene.nearPath(random, reach * diagonal, turn));
        if (!scene.validator->checkMotion(s1.get(), s2.get())) continue;
        const double found = cost(objective, s1, s2), truth = weightedLength(scene, s1, s2, 1000, extra);
        judged.worst = std::max(judged.worst, std::abs(found - truth) / truth);
        ++judged.motions;
        BOOST_TEST(found >= scene.space->distance(s1.get(), s2.get()));
    }
    return judged;
}

BOOST_AUTO_TEST_CASE(a_cost_is_the_integral_of_the_stated_weight_to_the_resolution) {
    int motions = 0;
    for (const auto& scene : testing::motionScenes()) {
        const double diagonal = scene->scene.part.box().diagonal().norm();
        for (const double resolution : {0.1, 0.02}) {
            ClearanceIntegralOptions integral;
            integral.resolution = resolution;
            const double reference = 0.05 * diagonal, floor = 1e-3 * diagonal, cap = diagonal;
            const Judged closeness = judge(
                *scene, ClearanceIntegralObjective(scene->si, scene->scene, integral),
                [&](double c) { return c < cap ? reference / (c + floor) - reference / (cap + floor) : 0; });
            LengthWithClearanceOptions wanted;
            wanted.resolution = resolution;
            const Judged length =
                judge(*scene, LengthWithClearanceObjective(scene->si, scene->scene, wanted),
                      [&](double c) { return 10 * std::max(0.0, 1 - c / (0.05 * diagonal)); });
            BOOST_TEST_MESSAGE(scene->name << ": off by " << closeness.worst << " and " << length.worst);
            BOOST_TEST(closeness.worst < resolution + 1e-3, scene->name << ", seed 31");
            BOOST_TEST(length.worst < resolution + 1e-3, scene->name << ", seed 31");
            motions += closeness.motions + length.motions;
        }
    }
    BOOST_TEST(motions > testing::inForm(200, 75));
}

BOOST_AUTO_TEST_CASE(poses_are_looked_at_where_it_is_close_and_not_by_a_step) {
    const Fixture f;
    const ClearanceIntegralObjective integral(f.si, f.window.scene);
    const LengthWithClearanceObjective wanted(f.si, f.window.scene);
    const auto queriesOf = [](const ClearanceObjective& objective, const ob::ScopedState<>& a,
                              const ob::ScopedState<>& b) {
        const std::uint64_t before = objective.counters().queries;
        objective.motionCost(a.get(), b.get());
        return objective.counters().queries - before;
    };
    // Motions of equal length: away from the wall, along it, and along it at a distance of 0.2.
    const auto far = queriesOf(wanted, f.at({-60, -30, 0}), f.at({-60, 30, 0}));
    const auto near = queriesOf(wanted, f.at({-34, -30, 0}), f.at({-34, 30, 0}));
    BOOST_TEST(far <= 5u);
    BOOST_TEST(near > 2 * far);
    BOOST_TEST(cost(wanted, f.at({-60, -30, 0}), f.at({-60, 30, 0})) == 60,
               boost::test_tools::tolerance(1e-9));
    const auto off = queriesOf(integral, f.at({-60, -30, 0}), f.at({-60, 30, 0}));
    const auto along = queriesOf(integral, f.at({-34, -30, 0}), f.at({-34, 30, 0}));
    const auto close = queriesOf(integral, f.at({-32.2, -30, 0}), f.at({-32.2, 30, 0}));
    BOOST_TEST(along > 2 * off);
    BOOST_TEST(close > 2 * along);
}

BOOST_AUTO_TEST_CASE(a_way_that_keeps_off_costs_less_than_a_shorter_one_that_does_not) {
    const Fixture f;
    const ClearanceIntegralObjective integral(f.si, f.window.scene);
    const LengthWithClearanceObjective wanted(f.si, f.window.scene);
    const auto a = f.at({-32.5, -30, 30}), b = f.at({-32.5, 30, 30});
    const auto offA = f.at({-42, -25, 30}), offB = f.at({-42, 25, 30});
    for (const ob::OptimizationObjective* objective :
         {static_cast<const ob::OptimizationObjective*>(&integral),
          static_cast<const ob::OptimizationObjective*>(&wanted)}) {
        const double straight = cost(*objective, a, b);
        const double round =
            cost(*objective, a, offA) + cost(*objective, offA, offB) + cost(*objective, offB, b);
        BOOST_TEST(round < straight, objective->getDescription());
    }
}

BOOST_AUTO_TEST_CASE(motions_that_collide_cost_the_worst_however_thin_the_wall) {
    const Fixture f;
    const ClearanceIntegralObjective integral(f.si, f.window.scene);
    const LengthWithClearanceObjective wanted(f.si, f.window.scene);
    const auto s1 = f.at({-90, 0, 30}), s2 = f.at({90, 0, 30}), in = f.at({0, 0, 30});
    for (const ClearanceObjective* objective : {static_cast<const ClearanceObjective*>(&integral),
                                                static_cast<const ClearanceObjective*>(&wanted)}) {
        BOOST_TEST(cost(*objective, s1, s2) == kInvalidMotionCost);
        BOOST_TEST(cost(*objective, s1, in) == kInvalidMotionCost);
        BOOST_TEST(objective->counters().invalid == 2u);
        BOOST_TEST(objective->stateCost(in.get()).value() == kInvalidMotionCost);
        BOOST_TEST(objective->stateCost(s1.get()).value() >= 1);
    }
    BOOST_TEST(wanted.stateCost(f.at({-33, 0, 30}).get()).value() ==
                   1 + 10 * (1 - 1 / (0.05 * Vector3(60, 40, 10).norm())),
               boost::test_tools::tolerance(1e-9));
}

BOOST_AUTO_TEST_CASE(a_motion_of_no_length_and_one_without_obstacles_have_their_lengths) {
    const Fixture f;
    const Scene empty(f.window.scene.part);
    const ClearanceIntegralObjective integral(f.si, f.window.scene), alone(f.si, empty);
    const MinClearanceObjective least(f.si, empty);
    const auto s1 = f.at({-33, 0, 30}), s2 = f.at({33, 0, 30}, 1);
    BOOST_TEST(cost(integral, s1, s1) == 0);
    BOOST_TEST(cost(alone, s1, s2) == f.space->distance(s1.get(), s2.get()));
    BOOST_TEST(cost(least, s1, s2) == least.cap());
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::planning
