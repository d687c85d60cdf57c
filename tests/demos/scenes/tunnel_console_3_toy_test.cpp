// The tunnel console at full size is no toy: the checks of the small scenes, and the
// reach of planners in their first motions. Each check also runs on a toy: the console above a bare floor.
#include <ompl/util/Console.h>
#include <ompl/util/RandomNumbers.h>

#include <array>
#include <boost/test/data/monomorphic.hpp>
#include <boost/test/data/test_case.hpp>
#include <boost/test/unit_test.hpp>
#include <cstdlib>
#include <deque>
#include <map>
#include <optional>
#include <set>
#include <vector>

#include "core/number.h"
#include "demos/scenes/scene_checks.h"
#include "demos/scenes/scenes.h"
#include "mesh/components.h"
#include "planning/plan/plan_setup.h"
#include "support/full_run.h"

namespace {

struct QuietPlanners {
    QuietPlanners() { ompl::msg::setLogLevel(ompl::msg::LOG_NONE); }
};

}  // namespace

BOOST_AUTO_TEST_SUITE(tunnel_console_3_toy_test, *boost::unit_test::fixture<QuietPlanners>())

using namespace clearway;
using namespace clearway::scenes;
using namespace clearway::testing;

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

/// The scene whose environment is only the components with names that begin with the stem.
GeneratedScene keeping(const std::string& stem, const GeneratedScene& scene) {
    std::vector<std::size_t> those;
    for (std::size_t i = 0; i < scene.environment.components.size(); ++i) {
        if (scene.environment.components[i].name.rfind(stem, 0) == 0) those.push_back(i);
    }
    GeneratedScene kept = scene;
    kept.environment = meshOfComponents(scene.environment, those);
    return kept;
}

struct StraightMotion {
    double colliding = 0;  ///< share of its poses that collide
    std::size_t hit = 0;   ///< number of components hit, counting the closest one of each pose
};

/// The straight motion from start to goal, as a planner interpolates.
StraightMotion straightMotion(const BuiltScene& made) {
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
Flood flood(const BuiltScene& made, double cellSize, double out) {
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
TrialEnd firstMotions(const BuiltScene& made, const Trial& trial, std::size_t motions) {
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

GeneratedScene fullSize(double clearance) {
    SceneOptions options = kTunnelConsole3;
    options.clearance = clearance;
    return makeTunnelConsole3(options);
}

/// The built scene, made once for each clearance.
const BuiltScene& real(double clearance) {
    static std::map<double, BuiltScene> made;
    const auto found = made.find(clearance);
    return found != made.end() ? found->second : made.emplace(clearance, fullSize(clearance)).first->second;
}

const BuiltScene& toy() {
    static const BuiltScene kToy(keeping("floor_pan", real(10).scene));
    return kToy;
}

/// Clearances, of which 2 mm is only tried with CLEARWAY_FULL=1: what finds a way there would find one at 10 mm.
const auto kClearances =
    boost::unit_test::data::make(isFullRun() ? std::vector<double>{10, 2} : std::vector<double>{10});
const auto kPlanners = boost::unit_test::data::make({"RRTConnect", "RRT"});

constexpr double kOut = 150;         // mm of the 900 mm to go
constexpr std::size_t kFirst = 100;  // motions

/// A hundred edges of `plan`'s length are hardly as long as the straight way, and RRT's edges do not go straight. So planners also run with
/// edges of any length, of which one could be the whole way.
constexpr double kAnyLength = 1e5;
const std::optional<double> kRanges[] = {std::nullopt, kAnyLength};

std::uint32_t seedCount() {
    return isFullRun() ? 300 : 40;
}

BOOST_DATA_TEST_CASE(the_straight_motion_collides_over_half_its_length_with_three_components, kClearances,
                     clearance) {
    const StraightMotion motion = straightMotion(real(clearance));
    BOOST_TEST(motion.colliding >= 0.5);
    BOOST_TEST(motion.hit >= 3);
}

BOOST_DATA_TEST_CASE(a_flood_of_translations_stays_near_the_start, kClearances, clearance) {
    // A cell's diagonal is less than the clearance; the narrow scene then has few free cells.
    const Flood found = flood(real(clearance), clearance == 10 ? 4 : 1, kOut);
    BOOST_TEST_MESSAGE(found.freeCells << " free cells");
    BOOST_TEST(found.freeCells > 27);
    BOOST_TEST(!found.isOut);
}

/// Planners run as in `plan`. With CLEARWAY_FULL=1 there are many more seeds.
BOOST_DATA_TEST_CASE(no_seed_solves_it_within_its_first_100_motions, kPlanners* kClearances, planner,
                     clearance) {
    for (const std::optional<double>& range : kRanges) {
        std::set<double> drawn;
        for (std::uint32_t seed = 1; seed <= seedCount(); ++seed) {
            const TrialEnd end = firstMotions(real(clearance), {planner, seed, range}, kFirst);
            BOOST_TEST(!end.isSolved, "seed " << seed);
            BOOST_TEST(end.motions >= kFirst, "seed " << seed);
            drawn.insert(end.drawn);
        }
        BOOST_TEST(drawn.size() == seedCount());  // all runs differ
    }
}

BOOST_AUTO_TEST_CASE(a_toy_is_told_by_its_straight_motion_and_its_translations) {
    BOOST_TEST(straightMotion(toy()).colliding == 0);
    BOOST_TEST(flood(toy(), 25, kOut).isOut);
}

BOOST_AUTO_TEST_CASE(a_toy_is_told_by_its_first_100_motions) {
    for (std::uint32_t seed = 1; seed <= 5; ++seed) {
        BOOST_TEST(firstMotions(toy(), {"RRTConnect", seed, {}}, kFirst).isSolved, "seed " << seed);
        for (const char* planner : {"RRTConnect", "RRT"}) {
            BOOST_TEST(firstMotions(toy(), {planner, seed, kAnyLength}, kFirst).isSolved,
                       planner << ", seed " << seed);
        }
    }
}

BOOST_AUTO_TEST_SUITE_END()
