// The tunnel console at full size is no toy: the checks of the small scenes, and the
// reach of planners in their first motions. Each check also runs on a toy: the console above a bare floor.
#include <ompl/util/Console.h>

#include <boost/test/data/monomorphic.hpp>
#include <boost/test/data/test_case.hpp>
#include <boost/test/unit_test.hpp>
#include <map>
#include <optional>
#include <set>
#include <vector>

#include "demos/scenes/scenes.h"
#include "demos/scenes/toy_checks.h"

namespace {

struct QuietPlanners {
    QuietPlanners() { ompl::msg::setLogLevel(ompl::msg::LOG_NONE); }
};

}  // namespace

BOOST_AUTO_TEST_SUITE(tunnel_console_3_toy_test, *boost::unit_test::fixture<QuietPlanners>())

using namespace clearway;
using namespace clearway::scenes;
using namespace clearway::testing;

namespace {

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
    static const BuiltScene kToy(keeping(real(10).scene, {"floor_pan"}));
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

}  // namespace

BOOST_AUTO_TEST_SUITE_END()
