// Checks that a scene is no toy: how far translations lead, how much the straight motion collides, and what
// planners find at once.
#pragma once

#include <ompl/util/RandomNumbers.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <deque>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/number.h"
#include "demos/scenes/scene_checks.h"
#include "planning/plan/plan_setup.h"
#include "support/full_run.h"

namespace clearway::testing {

/// A scene with trees that are built quickly.
struct BuiltScene {
    explicit BuiltScene(GeneratedScene made) : scene(std::move(made)) {}

    GeneratedScene scene;
    Model part = Model::build(scene.part);
    Model environment = Model::build(scene.environment);

    bool isFree(const PartState& state, Workspace& workspace) const {
        return !collides(part, environment, poseOf(state), workspace);
    }
};

/// The scene whose environment is only the components with names that begin with one of the stems.
inline GeneratedScene keeping(const GeneratedScene& scene, const std::vector<std::string>& stems) {
    GeneratedScene kept = scene;
    kept.environment.triangles.clear();
    kept.environment.components.clear();
    for (Component component : scene.environment.components) {
        const auto begins = [&](const std::string& stem) { return component.name.rfind(stem, 0) == 0; };
        if (std::none_of(stems.begin(), stems.end(), begins)) continue;
        const auto first = scene.environment.triangles.begin() + component.firstTriangle;
        component.firstTriangle = static_cast<std::uint32_t>(kept.environment.triangles.size());
        kept.environment.triangles.insert(kept.environment.triangles.end(), first,
                                          first + component.triangleCount);
        kept.environment.components.push_back(component);
    }
    return kept;
}

struct StraightMotion {
    double colliding = 0;  ///< share of its poses that collide
    std::size_t hit = 0;   ///< number of components hit, counting the closest one of each pose
};

/// The straight motion from start to goal, as a planner interpolates.
inline StraightMotion straightMotion(const BuiltScene& made) {
    constexpr int kSamples = 200;
    Workspace workspace;
    int collisions = 0;
    std::set<int> hit;
    for (int i = 0; i < kSamples; ++i) {
        const PartState state =
            between(made.scene.path.front(), made.scene.path.back(), (i + 0.5) / kSamples);
        const DistanceResult found = distance(made.part, made.environment, poseOf(state), {}, workspace);
        if (!found.collides()) continue;
        ++collisions;
        hit.insert(found.witness->environmentComponent);
    }
    return {static_cast<double>(collisions) / kSamples, hit.size()};
}

struct Flood {
    std::size_t freeCells = 0;
    bool isOut = false;  ///< a free cell is at least `out` away along an axis
};

/// Floods the translations from the start. Neighbouring free cells count as connected, even if something lies
/// between them. So the flood goes too far rather than not far enough.
inline Flood flood(const BuiltScene& made, double cellSize, double out) {
    using Cell = std::array<int, 3>;
    Workspace workspace;
    const auto isFree = [&](const Cell& cell) {
        PartState state = made.scene.problem.start;
        state.position += cellSize * Vector3(cell[0], cell[1], cell[2]);
        return made.isFree(state, workspace);
    };
    std::set<Cell> seen{{0, 0, 0}};
    std::deque<Cell> open{{0, 0, 0}};
    Flood result;
    while (!open.empty() && !result.isOut) {
        const Cell cell = open.front();
        open.pop_front();
        if (!isFree(cell)) continue;
        ++result.freeCells;
        for (const int steps : cell) result.isOut = result.isOut || std::abs(steps) * cellSize >= out;
        for (int i = 0; i < 27; ++i) {
            const Cell next{cell[0] + i % 3 - 1, cell[1] + i / 3 % 3 - 1, cell[2] + i / 9 - 1};
            if (seen.insert(next).second) open.push_back(next);
        }
    }
    return result;
}

/// A run of one planner.
struct Trial {
    std::string planner;
    std::uint32_t seed = 1;
    std::optional<double> range;  ///< longest edge of its trees; empty: the edge that `plan` sets
};

struct TrialEnd {
    bool isSolved = false;
    std::size_t motions = 0;  ///< checked motions
    double drawn = 0;         ///< a random number after the run, which distinguishes seeds
};

/// Runs the planner as `plan` does and stops it after `motions` checked motions.
inline TrialEnd firstMotions(const BuiltScene& made, const Trial& trial, std::size_t motions) {
    planning::PlanOptions options;
    options.planner = trial.planner;
    options.seed = trial.seed;
    options.threads = 1;
    if (trial.range) options.parameters = {{"range", formatNumber(*trial.range)}};
    planning::PlanReport report;
    const planning::PlanSetup setup =
        planning::makePlanSetup(made.scene.problem, Scene(made.part, made.environment), options, report);
    const auto checked = [&] {
        const planning::MotionCounters counters = setup.certified->counters();
        return static_cast<std::size_t>(counters.valid + counters.invalid);
    };
    setup.planners.at(0)->solve(
        ompl::base::PlannerTerminationCondition([&] { return checked() >= motions; }));
    return {setup.definition->hasExactSolution(), checked(), ompl::RNG().uniform01()};
}

}  // namespace clearway::testing
