#include "demos/study/replay.h"

#include <boost/test/unit_test.hpp>

namespace clearway::testing {

BOOST_AUTO_TEST_SUITE(replay_test)

using namespace study;
namespace {

using Places = std::vector<std::size_t>;

BOOST_AUTO_TEST_CASE(slow_planners_have_fewer_blocks_replayed_evenly_spread) {
    const auto count = [](double secondsPerCall) { return replayedBlocks(32, 32, secondsPerCall).size(); };
    BOOST_TEST(count(0) == 32u);
    BOOST_TEST(count(0.1 / 1024) == 32u);
    BOOST_TEST(count(0.2 / 1024) == 16u);
    BOOST_TEST(count(10) == 4u);
    BOOST_TEST(replayedBlocks(32, 32, 10) == Places({0, 8, 16, 24}), boost::test_tools::per_element());
    BOOST_TEST(replayedBlocks(3, 32, 10) == Places({0, 1, 2}), boost::test_tools::per_element());
    BOOST_TEST(replayedBlocks(0, 32, 10).empty());
}

RunRow run(const char* planner, int seed, double querySeconds) {
    RunRow row;
    row.scene = "s";
    row.planner = planner;
    row.seed = seed;
    row.stateChecks = 6;
    row.motionChecks = 3;
    row.motionCosts = 1;
    row.querySeconds = querySeconds;
    return row;
}

BOOST_AUTO_TEST_CASE(a_planner_is_as_slow_as_its_middle_run_with_the_seed) {
    const std::vector<RunRow> runs = {run("P", 1, 1), run("P", 1, 2), run("P", 1, 9), run("P", 2, 50),
                                      run("Q", 1, 70)};
    BOOST_TEST(querySecondsPerCall(runs, "s", "P", 1) == 0.2);
    BOOST_TEST(querySecondsPerCall(runs, "s", "Q", 1) == 7);
    BOOST_TEST(querySecondsPerCall(runs, "other", "P", 1) == 0);
}

}  // namespace
BOOST_AUTO_TEST_SUITE_END()

}  // namespace clearway::testing
