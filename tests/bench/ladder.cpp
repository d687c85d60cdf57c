// Climbs from the engine of Ytterlid's thesis to clearway's, one step at a time: what each step does to the work and the time of a
// query.
//   benchmarks ladder [--scenes K,I] [--out DIR] ...      see --help and README.md in this folder
// Ends with exit code 1 when an answer is farther off than its step allows, and with 2 when the benchmark cannot run.
#include <algorithm>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <memory>
#include <sstream>

#include "bench/clearway_series.h"
#include "bench/float_only.h"
#include "bench/judge.h"
#include "bench/pinned.h"
#include "bench/scalar_double.h"
#include "bench/task_options.h"
#include "clearway/sweep.h"
#include "clearway/targets.h"
#include "core/clock.h"

namespace clearway::testing::ladder {

// Shares of the scene's size.
constexpr double kDoubleError = 1e-12;
constexpr double kFloatError = 1e-5;
constexpr double kPeerError = 1e-9;

/// No corner of the part's box moves farther between two poses than this share of the part's size.
constexpr double kMotionStep = 3e-4;

enum class Engine { kScalarDouble, kFloatExactRectangles, kFloat, kLibrary };

/// A step of the ladder: one change to the step before it.
struct Step {
    const char* name;
    Engine engine;
    bool isWarm;
    BuildOptions trees;
    const char* target = "best";  ///< the instruction set
};

BuildOptions trees(const char* split, const char* fit, int leafSize, int nodeWidth) {
    BuildOptions options;
    options.generalSplit = split;
    options.leafSplit = "none";
    options.fit = fit;
    options.leafSize = leafSize;
    options.nodeWidth = nodeWidth;
    return options;
}

const std::vector<Step>& steps() {
    static const std::vector<Step> kSteps = {
        {"thesis's tree", Engine::kScalarDouble, false, trees("axis", "covariance", 1, 2)},
        {"builder", Engine::kScalarDouble, false, trees("sah", "covariance", 1, 2)},
        {"fit", Engine::kScalarDouble, false, trees("sah", "frames", 1, 2)},
        {"leaves of four", Engine::kScalarDouble, false, trees("sah", "frames", 4, 2)},
        {"float", Engine::kFloat, false, trees("sah", "frames", 4, 2), "scalar"},
        {"leaf width", Engine::kFloat, false, trees("sah", "frames", 4, 2)},
        {"node width", Engine::kFloatExactRectangles, false, trees("sah", "frames", 4, 8)},
        {"cheap bound", Engine::kFloat, false, trees("sah", "frames", 4, 8)},
        {"double finish", Engine::kLibrary, false, trees("sah", "frames", 4, 8)},
        {"warm start", Engine::kLibrary, true, trees("sah", "frames", 4, 8)},
        {"leaf split", Engine::kLibrary, true, BuildOptions()},
    };
    return kSteps;
}

/// A row of the table.
struct Row {
    std::string step;
    std::string asked;  ///< "pose" or "motion"
    std::size_t count = 0, repetitions = 0;
    double median = 0, mean = 0;  ///< microseconds
    QueryCounters work;           ///< of all queries
    double worstError = 0;        ///< share of the scene's size
    std::size_t wrong = 0;
    std::size_t missed = 0;  ///< motions called valid that touch between two poses
};

/// Makes a series of distances; `forget` drops the engine's warm start.
Series seriesOf(const BenchTask& task, const std::string& name, std::function<Answer(const Pose&)> ask,
                const std::function<void()>& forget, bool isWarm, const std::string& target) {
    Series series;
    series.engine = name;
    series.ask = std::move(ask);
    series.beforePass = [forget, target] {
        useTarget(target);
        forget();
    };
    if (!isWarm) series.beforeQuery = forget;
    series.order = inOrder(task.poses.size());
    return series;
}

Series seriesOf(const Step& step, const BenchTask& task, const TreePair& built) {
    const auto made = [&](const auto& engine) {
        return seriesOf(
            task, step.name, [engine](const Pose& pose) { return engine->distance(pose); },
            [engine] { engine->forgetWarmStart(); }, step.isWarm, step.target);
    };
    switch (step.engine) {
        case Engine::kScalarDouble:
            return made(std::make_shared<ScalarDouble>(built.part, built.environment));
        case Engine::kFloatExactRectangles:
            return made(std::make_shared<FloatOnly>(built.part, built.environment, /*exactRectangles*/ true));
        case Engine::kFloat:
            return made(std::make_shared<FloatOnly>(built.part, built.environment));
        case Engine::kLibrary:
            break;
    }
    const auto workspace = std::make_shared<Workspace>();
    const auto ask = [built, workspace](const Pose& pose) {
        const DistanceResult found = distance(built.part, built.environment, pose, {}, *workspace);
        return Answer{found.distance, found.lower, found.upper, found.counters};
    };
    return seriesOf(
        task, step.name, ask, [workspace] { workspace->forgetWarmStart(); }, step.isWarm, step.target);
}

double errorAllowed(Engine engine) {
    return engine == Engine::kFloat || engine == Engine::kFloatExactRectangles ? kFloatError : kDoubleError;
}

/// The errors of a series. isProved: its answers are intervals, which must hold the true distance.
Row rowOf(const Series& series, const std::vector<double>& truths, double sceneSize, double allowed,
          bool isProved) {
    Row row;
    row.step = series.engine;
    row.asked = "pose";
    row.count = truths.size();
    row.repetitions = series.nanoseconds.size();
    const std::vector<double> times = series.medians();
    row.median = median(times) / 1000;
    row.mean = mean(times) / 1000;
    for (std::size_t i = 0; i < truths.size(); ++i) {
        const Answer& answer = series.answers[i];
        row.work += answer.counters;
        const double error = std::abs(std::max(0.0, answer.value) - truths[i]) / sceneSize;
        const double rounding = kDoubleError * sceneSize;
        const bool isOutside = answer.lower > truths[i] + rounding || answer.upper < truths[i] - rounding;
        row.worstError = std::max(row.worstError, error);
        row.wrong += !(error <= allowed) || (isProved && isOutside);
    }
    return row;
}

/// A motion between two poses that are free.
struct FreeEnds {
    RigidMotion motion;
    int steps;  ///< in which no corner of the part's box moves farther than kMotionStep
};

std::vector<FreeEnds> motionsOf(const BenchTask& task, const TreePair& built,
                                const std::vector<double>& truths) {
    const std::vector<double> lengths = stepsBetween(task.poses, built.part.box());
    std::vector<FreeEnds> motions;
    for (std::size_t i = 0; i + 1 < task.poses.size(); ++i) {
        if (truths[i] == 0 || truths[i + 1] == 0) continue;
        motions.push_back({motionBetween(task.poses[i], task.poses[i + 1]),
                           std::max(1, int(std::ceil(lengths[i] / kMotionStep)))});
    }
    return motions;
}

/// Checks motions, by poses in steps and certified. A verdict is wrong if a certified motion touches at one of the poses, or a
/// contact that was found is none.
class MotionChecks {
  public:
    MotionChecks(const BenchTask& task, const TreePair& built, const std::vector<double>& truths)
        : built_(built), sceneSize_(task.sceneSize()), motions_(motionsOf(task, built, truths)) {}

    std::vector<Row> run(const Schedule& schedule) {
        if (motions_.empty()) return {};
        Row steps, certified;
        steps.step = "motions in steps";
        certified.step = "certified motions";
        steps.asked = certified.asked = "motion";
        std::vector<SweepResult> results(motions_.size());
        std::vector<char> areValid(motions_.size());
        runPinned(schedule.cpu, [&] {
            measure(schedule, steps, [&](std::size_t i) { return inSteps(motions_[i], areValid[i]); });
            measure(schedule, certified, [&](std::size_t i) {
                results[i] = sweep(built_.part, built_.environment, piecesOf(motions_[i].motion, built_.part),
                                   {}, workspace_);
                return results[i].counters;
            });
        });
        for (std::size_t i = 0; i < results.size(); ++i) {
            const bool isContact = results[i].verdict == SweepVerdict::kContact;
            const bool touches = isContact && distanceAt(motions_[i].motion, *results[i].contactTime) <=
                                                  kDoubleError * sceneSize_;
            certified.wrong +=
                (isContact && !touches) || (results[i].verdict == SweepVerdict::kCertified && !areValid[i]);
            steps.missed += touches && areValid[i];
        }
        return {steps, certified};
    }

  private:
    template <class Ask>
    void measure(const Schedule& schedule, Row& row, const Ask& ask) {
        std::vector<std::vector<double>> times(motions_.size());
        for (int pass = 0; pass <= schedule.repetitions; ++pass) {
            workspace_.forgetWarmStart();
            row.work = {};
            for (std::size_t i = 0; i < motions_.size(); ++i) {
                const auto start = Clock::now();
                row.work += ask(i);
                const double seconds = secondsSince(start);
                if (pass > 0) times[i].push_back(1e6 * seconds);
            }
        }
        std::vector<double> medians;
        for (const auto& ofMotion : times) medians.push_back(median(ofMotion));
        row.count = medians.size();
        row.repetitions = std::size_t(schedule.repetitions);
        row.median = median(medians);
        row.mean = mean(medians);
    }

    QueryCounters inSteps(const FreeEnds& motion, char& isValid) {
        const MotionPieces pieces = piecesOf(motion.motion, built_.part);
        QueryCounters work;
        isValid = true;
        for (int k = 0; k <= motion.steps && isValid; ++k) {
            const double time = double(k) / motion.steps;
            isValid = !collides(built_.part, built_.environment, pieces(time, time).middle, workspace_);
            work += workspace_.counters();
        }
        return work;
    }

    double distanceAt(const RigidMotion& motion, double time) {
        return distance(built_.part, built_.environment, piecesOf(motion, built_.part)(time, time).middle, {},
                        workspace_)
            .distance;
    }

    TreePair built_;
    double sceneSize_;
    std::vector<FreeEnds> motions_;
    Workspace workspace_;
};

std::string textOf(const BenchTask& task, const Row& row) {
    std::ostringstream out;
    out << std::setprecision(6);
    const auto each = [&](std::uint64_t count) { return double(count) / double(row.count); };
    out << task.name << ',' << task.sceneName << ',' << task.part.triangles.size() << ','
        << task.environment.triangles.size() << ',' << row.step << ',' << row.asked << ',' << row.count << ','
        << row.repetitions << ',' << row.median << ',' << row.mean << ',' << each(row.work.volumeTests) << ','
        << each(row.work.triangleTests) << ',';
    if (row.asked == "pose") out << row.worstError;
    out << ',' << row.wrong << ',' << row.missed << '\n';
    return out.str();
}

/// Appends the rows of a scene to the table. Returns the number of wrong answers.
std::size_t measure(const BenchTask& task, const TaskChoices& choices, std::string& table) {
    std::vector<Series> all;
    for (const Step& step : steps()) {
        all.push_back(seriesOf(step, task, buildTrees(task, step.trees)));
    }
    if (!choices.withoutPeers) {
        for (const NamedPeer& named : distancePeers()) {
            if (std::string(named.name) != "PQP") continue;
            const Peer pqp = named.make(task.part, task.environment);
            all.push_back(seriesOf(task, "PQP", pqp.distance, pqp.forgetWarmStart, /*isWarm*/ false, "best"));
        }
    }
    runAll(all, task.poses, choices.schedule);
    useTarget("best");

    const Referee oracle = lazyOracle(task);
    std::vector<double> truths;
    for (std::size_t i = 0; i < task.poses.size(); ++i) truths.push_back(oracle(i));
    std::vector<Row> rows;
    for (std::size_t k = 0; k < all.size(); ++k) {
        const bool isPeer = k >= steps().size();
        rows.push_back(rowOf(all[k], truths, task.sceneSize(),
                             isPeer ? kPeerError : errorAllowed(steps()[k].engine), !isPeer));
    }
    for (const Row& row :
         MotionChecks(task, buildTrees(task, steps().back().trees), truths).run(choices.schedule)) {
        rows.push_back(row);
    }
    std::size_t wrong = 0;
    for (const Row& row : rows) {
        table += textOf(task, row);
        if (row.step != "PQP") wrong += row.wrong;
    }
    return wrong;
}

int run(int count, char** words) {
    TaskChoices choices;
    choices.scenes = {"K", "I"};
    choices.poseCount = 100;
    choices.schedule.peerBudget = 10;
    cli::CommandLine line(
        "benchmarks ladder [options]",
        "Times distances from the thesis's engine to clearway's, with one more step each time.");
    addTaskOptions(line, "ladder.csv", choices);
    if (!line.parse({words + 1, words + count})) return 0;
    std::string table =
        "scene,scene_name,part_triangles,environment_triangles,step,asked,count,repetitions,us_median,us_"
        "mean,"
        "volume_tests,triangle_tests,error_worst,wrong,missed\n";
    std::size_t wrong = 0;
    for (const std::string& scene : choices.scenes)
        wrong += measure(makeTask(choices, scene), choices, table);
    std::cout << table;
    if (wrong > 0) std::cout << wrong << " answers are wrong\n";
    writeTable(choices.out, "ladder.csv", table);
    return wrong == 0 ? 0 : 1;
}

}  // namespace clearway::testing::ladder
