#include "demos/study/statistics.h"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <random>

namespace clearway::testing {

BOOST_AUTO_TEST_SUITE(statistics_test)

using namespace study;
namespace {

const StatisticRow& find(const std::vector<StatisticRow>& rows, const std::string& measure,
                         const std::string& planner, const std::string& instructions = "best") {
    for (const StatisticRow& row : rows) {
        if (row.measure == measure && row.planner == planner && row.instructions == instructions) return row;
    }
    BOOST_FAIL("no such row among " << rows.size());
    return rows.front();
}

const SummaryRow& find(const std::vector<SummaryRow>& rows, const std::string& planner,
                       const std::string& leafSplit) {
    for (const SummaryRow& row : rows) {
        if (row.planner == planner && row.leafSplit == leafSplit) return row;
    }
    BOOST_FAIL("no such row among " << rows.size());
    return rows.front();
}

template <class Row>
Row rowOf(const std::string& leaf, int seed) {
    Row row;
    row.scene = "s";
    row.planner = "P";
    row.generalSplit = "sah";
    row.leafSplit = leaf;
    row.seed = seed;
    row.distanceQueries = 10;
    row.withinQueries = 10;
    row.volumeTests = 400;
    row.triangleTests = 100;
    row.triangleLanes = 200;
    row.kernelPairs = 30;
    row.kernelLanes = 120;
    return row;
}

RunRow run(const std::string& leaf, int seed, double first, bool isSolved = true) {
    auto row = rowOf<RunRow>(leaf, seed);
    row.isSolved = isSolved;
    row.seconds = first;
    if (isSolved) row.firstSolutionSeconds = first;
    row.stateChecks = 60;
    row.motionChecks = 40;
    row.querySeconds = first / 4;
    return row;
}

BOOST_AUTO_TEST_CASE(medians_are_those_in_the_middle) {
    BOOST_TEST(median({3}) == 3);
    BOOST_TEST(median({5, 1}) == 3);
    BOOST_TEST(median({9, 1, 2}) == 2);
    BOOST_TEST(median({4, 1, 3, 2}) == 2.5);
}

BOOST_AUTO_TEST_CASE(a_ratio_that_is_always_the_same_has_no_doubt) {
    const PairedRatio ratio = pairedRatio({{2, 2}, {}, {2}});
    BOOST_TEST(ratio.median == 2);
    BOOST_TEST(ratio.low == 2);
    BOOST_TEST(ratio.high == 2);
    BOOST_TEST(ratio.pairs == 3u);
    BOOST_TEST(ratio.clusters == 2u);
    BOOST_TEST(pairedRatio({{}, {}}).pairs == 0u);
}

/// The median of n values has a standard error of about 1.25 / sqrt(n) of their deviation. An interval of 95
/// in 100 reaches twice that far to each side.
BOOST_AUTO_TEST_CASE(the_interval_is_as_wide_as_statistics_say_and_mostly_holds_the_truth) {
    std::mt19937_64 random(7);
    std::normal_distribution<double> noise(0, 0.1);
    constexpr int kTries = 100, kClusters = 100;
    int held = 0;
    for (int i = 0; i < kTries; ++i) {
        std::vector<std::vector<double>> clusters;
        for (int k = 0; k < kClusters; ++k) clusters.push_back({1.3 + noise(random)});
        const PairedRatio ratio = pairedRatio(clusters);
        held += ratio.low <= 1.3 && 1.3 <= ratio.high;
        const double halfWidth = (ratio.high - ratio.low) / 2,
                     expected = 1.96 * 1.2533 * 0.1 / std::sqrt(kClusters);
        BOOST_TEST(halfWidth > 0.4 * expected);
        BOOST_TEST(halfWidth < 2 * expected);
        BOOST_TEST((ratio.low <= ratio.median && ratio.median <= ratio.high));
    }
    BOOST_TEST(held >= 88);
    BOOST_TEST(held <= 100);
}

/// Pairs of one run depend on each other: ten times as many of them make the ratio no surer.
BOOST_AUTO_TEST_CASE(pairs_of_one_run_are_drawn_together) {
    std::mt19937_64 random(8);
    std::normal_distribution<double> noise(0, 0.1);
    std::vector<std::vector<double>> alone, together;
    for (int k = 0; k < 40; ++k) {
        const double ratio = 1 + noise(random);
        alone.push_back({ratio});
        together.push_back(std::vector<double>(10, ratio));
    }
    const PairedRatio a = pairedRatio(alone), b = pairedRatio(together);
    BOOST_TEST(b.median == a.median);
    BOOST_TEST((b.high - b.low) > 0.7 * (a.high - a.low));
}

BOOST_AUTO_TEST_CASE(runs_count_alike_however_many_pairs_they_have) {
    const PairedRatio ratio = pairedRatio({std::vector<double>(100, 1), {2, 2, 9}, {3}});
    BOOST_TEST(ratio.median == 2);
    BOOST_TEST(ratio.pairs == 104u);
    BOOST_TEST(ratio.clusters == 3u);
}

BOOST_AUTO_TEST_CASE(runs_are_compared_with_those_of_their_seed) {
    std::vector<RunRow> runs;
    for (int seed = 1; seed <= 5; ++seed) {  // seeds differ tenfold by luck, strategies by half
        runs.push_back(run("none", seed, seed * seed));
        runs.push_back(run("chain", seed, 1.5 * seed * seed));
    }
    runs.push_back(run("none", 6, 3));
    runs.push_back(run("chain", 6, 3, false));  // no pair for the first solution
    const auto statistics = statisticsOf(runs, {}, "none");
    const StatisticRow& first = find(statistics, "first_solution_seconds", "P");
    BOOST_TEST(first.leafSplit == "chain");
    BOOST_TEST(first.median == 1.5);
    BOOST_TEST(first.low == 1.5);
    BOOST_TEST(first.pairs == 5u);
    const StatisticRow& each = find(statistics, "seconds_per_call", "all");
    BOOST_TEST(each.pairs == 6u);
    for (const StatisticRow& row : statistics) BOOST_TEST(row.measure != "cost");

    const auto summary = summaryOf(runs, {});
    const SummaryRow& chain = find(summary, "P", "chain");
    BOOST_TEST(chain.runs.value() == 6u);
    BOOST_TEST(chain.solved.value() == 5u);
    BOOST_TEST(chain.firstSolutionSeconds.value() == 13.5);
    BOOST_TEST(chain.queryShare.value() == 0.25);
    BOOST_TEST(chain.volumeTests.value() == 20);
    BOOST_TEST(chain.blockFill.value() == 0.5);
    BOOST_TEST(chain.kernelFill.value() == 0.25);
}

/// Without such pairs, only those in which the slower strategy was quick would remain.
BOOST_AUTO_TEST_CASE(a_run_that_found_nothing_counts_as_one_that_found_at_its_end) {
    constexpr double kNone = -1;
    const auto ratioOfFirst = [](const std::vector<RunRow>& runs) -> double {
        for (const StatisticRow& row : statisticsOf(runs, {}, "none")) {
            if (row.measure == "first_solution_seconds") return row.median;
        }
        return kNone;
    };
    BOOST_TEST(ratioOfFirst({run("none", 1, 4), run("all", 1, 20, false)}) == 5);
    BOOST_TEST(ratioOfFirst({run("none", 1, 20, false), run("all", 1, 5)}) == 0.25);
    BOOST_TEST(ratioOfFirst({run("none", 1, 20, false), run("all", 1, 20, false)}) == kNone);
    // A run that gave up earlier says nothing.
    BOOST_TEST(ratioOfFirst({run("none", 1, 4), run("all", 1, 3, false)}) == kNone);
    BOOST_TEST(ratioOfFirst({run("none", 1, 3, false), run("all", 1, 4)}) == kNone);
}

BOOST_AUTO_TEST_CASE(clock_times_of_runs_that_had_no_whole_processor_are_left_out) {
    std::vector<RunRow> runs;
    for (int seed = 1; seed <= 3; ++seed) {
        for (const char* leaf : {"none", "all"}) {
            runs.push_back(run(leaf, seed, 10));
            runs.back().processorSeconds = 9.6;
        }
    }
    runs[1].processorSeconds = 6;
    runs[1].stateChecks = 10;
    runs[1].triangleTests = 150;
    BOOST_TEST(runs[1].wasDisturbed());
    BOOST_TEST(!runs[0].wasDisturbed());
    BOOST_TEST(!run("none", 1, 10).wasDisturbed());  // its processor time is unknown
    const auto statistics = statisticsOf(runs, {}, "none");
    for (const char* time : {"first_solution_seconds", "query_seconds_per_call"}) {
        const StatisticRow& row = find(statistics, time, "P");
        BOOST_TEST(row.pairs == 2u, time);
        BOOST_TEST(row.median == 1, time);
    }
    const StatisticRow& triangles = find(statistics, "triangle_tests_per_query", "P");
    BOOST_TEST(triangles.pairs == 3u);
    BOOST_TEST(triangles.high == 1.5);
    const auto summary = summaryOf(runs, {});
    const SummaryRow& all = find(summary, "P", "all");
    BOOST_TEST(all.disturbed.value() == 1u);
    BOOST_TEST(all.callsPerSecond.value() == 250 / 25.2, boost::test_tools::tolerance(1e-12));
    BOOST_TEST(all.stateChecks.value() == 130 / 3.0, boost::test_tools::tolerance(1e-12));
}

/// A length is better when it is less, a clearance when it is more.
BOOST_AUTO_TEST_CASE(costs_of_different_planners_are_not_mixed) {
    std::vector<RunRow> runs;
    for (const char* leaf : {"none", "all"}) {
        runs.push_back(run(leaf, 1, 10));
        runs.back().cost = *leaf == 'n' ? 2 : 3;
    }
    int found = 0;
    for (const StatisticRow& row : statisticsOf(runs, {}, "none")) {
        if (row.measure != "cost") continue;
        BOOST_TEST(row.planner == "P");
        BOOST_TEST(row.median == 1.5);
        ++found;
    }
    BOOST_TEST(found == 1);
}

BOOST_AUTO_TEST_CASE(replays_are_compared_block_by_block_within_one_tree) {
    std::vector<ReplayRow> replays;
    const auto add = [&](const char* target, const char* leaf, int block, double seconds) {
        auto row = rowOf<ReplayRow>(leaf, 1);
        row.instructions = target;
        row.block = static_cast<std::uint64_t>(block);
        row.calls = 25;
        row.seconds = seconds;
        replays.push_back(row);
    };
    for (int block = 0; block < 3; ++block) {
        add("best", "none", block, block + 1);
        add("best", "edge", block, 0.5 * (block + 1));
        add("sse4", "none", block, 4 * (block + 1));
        add("sse4", "edge", block, 8 * (block + 1));
    }
    const auto statistics = statisticsOf({}, replays, "none");
    const StatisticRow& best = find(statistics, "seconds", "all");
    BOOST_TEST(best.median == 0.5);
    BOOST_TEST(best.pairs == 3u);
    BOOST_TEST(best.clusters == 1u);
    const StatisticRow& sse4 = find(statistics, "seconds", "P", "sse4");
    BOOST_TEST(sse4.median == 2);
}

}  // namespace
BOOST_AUTO_TEST_SUITE_END()

}  // namespace clearway::testing
