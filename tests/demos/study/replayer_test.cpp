#include "demos/study/replayer.h"

#include <boost/test/unit_test.hpp>
#include <set>

#include "clearway/planning/ompl_messages.h"
#include "demos/study/recorder.h"
#include "planning/space/ompl_states.h"
#include "program/bench/planner_run.h"
#include "support/planar_scenes.h"
#include "support/processor_time.h"
#include "support/window_scene.h"

namespace clearway::study {
BOOST_AUTO_TEST_SUITE(replayer_test)

using testing::windowScene;

struct TracedRun : BenchmarkRun {
    std::vector<CallBlock> calls;
};

TracedRun runTraced(Problem problem, const Scene& scene, const std::string& planner,
                    const std::string& objective, double seconds) {
    problem.planning.planners = {{planner}};
    planning::PlanOptions options;
    options.threads = 1;
    options.objective = objective;
    RunLimits limits;
    limits.bytes = std::uint64_t(1) << 40;
    limits.simplify = false;
    std::optional<Recorder> recorder;
    limits.watch = recordingInto(recorder, {});
    const planning::OmplMessages unobserved;
    std::vector<std::string> warnings;
    return testing::withProcessorTime(seconds, [&](double limit) {
        options.seconds = limits.seconds = limit;
        const BenchmarkRun run = runOnce(problem, scene, options, limits, warnings).value();
        return TracedRun{run, recorder->sample()};
    });
}

TracedRun runTraced(const std::string& planner, const std::string& objective, double seconds) {
    const auto window = windowScene();
    return runTraced(window.problem, window.scene, planner, objective, seconds);
}

double valueOf(const BenchmarkRun& run, const std::string& property) {
    return std::stod(run.properties.at(property));
}

BOOST_AUTO_TEST_CASE(a_run_tells_what_it_asked_and_how_long_that_took) {
    const BenchmarkRun run = runTraced("RRTConnect", "", 20);
    BOOST_TEST_REQUIRE(run.isSolved);
    BOOST_TEST(run.properties.at("motion checks INTEGER") ==
               std::to_string(std::stol(run.properties.at("valid motions INTEGER")) +
                              std::stol(run.properties.at("invalid motions INTEGER"))));
    BOOST_TEST(valueOf(run, "distance queries INTEGER") + valueOf(run, "within queries INTEGER") >=
               valueOf(run, "motion queries INTEGER"));
    BOOST_TEST(valueOf(run, "query time REAL") > 0);
    BOOST_TEST(valueOf(run, "query time REAL") < valueOf(run, "time REAL"));
    BOOST_TEST(valueOf(run, "query share REAL") < 1);
    BOOST_TEST(valueOf(run, "volume tests INTEGER") > 0);
    const double tests = valueOf(run, "triangle tests INTEGER"),
                 kernel = valueOf(run, "kernel pairs INTEGER");
    BOOST_TEST(tests > 0);
    BOOST_TEST(tests <= valueOf(run, "triangle lanes INTEGER"));
    BOOST_TEST(kernel > 0);
    BOOST_TEST(kernel <= tests);
    BOOST_TEST(kernel <= valueOf(run, "kernel lanes INTEGER"));
    BOOST_TEST(run.properties.at("time to first solution REAL") == run.properties.at("time REAL"));
}

BOOST_AUTO_TEST_CASE(planners_that_improve_tell_of_their_first_and_their_last_solution) {
    const auto gates = testing::gatesScene();
    const BenchmarkRun run = runTraced(gates.problem, gates.scene, "RRTstar", "", 2);
    BOOST_TEST_REQUIRE(run.isSolved);
    BOOST_TEST(valueOf(run, "time to first solution REAL") > 0);
    BOOST_TEST(valueOf(run, "time to first solution REAL") < valueOf(run, "time to final solution REAL"));
    BOOST_TEST(valueOf(run, "time to final solution REAL") <= valueOf(run, "time REAL"));
}

BOOST_AUTO_TEST_CASE(recorded_calls_answer_alike_with_all_trees) {
    for (const char* planner : {"RRTConnect", "KPIECE1", "BITstar"}) {
        const TracedRun run = runTraced(planner, "", 0.5);
        BOOST_TEST_REQUIRE(!run.calls.empty());
        std::set<CallKind> kinds;
        for (const CallBlock& block : run.calls) {
            for (const Call& call : block) kinds.insert(call.kind);
        }
        BOOST_TEST(kinds.count(planner == std::string("KPIECE1") ? CallKind::kForwardMotion
                                                                 : CallKind::kMotion) == 1u);

        std::vector<std::vector<CallAnswer>> first;
        for (const char* leafSplit : {"none", "chain", "all"}) {
            for (const int width : {8, 2}) {
                BuildOptions build;
                build.leafSplit = leafSplit;
                build.nodeWidth = width;
                const auto window = windowScene(build);
                Replayer replayer(window.problem, window.scene);
                const ReplayedCalls replayed = replayer.replay(run.calls);
                if (first.empty()) first = replayed.answers;
                BOOST_TEST((replayed.answers == first), planner << ", " << leafSplit << ", width " << width);
                BOOST_TEST_REQUIRE(replayed.tallies.size() == run.calls.size());
                std::uint64_t queries = 0;
                for (const QueryTally& tally : replayed.tallies) queries += tally.distances + tally.withins;
                BOOST_TEST(queries > 0u);
                BOOST_TEST(replayer.time(run.calls).size() == run.calls.size());
            }
        }
        std::set<char> given;
        for (const auto& block : first) {
            for (const CallAnswer answer : block) given.insert(static_cast<char>(answer));
        }
        BOOST_TEST(given.count('y') == 1u, planner);
        BOOST_TEST(given.count('n') == 1u, planner);
    }
}

BOOST_AUTO_TEST_CASE(the_sample_is_of_whole_blocks_in_order_and_even_over_the_run) {
    const auto space = planning::makeSpace(Space::kSe3, Box(Vector3::Zero(), Vector3::Constant(2000)), 1);
    space->setup();
    PartState state;
    double sum = 0;
    constexpr int kSeeds = 40, kCalls = 1000;
    for (int seed = 1; seed <= kSeeds; ++seed) {
        Recorder recorder(space, {4, 10, static_cast<std::uint64_t>(seed)});
        recorder.begin();
        for (int i = 0; i < kCalls; ++i) {
            state.position.x() = i;
            const auto omplState = planning::toOmpl(space, Space::kSe3, state);
            recorder.record(CallKind::kState, omplState.get(), nullptr, [] { return true; });
        }
        recorder.end();
        recorder.record(CallKind::kState, nullptr, nullptr, [] { return true; });
        BOOST_TEST(recorder.calls(CallKind::kState) == std::uint64_t(kCalls));
        const std::vector<CallBlock> sample = recorder.sample();
        BOOST_TEST_REQUIRE(sample.size() == 4u);
        double last = -1;
        for (const CallBlock& block : sample) {
            BOOST_TEST_REQUIRE(block.size() == 10u);
            BOOST_TEST(block[0].from[0] > last);
            for (std::size_t i = 0; i < block.size(); ++i)
                BOOST_TEST(block[i].from[0] == block[0].from[0] + double(i));
            last = block[9].from[0];
            sum += block[0].from[0];
        }
    }
    // Blocks begin at 495 in the mean, with a deviation of 289 each: 160 of them within 23 with 68 %.
    BOOST_TEST(std::abs(sum / (4 * kSeeds) - 495) < 80, "seeds 1 to 40, mean " << sum / (4 * kSeeds));
}

BOOST_AUTO_TEST_CASE(states_of_another_space_are_refused) {
    const auto window = windowScene();
    Replayer replayer(window.problem, window.scene);
    BOOST_CHECK_THROW(replayer.replay({{Call{CallKind::kState, {1, 2, 3}, {}}}}), std::invalid_argument);
    BOOST_CHECK_THROW(posesOf(window.problem, {{Call{CallKind::kState, {1, 2, 3}, {}}}}),
                      std::invalid_argument);
    const std::vector<Pose> poses =
        posesOf(window.problem, {{Call{CallKind::kMotion, {1, 2, 3, 0, 0, 0, 1}, {4, 5, 6, 0, 0, 0, 1}}}});
    BOOST_TEST_REQUIRE(poses.size() == 2u);
    BOOST_TEST(poses[1].translation == Vector3(4, 5, 6));
    BOOST_TEST((poses[0].rotation == Matrix3::Identity()));
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::study
