// Measures how time and memory grow with the number of triangles: a distance, a certified motion, and the trees of clearway
// and of its peers. A run measures one size of one scene.
//   benchmarks growth [--part-triangles N] [--environment-triangles N] [--out DIR] ...      see --help and README.md in this folder
// Ends with exit code 1 when an answer is wrong, and with 2 when the benchmark cannot run.
#include <algorithm>
#include <iomanip>
#include <iostream>
#include <sstream>
#include <stdexcept>

#include "bench/clearway_series.h"
#include "bench/judge.h"
#include "bench/pinned.h"
#include "bench/task_options.h"
#include "clearway/sweep.h"
#include "core/clock.h"
#include "core/number.h"

namespace clearway::testing::growth {

constexpr double kAgreement = 1e-9;  // share of the scene's size
constexpr int kBuildRounds = 5;
constexpr double kBuildBudget = 3;  // seconds; no further round of builds starts after them
constexpr int kProbes = 3;          // queries that tell how long a pass of a peer will take

/// A row of the table.
struct Row {
    std::string engine;
    std::string leftOut;  ///< why the queries were not measured; empty if they were
    double buildSeconds = 0, bytesPerTriangle = 0;
    const Series* series = nullptr;
    std::size_t wrong = 0;  ///< distances and motions
};

/// Times clearway's certified motions between consecutive poses, and checks their verdicts.
class Motions {
  public:
    Motions(const BenchTask& task, const TreePair& trees) : task_(task), trees_(trees) {}

    void run(const Schedule& schedule) {
        std::vector<std::vector<double>> times(task_.poses.size() - 1);
        results_.resize(times.size());
        runPinned(schedule.cpu, [&] {
            for (int pass = 0; pass <= schedule.repetitions; ++pass) {
                workspace_.forgetWarmStart();
                for (std::size_t i = 0; i < times.size(); ++i) {
                    const auto start = Clock::now();
                    results_[i] = sweep(trees_.part, trees_.environment, motion(i), {}, workspace_);
                    if (pass > 0) times[i].push_back(1e6 * secondsSince(start));
                }
            }
        });
        for (const auto& ofMotion : times) microseconds_.push_back(testing::median(ofMotion));
        for (std::size_t i = 0; i < results_.size(); ++i) wrong_ += !isRight(i);
    }

    std::size_t count() const { return microseconds_.size(); }
    std::size_t count(SweepVerdict verdict) const {
        return std::size_t(std::count_if(results_.begin(), results_.end(), [&](const SweepResult& result) {
            return result.verdict == verdict;
        }));
    }
    double median() const { return testing::median(microseconds_); }
    double mean() const { return testing::mean(microseconds_); }
    std::size_t wrong() const { return wrong_; }

  private:
    MotionPieces motion(std::size_t i) const {
        return piecesOf(motionBetween(task_.poses[i], task_.poses[i + 1]), trees_.part);
    }

    double distanceAt(std::size_t i, double time) {
        return distance(trees_.part, trees_.environment, motion(i)(time, time).middle, {}, workspace_)
            .distance;
    }

    /// A certified motion has no pose in contact, and a contact is one.
    bool isRight(std::size_t i) {
        const SweepResult& result = results_[i];
        if (result.verdict == SweepVerdict::kContact) {
            return distanceAt(i, *result.contactTime) <= kAgreement * task_.sceneSize();
        }
        for (const double time : {0.0, 0.25, 0.5, 0.75, 1.0}) {
            if (result.verdict == SweepVerdict::kCertified && !(distanceAt(i, time) > 0)) return false;
        }
        return true;
    }

    const BenchTask& task_;
    const TreePair& trees_;
    Workspace workspace_;
    std::vector<SweepResult> results_;
    std::vector<double> microseconds_;
    std::size_t wrong_ = 0;
};

/// Builds both trees on one thread, several times if that takes little time.
TreePair build(const BenchTask& task, Row& row) {
    BuildOptions options;
    options.threads = 1;
    std::vector<double> seconds;
    const auto begin = Clock::now();
    while (true) {
        const auto start = Clock::now();
        const TreePair trees = buildTrees(task, options);
        seconds.push_back(secondsSince(start));
        if (int(seconds.size()) < kBuildRounds && secondsSince(begin) < kBuildBudget) continue;
        row.buildSeconds = median(seconds);
        const BuildReport &part = trees.part.report(), &environment = trees.environment.report();
        row.bytesPerTriangle =
            double(part.tree.bytes + environment.tree.bytes) / double(part.triangles + environment.triangles);
        return trees;
    }
}

/// Builds a peer's trees, and keeps them if a pass over the poses will take less than `budget` seconds.
void addPeer(const NamedPeer& named, const BenchTask& task, double budget, std::vector<Peer>& peers,
             std::vector<Row>& rows) {
    Peer peer = named.make(task.part, task.environment);
    Row row{named.name, "", peer.buildSeconds,
            double(peer.bytes) / double(task.part.triangles.size() + task.environment.triangles.size())};
    const auto start = Clock::now();
    for (std::size_t i = 0; i < kProbes; ++i) peer.distance(task.poses[i * task.poses.size() / kProbes]);
    const double expected = secondsSince(start) / kProbes * double(task.poses.size());
    if (expected > budget) {
        row.leftOut = "a pass would take " + shortNumber(std::round(expected)) + " s";
    } else {
        peers.push_back(std::move(peer));
    }
    rows.push_back(row);
}

constexpr const char* kHeader =
    "scene,scene_name,part_triangles,environment_triangles,engine,build_seconds,bytes_per_triangle,poses,"
    "repetitions,"
    "us_median,us_mean,node_visits,volume_tests,triangle_tests,motions,motions_certified,motions_in_contact,"
    "us_motion_median,us_motion_mean,wrong,left_out\n";

std::string textOf(const BenchTask& task, const Row& row, const Motions* motions) {
    std::ostringstream out;
    out << std::setprecision(6) << task.name << ',' << task.sceneName << ',' << task.part.triangles.size()
        << ',' << task.environment.triangles.size() << ',' << row.engine << ',' << row.buildSeconds << ','
        << row.bytesPerTriangle << ',' << task.poses.size() << ',';
    if (row.series) {
        QueryCounters work;
        for (const Answer& answer : row.series->answers) work += answer.counters;
        const auto each = [&](std::uint64_t count) {  // peers do not count all
            std::ostringstream number;
            if (count > 0) number << std::setprecision(6) << double(count) / double(task.poses.size());
            return number.str();
        };
        const std::vector<double> times = row.series->medians();
        out << row.series->nanoseconds.size() << ',' << median(times) / 1000 << ',' << mean(times) / 1000
            << ',' << each(work.nodeVisits) << ',' << each(work.volumeTests) << ','
            << each(work.triangleTests) << ',';
    } else {
        out << "0,,,,,,";
    }
    if (motions) {
        out << motions->count() << ',' << motions->count(SweepVerdict::kCertified) << ','
            << motions->count(SweepVerdict::kContact) << ',' << motions->median() << ',' << motions->mean()
            << ',';
    } else {
        out << ",,,,,";
    }
    out << row.wrong << ',' << row.leftOut << '\n';
    return out.str();
}

/// Appends the rows of a scene to the table. Returns the number of wrong answers of clearway.
std::size_t measure(const BenchTask& task, const TaskChoices& choices, std::string& table) {
    std::vector<Row> rows(1);
    rows[0].engine = "clearway";
    const TreePair trees = build(task, rows[0]);
    std::vector<Peer> peers;
    if (!choices.withoutPeers) {
        for (const NamedPeer& named : distancePeers()) {
            addPeer(named, task, choices.schedule.peerBudget, peers, rows);
        }
    }
    std::vector<Series> all = distanceSeries(task, trees, peers);
    runAll(all, task.poses, choices.schedule);
    Motions motions(task, trees);
    motions.run(choices.schedule);
    const Judgement judgement =
        judge(all, task.poses.size(), kAgreement * task.sceneSize(), lazyOracle(task), /*refereed*/ 0);
    std::size_t next = 0;
    for (Row& row : rows) {
        if (!row.leftOut.empty()) continue;
        row.wrong = std::size_t(judgement.wrong[next]);
        row.series = &all[next++];
    }
    rows[0].wrong += motions.wrong();
    for (const Row& row : rows) table += textOf(task, row, &row == &rows[0] ? &motions : nullptr);
    for (const std::string& complaint : judgement.complaints) std::cout << complaint << '\n';
    if (motions.wrong() > 0) std::cout << motions.wrong() << " verdicts on motions are wrong\n";
    return rows[0].wrong;
}

int run(int count, char** words) {
    TaskChoices choices;
    choices.scenes = {"M"};
    cli::CommandLine line("benchmarks growth [options]",
                          "Times distances, certified motions and builds at one number of triangles.");
    addTaskOptions(line, "growth.csv", choices);
    if (!line.parse({words + 1, words + count})) return 0;
    if (choices.poseCount < 2) {
        throw std::invalid_argument(
            "--pose-count is 1, expected at least 2: motions lead from a pose to the next");
    }
    std::string table = kHeader;
    std::size_t wrong = 0;
    for (const std::string& scene : choices.scenes)
        wrong += measure(makeTask(choices, scene), choices, table);
    std::cout << table;
    writeTable(choices.out, "growth.csv", table);
    return wrong == 0 ? 0 : 1;
}

}  // namespace clearway::testing::growth
