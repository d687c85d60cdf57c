#include "program/cli/print_study.h"

#include <algorithm>
#include <cstdio>
#include <iostream>
#include <map>
#include <tuple>

#include "clearway/build_options.h"
#include "core/number.h"
#include "program/study/claims.h"

namespace clearway::cli {

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

std::string ratioText(const study::TableRow& row) {
    return short3(row.at("ratio")) + " (" + short3(row.at("low")) + " to " + short3(row.at("high")) + ")";
}

std::string value(const study::TableRow& row, const std::string& column) {
    const auto found = row.find(column);
    return found == row.end() ? "" : found->second;
}

/// Leaf splits from the fewest leaves to the most.
std::size_t placeOf(const std::string& leafSplit) {
    const std::vector<std::string> all = leafSplitNames();
    return static_cast<std::size_t>(std::find(all.begin(), all.end(), leafSplit) - all.begin());
}

/// Of a scene's runs a line for each planner and strategy.
template <class Cells>
void printRuns(const study::StudyResult& result, const std::string& scene, const std::string& title,
               const std::vector<std::string>& head, const Cells& cells) {
    Lines lines = {{"planner", "strategy"}};
    lines[0].insert(lines[0].end(), head.begin(), head.end());
    for (const study::TableRow& row : result.summary) {
        if (row.at("scene") != scene || row.at("source") != "runs" || row.at("planner") == "all") continue;
        lines.push_back({row.at("planner"), value(row, "general_split") + "/" + value(row, "leaf_split")});
        const std::vector<std::string> more = cells(row);
        lines.back().insert(lines.back().end(), more.begin(), more.end());
    }
    const auto key = [](const std::vector<std::string>& line) {
        const std::size_t slash = line[1].find('/');
        return std::tuple(line[0], line[1].substr(0, slash), placeOf(line[1].substr(slash + 1)));
    };
    std::sort(lines.begin() + 1, lines.end(), [&](const auto& a, const auto& b) { return key(a) < key(b); });
    printTable(scene + ": " + title, lines);
}

void printAnswers(const study::StudyResult& result, const std::string& scene) {
    printRuns(result, scene, "what planners found (medians), and what they asked about (means of a run)",
              {"solved", "first solution s", "last one s", "cost", "states", "motions", "motion costs",
               "distance queries", "within queries"},
              [](const study::TableRow& row) {
                  std::vector<std::string> cells = {value(row, "solved") + " of " + value(row, "runs")};
                  for (const char* column :
                       {"first_solution_seconds", "final_solution_seconds", "cost", "state_checks",
                        "motion_checks", "motion_costs", "distance_queries", "within_queries"}) {
                      cells.push_back(short3(value(row, column)));
                  }
                  return cells;
              });
}

void printWork(const study::StudyResult& result, const std::string& scene) {
    printRuns(
        result, scene, "what answers took",
        {"calls/s", "time in queries", "volumes/query", "triangles/query", "blocks full", "kernels full"},
        [](const study::TableRow& row) -> std::vector<std::string> {
            return {short3(value(row, "calls_per_second")), percent(value(row, "query_share")),
                    short3(value(row, "volume_tests")),     short3(value(row, "triangle_tests")),
                    percent(value(row, "block_fill")),      percent(value(row, "kernel_fill"))};
        });
}

/// Runs of which times say nothing.
void printDisturbed(const study::StudyResult& result, const std::string& scene) {
    double disturbed = 0, runs = 0;
    for (const study::TableRow& row : result.summary) {
        if (row.at("scene") != scene || row.at("source") != "runs" || row.at("planner") != "all") continue;
        disturbed += parseNumber(value(row, "disturbed")).value_or(0);
        runs += parseNumber(value(row, "runs")).value_or(0);
    }
    if (disturbed == 0) return;
    std::cout << "\n"
              << shortNumber(disturbed) << " of " << shortNumber(runs) << " runs of " << scene
              << " had less than 95 % of a processor: the machine was at other work. They are left out of "
                 "ratios of seconds\nto the first solution and in queries.\n";
}

bool isUsual(const study::TableRow& row) {
    return row.at("leaf_size") == "4" && row.at("node_width") == "8" && row.at("instructions") == "best";
}

std::string treeName(const study::TableRow& row) {
    std::string name = row.at("general_split");
    if (row.at("leaf_size") != "4") name += ", leaves of " + row.at("leaf_size");
    if (row.at("node_width") != "8") name += ", width " + row.at("node_width");
    if (row.at("instructions") != "best") name += ", " + row.at("instructions");
    return name;
}

struct Ratios {
    const char* title;
    const char* source;
    const char* measure;
    bool isByPlanner;  ///< of the usual trees; else of all trees, by all planners' calls
};

/// A line for each tree or planner, a column for each leaf split.
void printRatios(const study::StudyResult& result, const std::string& scene, const Ratios& of) {
    std::vector<std::string> splits, names;
    std::map<std::string, std::map<std::string, std::string>> ratios;
    std::map<std::string, std::tuple<std::string, std::string, bool, int, int>> keys;  // of names, to sort by
    std::string baseline;
    for (const study::TableRow& row : result.statistics) {
        if (row.at("scene") != scene || row.at("source") != of.source || row.at("measure") != of.measure)
            continue;
        if ((row.at("planner") == "all") == of.isByPlanner || (of.isByPlanner && !isUsual(row))) continue;
        const std::string& split = row.at("leaf_split");
        if (std::find(splits.begin(), splits.end(), split) == splits.end()) splits.push_back(split);
        const std::string name = (of.isByPlanner ? row.at("planner") + ", " : "") + treeName(row);
        if (ratios.count(name) == 0) names.push_back(name);
        keys[name] = {of.isByPlanner ? row.at("planner") : "", row.at("general_split"),
                      row.at("instructions") != "best", -std::stoi(row.at("node_width")),
                      std::stoi(row.at("leaf_size"))};
        ratios[name][split] = ratioText(row);
        baseline = row.at("baseline");
    }
    std::sort(splits.begin(), splits.end(),
              [](const auto& a, const auto& b) { return placeOf(a) < placeOf(b); });
    std::sort(names.begin(), names.end(),
              [&](const auto& a, const auto& b) { return keys.at(a) < keys.at(b); });
    Lines lines = {{of.isByPlanner ? "planner, tree" : "tree"}};
    for (const std::string& split : splits) lines[0].push_back(split + " / " + baseline);
    for (const std::string& name : names) {
        lines.push_back({name});
        for (const std::string& split : splits) {
            const auto found = ratios[name].find(split);
            lines.back().push_back(found == ratios[name].end() ? "-" : found->second);
        }
    }
    printTable(scene + ": " + of.title, lines);
}

constexpr Ratios kRatios[] = {
    {"seconds to the first solution, pairs of runs", "runs", "first_solution_seconds", true},
    {"planners' seconds for each call, pairs of runs", "runs", "seconds_per_call", true},
    {"seconds in queries for each call, pairs of runs", "runs", "query_seconds_per_call", true},
    {"seconds of the same calls, replayed", "replay", "seconds", true},
    {"seconds of the same calls, replayed, all planners'", "replay", "seconds", false},
    {"triangle tests of the same calls, replayed", "replay", "triangle_tests", false},
    {"share of blocks in use, replayed", "replay", "block_fill", false},
};

/// Ours, then the thesis's in brackets.
std::string beside(const study::TableRow& row, const std::string& measure) {
    const std::string theirs = value(row, "thesis_" + measure);
    return short3(value(row, measure)) + (theirs.empty() ? "" : " [" + short3(theirs) + "]");
}

void printTrees(const study::StudyResult& result, const std::string& scene) {
    Lines lines = {{"width", "strategy", "build s", "MB", "leaves of 1", "2", "3", "4", "leaves",
                    "collisions/s", "distances/s"}};
    std::string about, thesis;
    for (const study::TableRow& row : result.trees) {
        if (row.at("scene") != scene) continue;
        lines.push_back({row.at("node_width"), row.at("general_split") + "/" + row.at("leaf_split"),
                         beside(row, "build_seconds"), beside(row, "megabytes"), row.at("leaves_1"),
                         row.at("leaves_2"), row.at("leaves_3"), row.at("leaves_4"), beside(row, "leaves"),
                         beside(row, "collisions_per_second"), beside(row, "distances_per_second")});
        about = row.at("triangles") + " triangles, " + row.at("colliding") + " of " + row.at("poses") +
                " poses collide";
        if (!row.at("thesis_scene").empty()) thesis = "; in brackets the thesis's " + row.at("thesis_scene");
    }
    printTable(scene + ": trees of the environment, " + about + thesis, lines);
}

void printClaims(const study::StudyResult& result, const std::string& scene) {
    Lines lines = {{"width", "claim", "thesis", "here", "verdict"}};
    for (const study::TableRow& row : result.claims) {
        if (row.at("scene") != scene) continue;
        lines.push_back({row.at("node_width"), row.at("claim"), short3(row.at("thesis_ratio")),
                         ratioText(row), row.at("verdict")});
    }
    printTable(scene + ": the thesis's claims", lines);
}

}  // namespace

void printStudy(const study::StudyResult& result) {
    std::vector<std::string> scenes;
    for (const study::TableRow& row : result.trees) {
        if (std::find(scenes.begin(), scenes.end(), row.at("scene")) == scenes.end())
            scenes.push_back(row.at("scene"));
    }
    for (const std::string& scene : scenes) {
        printAnswers(result, scene);
        printWork(result, scene);
        printDisturbed(result, scene);
        for (const Ratios& ratios : kRatios) printRatios(result, scene, ratios);
        printTrees(result, scene);
        printClaims(result, scene);
    }
    std::cout
        << "\nRatios are medians, with intervals of 95 in 100 bootstrap resamples of runs; of seconds, one "
           "below 1 is quicker.\nPlanners' seconds for each call are the processor's.\n"
        << study::claimRule() << "\n\n";
}

}  // namespace clearway::cli
