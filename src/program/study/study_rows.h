// What rows of the study's tables tell.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "program/study/growing_table.h"

namespace clearway::study {

using Measure = std::optional<double>;  ///< nothing where a row has none

Measure numberIn(const TableRow& row, const std::string& column);

/// A column without a number counts as 0.
double sumIn(const TableRow& row, const std::vector<std::string>& columns);

/// States and motions that a run's planner asked about.
double callsOf(const TableRow& run);

/// Of a run that found a path.
Measure firstSolution(const TableRow& run);
Measure costOf(const TableRow& run);

/// Of a run's planner; by the clock where they are not told.
Measure processorSeconds(const TableRow& run);

/// True when a run had less than 95 % of a processor: the machine was at other work, and the run's times by
/// the clock tell of that.
bool wasDisturbed(const TableRow& run);

/// What tells trees and instructions apart, but for the leaf split: the scene, then engineColumns() without
/// it.
const std::vector<std::string>& treeKeyColumns();

/// The values of the columns: equal for rows that agree in them.
std::vector<std::string> keyOf(const TableRow& row, const std::vector<std::string>& columns);

/// Runs, with the tree columns that they lack as they are of the usual trees and the best instructions, and
/// each as a block of its own.
std::vector<TableRow> withTree(std::vector<TableRow> runs);

}  // namespace clearway::study
