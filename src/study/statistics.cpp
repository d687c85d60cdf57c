#include "study/statistics.h"

#include <functional>
#include <map>
#include <optional>
#include <tuple>

#include "core/number.h"
#include "study/engine.h"
#include "study/paired_ratio.h"

namespace clearway {
namespace {

using Measure = std::optional<double>;

std::optional<double> numberIn(const TableRow& row, const std::string& column) {
    const auto found = row.find(column);
    return found == row.end() ? std::nullopt : parseNumber(found->second);
}

double sumIn(const TableRow& row, std::initializer_list<const char*> columns) {
    double sum = 0;
    for (const char* column : columns) sum += numberIn(row, column).value_or(0);
    return sum;
}

struct NamedMeasure {
    const char* name;
    std::function<Measure(const TableRow&)> of;
};

Measure firstSolution(const TableRow& row) {
    return row.at("solved") == "1" ? numberIn(row, "first_solution_seconds") : std::nullopt;
}

Measure costOf(const TableRow& row) {
    return row.at("solved") == "1" ? numberIn(row, "cost") : std::nullopt;
}

double callsOf(const TableRow& run) {
    return sumIn(run, {"state_checks", "motion_checks", "motion_costs"});
}

Measure secondsPerCall(const TableRow& row) {
    const double calls = callsOf(row);
    return calls > 0 ? Measure(sumIn(row, {"seconds"}) / calls) : std::nullopt;
}

NamedMeasure column(const char* name) {
    return {name, [name](const TableRow& row) { return numberIn(row, name); }};
}

/// Of rows the values of some columns, joined: equal for rows that agree in them.
std::vector<std::string> keyOf(const TableRow& row, const std::vector<std::string>& columns) {
    std::vector<std::string> key;
    for (const std::string& name : columns) {
        const auto found = row.find(name);
        key.push_back(found == row.end() ? "" : found->second);
    }
    return key;
}

/// Runs are of the usual trees and the best instructions.
std::vector<TableRow> withEngine(std::vector<TableRow> runs) {
    for (TableRow& row : runs) {
        Engine engine;
        engine.build.generalSplit = row.at("general_split");
        engine.build.leafSplit = row.at("leaf_split");
        for (const auto& [name, value] : engineRow(engine)) row[name] = value;
        row["block"] = "0";
    }
    return runs;
}

const std::vector<std::string> kTreeColumns = {"scene", "general_split", "leaf_size", "node_width",
                                               "instructions"};

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
            const auto ratio = ratioOf(row, measure);
            if (!ratio) continue;
            std::vector<std::string> key = keyOf(row, kTreeColumns);
            key.push_back(row.at("leaf_split"));
            const std::string cluster = row.at("planner") + "/" + row.at("seed");
            key.push_back("all");
            found[key][cluster].push_back(*ratio);
            key.back() = row.at("planner");
            found[key][cluster].push_back(*ratio);
        }
        for (const auto& [key, clusters] : found) statistics.push_back(statisticOf(key, clusters, measure));
    }

  private:
    static std::vector<std::string> pairKey(const TableRow& row) {
        std::vector<std::string> columns = kTreeColumns;
        columns.insert(columns.end(), {"planner", "seed", "block"});
        return keyOf(row, columns);
    }

    std::optional<double> ratioOf(const TableRow& row, const NamedMeasure& measure) const {
        if (row.at("leaf_split") == baseline_) return std::nullopt;
        const auto with = baselines_.find(pairKey(row));
        if (with == baselines_.end()) return std::nullopt;
        const Measure mine = measure.of(row), other = measure.of(*with->second);
        if (!mine || !other || !(*other > 0)) return std::nullopt;
        return *mine / *other;
    }

    TableRow statisticOf(const std::vector<std::string>& key,
                         const std::map<std::string, std::vector<double>>& clusters,
                         const NamedMeasure& measure) const {
        std::vector<std::vector<double>> ratios;
        for (const auto& cluster : clusters) ratios.push_back(cluster.second);
        const PairedRatio ratio = pairedRatio(ratios);
        TableRow row;
        for (std::size_t i = 0; i < kTreeColumns.size(); ++i) row[kTreeColumns[i]] = key[i];
        row["leaf_split"] = key[kTreeColumns.size()];
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

/// Sums over the runs, or blocks, of one engine and planner.
struct Sums {
    std::size_t rows = 0, solved = 0;
    std::vector<double> firstSolutions;
    double calls = 0, seconds = 0, querySeconds = 0, queries = 0, volumes = 0, triangles = 0, lanes = 0,
           kernelPairs = 0, kernelLanes = 0;

    void add(const TableRow& row, bool isRun) {
        ++rows;
        if (isRun && row.at("solved") == "1") ++solved;
        if (isRun && firstSolution(row)) firstSolutions.push_back(*firstSolution(row));
        calls += isRun ? callsOf(row) : sumIn(row, {"calls"});
        seconds += sumIn(row, {"seconds"});
        querySeconds += sumIn(row, {"query_seconds"});
        queries += sumIn(row, {"distance_queries", "within_queries"});
        volumes += sumIn(row, {"volume_tests"});
        triangles += sumIn(row, {"triangle_tests"});
        lanes += sumIn(row, {"triangle_lanes"});
        kernelPairs += sumIn(row, {"kernel_pairs"});
        kernelLanes += sumIn(row, {"kernel_lanes"});
    }

    void write(bool isRun, TableRow& row) const {
        const auto put = [&](const char* name, double value, double per) {
            if (per > 0) row[name] = shortNumber(value / per);
        };
        if (isRun) {
            row["runs"] = std::to_string(rows);
            row["solved"] = std::to_string(solved);
            if (!firstSolutions.empty()) row["first_solution_seconds"] = shortNumber(median(firstSolutions));
            put("query_share", querySeconds, seconds);
        }
        put("calls_per_second", calls, seconds);
        put("volume_tests", volumes, queries);
        put("triangle_tests", triangles, queries);
        put("block_fill", triangles, lanes);
        put("kernel_fill", kernelPairs, kernelLanes);
    }
};

void addSummary(const std::vector<TableRow>& rows, const char* source, std::vector<TableRow>& summary) {
    std::vector<std::string> columns = kTreeColumns;
    columns.push_back("leaf_split");
    columns.push_back("planner");
    std::map<std::vector<std::string>, Sums> sums;
    const bool isRun = std::string(source) == "runs";
    for (const TableRow& row : rows) {
        std::vector<std::string> key = keyOf(row, columns);
        sums[key].add(row, isRun);
        key.back() = "all";
        sums[key].add(row, isRun);
    }
    for (const auto& [key, of] : sums) {
        TableRow row = {{"source", source}};
        for (std::size_t i = 0; i < columns.size(); ++i) row[columns[i]] = key[i];
        of.write(isRun, row);
        summary.push_back(row);
    }
}

}  // namespace

std::vector<std::string> statisticsColumns() {
    return {"scene",        "source",  "general_split", "leaf_size",  "node_width",
            "instructions", "planner", "measure",       "leaf_split", "baseline",
            "ratio",        "low",     "high",          "pairs",      "clusters"};
}

std::vector<TableRow> statisticsOf(const std::vector<TableRow>& runs, const std::vector<TableRow>& replays,
                                   const std::string& baseline) {
    std::vector<TableRow> statistics;
    const std::vector<TableRow> planned = withEngine(runs);
    const Pairing ofRuns(planned, "runs", baseline);
    ofRuns.add({"first_solution_seconds", firstSolution}, statistics);
    ofRuns.add({"seconds_per_call", secondsPerCall}, statistics);
    ofRuns.add({"cost", costOf}, statistics);
    const Pairing ofReplays(replays, "replay", baseline);
    for (const char* name : {"seconds", "volume_tests", "triangle_tests"})
        ofReplays.add(column(name), statistics);
    return statistics;
}

std::vector<std::string> summaryColumns() {
    return {"scene",
            "source",
            "general_split",
            "leaf_size",
            "node_width",
            "instructions",
            "leaf_split",
            "planner",
            "runs",
            "solved",
            "first_solution_seconds",
            "calls_per_second",
            "query_share",
            "volume_tests",
            "triangle_tests",
            "block_fill",
            "kernel_fill"};
}

std::vector<TableRow> summaryOf(const std::vector<TableRow>& runs, const std::vector<TableRow>& replays) {
    std::vector<TableRow> summary;
    addSummary(withEngine(runs), "runs", summary);
    addSummary(replays, "replay", summary);
    return summary;
}

}  // namespace clearway
