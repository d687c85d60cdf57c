// demos/leaf_strategies.cpp PROBLEM.cfg: does splitting the leaves of a tree help a planner? Loads the problem, builds trees with each leaf
// split, and plans in them with OMPL's RRTConnect and certified motions. Verdicts are exact, so that with one seed the planner makes the same decisions in all of them.
#include <clearway/planning/problem_setup.h>
#include <clearway/planning/validity_checker.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <iostream>

namespace cp = clearway::planning;
namespace ob = ompl::base;
using Clock = std::chrono::steady_clock;

constexpr double kSeconds = 6;       // after these no further round of runs begins
constexpr double kMostSeconds = 60;  // for one run
constexpr double kNoise = 0.03;      // share by which runtimes of equal work differ
constexpr double kQuickest = 0.01;   // seconds; shorter runtimes differ by more

double secondsSince(Clock::time_point begin) {
    return std::chrono::duration<double>(Clock::now() - begin).count();
}

/// Passes the planner's motions on to clearway's validator, and measures the time that it takes, nearly all of it in the trees.
struct TimedMotions : ob::MotionValidator {
    TimedMotions(const ob::SpaceInformationPtr& si, const clearway::Scene& scene)
        : ob::MotionValidator(si), judge(si, scene) {}
    bool checkMotion(const ob::State* from, const ob::State* to) const override {
        const Clock::time_point begin = Clock::now();
        const bool isValid = judge.checkMotion(from, to);
        seconds += secondsSince(begin);
        return isValid;
    }
    bool checkMotion(const ob::State* from, const ob::State* to,
                     std::pair<ob::State*, double>& lastValid) const override {
        return judge.checkMotion(from, to, lastValid);
    }
    const cp::MotionValidator judge;
    mutable double seconds = 0;
};

struct Run {
    std::string split;
    double seconds = 0, secondsInTrees = 0;
    cp::MotionCounters motions;
    bool isFound = false;
};

bool isFaster(const Run& a, const Run& b) {
    return a.seconds < b.seconds;
}

Run planOnce(const clearway::Problem& problem, const clearway::Scene& scene, const std::string& split) {
    ompl::RNG::setSeed(1);
    ompl::geometric::SimpleSetup setup = cp::makeSetup(problem, scene);
    const auto timed = std::make_shared<TimedMotions>(setup.getSpaceInformation(), scene);
    setup.getSpaceInformation()->setMotionValidator(timed);
    const auto planner = std::make_shared<ompl::geometric::RRTConnect>(setup.getSpaceInformation());
    planner->setRange(20 * problem.fineness.value_or(1));
    setup.setPlanner(planner);
    setup.setup();
    const Clock::time_point begin = Clock::now();
    setup.solve(kMostSeconds);
    return {split, secondsSince(begin), timed->seconds, timed->judge.counters(),
            setup.haveExactSolutionPath()};
}

/// Whether the planner found its path by the same decisions in all trees.
bool areComparable(const std::vector<Run>& runs) {
    return std::all_of(runs.begin(), runs.end(), [&](const Run& run) {
        return run.isFound && run.motions.valid == runs[0].motions.valid &&
               run.motions.invalid == runs[0].motions.invalid;
    });
}

/// One sentence on whether any leaf split gains the planner time; runs[0] is the one in trees whose leaves are not split.
void printAnswer(const std::vector<Run>& runs) {
    const Run &none = runs[0], &best = *std::min_element(runs.begin() + 1, runs.end(), isFaster);
    const double ratio = best.seconds / none.seconds;
    if (none.seconds < kQuickest) {
        std::printf("\nThe planner needs %.1f ms: too few to tell what splitting leaves gains.\n",
                    1e3 * none.seconds);
        return;
    }
    std::printf(
        "\nSplitting leaves %s here: with '%s', the fastest split, the planner takes %.2f times as long as "
        "with '%s'; "
        "if its checks took no time at all, it would take %.2f times as long.\n",
        ratio < 1 - kNoise ? "pays" : "does not pay", best.split.c_str(), ratio, none.split.c_str(),
        1 - none.secondsInTrees / none.seconds);
}

int main(int argc, char** argv) try {
    if (argc != 2) throw std::invalid_argument("expected one argument, PROBLEM.cfg");
    ompl::msg::setLogLevel(ompl::msg::LOG_NONE);  // OMPL warns when a seed is set again
    const clearway::Problem problem = clearway::readProblem(argv[1]);
    const std::vector<std::string> splits = clearway::leafSplitNames();
    std::vector<clearway::Scene> scenes;
    std::vector<double> files;  // the seconds of loading and building
    for (const std::string& split : splits) {
        clearway::BuildOptions options;
        options.leafSplit = split;
        const Clock::time_point start = Clock::now();
        scenes.push_back(clearway::loadScene(problem, options).scene);
        files.push_back(secondsSince(start));
    }
    // The splits take turns. All runs with one split do the same work, so that the fastest of them was disturbed least.
    std::vector<Run> runs(splits.size());
    const Clock::time_point begin = Clock::now();
    int rounds = 0;
    do {
        for (std::size_t i = 0; i < splits.size(); ++i) {
            const Run run = planOnce(problem, scenes[i], splits[i]);
            if (rounds == 0 || isFaster(run, runs[i])) runs[i] = run;
        }
        ++rounds;
    } while (secondsSince(begin) < kSeconds);

    std::printf(
        "RRTConnect with certified motions in trees with each leaf split; one seed, the fastest of %d "
        "runs\n\n"
        "leaf   files   planning     s in     calls:   valid\n"
        "split  to path        s    trees    motions  motions  queries  leaves\n",
        rounds);
    for (std::size_t i = 0; i < runs.size(); ++i) {
        const Run& run = runs[i];
        std::size_t leaves = scenes[i].part.report().tree.leaves;
        for (const auto& obstacle : scenes[i].obstacles) leaves += obstacle.model.report().tree.leaves;
        std::printf("%-6s %7.3f  %8.3f %8.3f %10lu %8lu %8lu %7zu\n", run.split.c_str(),
                    files[i] + run.seconds, run.seconds, run.secondsInTrees,
                    run.motions.valid + run.motions.invalid, run.motions.valid, run.motions.queries, leaves);
    }
    if (!areComparable(runs)) {
        std::printf(
            "\nThe runs do not compare: expected a path within %g s, by the same motions, in every tree.\n",
            kMostSeconds);
        return 1;
    }
    printAnswer(runs);
    return 0;
} catch (const std::exception& error) {
    std::cerr << "leaf_strategies: " << error.what() << "\n";
    return 2;
}
