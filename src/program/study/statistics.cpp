#include "program/study/statistics.h"

#include <functional>
#include <map>
#include <optional>

#include "core/number.h"
#include "program/study/paired_ratio.h"
#include "program/study/study_rows.h"

namespace clearway::study {
namespace {

/// What is compared of two rows.
struct NamedMeasure {
    const char* name;
    std::function<Measure(const TableRow& mine, const TableRow& other)> ratio;
    bool isOfAllPlanners = true;  ///< means the same whichever planner it is
};

/// Of values that both rows have, none below 0.
NamedMeasure ratioOf(const char* name, const std::function<Measure(const TableRow&)>& of) {
    return {name, [of](const TableRow& row, const TableRow& with) -> Measure {
                const Measure mine = of(row), other = of(with);
                if (!mine || !other || !(*mine >= 0) || !(*other > 0)) return std::nullopt;
                return *mine / *other;
            }};
}

NamedMeasure column(const char* name) {
    return ratioOf(name, [name](const TableRow& row) { return numberIn(row, name); });
}

/// The first column's value, or the sum of some, for each of the second's.
NamedMeasure quotient(const char* name, const char* of, std::initializer_list<const char*> per) {
    const std::vector<std::string> columns(per.begin(), per.end());
    return ratioOf(name, [of, columns](const TableRow& row) -> Measure {
        double each = 0;
        for (const std::string& column : columns) each += numberIn(row, column).value_or(0);
        return each > 0 ? Measure(numberIn(row, of).value_or(0) / each) : std::nullopt;
    });
}

/// Seconds for each of a run's calls.
NamedMeasure perCall(const char* name, const std::function<Measure(const TableRow&)>& seconds) {
    return ratioOf(name, [seconds](const TableRow& run) -> Measure {
        const double calls = callsOf(run);
        return calls > 0 ? Measure(seconds(run).value_or(0) / calls) : std::nullopt;
    });
}

/// Times by the clock of a run that was disturbed tell of the machine.
NamedMeasure undisturbed(const NamedMeasure& measure) {
    return {measure.name, [ratio = measure.ratio](const TableRow& mine, const TableRow& other) -> Measure {
                if (wasDisturbed(mine) || wasDisturbed(other)) return std::nullopt;
                return ratio(mine, other);
            }};
}

/// A run that ended unsolved would have taken longer than it did. Without such pairs only those would count
/// in which a slower strategy was quick enough.
Measure firstSolutionRatio(const TableRow& mine, const TableRow& other) {
    const Measure ofMine = firstSolution(mine), ofOther = firstSolution(other);
    if (!ofMine && !ofOther) return std::nullopt;
    const double first = ofMine.value_or(sumIn(mine, {"seconds"})),
                 with = ofOther.value_or(sumIn(other, {"seconds"}));
    const bool isKnown = ofMine && ofOther, isLonger = ofMine ? with > first : first > with;
    if (!(first > 0) || !(with > 0) || !(isKnown || isLonger)) return std::nullopt;
    return first / with;
}

class Pairing {
  public:
    Pairing(const std::vector<TableRow>& rows, std::string source, std::string baseline)
        : rows_(rows), source_(std::move(source)), baseline_(std::move(baseline)) {
        for (const TableRow& row : rows) {
            if (row.at("leaf_split") == baseline_) baselines_[pairKey(row)] = &row;
        }
    }

    void add(const NamedMeasure& measure, std::vector<TableRow>& statistics) const {
        // of each tree, leaf split and planner the clusters, by seed
        std::map<std::vector<std::string>, std::map<std::string, std::vector<double>>> found;
        for (const TableRow& row : rows_) {
            const auto ratio = pairRatio(row, measure);
            if (!ratio) continue;
            std::vector<std::string> key = keyOf(row, treeKeyColumns());
            key.push_back(row.at("leaf_split"));
            const std::string cluster = row.at("planner") + "/" + row.at("seed");
            key.push_back(row.at("planner"));
            found[key][cluster].push_back(*ratio);
            if (!measure.isOfAllPlanners) continue;
            key.back() = "all";
            found[key][cluster].push_back(*ratio);
        }
        for (const auto& [key, clusters] : found) statistics.push_back(statisticOf(key, clusters, measure));
    }

  private:
    static std::vector<std::string> pairKey(const TableRow& row) {
        std::vector<std::string> columns = treeKeyColumns();
        columns.insert(columns.end(), {"planner", "seed", "block"});
        return keyOf(row, columns);
    }

    Measure pairRatio(const TableRow& row, const NamedMeasure& measure) const {
        if (row.at("leaf_split") == baseline_) return std::nullopt;
        const auto with = baselines_.find(pairKey(row));
        return with == baselines_.end() ? std::nullopt : measure.ratio(row, *with->second);
    }

    TableRow statisticOf(const std::vector<std::string>& key,
                         const std::map<std::string, std::vector<double>>& clusters,
                         const NamedMeasure& measure) const {
        std::vector<std::vector<double>> ratios;
        for (const auto& cluster : clusters) ratios.push_back(cluster.second);
        const PairedRatio ratio = pairedRatio(ratios);
        TableRow row;
        for (std::size_t i = 0; i < treeKeyColumns().size(); ++i) row[treeKeyColumns()[i]] = key[i];
        row["leaf_split"] = key[treeKeyColumns().size()];
        row["planner"] = key.back();
        row["source"] = source_;
        row["measure"] = measure.name;
        row["baseline"] = baseline_;
        row["ratio"] = shortNumber(ratio.median);
        row["low"] = shortNumber(ratio.low);
        row["high"] = shortNumber(ratio.high);
        row["pairs"] = std::to_string(ratio.pairs);
        row["clusters"] = std::to_string(ratio.clusters);
        return row;
    }

    const std::vector<TableRow>& rows_;
    std::string source_, baseline_;
    std::map<std::vector<std::string>, const TableRow*> baselines_;
};

}  // namespace

std::vector<std::string> statisticsColumns() {
    return {"scene",        "source",  "general_split", "leaf_size",  "node_width",
            "instructions", "planner", "measure",       "leaf_split", "baseline",
            "ratio",        "low",     "high",          "pairs",      "clusters"};
}

std::vector<TableRow> statisticsOf(const std::vector<TableRow>& runs, const std::vector<TableRow>& replays,
                                   const std::string& baseline) {
    std::vector<TableRow> statistics;
    const std::vector<TableRow> planned = withTree(runs);
    const Pairing ofRuns(planned, "runs", baseline);
    const auto perQuery = {"distance_queries", "within_queries"};
    ofRuns.add(undisturbed({"first_solution_seconds", firstSolutionRatio}), statistics);
    ofRuns.add(perCall("seconds_per_call", processorSeconds), statistics);
    const auto querySeconds = [](const TableRow& run) { return numberIn(run, "query_seconds"); };
    ofRuns.add(undisturbed(perCall("query_seconds_per_call", querySeconds)), statistics);
    ofRuns.add({"cost", ratioOf("cost", costOf).ratio, false}, statistics);
    ofRuns.add(quotient("volume_tests_per_query", "volume_tests", perQuery), statistics);
    ofRuns.add(quotient("triangle_tests_per_query", "triangle_tests", perQuery), statistics);
    const Pairing ofReplays(replays, "replay", baseline);
    for (const char* name : {"seconds", "volume_tests", "triangle_tests"})
        ofReplays.add(column(name), statistics);
    for (const Pairing* of : {&ofRuns, &ofReplays}) {
        of->add(quotient("block_fill", "triangle_tests", {"triangle_lanes"}), statistics);
        of->add(quotient("kernel_fill", "kernel_pairs", {"kernel_lanes"}), statistics);
    }
    return statistics;
}

}  // namespace clearway::study
