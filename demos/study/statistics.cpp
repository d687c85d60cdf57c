#include "demos/study/statistics.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <functional>
#include <map>
#include <optional>
#include <random>
#include <tuple>
#include <type_traits>

namespace clearway::study {
namespace {

constexpr std::size_t kResamples = 2000;
constexpr double kOutside = 0.025;  ///< share of the resamples outside the interval, at each end
constexpr std::uint64_t kSeed = 20131;
constexpr const char* kAllPlanners = "all";

double number(const Count& count) {
    return static_cast<double>(count.value_or(0));
}

/// Scene, engine and planner as texts, by which the files' rows are sorted.
using Key = std::array<std::string, 7>;
constexpr std::size_t kLeafSplit = 5, kPlanner = 6;

Key columnsOf(const CallsRow& row) {
    return {row.scene,
            row.generalSplit,
            std::to_string(row.leafSize),
            std::to_string(row.nodeWidth),
            row.instructions,
            row.leafSplit,
            row.planner};
}

template <class Row>
Row rowAt(const Key& key, const CallsRow& like) {
    Row row;
    static_cast<CallsRow&>(row) = like;
    row.planner = key[kPlanner];
    return row;
}

/// Compares two rows. The ratio is empty if either row lacks the measure.
template <class Row>
using RatioOf = std::function<Measure(const Row& mine, const Row& other)>;

/// The ratio of a value that both rows have, neither of them below 0.
template <class Row, class Value>
RatioOf<Row> ratioOf(const Value& value) {
    return [value](const Row& row, const Row& with) -> Measure {
        const Measure mine = value(row), other = value(with);
        if (!mine || !other || !(*mine >= 0) || !(*other > 0)) return std::nullopt;
        return *mine / *other;
    };
}

Measure quotient(double of, double per) {
    return per > 0 ? Measure(of / per) : std::nullopt;
}

/// Leaves out disturbed runs, because their clock times depend on the machine's other work.
RatioOf<RunRow> undisturbed(const RatioOf<RunRow>& ratio) {
    return [ratio](const RunRow& mine, const RunRow& other) -> Measure {
        if (mine.wasDisturbed() || other.wasDisturbed()) return std::nullopt;
        return ratio(mine, other);
    };
}

/// The ratio of the times to the first solution. An unsolved run would have taken longer than it did. But
/// without such pairs, only pairs in which the slower strategy was quick enough would count.
Measure firstSolutionRatio(const RunRow& mine, const RunRow& other) {
    const Measure ofMine = mine.firstSolution(), ofOther = other.firstSolution();
    if (!ofMine && !ofOther) return std::nullopt;
    const double first = ofMine.value_or(mine.seconds.value_or(0)),
                 with = ofOther.value_or(other.seconds.value_or(0));
    const bool isKnown = ofMine && ofOther, isLonger = ofMine ? with > first : first > with;
    if (!(first > 0) || !(with > 0) || !(isKnown || isLonger)) return std::nullopt;
    return first / with;
}

template <class Row>
class Pairing {
  public:
    Pairing(const std::vector<Row>& rows, std::string source, std::string baseline)
        : rows_(rows), source_(std::move(source)), baseline_(std::move(baseline)) {
        for (const Row& row : rows) {
            if (row.leafSplit == baseline_) baselines_[pairKey(row)] = &row;
        }
    }

    /// isOfAllPlanners: false for a measure whose meaning differs between planners.
    void add(const char* measure, const RatioOf<Row>& ratio, std::vector<StatisticRow>& statistics,
             bool isOfAllPlanners = true) const {
        struct Found {
            const CallsRow* row = nullptr;
            std::map<std::string, std::vector<double>> clusters;  ///< by planner and seed
        };
        std::map<Key, Found> found;
        for (const Row& row : rows_) {
            const auto with = baselines_.find(pairKey(row));
            if (row.leafSplit == baseline_ || with == baselines_.end()) continue;
            const Measure value = ratio(row, *with->second);
            if (!value) continue;
            Key key = columnsOf(row);
            for (const std::string& planner : {row.planner, std::string(kAllPlanners)}) {
                if (planner == kAllPlanners && !isOfAllPlanners) continue;
                key[kPlanner] = planner;
                found[key].row = &row;
                found[key].clusters[row.planner + "/" + std::to_string(row.seed)].push_back(*value);
            }
        }
        for (const auto& [key, of] : found) {
            std::vector<std::vector<double>> ratios;
            for (const auto& cluster : of.clusters) ratios.push_back(cluster.second);
            auto row = rowAt<StatisticRow>(key, *of.row);
            static_cast<PairedRatio&>(row) = pairedRatio(ratios);
            row.source = source_;
            row.measure = measure;
            row.baseline = baseline_;
            statistics.push_back(row);
        }
    }

    void addFills(std::vector<StatisticRow>& statistics) const {
        const auto blocks = [](const Row& row) {
            return quotient(number(row.triangleTests), number(row.triangleLanes));
        };
        const auto kernels = [](const Row& row) {
            return quotient(number(row.kernelPairs), number(row.kernelLanes));
        };
        add("block_fill", ratioOf<Row>(blocks), statistics);
        add("kernel_fill", ratioOf<Row>(kernels), statistics);
    }

  private:
    static auto pairKey(const Row& row) {
        Key key = columnsOf(row);
        key[kLeafSplit].clear();
        return std::tuple(key, row.seed, row.block);
    }

    const std::vector<Row>& rows_;
    std::string source_, baseline_;
    std::map<std::tuple<Key, int, std::uint64_t>, const Row*> baselines_;
};

/// Sums over the runs, or over the replayed blocks, of one engine and planner.
struct Sums {
    const CallsRow* first = nullptr;
    std::size_t rows = 0, solved = 0, disturbed = 0;
    std::vector<double> firstSolutions, finalSolutions, costs;
    double stateChecks = 0, motionChecks = 0, motionCosts = 0, distanceQueries = 0, withinQueries = 0;
    double seconds = 0, calls = 0, askingSeconds = 0, querySeconds = 0, queries = 0, volumes = 0,
           triangles = 0, lanes = 0, kernelPairs = 0, kernelLanes = 0;

    void add(const RunRow& run) {
        addWork(run, run, run.calls(), run.askingSeconds().value_or(0));
        if (run.wasDisturbed()) ++disturbed;
        seconds += run.seconds.value_or(0);
        querySeconds += run.querySeconds.value_or(0);
        stateChecks += number(run.stateChecks);
        motionChecks += number(run.motionChecks);
        motionCosts += number(run.motionCosts);
        distanceQueries += number(run.distanceQueries);
        withinQueries += number(run.withinQueries);
        if (run.isSolved != 1u) return;
        ++solved;
        const auto keep = [](const Measure& value, std::vector<double>& all) {
            if (value) all.push_back(*value);
        };
        keep(run.firstSolution(), firstSolutions);
        keep(run.finalSolutionSeconds, finalSolutions);
        keep(run.finiteCost(), costs);
    }

    void add(const ReplayRow& block) {
        addWork(block, block, static_cast<double>(block.calls), block.seconds);
    }

    void addWork(const CallsRow& row, const Work& work, double asked, double took) {
        first = &row;
        ++rows;
        calls += asked;
        askingSeconds += took;
        queries += work.queries();
        volumes += number(work.volumeTests);
        triangles += number(work.triangleTests);
        lanes += number(work.triangleLanes);
        kernelPairs += number(work.kernelPairs);
        kernelLanes += number(work.kernelLanes);
    }

    void writeRuns(SummaryRow& row) const {
        const auto count = static_cast<double>(rows);
        const auto medianOf = [](const std::vector<double>& values) {
            return values.empty() ? std::nullopt : Measure(median(values));
        };
        row.runs = rows;
        row.solved = solved;
        row.disturbed = disturbed;
        row.firstSolutionSeconds = medianOf(firstSolutions);
        row.finalSolutionSeconds = medianOf(finalSolutions);
        row.cost = medianOf(costs);
        row.stateChecks = quotient(stateChecks, count);
        row.motionChecks = quotient(motionChecks, count);
        row.motionCosts = quotient(motionCosts, count);
        row.distanceQueries = quotient(distanceQueries, count);
        row.withinQueries = quotient(withinQueries, count);
        row.queryShare = quotient(querySeconds, seconds);
    }

    void writeWork(SummaryRow& row) const {
        row.callsPerSecond = quotient(calls, askingSeconds);
        row.volumeTests = quotient(volumes, queries);
        row.triangleTests = quotient(triangles, queries);
        row.blockFill = quotient(triangles, lanes);
        row.kernelFill = quotient(kernelPairs, kernelLanes);
    }
};

template <class Row>
void addSummary(const std::vector<Row>& rows, const char* source, std::vector<SummaryRow>& summary) {
    constexpr bool kAreRuns = std::is_same_v<Row, RunRow>;
    std::map<Key, Sums> sums;
    for (const Row& row : rows) {
        Key key = columnsOf(row);
        sums[key].add(row);
        key[kPlanner] = kAllPlanners;
        sums[key].add(row);
    }
    for (const auto& [key, of] : sums) {
        auto row = rowAt<SummaryRow>(key, *of.first);
        row.source = source;
        if (kAreRuns) of.writeRuns(row);
        of.writeWork(row);
        summary.push_back(row);
    }
}

}  // namespace

double median(std::vector<double> values) {
    assert(!values.empty());
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    if (values.size() % 2 == 1) return *middle;
    return (*middle + *std::max_element(values.begin(), middle)) / 2;
}

PairedRatio pairedRatio(const std::vector<std::vector<double>>& clusters) {
    PairedRatio result;
    std::vector<double> ofClusters;
    for (const auto& cluster : clusters) {
        if (cluster.empty()) continue;
        ofClusters.push_back(median(cluster));
        result.pairs += cluster.size();
    }
    result.clusters = ofClusters.size();
    if (ofClusters.empty()) return result;
    result.median = median(ofClusters);

    std::mt19937_64 random(kSeed);  // without the standard's distributions, which differ between libraries
    std::vector<double> medians, drawn(ofClusters.size());
    for (std::size_t i = 0; i < kResamples; ++i) {
        for (double& cluster : drawn) cluster = ofClusters[random() % ofClusters.size()];
        medians.push_back(median(drawn));
    }
    std::sort(medians.begin(), medians.end());
    const auto outside = static_cast<std::size_t>(kOutside * kResamples);
    result.low = medians[outside];
    result.high = medians[kResamples - 1 - outside];
    return result;
}

Columns<StatisticRow> statisticColumns() {
    using Row = StatisticRow;
    return {
        {"scene", &Row::scene},        {"source", &Row::source},        {"general_split", &Row::generalSplit},
        {"leaf_size", &Row::leafSize}, {"node_width", &Row::nodeWidth}, {"instructions", &Row::instructions},
        {"planner", &Row::planner},    {"measure", &Row::measure},      {"leaf_split", &Row::leafSplit},
        {"baseline", &Row::baseline},  {"ratio", &Row::median},         {"low", &Row::low},
        {"high", &Row::high},          {"pairs", &Row::pairs},          {"clusters", &Row::clusters}};
}

std::vector<StatisticRow> statisticsOf(const std::vector<RunRow>& runs, const std::vector<ReplayRow>& replays,
                                       const std::string& baseline) {
    const auto ofRun = [](const auto& value) { return ratioOf<RunRow>(value); };
    const auto ofReplay = [](const auto& value) { return ratioOf<ReplayRow>(value); };
    const auto secondsPerCall = [](const RunRow& run) {
        return quotient(run.askingSeconds().value_or(0), run.calls());
    };
    const auto querySecondsPerCall = [](const RunRow& run) {
        return quotient(run.querySeconds.value_or(0), run.calls());
    };
    const auto volumesPerQuery = [](const RunRow& run) {
        return quotient(number(run.volumeTests), run.queries());
    };
    const auto trianglesPerQuery = [](const RunRow& run) {
        return quotient(number(run.triangleTests), run.queries());
    };
    std::vector<StatisticRow> all;
    const Pairing<RunRow> pairs(runs, "runs", baseline);
    pairs.add("first_solution_seconds", undisturbed(firstSolutionRatio), all);
    pairs.add("seconds_per_call", ofRun(secondsPerCall), all);
    pairs.add("query_seconds_per_call", undisturbed(ofRun(querySecondsPerCall)), all);
    pairs.add("cost", ofRun([](const RunRow& run) { return run.finiteCost(); }), all, false);
    pairs.add("volume_tests_per_query", ofRun(volumesPerQuery), all);
    pairs.add("triangle_tests_per_query", ofRun(trianglesPerQuery), all);
    const Pairing<ReplayRow> blocks(replays, "replay", baseline);
    blocks.add("seconds", ofReplay([](const ReplayRow& block) { return Measure(block.seconds); }), all);
    blocks.add("volume_tests",
               ofReplay([](const ReplayRow& block) { return Measure(number(block.volumeTests)); }), all);
    blocks.add("triangle_tests",
               ofReplay([](const ReplayRow& block) { return Measure(number(block.triangleTests)); }), all);
    pairs.addFills(all);
    blocks.addFills(all);
    return all;
}

Columns<SummaryRow> summaryColumns() {
    using Row = SummaryRow;
    const Columns<Row> source = {{"scene", &Row::scene}, {"source", &Row::source}};
    const Columns<Row> figures = {{"planner", &Row::planner},
                                  {"runs", &Row::runs},
                                  {"solved", &Row::solved},
                                  {"disturbed", &Row::disturbed},
                                  {"first_solution_seconds", &Row::firstSolutionSeconds},
                                  {"final_solution_seconds", &Row::finalSolutionSeconds},
                                  {"cost", &Row::cost},
                                  {"state_checks", &Row::stateChecks},
                                  {"motion_checks", &Row::motionChecks},
                                  {"motion_costs", &Row::motionCosts},
                                  {"distance_queries", &Row::distanceQueries},
                                  {"within_queries", &Row::withinQueries},
                                  {"calls_per_second", &Row::callsPerSecond},
                                  {"query_share", &Row::queryShare},
                                  {"volume_tests", &Row::volumeTests},
                                  {"triangle_tests", &Row::triangleTests},
                                  {"block_fill", &Row::blockFill},
                                  {"kernel_fill", &Row::kernelFill}};
    return source + engineColumns<Row>() + figures;
}

std::vector<SummaryRow> summaryOf(const std::vector<RunRow>& runs, const std::vector<ReplayRow>& replays) {
    std::vector<SummaryRow> summary;
    addSummary(runs, "runs", summary);
    addSummary(replays, "replay", summary);
    return summary;
}

}  // namespace clearway::study
