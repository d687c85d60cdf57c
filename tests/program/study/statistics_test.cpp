#include "program/study/statistics.h"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <random>

#include "core/number.h"
#include "program/study/claims.h"
#include "program/study/paired_ratio.h"
#include "program/study/study_rows.h"
#include "program/study/summary.h"
#include "program/study/thesis.h"

namespace clearway::testing {

using namespace study;
namespace {

double in(const TableRow& row, const std::string& column) {
    return parseNumber(row.at(column)).value();
}

const TableRow& find(const std::vector<TableRow>& rows, const TableRow& wanted) {
    for (const TableRow& row : rows) {
        bool isWanted = true;
        for (const auto& [column, value] : wanted)
            isWanted = isWanted && row.count(column) && row.at(column) == value;
        if (isWanted) return row;
    }
    BOOST_FAIL("no such row among " << rows.size());
    return rows.front();
}

TableRow run(const std::string& leaf, int seed, double first, bool isSolved = true) {
    return {{"scene", "s"},
            {"planner", "P"},
            {"general_split", "sah"},
            {"leaf_split", leaf},
            {"seed", std::to_string(seed)},
            {"solved", isSolved ? "1" : "0"},
            {"seconds", shortNumber(first)},
            {"first_solution_seconds", isSolved ? shortNumber(first) : ""},
            {"cost", ""},
            {"state_checks", "60"},
            {"motion_checks", "40"},
            {"motion_costs", ""},
            {"query_seconds", shortNumber(first / 4)},
            {"distance_queries", "10"},
            {"within_queries", "10"},
            {"volume_tests", "400"},
            {"triangle_tests", "100"},
            {"triangle_lanes", "200"},
            {"kernel_pairs", "30"},
            {"kernel_lanes", "120"}};
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

/// The median of n values is known to about 1.25 / sqrt(n) of their deviation; an interval of 95 in 100 is
/// twice that, to each side.
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

/// Pairs of a run hang together: ten times as many of them make nothing surer.
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
    std::vector<TableRow> runs;
    for (int seed = 1; seed <= 5; ++seed) {  // seeds differ by luck tenfold, strategies by half
        runs.push_back(run("none", seed, seed * seed));
        runs.push_back(run("chain", seed, 1.5 * seed * seed));
    }
    runs.push_back(run("none", 6, 3));
    runs.push_back(run("chain", 6, 3, false));  // no pair for the first solution
    const auto statistics = statisticsOf(runs, {}, "none");
    const TableRow& first =
        find(statistics, {{"measure", "first_solution_seconds"}, {"planner", "P"}, {"leaf_split", "chain"}});
    BOOST_TEST(in(first, "ratio") == 1.5);
    BOOST_TEST(in(first, "low") == 1.5);
    BOOST_TEST(first.at("pairs") == "5");
    const TableRow& each = find(statistics, {{"measure", "seconds_per_call"}, {"planner", "all"}});
    BOOST_TEST(each.at("pairs") == "6");
    for (const TableRow& row : statistics) BOOST_TEST(row.at("measure") != "cost");

    const auto summary = summaryOf(runs, {});
    const TableRow& chain = find(summary, {{"planner", "P"}, {"leaf_split", "chain"}});
    BOOST_TEST(chain.at("runs") == "6");
    BOOST_TEST(chain.at("solved") == "5");
    BOOST_TEST(in(chain, "first_solution_seconds") == 13.5);
    BOOST_TEST(in(chain, "query_share") == 0.25);
    BOOST_TEST(in(chain, "volume_tests") == 20);
    BOOST_TEST(in(chain, "block_fill") == 0.5);
    BOOST_TEST(in(chain, "kernel_fill") == 0.25);
}

/// Leaving such pairs out would leave those in which the slower strategy was quick.
BOOST_AUTO_TEST_CASE(a_run_that_found_nothing_counts_as_one_that_found_at_its_end) {
    const auto ratioOfFirst = [](const std::vector<TableRow>& runs) -> std::string {
        for (const TableRow& row : statisticsOf(runs, {}, "none")) {
            if (row.at("measure") == "first_solution_seconds") return row.at("ratio");
        }
        return "none";
    };
    BOOST_TEST(ratioOfFirst({run("none", 1, 4), run("all", 1, 20, false)}) == "5");
    BOOST_TEST(ratioOfFirst({run("none", 1, 20, false), run("all", 1, 5)}) == "0.25");
    BOOST_TEST(ratioOfFirst({run("none", 1, 20, false), run("all", 1, 20, false)}) == "none");
    // one that gave up before tells nothing
    BOOST_TEST(ratioOfFirst({run("none", 1, 4), run("all", 1, 3, false)}) == "none");
    BOOST_TEST(ratioOfFirst({run("none", 1, 3, false), run("all", 1, 4)}) == "none");
}

BOOST_AUTO_TEST_CASE(clock_times_of_runs_that_had_no_whole_processor_are_left_out) {
    std::vector<TableRow> runs;
    for (int seed = 1; seed <= 3; ++seed) {
        for (const char* leaf : {"none", "all"}) {
            runs.push_back(run(leaf, seed, 10));
            runs.back()["processor_seconds"] = "9.6";
        }
    }
    runs[1]["processor_seconds"] = "6";
    runs[1]["state_checks"] = "10";
    runs[1]["triangle_tests"] = "150";
    BOOST_TEST(wasDisturbed(runs[1]));
    BOOST_TEST(!wasDisturbed(runs[0]));
    BOOST_TEST(!wasDisturbed(run("none", 1, 10)));  // nothing is known of it
    const auto statistics = statisticsOf(runs, {}, "none");
    for (const char* time : {"first_solution_seconds", "query_seconds_per_call"}) {
        const TableRow& row = find(statistics, {{"measure", time}, {"planner", "P"}});
        BOOST_TEST(row.at("pairs") == "2", time);
        BOOST_TEST(in(row, "ratio") == 1, time);
    }
    const TableRow& triangles = find(statistics, {{"measure", "triangle_tests_per_query"}, {"planner", "P"}});
    BOOST_TEST(triangles.at("pairs") == "3");
    BOOST_TEST(in(triangles, "high") == 1.5);
    const auto summary = summaryOf(runs, {});
    const TableRow& all = find(summary, {{"planner", "P"}, {"leaf_split", "all"}});
    BOOST_TEST(all.at("disturbed") == "1");
    BOOST_TEST(in(all, "calls_per_second") == 250 / 25.2, boost::test_tools::tolerance(1e-12));
    BOOST_TEST(in(all, "state_checks") == 130 / 3.0, boost::test_tools::tolerance(1e-12));
}

/// A path's length is the better the less it is, its clearance the more it is.
BOOST_AUTO_TEST_CASE(costs_of_different_planners_are_not_mixed) {
    std::vector<TableRow> runs;
    for (const char* leaf : {"none", "all"}) {
        runs.push_back(run(leaf, 1, 10));
        runs.back()["cost"] = *leaf == 'n' ? "2" : "3";
    }
    int found = 0;
    for (const TableRow& row : statisticsOf(runs, {}, "none")) {
        if (row.at("measure") != "cost") continue;
        BOOST_TEST(row.at("planner") == "P");
        BOOST_TEST(in(row, "ratio") == 1.5);
        ++found;
    }
    BOOST_TEST(found == 1);
}

BOOST_AUTO_TEST_CASE(replays_are_compared_block_by_block_within_one_tree) {
    std::vector<TableRow> replays;
    const auto add = [&](const char* target, const char* leaf, int block, double seconds) {
        TableRow row = run(leaf, 1, seconds);
        row["leaf_size"] = "4";
        row["node_width"] = "8";
        row["instructions"] = target;
        row["block"] = std::to_string(block);
        row["calls"] = "25";
        replays.push_back(row);
    };
    for (int block = 0; block < 3; ++block) {
        add("best", "none", block, block + 1);
        add("best", "edge", block, 0.5 * (block + 1));
        add("sse4", "none", block, 4 * (block + 1));
        add("sse4", "edge", block, 8 * (block + 1));
    }
    const auto statistics = statisticsOf({}, replays, "none");
    const TableRow& best =
        find(statistics, {{"measure", "seconds"}, {"instructions", "best"}, {"planner", "all"}});
    BOOST_TEST(in(best, "ratio") == 0.5);
    BOOST_TEST(best.at("pairs") == "3");
    BOOST_TEST(best.at("clusters") == "1");
    const TableRow& sse4 =
        find(statistics, {{"measure", "seconds"}, {"instructions", "sse4"}, {"planner", "P"}});
    BOOST_TEST(in(sse4, "ratio") == 2);
}

TableRow tree(const std::string& scene, const std::string& general, const std::string& leaf, double seconds,
              double leaves) {
    std::string blocks;
    for (int i = 0; i < 20; ++i) blocks += shortNumber(seconds * (1 + 0.001 * (i % 5))) + " ";
    return {{"scene", scene},
            {"node_width", "2"},
            {"general_split", general},
            {"leaf_split", leaf},
            {"build_seconds", "1"},
            {"megabytes", "30"},
            {"leaves", shortNumber(leaves)},
            {"distances_block_seconds", blocks},
            {"collisions_block_seconds", blocks}};
}

BOOST_AUTO_TEST_CASE(claims_are_judged_by_the_rule) {
    const std::vector<TableRow> trees = {
        tree("cembox", "mean", "chain", 2, 100), tree("cembox", "axis", "chain", 1, 200),
        tree("cembox", "axis", "none", 0.5, 100), tree("cembox", "axis", "edge", 1.001, 300),
        tree("cembox", "axis", "all", 3, 400)};
    const auto claims = judgeClaims(trees);
    const auto verdict = [&](const std::string& claim) {
        return find(claims, {{"claim", claim}}).at("verdict");
    };
    BOOST_TEST(verdict("AxisSplit answers distances faster than MeanSplit") == "holds");
    BOOST_TEST(verdict("ChainSplit answers distances faster than NoSplit") == "the opposite");
    BOOST_TEST(verdict("ChainSplit answers distances faster than EdgeSplit") == "no difference");
    BOOST_TEST(verdict("EdgeSplit answers collisions as fast as ChainSplit") == "holds");
    BOOST_TEST(verdict("ChainSplit answers collisions as fast as NoSplit") == "the first is slower");
    BOOST_TEST(verdict("AxisSplit takes longer to build than MeanSplit") == "no difference");
    BOOST_TEST(verdict("ChainSplit makes more leaves than NoSplit") == "holds");
    for (const TableRow& row : claims)
        BOOST_TEST(row.at("claim") != "ChainSplit answers collisions faster than NoSplit");
    const auto inLarge = judgeClaims({tree("large-environment", "axis", "chain", 1, 200),
                                      tree("large-environment", "axis", "none", 5, 100)});
    const TableRow& collisions =
        find(inLarge, {{"claim", "ChainSplit answers collisions faster than NoSplit"}});
    BOOST_TEST(collisions.at("verdict") == "holds");
    BOOST_TEST(in(collisions, "thesis_ratio") == 16223.0 / 3151.0);
    const TableRow& axis = find(claims, {{"claim", "AxisSplit answers distances faster than MeanSplit"}});
    BOOST_TEST(in(axis, "ratio") == 2);
    BOOST_TEST(in(axis, "thesis_ratio") == 595.0 / 205.0);
    const auto elsewhere =
        judgeClaims({tree("window", "mean", "chain", 2, 1), tree("window", "axis", "chain", 1, 1)});
    BOOST_TEST(elsewhere.at(0).at("thesis_ratio") == "");
}

/// That nothing was shown is no proof that both are alike.
BOOST_AUTO_TEST_CASE(a_claim_about_which_poses_disagree_is_undecided) {
    std::vector<TableRow> trees = {tree("cembox", "axis", "chain", 1, 200),
                                   tree("cembox", "axis", "edge", 1, 300)};
    std::string blocks;
    for (int i = 0; i < 20; ++i) blocks += i % 2 == 0 ? "0.8 " : "1.25 ";
    trees[1]["collisions_block_seconds"] = trees[1]["distances_block_seconds"] = blocks;
    const auto claims = judgeClaims(trees);
    for (const char* claim : {"EdgeSplit answers collisions as fast as ChainSplit",
                              "ChainSplit answers distances faster than EdgeSplit"}) {
        BOOST_TEST(find(claims, {{"claim", claim}}).at("verdict") == "undecided", claim);
    }
}

BOOST_AUTO_TEST_CASE(thesis_values_are_looked_up_by_scene_and_strategy) {
    const ThesisScene* tunnel = thesisSceneOf("tunnel-console-3");
    BOOST_TEST_REQUIRE(tunnel != nullptr);
    BOOST_TEST(thesisValue(*tunnel, "distances_per_second", "axis", "edge").value() == 339);
    BOOST_TEST(thesisValue(*tunnel, "distances_per_second", "mean", "chain").value() == 230);
    BOOST_TEST(thesisValue(*tunnel, "leaves", "axis", "all").value() == 300401);
    BOOST_TEST(thesisValue(*tunnel, "build_seconds", "axis", "chain").value() == 4.05);
    BOOST_TEST(!thesisValue(*tunnel, "build_seconds", "axis", "none"));
    BOOST_TEST(!thesisValue(*tunnel, "distances_per_second", "sah", "chain"));
    BOOST_TEST(!thesisValue(*thesisSceneOf("cembox"), "leaves", "axis", "all"));
    BOOST_TEST(thesisSceneOf("window") == nullptr);
    // NoSplit's leaves hold all triangles of the thesis's static model, as every other split's do.
    for (const auto& sizes : *tunnel->leaves) {
        double triangles = 0;
        for (std::size_t i = 0; i < sizes.size(); ++i) triangles += static_cast<double>(i + 1) * sizes[i];
        BOOST_TEST(std::abs(triangles - 300401) <= 1, "leaves hold " << triangles << " triangles");
    }
}

}  // namespace
}  // namespace clearway::testing
