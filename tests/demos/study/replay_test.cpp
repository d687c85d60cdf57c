#include "demos/study/replay.h"

#include <boost/test/unit_test.hpp>

#include "support/temporary_folder.h"
#include "support/window_scene.h"

namespace clearway::testing {
BOOST_AUTO_TEST_SUITE(replay_test)

using namespace study;

using Places = std::vector<std::size_t>;

BOOST_AUTO_TEST_CASE(blocks_are_spread_evenly_over_the_run) {
    BOOST_TEST(spreadEvenly(4, 32) == Places({0, 8, 16, 24}), boost::test_tools::per_element());
    BOOST_TEST(spreadEvenly(5, 3) == Places({0, 1, 2}), boost::test_tools::per_element());
    BOOST_TEST(spreadEvenly(4, 0).empty());
}

StudyProblem windowProblem() {
    StudyProblem problem;
    problem.name = "window";
    problem.problem = readProblem(CLEARWAY_DATA_DIR "/window/window.cfg");
    SceneMeshes meshes = loadMeshes(problem.problem);
    problem.obstacles = obstaclesOf(problem.problem, meshes.worlds);
    problem.part = meshes.part;
    return problem;
}

/// The answers of every tree must be those that were kept with the sample: a tree that says "valid" where another says "collides" is
/// the worst that can happen.
BOOST_AUTO_TEST_CASE(samples_are_replayed_in_all_trees_and_a_wrong_answer_is_told) {
    const TemporaryFolder folder;
    const StudyProblem problem = windowProblem();
    StudyOptions options;
    options.repetitions = 1;
    options.generalSplits = {"axis", "sah"};
    const Scene scene = buildScene(problem, qualifyingEngine(options));
    const auto run =
        runPlanned(problem, scene, options, {"RRTConnect", qualifyingEngine(options), 1, 20}, true);
    BOOST_TEST_REQUIRE(run.has_value());
    BOOST_TEST_REQUIRE(!run->calls.empty());
    std::filesystem::create_directory(folder.file("calls"));
    BOOST_TEST(!hasSample(folder.path(), "window", "RRTConnect", 1));
    keepCalls(*run, problem, scene, folder.path());
    auto sample = readSample(folder.path(), "window", "RRTConnect", 1);
    BOOST_TEST_REQUIRE(sample.has_value());
    BOOST_TEST(sample->blocks.size() >= std::min(run->calls.size(), kLeastReplayedBlocks));

    const auto groups = replayedGroups(options);
    const auto rows = replayGroup(problem, groups.front(), {*sample}, options);
    BOOST_TEST_REQUIRE(rows.has_value());
    BOOST_TEST_REQUIRE(rows->size() == groups.front().size());
    for (std::size_t i = 0; i < rows->size(); ++i) {
        BOOST_TEST(((*rows)[i] == groups.front()[i]));
        BOOST_TEST((*rows)[i].seconds > 0);
        BOOST_TEST((*rows)[i].volumeTests.value() > 0u);
    }
    CallAnswer& answer = sample->answers.front().front();
    answer = answer == CallAnswer::kYes ? CallAnswer::kNo : CallAnswer::kYes;
    BOOST_CHECK_THROW(replayGroup(problem, groups.back(), {*sample}, options), std::logic_error);
    options.isStopped = [] { return true; };
    BOOST_TEST(!replayGroup(problem, groups.back(), {*sample}, options).has_value());
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::testing
