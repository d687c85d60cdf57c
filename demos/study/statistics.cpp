#include "demos/study/statistics.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <functional>
#include <map>
#include <random>
#include <tuple>

#include "demos/study/qualification.h"

namespace clearway::study {
namespace {

constexpr std::size_t kResamples = 2000;
constexpr double kOutside = 0.025;  ///< share of the resamples outside the interval, at each end
constexpr std::uint64_t kSeed = 20131;
constexpr const char* kAllPlanners = "all";
constexpr double kMicro = 1e-6;

double number(const Count& count) {
    return static_cast<double>(count.value_or(0));
}

Measure quotient(const Measure& of, const Measure& per) {
    return of && per && *per > 0 ? Measure(*of / *per) : std::nullopt;
}

using Key = std::tuple<std::string, std::string, std::string, std::string, int, int, std::string>;

/// Scene, planner and engine.
Key keyOf(const CallsRow& row) {
    return {row.scene,    row.planner,   row.generalSplit, row.leafSplit,
            row.leafSize, row.nodeWidth, row.instructions};
}

template <class Row>
std::map<Key, std::map<int, const Row*>> bySeed(const std::vector<Row>& rows) {
    std::map<Key, std::map<int, const Row*>> cells;
    for (const Row& row : rows) cells[keyOf(row)][row.seed] = &row;
    return cells;
}

/// The same scene, planner, leaf size, width and instructions in another tree.
CallsRow inTree(CallsRow row, const std::string& general, const std::string& leaf) {
    row.generalSplit = general;
    row.leafSplit = leaf;
    return row;
}

const FilesRow* filesOf(const std::vector<FilesRow>& files, const CallsRow& row) {
    for (const FilesRow& each : files) {
        if (each.scene == row.scene && static_cast<const Engine&>(each) == row) return &each;
    }
    return nullptr;
}

Measure filesSeconds(const std::vector<FilesRow>& files, const CallsRow& row) {
    const FilesRow* const found = filesOf(files, row);
    return found ? Measure(found->seconds()) : std::nullopt;
}

template <class Row>
using ValueOf = std::function<Measure(const Row&)>;

template <class Row>
struct NamedMeasure {
    const char* name;
    ValueOf<Row> value;
    bool isTime = false;
    bool isOfAnyPair = false;  ///< also of runs that did not do the same
};

/// The trees that an engine is compared with, as general and leaf split.
std::vector<std::pair<std::string, std::string>> baselinesOf(const Engine& engine,
                                                             const StudyOptions& options) {
    std::vector<std::pair<std::string, std::string>> all;
    const std::string& none = options.leafSplits.front();
    if (engine.leafSplit != none) all.emplace_back(engine.generalSplit, none);
    if (engine.generalSplit != options.generalSplits.back())
        all.emplace_back(options.generalSplits.back(), none);
    return all;
}

bool hasEnough(const std::map<int, const RunRow*>& runs) {
    const auto solved = std::count_if(
        runs.begin(), runs.end(), [](const auto& run) { return run.second->planningSeconds().has_value(); });
    return static_cast<double>(solved) >= kLeastSolved * static_cast<double>(runs.size()) - 1e-9;
}

bool hasEnough(const std::map<int, const ReplayRow*>& /*samples*/) {
    return true;
}

bool isPair(const ReplayRow& /*a*/, const ReplayRow& /*b*/) {
    return true;
}
bool isPair(const RunRow& a, const RunRow& b) {
    return didTheSame(a, b);
}

/// A run's cell has few pairs when planners decide otherwise in other trees: these would be a lucky choice.
std::size_t leastPairs(const std::map<int, const RunRow*>& runs) {
    return (runs.size() + 1) / 2;
}
std::size_t leastPairs(const std::map<int, const ReplayRow*>& /*samples*/) {
    return 1;
}

bool wasDisturbed(const RunRow& run) {
    return run.wasDisturbed();
}
bool wasDisturbed(const ReplayRow& /*sample*/) {
    return false;  // its seconds are those of the processor
}

template <class Row>
using BySeed = std::map<int, const Row*>;

/// A measure in a cell over that in another one, for each pair; none where there are too few pairs.
template <class Row>
std::vector<double> ratiosOfPairs(const BySeed<Row>& runs, const BySeed<Row>& others,
                                  const NamedMeasure<Row>& measure) {
    std::vector<double> ratios;
    if (!hasEnough(runs) || !hasEnough(others)) return ratios;
    std::size_t pairs = 0;
    for (const auto& [seed, run] : runs) {
        const auto other = others.find(seed);
        if (other == others.end() || !(measure.isOfAnyPair || isPair(*run, *other->second))) continue;
        ++pairs;
        if (measure.isTime && (wasDisturbed(*run) || wasDisturbed(*other->second))) continue;
        if (const Measure ratio = quotient(measure.value(*run), measure.value(*other->second)))
            ratios.push_back(*ratio);
    }
    if (pairs < leastPairs(runs)) ratios.clear();
    return ratios;
}

template <class Row>
void addRatios(const std::vector<Row>& rows, const char* source, bool ofAllPlanners,
               const std::vector<NamedMeasure<Row>>& measures, const StudyOptions& options,
               std::vector<RatioRow>& ratios) {
    const auto cells = bySeed(rows);
    for (const NamedMeasure<Row>& measure : measures) {
        std::map<std::pair<Key, std::string>, std::pair<CallsRow, std::vector<double>>> found;
        for (const auto& cell : cells) {
            CallsRow row = *cell.second.begin()->second;
            for (const auto& [general, leaf] : baselinesOf(row, options)) {
                const auto others = cells.find(keyOf(inTree(row, general, leaf)));
                if (others == cells.end()) continue;
                CallsRow shown = row;
                if (ofAllPlanners) shown.planner = kAllPlanners;
                auto& [of, values] = found[{keyOf(shown), general + "/" + leaf}];
                of = shown;
                for (const double ratio : ratiosOfPairs(cell.second, others->second, measure))
                    values.push_back(ratio);
            }
        }
        for (const auto& [key, of] : found) {
            if (of.second.empty()) continue;
            RatioRow row;
            static_cast<CallsRow&>(row) = of.first;
            static_cast<PairedRatio&>(row) = pairedRatio(of.second);
            row.source = source;
            row.measure = measure.name;
            row.baseline = key.second;
            ratios.push_back(row);
        }
    }
}

/// Median of a measure over the runs that have it.
template <class Row>
Measure medianOf(const std::map<int, const Row*>& rows, const ValueOf<Row>& value) {
    std::vector<double> values;
    for (const auto& [seed, row] : rows) {
        if (const Measure each = value(*row)) values.push_back(*each);
    }
    return values.empty() ? std::nullopt : Measure(median(std::move(values)));
}

std::array<double, 4> workOf(const Work& work, double calls) {
    return {number(work.volumeTests), number(work.triangleLanes), number(work.kernelLanes), calls};
}

}  // namespace

double median(std::vector<double> values) {
    assert(!values.empty());
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    if (values.size() % 2 == 1) return *middle;
    return (*middle + *std::max_element(values.begin(), middle)) / 2;
}

PairedRatio pairedRatio(const std::vector<double>& ratios) {
    PairedRatio result;
    result.pairs = ratios.size();
    if (ratios.empty()) return result;
    result.median = median(ratios);
    std::mt19937_64 random(kSeed);  // without the standard's distributions, which differ between libraries
    std::vector<double> medians, drawn(ratios.size());
    for (std::size_t i = 0; i < kResamples; ++i) {
        for (double& each : drawn) each = ratios[random() % ratios.size()];
        medians.push_back(median(drawn));
    }
    std::sort(medians.begin(), medians.end());
    const auto outside = static_cast<std::size_t>(kOutside * kResamples);
    result.low = medians[outside];
    result.high = medians[kResamples - 1 - outside];
    return result;
}

/// Leaves out the work whose cost comes out negative, the most negative first, and fits the rest again.
WorkCosts fitCosts(const std::vector<ReplayRow>& replays) {
    std::vector<const ReplayRow*> rows;
    for (const ReplayRow& row : replays) {
        if (row.seconds > 0) rows.push_back(&row);
    }
    std::vector<int> used = {0, 1, 2, 3};
    const auto count = static_cast<Eigen::Index>(rows.size());
    Eigen::VectorXd costs = Eigen::VectorXd::Zero(4);
    Eigen::MatrixXd relative(count, 4);
    for (Eigen::Index i = 0; i < count; ++i) {
        const ReplayRow& row = *rows[static_cast<std::size_t>(i)];
        const std::array<double, 4> work = workOf(row, static_cast<double>(row.calls));
        for (int k = 0; k < 4; ++k) relative(i, k) = kMicro * work[static_cast<std::size_t>(k)] / row.seconds;
    }
    while (!used.empty() && count >= 4) {
        Eigen::MatrixXd columns(count, static_cast<Eigen::Index>(used.size()));
        for (std::size_t k = 0; k < used.size(); ++k)
            columns.col(static_cast<Eigen::Index>(k)) = relative.col(used[k]);
        const Eigen::VectorXd found =
            columns.colPivHouseholderQr().solve(Eigen::VectorXd::Ones(count).eval());
        Eigen::Index worst = 0;
        if (found.minCoeff(&worst) >= 0) {
            for (std::size_t k = 0; k < used.size(); ++k)
                costs[used[k]] = found[static_cast<Eigen::Index>(k)];
            break;
        }
        used.erase(used.begin() + worst);
    }
    WorkCosts result{costs[0], costs[1], costs[2], costs[3], 0};
    if (count > 0)
        result.error = std::sqrt((relative * costs - Eigen::VectorXd::Ones(count)).squaredNorm() /
                                 static_cast<double>(count));
    return result;
}

bool didTheSame(const RunRow& a, const RunRow& b) {
    return a.planningSeconds() && b.planningSeconds() && a.stateChecks == b.stateChecks &&
           a.motionChecks == b.motionChecks && a.graphStates == b.graphStates && a.length == b.length;
}

Columns<CellRow> cellColumns() {
    using Row = CellRow;
    return {{"scene", &Row::scene},
            {"planner", &Row::planner},
            {"general_split", &Row::generalSplit},
            {"leaf_split", &Row::leafSplit},
            {"runs", &Row::runs},
            {"solved", &Row::solved},
            {"files_to_path_seconds", &Row::filesToPath},
            {"planning_seconds", &Row::planning},
            {"calls", &Row::calls},
            {"queries", &Row::queries},
            {"query_seconds", &Row::querySeconds},
            {"query_share", &Row::queryShare},
            {"volume_share", &Row::volumeShare},
            {"triangle_share", &Row::triangleShare},
            {"leaves_ratio", &Row::leavesRatio},
            {"equal_questions", &Row::equalQuestions}};
}

std::vector<CellRow> cellsOf(const Measured& measured, const StudyOptions& options) {
    std::map<std::string, std::vector<ReplayRow>> replays;  // by scene, in the trees that planners use
    for (const ReplayRow& row : measured.replays) {
        const std::vector<Engine> planned = plannedEngines(options);
        if (std::find(planned.begin(), planned.end(), static_cast<const Engine&>(row)) != planned.end())
            replays[row.scene].push_back(row);
    }
    std::map<std::string, WorkCosts> costs;
    for (const auto& [scene, rows] : replays) costs[scene] = fitCosts(rows);

    const auto cells = bySeed(measured.runs);
    const Engine qualifying = qualifyingEngine(options);
    std::vector<CellRow> result;
    for (const auto& [key, runs] : cells) {
        const RunRow& first = *runs.begin()->second;
        CellRow row;
        static_cast<CallsRow&>(row) = first;
        row.runs = runs.size();
        for (const auto& [seed, run] : runs) row.solved += run->planningSeconds().has_value();
        row.planning = medianOf<RunRow>(runs, [](const RunRow& run) { return run.planningSeconds(); });
        const Measure files = filesSeconds(measured.files, first);
        if (files && row.planning) row.filesToPath = *files + *row.planning;
        const auto recorded = [](const ValueOf<RunRow>& value) {
            return [value](const RunRow& run) { return run.calls() ? value(run) : std::nullopt; };
        };
        row.calls = medianOf<RunRow>(runs, [](const RunRow& run) { return run.calls(); });
        row.queries = medianOf<RunRow>(runs, recorded([](const RunRow& run) { return run.queries(); }));
        row.querySeconds =
            medianOf<RunRow>(runs, recorded([](const RunRow& run) { return run.querySeconds; }));
        row.queryShare = medianOf<RunRow>(runs, recorded([](const RunRow& run) { return run.queryShare; }));
        if (costs.count(first.scene) > 0) {
            const WorkCosts& cost = costs[first.scene];
            row.volumeShare = medianOf<RunRow>(
                runs, recorded([&](const RunRow& run) {
                    return quotient(kMicro * cost.volumeTest * number(run.volumeTests), run.seconds);
                }));
            row.triangleShare =
                medianOf<RunRow>(runs, recorded([&](const RunRow& run) {
                                     return quotient(kMicro * (cost.trianglePair * number(run.triangleLanes) +
                                                               cost.kernelLane * number(run.kernelLanes)),
                                                     run.seconds);
                                 }));
        }
        const FilesRow* const leaves = filesOf(measured.files, first);
        const FilesRow* const unsplit =
            filesOf(measured.files, inTree(first, first.generalSplit, options.leafSplits.front()));
        if (leaves && unsplit)
            row.leavesRatio = static_cast<double>(leaves->leaves) / static_cast<double>(unsplit->leaves);
        const auto others = cells.find(keyOf(inTree(first, qualifying.generalSplit, qualifying.leafSplit)));
        for (const auto& [seed, run] : runs) {
            if (others == cells.end() || others->second.count(seed) == 0) continue;
            const RunRow& other = *others->second.at(seed);
            row.equalQuestions += didTheSame(*run, other);
        }
        result.push_back(row);
    }
    return result;
}

Columns<RatioRow> ratioColumns() {
    using Row = RatioRow;
    const Columns<Row> head = {{"scene", &Row::scene}, {"source", &Row::source}};
    const Columns<Row> rest = {{"planner", &Row::planner},   {"measure", &Row::measure},
                               {"baseline", &Row::baseline}, {"ratio", &Row::median},
                               {"low", &Row::low},           {"high", &Row::high},
                               {"pairs", &Row::pairs}};
    return head + engineColumns<Row>() + rest;
}

std::vector<RatioRow> ratiosOf(const Measured& measured, const StudyOptions& options) {
    const auto filesToPath = [&](const RunRow& run) -> Measure {
        const Measure files = filesSeconds(measured.files, run), planning = run.planningSeconds();
        return files && planning ? Measure(*files + *planning) : std::nullopt;
    };
    const auto planning = [](const RunRow& run) { return run.planningSeconds(); };
    const auto solved = [](const auto& value) {
        return [value](const RunRow& run) -> Measure {
            return run.planningSeconds() && run.calls() ? value(run) : std::nullopt;
        };
    };
    std::vector<RatioRow> ratios;
    addRatios<RunRow>(
        measured.runs, "runs", false,
        {{"files_to_path", filesToPath, true},
         {"files_to_path_any", filesToPath, true, true},
         {"planning", planning, true},
         {"planning_any", planning, true, true},
         {"queries", solved([](const RunRow& run) { return run.querySeconds; }), true},
         {"volume_tests", solved([](const RunRow& run) { return Measure(number(run.volumeTests)); })},
         {"triangle_tests", solved([](const RunRow& run) { return Measure(number(run.triangleTests)); })}},
        options, ratios);
    addRatios<ReplayRow>(
        measured.replays, "replay", true,
        {{"seconds", [](const ReplayRow& row) { return Measure(row.seconds); }, true},
         {"volume_tests", [](const ReplayRow& row) { return Measure(number(row.volumeTests)); }},
         {"triangle_tests", [](const ReplayRow& row) { return Measure(number(row.triangleTests)); }}},
        options, ratios);
    return ratios;
}

}  // namespace clearway::study
