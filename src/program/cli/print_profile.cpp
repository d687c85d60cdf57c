// The clearance along a path as a plot of characters: # what is certain, : what was found at poses.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <limits>
#include <string>
#include <vector>

#include "program/cli/print_audit.h"

namespace clearway::cli {

namespace {

using planning::PathAudit;
using planning::PathProfilePoint;

constexpr int kColumns = 66;
constexpr int kRows = 14;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct Column {
    double certain = kInfinity;  ///< nowhere in it the clearance is less
    double found = kInfinity;    ///< the least of the poses looked at, else what lies between its neighbours
};

int columnOf(double travel, double whole) {
    return std::clamp(static_cast<int>(kColumns * travel / whole), 0, kColumns - 1);
}

std::vector<Column> columnsOf(const std::vector<PathProfilePoint>& profile) {
    std::vector<Column> columns(kColumns);
    const double whole = profile.back().travel;
    for (std::size_t k = 0; k < profile.size(); ++k) {
        const PathProfilePoint& here = profile[k];
        const PathProfilePoint& next = profile[std::min(k + 1, profile.size() - 1)];
        const int first = columnOf(here.travel, whole), last = columnOf(next.travel, whole);
        columns[first].found = std::min(columns[first].found, here.clearance);
        for (int c = first; c <= last; ++c) {
            columns[c].certain = std::min(columns[c].certain, here.lowerToNext);
            if (c == first || c == last) continue;
            const double share = (whole * (c + 0.5) / kColumns - here.travel) / (next.travel - here.travel);
            columns[c].found = here.clearance + share * (next.clearance - here.clearance);
        }
    }
    return columns;
}

/// The clearances of the plot's rows, lowest first: each the same multiple of the one before.
std::vector<double> levelsOf(const std::vector<Column>& columns) {
    double low = kInfinity, high = 0;
    for (const Column& column : columns) {
        for (const double value : {column.certain, column.found}) {
            if (value > 0) low = std::min(low, value);
        }
        if (std::isfinite(column.found)) high = std::max(high, column.found);
    }
    std::vector<double> levels;
    if (!(low < kInfinity) || !(high > 0)) return levels;
    low = std::max(low, 1e-6 * high);  // what is next to nothing must not flatten the rest
    for (int row = 0; row < kRows; ++row) {
        levels.push_back(low * std::pow(high / low, static_cast<double>(row) / (kRows - 1)));
    }
    return levels;
}

char footOf(const Column& column) {
    if (column.found <= 0) return 'x';
    return column.certain > 0 ? '-' : '?';
}

}  // namespace

void printProfile(const PathAudit& audit) {
    if (audit.profile.empty() || !(audit.profile.back().travel > 0)) return;
    const std::vector<Column> columns = columnsOf(audit.profile);
    const std::vector<double> levels = levelsOf(columns);
    std::cout << "clearance along the path: # certain, : found"
              << (audit.isValid() ? "" : ", x not valid, ? not certified") << "\n";
    char label[32];
    for (int row = static_cast<int>(levels.size()) - 1; row >= 0; --row) {
        const double level = levels[static_cast<std::size_t>(row)] * (1 - 1e-12);
        std::snprintf(label, sizeof label, "%9.3g |", level);
        std::string line = label;
        for (const Column& column : columns) {
            line += column.certain >= level ? '#' : column.found >= level ? ':' : ' ';
        }
        std::cout << line.substr(0, line.find_last_not_of(' ') + 1) << "\n";
    }
    std::string foot = "          +";
    for (const Column& column : columns) foot += footOf(column);
    std::snprintf(label, sizeof label, "travelled %.6g", audit.profile.back().travel);
    const std::string end = label;
    std::cout << foot << "\n"
              << std::string(11, ' ') << "0" << std::string(kColumns - 1 - end.size(), ' ') << end << "\n";
}

}  // namespace clearway::cli
