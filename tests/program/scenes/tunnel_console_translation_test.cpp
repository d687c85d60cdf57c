// The console cannot leave its tunnel by translation alone: flooded on a grid, and tried with a planner.
#include <ompl/util/Console.h>

#include <boost/test/data/monomorphic.hpp>
#include <boost/test/data/test_case.hpp>
#include <boost/test/unit_test.hpp>

#include "program/scenes/scenes.h"
#include "program/scenes/toy_checks.h"

using namespace clearway;
using namespace clearway::scenes;
using namespace clearway::testing;

namespace {

BuiltScene make(int version) {
    return BuiltScene(sceneNamed("tunnel-console-" + std::to_string(version)).make(kTunnelConsole));
}

const auto kVersions = boost::unit_test::data::make({1, 2});

BOOST_AUTO_TEST_SUITE(tunnel_console_translation)  // its cases share names with other scenes' cases

BOOST_DATA_TEST_CASE(a_flood_of_translations_stays_near_the_start, kVersions, version) {
    const Flood found = flood(make(version), 3, 150);  // mm of the 900 mm to go
    BOOST_TEST_MESSAGE(found.freeCells << " free cells");
    BOOST_TEST(found.freeCells > 27);
    BOOST_TEST(!found.isOut);
}

/// Two seeds, a few seconds each; with CLEARWAY_FULL=1 five of 30 s.
BOOST_DATA_TEST_CASE(a_planner_that_only_translates_finds_nothing, kVersions, version) {
    ompl::msg::setLogLevel(ompl::msg::LOG_NONE);
    const BuiltScene made = make(version);
    Workspace workspace;
    BOOST_REQUIRE(made.isFree(translatedGoal(made), workspace));
    for (std::uint32_t seed = 1; seed <= (isFull() ? 5 : 2); ++seed) {
        BOOST_TEST(!translatesOut(made, 10, seed, isFull() ? 30 : 3), "seed " << seed);
    }
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace
