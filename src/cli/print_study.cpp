#include "cli/print_study.h"

#include <algorithm>
#include <cstdio>
#include <iostream>
#include <map>
#include <set>

#include "core/number.h"
#include "study/claims.h"

namespace clearway {

namespace {

using Lines = std::vector<std::vector<std::string>>;

/// Columns as wide as their widest cell; the first line is the head.
void printTable(const std::string& title, const Lines& lines) {
    if (lines.size() < 2) return;
    std::cout << "\n" << title << "\n";
    std::vector<std::size_t> widths(lines[0].size());
    for (const auto& line : lines) {
        for (std::size_t i = 0; i < line.size(); ++i) widths[i] = std::max(widths[i], line[i].size());
    }
    for (const auto& line : lines) {
        std::string text;
        for (std::size_t i = 0; i < line.size(); ++i) {
            text += (i > 0 ? "  " : "  ") + line[i] + std::string(widths[i] - line[i].size(), ' ');
        }
        text.erase(text.find_last_not_of(' ') + 1);
        std::cout << text << "\n";
    }
}

std::string short3(const std::string& value) {
    const auto number = parseNumber(value);
    if (!number) return value.empty() ? "-" : value;
    char text[32];
    std::snprintf(text, sizeof text, *number >= 1000 ? "%.0f" : "%.3g", *number);
    return text;
}

std::string percent(const std::string& share) {
    const auto number = parseNumber(share);
    return number ? short3(shortNumber(100 * *number)) + " %" : "-";
}

std::string ratioText(const TableRow& row) {
    return short3(row.at("ratio")) + " (" + short3(row.at("low")) + " to " + short3(row.at("high")) + ")";
}

std::string value(const TableRow& row, const std::string& column) {
    const auto found = row.find(column);
    return found == row.end() ? "" : found->second;
}

std::string treeName(const TableRow& row) {
    return value(row, "general_split") + ", leaves of " + value(row, "leaf_size") + ", width " +
           value(row, "node_width") + ", " + value(row, "instructions");
}

void printRuns(const StudyResult& result, const std::string& scene) {
    Lines lines = {{"planner", "strategy", "solved", "first solution s", "calls/s", "in queries",
                    "volumes/query", "triangles/query", "blocks full", "kernels full"}};
    for (const TableRow& row : result.summary) {
        if (row.at("scene") != scene || row.at("source") != "runs" || row.at("planner") == "all") continue;
        lines.push_back({row.at("planner"), value(row, "general_split") + "/" + value(row, "leaf_split"),
                         value(row, "solved") + " of " + value(row, "runs"),
                         short3(value(row, "first_solution_seconds")), short3(value(row, "calls_per_second")),
                         percent(value(row, "query_share")), short3(value(row, "volume_tests")),
                         short3(value(row, "triangle_tests")), percent(value(row, "block_fill")),
                         percent(value(row, "kernel_fill"))});
    }
    std::stable_sort(lines.begin() + 1, lines.end(),
                     [](const auto& a, const auto& b) { return a[0] < b[0]; });
    printTable(scene + ": planner runs", lines);
}

/// A line for each tree and planner, a column for each leaf split.
void printRatios(const StudyResult& result, const std::string& scene, const std::string& source,
                 const std::string& measure, const std::string& title) {
    std::vector<std::string> splits;
    std::map<std::pair<std::string, std::string>, std::map<std::string, std::string>> ratios;
    std::string baseline;
    for (const TableRow& row : result.statistics) {
        if (row.at("scene") != scene || row.at("source") != source || row.at("measure") != measure) continue;
        const std::string& split = row.at("leaf_split");
        if (std::find(splits.begin(), splits.end(), split) == splits.end()) splits.push_back(split);
        ratios[{treeName(row), row.at("planner")}][split] = ratioText(row);
        baseline = row.at("baseline");
    }
    Lines lines = {{"tree", "planner"}};
    for (const std::string& split : splits) lines[0].push_back(split + " / " + baseline);
    for (const auto& [key, of] : ratios) {
        lines.push_back({key.first, key.second});
        for (const std::string& split : splits) {
            const auto found = of.find(split);
            lines.back().push_back(found == of.end() ? "-" : found->second);
        }
    }
    printTable(scene + ": " + title, lines);
}

/// Ours, then the thesis's in brackets.
std::string beside(const TableRow& row, const std::string& measure) {
    const std::string theirs = value(row, "thesis_" + measure);
    return short3(value(row, measure)) + (theirs.empty() ? "" : " [" + short3(theirs) + "]");
}

void printTrees(const StudyResult& result, const std::string& scene) {
    Lines lines = {{"width", "strategy", "build s", "MB", "leaves of 1", "2", "3", "4", "leaves",
                    "collisions/s", "distances/s"}};
    std::string poses, thesis;
    for (const TableRow& row : result.trees) {
        if (row.at("scene") != scene) continue;
        lines.push_back({row.at("node_width"), row.at("general_split") + "/" + row.at("leaf_split"),
                         beside(row, "build_seconds"), beside(row, "megabytes"), row.at("leaves_1"),
                         row.at("leaves_2"), row.at("leaves_3"), row.at("leaves_4"), beside(row, "leaves"),
                         beside(row, "collisions_per_second"), beside(row, "distances_per_second")});
        poses = row.at("colliding") + " of " + row.at("poses") + " poses collide";
        if (!row.at("thesis_scene").empty()) thesis = "; in brackets the thesis's " + row.at("thesis_scene");
    }
    printTable(scene + ": trees, " + poses + thesis, lines);
}

void printClaims(const StudyResult& result, const std::string& scene) {
    Lines lines = {{"width", "claim", "thesis", "here", "verdict"}};
    for (const TableRow& row : result.claims) {
        if (row.at("scene") != scene) continue;
        lines.push_back({row.at("node_width"), row.at("claim"), short3(row.at("thesis_ratio")),
                         ratioText(row), row.at("verdict")});
    }
    printTable(scene + ": the thesis's claims", lines);
}

}  // namespace

void printStudy(const StudyResult& result) {
    std::vector<std::string> scenes;
    for (const TableRow& row : result.trees) {
        if (std::find(scenes.begin(), scenes.end(), row.at("scene")) == scenes.end())
            scenes.push_back(row.at("scene"));
    }
    for (const std::string& scene : scenes) {
        printRuns(result, scene);
        printRatios(result, scene, "runs", "first_solution_seconds",
                    "seconds to the first solution, by pairs of runs");
        printRatios(result, scene, "runs", "seconds_per_call",
                    "seconds per call of planners, by pairs of runs");
        printRatios(result, scene, "replay", "seconds", "seconds of the same calls, replayed");
        printTrees(result, scene);
        printClaims(result, scene);
    }
    std::cout << "\n" << claimRule() << "\n\n";
}

}  // namespace clearway
