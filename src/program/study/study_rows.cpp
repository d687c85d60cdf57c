#include "program/study/study_rows.h"

#include "core/number.h"
#include "program/study/engine.h"

namespace clearway::study {
namespace {

constexpr double kLeastShare = 0.95;  ///< of a processor

}  // namespace

Measure numberIn(const TableRow& row, const std::string& column) {
    const auto found = row.find(column);
    return found == row.end() ? std::nullopt : parseNumber(found->second);
}

double sumIn(const TableRow& row, const std::vector<std::string>& columns) {
    double sum = 0;
    for (const std::string& column : columns) sum += numberIn(row, column).value_or(0);
    return sum;
}

double callsOf(const TableRow& run) {
    return sumIn(run, {"state_checks", "motion_checks", "motion_costs"});
}

Measure firstSolution(const TableRow& run) {
    return run.at("solved") == "1" ? numberIn(run, "first_solution_seconds") : std::nullopt;
}

Measure costOf(const TableRow& row) {
    return row.at("solved") == "1" ? numberIn(row, "cost") : std::nullopt;
}

Measure processorSeconds(const TableRow& run) {
    const Measure processor = numberIn(run, "processor_seconds");
    return processor ? processor : numberIn(run, "seconds");
}

bool wasDisturbed(const TableRow& run) {
    const auto processor = numberIn(run, "processor_seconds"), seconds = numberIn(run, "seconds");
    return processor && seconds && *processor < kLeastShare * *seconds;
}

const std::vector<std::string>& treeKeyColumns() {
    static const std::vector<std::string> kColumns = {"scene", "general_split", "leaf_size", "node_width",
                                                      "instructions"};
    return kColumns;
}

std::vector<std::string> keyOf(const TableRow& row, const std::vector<std::string>& columns) {
    std::vector<std::string> key;
    for (const std::string& name : columns) {
        const auto found = row.find(name);
        key.push_back(found == row.end() ? "" : found->second);
    }
    return key;
}

std::vector<TableRow> withTree(std::vector<TableRow> runs) {
    for (TableRow& row : runs) {
        Engine engine;
        engine.build.generalSplit = row.at("general_split");
        engine.build.leafSplit = row.at("leaf_split");
        for (const auto& [name, value] : engineRow(engine)) row[name] = value;
        row["block"] = "0";
    }
    return runs;
}

}  // namespace clearway::study
