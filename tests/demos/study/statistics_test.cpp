#include "demos/study/statistics.h"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <random>

namespace clearway::testing {
BOOST_AUTO_TEST_SUITE(statistics_test)

using namespace study;

StudyOptions twoTrees() {
    StudyOptions options;
    options.generalSplits = {"axis", "sah"};
    options.leafSplits = {"none", "chain"};
    return options;
}

template <class Row>
Row rowOf(const std::string& general, const std::string& leaf, int seed) {
    Row row;
    row.scene = "s";
    row.planner = "P";
    row.generalSplit = general;
    row.leafSplit = leaf;
    row.seed = seed;
    row.sweepQueries = 20;
    row.volumeTests = 400;
    row.triangleTests = 100;
    row.triangleLanes = 200;
    row.kernelPairs = 30;
    row.kernelLanes = 120;
    return row;
}

RunRow run(const std::string& general, const std::string& leaf, int seed, double seconds,
           bool isSolved = true) {
    auto row = rowOf<RunRow>(general, leaf, seed);
    row.isSolved = isSolved;
    row.seconds = row.processorSeconds = seconds;
    if (isSolved) row.firstSolutionSeconds = seconds;
    row.stateChecks = 60;
    row.motionChecks = 40;
    row.graphStates = 30;
    row.length = 100.0 + seed;
    row.querySeconds = seconds / 4;
    return row;
}

FilesRow files(const std::string& general, const std::string& leaf, double seconds) {
    FilesRow row;
    row.scene = "s";
    row.generalSplit = general;
    row.leafSplit = leaf;
    row.loadSeconds = 0.25;
    row.buildSeconds = seconds - 0.25;
    row.leaves = leaf == "none" ? 10 : 15;
    return row;
}

const RatioRow* find(const std::vector<RatioRow>& rows, const std::string& measure, const std::string& tree,
                     const std::string& baseline, const std::string& planner = "P") {
    for (const RatioRow& row : rows) {
        if (row.measure == measure && row.name() == tree && row.baseline == baseline &&
            row.planner == planner)
            return &row;
    }
    return nullptr;
}

BOOST_AUTO_TEST_CASE(medians_are_those_in_the_middle) {
    BOOST_TEST(median({3}) == 3);
    BOOST_TEST(median({5, 1}) == 3);
    BOOST_TEST(median({9, 1, 2}) == 2);
    BOOST_TEST(median({4, 1, 3, 2}) == 2.5);
}

BOOST_AUTO_TEST_CASE(a_ratio_that_is_always_the_same_has_no_doubt) {
    const PairedRatio ratio = pairedRatio({2, 2, 2});
    BOOST_TEST(ratio.median == 2);
    BOOST_TEST(ratio.low == 2);
    BOOST_TEST(ratio.high == 2);
    BOOST_TEST(ratio.pairs == 3u);
    BOOST_TEST(pairedRatio({}).pairs == 0u);
}

/// The median of n values has a standard error of about 1.25 / sqrt(n) of their deviation. An interval of 95
/// in 100 reaches twice that far to each side.
BOOST_AUTO_TEST_CASE(the_interval_is_as_wide_as_statistics_say_and_mostly_holds_the_truth) {
    std::mt19937_64 random(7);
    std::normal_distribution<double> noise(0, 0.1);
    constexpr int kTries = 100, kPairs = 100;
    int held = 0;
    for (int i = 0; i < kTries; ++i) {
        std::vector<double> ratios;
        for (int k = 0; k < kPairs; ++k) ratios.push_back(1.3 + noise(random));
        const PairedRatio ratio = pairedRatio(ratios);
        held += ratio.low <= 1.3 && 1.3 <= ratio.high;
        const double halfWidth = (ratio.high - ratio.low) / 2,
                     expected = 1.96 * 1.2533 * 0.1 / std::sqrt(kPairs);
        BOOST_TEST(halfWidth > 0.4 * expected);
        BOOST_TEST(halfWidth < 2 * expected);
        BOOST_TEST((ratio.low <= ratio.median && ratio.median <= ratio.high));
    }
    BOOST_TEST(held >= 88);
    BOOST_TEST(held <= 100);
}

BOOST_AUTO_TEST_CASE(runs_are_compared_with_those_of_their_seed_in_both_other_trees) {
    Measured measured;
    measured.files = {files("sah", "none", 1), files("sah", "chain", 2), files("axis", "none", 4),
                      files("axis", "chain", 4)};
    for (int seed = 1; seed <= 5; ++seed) {  // seeds differ tenfold by luck, trees by half
        const double luck = seed * seed;
        measured.runs.push_back(run("sah", "none", seed, luck));
        measured.runs.push_back(run("sah", "chain", seed, 1.5 * luck));
        measured.runs.push_back(run("axis", "none", seed, 2 * luck));
        measured.runs.push_back(run("axis", "chain", seed, luck));
    }
    const auto ratios = ratiosOf(measured, twoTrees());
    const RatioRow* const chain = find(ratios, "planning", "sah/chain", "sah/none");
    BOOST_TEST_REQUIRE(chain != nullptr);
    BOOST_TEST(chain->median == 1.5);
    BOOST_TEST(chain->low == 1.5);
    BOOST_TEST(chain->pairs == 5u);
    BOOST_TEST(find(ratios, "planning", "axis/chain", "axis/none")->median == 0.5);
    BOOST_TEST(find(ratios, "planning", "axis/chain", "sah/none")->median == 1);
    BOOST_TEST(find(ratios, "planning", "axis/none", "sah/none")->median == 2);
    BOOST_TEST(find(ratios, "planning", "sah/none", "sah/none") == nullptr);
    // The third of the five seeds has the median ratio: (2 + 1.5 * 9) / (1 + 9).
    BOOST_TEST(find(ratios, "files_to_path", "sah/chain", "sah/none")->median == 1.55);

    const auto cells = cellsOf(measured, twoTrees());
    BOOST_TEST_REQUIRE(cells.size() == 4u);
    for (const CellRow& cell : cells) {
        BOOST_TEST(cell.runs == 5u);
        BOOST_TEST(cell.solved == 5u);
        BOOST_TEST(cell.equalQuestions == 5u);
        BOOST_TEST(cell.leavesRatio.value() == (cell.leafSplit == "none" ? 1 : 1.5));
        BOOST_TEST(cell.calls.value() == 100);
        if (cell.name() == "sah/chain") BOOST_TEST(cell.filesToPath.value() == 15.5);
    }
}

BOOST_AUTO_TEST_CASE(runs_without_a_path_are_counted_and_a_cell_with_many_has_no_ratio) {
    Measured measured;
    for (int seed = 1; seed <= 10; ++seed) {
        measured.runs.push_back(run("sah", "none", seed, 1));
        measured.runs.push_back(run("sah", "chain", seed, 2, seed > 2));
        measured.runs.push_back(run("axis", "none", seed, 2, seed > 3));
    }
    const auto ratios = ratiosOf(measured, twoTrees());
    const RatioRow* const chain = find(ratios, "planning", "sah/chain", "sah/none");
    BOOST_TEST_REQUIRE(chain != nullptr);
    BOOST_TEST(chain->pairs == 8u);
    BOOST_TEST(find(ratios, "planning", "axis/none", "sah/none") == nullptr);
    BOOST_TEST(find(ratios, "volume_tests", "axis/none", "sah/none") == nullptr);
    for (const CellRow& cell : cellsOf(measured, twoTrees()))
        BOOST_TEST(cell.solved == (cell.name() == "sah/none" ? 10u : cell.name() == "sah/chain" ? 8u : 7u));
}

/// Luck is no effect of trees: a planner that decided otherwise in the other tree says nothing about it.
BOOST_AUTO_TEST_CASE(runs_that_did_not_do_the_same_count_apart) {
    Measured measured;
    for (int seed = 1; seed <= 10; ++seed) {
        measured.runs.push_back(run("sah", "none", seed, 1));
        measured.runs.push_back(run("sah", "chain", seed, seed > 4 ? 2 : 9));
        if (seed <= 4) measured.runs.back().length = 7;
        measured.runs.push_back(run("axis", "none", seed, 3));
        if (seed <= 6) measured.runs.back().graphStates = 31;
    }
    BOOST_TEST(!didTheSame(measured.runs[0], measured.runs[1]));
    const auto ratios = ratiosOf(measured, twoTrees());
    const RatioRow* const same = find(ratios, "planning", "sah/chain", "sah/none");
    BOOST_TEST_REQUIRE(same != nullptr);
    BOOST_TEST(same->pairs == 6u);
    BOOST_TEST(same->high == 2);
    BOOST_TEST(find(ratios, "planning_any", "sah/chain", "sah/none")->pairs == 10u);
    BOOST_TEST(find(ratios, "planning", "axis/none", "sah/none") == nullptr);  // 4 of 10 seeds
    BOOST_TEST(find(ratios, "planning_any", "axis/none", "sah/none")->median == 3);
    for (const CellRow& cell : cellsOf(measured, twoTrees()))
        if (cell.name() == "sah/chain") BOOST_TEST(cell.equalQuestions == 6u);
}

BOOST_AUTO_TEST_CASE(clock_times_of_runs_that_had_no_whole_processor_are_left_out) {
    Measured measured;
    for (int seed = 1; seed <= 3; ++seed) {
        measured.runs.push_back(run("sah", "none", seed, 10));
        measured.runs.push_back(run("sah", "chain", seed, seed == 3 ? 30 : 10));
    }
    measured.runs.back().processorSeconds = 12;
    BOOST_TEST(measured.runs.back().wasDisturbed());
    BOOST_TEST(!measured.runs[0].wasDisturbed());
    const auto ratios = ratiosOf(measured, twoTrees());
    BOOST_TEST(find(ratios, "planning", "sah/chain", "sah/none")->pairs == 2u);
    BOOST_TEST(find(ratios, "planning", "sah/chain", "sah/none")->high == 1);
    BOOST_TEST(find(ratios, "volume_tests", "sah/chain", "sah/none")->pairs == 3u);
}

BOOST_AUTO_TEST_CASE(replays_are_compared_sample_by_sample_on_one_instruction_set) {
    Measured measured;
    const auto add = [&](const char* target, const char* leaf, const char* planner, double seconds) {
        auto row = rowOf<ReplayRow>("sah", leaf, 1);
        row.instructions = target;
        row.planner = planner;
        row.calls = 25;
        row.seconds = seconds;
        measured.replays.push_back(row);
    };
    for (const char* planner : {"P", "Q"}) {
        add("best", "none", planner, 2);
        add("best", "chain", planner, *planner == 'P' ? 1 : 3);
        add("sse4", "none", planner, 4);
        add("sse4", "chain", planner, 16);
    }
    const auto ratios = ratiosOf(measured, twoTrees());
    const RatioRow* const all = find(ratios, "seconds", "sah/chain", "sah/none", "all");
    BOOST_TEST_REQUIRE(all != nullptr);
    BOOST_TEST(all->median == 1);
    BOOST_TEST(all->pairs == 2u);
    BOOST_TEST(find(ratios, "seconds", "sah/chain sse4", "sah/none", "all")->median == 4);
    BOOST_TEST(find(ratios, "seconds", "sah/chain", "sah/none", "Q") == nullptr);
}

BOOST_AUTO_TEST_CASE(costs_are_found_again_and_none_is_negative) {
    std::mt19937_64 random(5);
    std::vector<ReplayRow> replays;
    for (int i = 0; i < 40; ++i) {
        auto row = rowOf<ReplayRow>("sah", "none", i);
        row.volumeTests = 1000 + random() % 9000;
        row.triangleLanes = 1000 + random() % 9000;
        row.kernelLanes = 500 + random() % 500;
        row.calls = 100 + random() % 100;
        row.seconds = 1e-6 * (0.05 * double(*row.volumeTests) + 0.01 * double(*row.triangleLanes) +
                              2 * double(row.calls));
        replays.push_back(row);
    }
    const WorkCosts costs = fitCosts(replays);
    BOOST_TEST(costs.volumeTest == 0.05, boost::test_tools::tolerance(1e-6));
    BOOST_TEST(costs.trianglePair == 0.01, boost::test_tools::tolerance(1e-6));
    BOOST_TEST(costs.call == 2, boost::test_tools::tolerance(1e-6));
    BOOST_TEST(std::abs(costs.kernelLane) < 1e-6);
    BOOST_TEST(costs.error < 1e-6);
    for (ReplayRow& row : replays) row.seconds -= 1e-6 * 0.02 * double(*row.kernelLanes);
    BOOST_TEST(fitCosts(replays).kernelLane == 0);
    BOOST_TEST(fitCosts({}).volumeTest == 0);
}

BOOST_AUTO_TEST_CASE(a_planner_that_asks_the_scene_itself_has_no_calls) {
    RunRow row = run("sah", "none", 1, 1);
    BOOST_TEST(row.calls().value() == 100);
    row.planner = "SlidingRRTConnect";
    BOOST_TEST(!row.calls());
    row = run("sah", "none", 1, 1);
    row.sweepQueries = 0;  // its own threads ask
    BOOST_TEST(!row.calls());
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::testing
