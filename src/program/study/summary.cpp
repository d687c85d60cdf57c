#include "program/study/summary.h"

#include <map>

#include "core/number.h"
#include "program/study/paired_ratio.h"
#include "program/study/study_rows.h"

namespace clearway::study {
namespace {

constexpr const char* kMeansOfRuns[] = {"state_checks", "motion_checks", "motion_costs", "distance_queries",
                                        "within_queries"};

/// Sums over the runs, or blocks, of one engine and planner.
struct Sums {
    std::size_t rows = 0, solved = 0, disturbed = 0;
    std::vector<double> firstSolutions, finalSolutions, costs;
    double seconds = 0, calls = 0, askingSeconds = 0, querySeconds = 0, queries = 0, volumes = 0,
           triangles = 0, lanes = 0, kernelPairs = 0, kernelLanes = 0;
    std::map<std::string, double> ofRuns;

    void add(const TableRow& row, bool isRun) {
        ++rows;
        if (isRun) addRun(row);
        calls += isRun ? callsOf(row) : sumIn(row, {"calls"});
        askingSeconds += isRun ? processorSeconds(row).value_or(0) : sumIn(row, {"seconds"});
        queries += sumIn(row, {"distance_queries", "within_queries"});
        volumes += sumIn(row, {"volume_tests"});
        triangles += sumIn(row, {"triangle_tests"});
        lanes += sumIn(row, {"triangle_lanes"});
        kernelPairs += sumIn(row, {"kernel_pairs"});
        kernelLanes += sumIn(row, {"kernel_lanes"});
    }

    void addRun(const TableRow& run) {
        if (wasDisturbed(run)) ++disturbed;
        seconds += sumIn(run, {"seconds"});
        querySeconds += sumIn(run, {"query_seconds"});
        for (const char* name : kMeansOfRuns) ofRuns[name] += sumIn(run, {name});
        if (run.at("solved") != "1") return;
        ++solved;
        const auto keep = [](const Measure& value, std::vector<double>& all) {
            if (value) all.push_back(*value);
        };
        keep(firstSolution(run), firstSolutions);
        keep(numberIn(run, "final_solution_seconds"), finalSolutions);
        keep(costOf(run), costs);
    }

    void write(bool isRun, TableRow& row) const {
        const auto put = [&](const char* name, double value, double per) {
            if (per > 0) row[name] = shortNumber(value / per);
        };
        const auto putMedian = [&](const char* name, const std::vector<double>& values) {
            if (!values.empty()) row[name] = shortNumber(median(values));
        };
        if (isRun) {
            row["runs"] = std::to_string(rows);
            row["solved"] = std::to_string(solved);
            row["disturbed"] = std::to_string(disturbed);
            putMedian("first_solution_seconds", firstSolutions);
            putMedian("final_solution_seconds", finalSolutions);
            putMedian("cost", costs);
            for (const auto& [name, sum] : ofRuns) put(name.c_str(), sum, static_cast<double>(rows));
            put("query_share", querySeconds, seconds);
        }
        put("calls_per_second", calls, askingSeconds);
        put("volume_tests", volumes, queries);
        put("triangle_tests", triangles, queries);
        put("block_fill", triangles, lanes);
        put("kernel_fill", kernelPairs, kernelLanes);
    }
};

void addSummary(const std::vector<TableRow>& rows, const char* source, std::vector<TableRow>& summary) {
    std::vector<std::string> columns = treeKeyColumns();
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
            "disturbed",
            "first_solution_seconds",
            "final_solution_seconds",
            "cost",
            "state_checks",
            "motion_checks",
            "motion_costs",
            "distance_queries",
            "within_queries",
            "calls_per_second",
            "query_share",
            "volume_tests",
            "triangle_tests",
            "block_fill",
            "kernel_fill"};
}

std::vector<TableRow> summaryOf(const std::vector<TableRow>& runs, const std::vector<TableRow>& replays) {
    std::vector<TableRow> summary;
    addSummary(withTree(runs), "runs", summary);
    addSummary(replays, "replay", summary);
    return summary;
}

}  // namespace clearway::study
