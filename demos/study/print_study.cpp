#include "demos/study/print_study.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <iostream>
#include <map>
#include <tuple>

#include "clearway/build_options.h"

namespace clearway::cli {

namespace {

using Lines = std::vector<std::vector<std::string>>;

/// Prints columns as wide as their widest cell. The first line is the head.
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

std::string short3(double number) {
    return number >= 1000 ? fmt::format("{:.0f}", number) : fmt::format("{:.3g}", number);
}

std::string short3(const study::Measure& number) {
    return number ? short3(*number) : "-";
}

std::string percent(const study::Measure& share) {
    return share ? short3(100 * *share) + " %" : "-";
}

std::string countText(const study::Count& count) {
    return count ? std::to_string(*count) : "";
}

std::string ratioText(const study::PairedRatio& ratio) {
    return fmt::format("{} ({} to {})", short3(ratio.median), short3(ratio.low), short3(ratio.high));
}

/// Orders leaf splits from the fewest leaves to the most.
std::size_t placeOf(const std::string& leafSplit) {
    const std::vector<std::string> all = leafSplitNames();
    return static_cast<std::size_t>(std::find(all.begin(), all.end(), leafSplit) - all.begin());
}

/// Prints a line for each planner and strategy of a scene's runs.
template <class Cells>
void printRuns(const study::StudyResult& result, const std::string& scene, const std::string& title,
               const std::vector<std::string>& head, const Cells& cells) {
    Lines lines = {{"planner", "strategy"}};
    lines[0].insert(lines[0].end(), head.begin(), head.end());
    for (const study::SummaryRow& row : result.summary) {
        if (row.scene != scene || row.source != "runs" || row.planner == "all") continue;
        lines.push_back({row.planner, row.generalSplit + "/" + row.leafSplit});
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
    printRuns(result, scene, "solutions (medians) and questions of the planners (means of a run)",
              {"solved", "first solution s", "last one s", "cost", "states", "motions", "motion costs",
               "distance queries", "within queries"},
              [](const study::SummaryRow& row) -> std::vector<std::string> {
                  return {countText(row.solved) + " of " + countText(row.runs),
                          short3(row.firstSolutionSeconds),
                          short3(row.finalSolutionSeconds),
                          short3(row.cost),
                          short3(row.stateChecks),
                          short3(row.motionChecks),
                          short3(row.motionCosts),
                          short3(row.distanceQueries),
                          short3(row.withinQueries)};
              });
}

void printWork(const study::StudyResult& result, const std::string& scene) {
    printRuns(result, scene, "cost of the answers",
              {"calls/s", "time in calls", "volumes/query", "triangles/query", "blocks full", "kernels full"},
              [](const study::SummaryRow& row) -> std::vector<std::string> {
                  return {short3(row.callsPerSecond), percent(row.queryShare), short3(row.volumeTests),
                          short3(row.triangleTests),  percent(row.blockFill),  percent(row.kernelFill)};
              });
}

/// Counts the runs whose times say nothing.
void printDisturbed(const study::StudyResult& result, const std::string& scene) {
    std::uint64_t disturbed = 0, runs = 0;
    for (const study::SummaryRow& row : result.summary) {
        if (row.scene != scene || row.source != "runs" || row.planner != "all") continue;
        disturbed += row.disturbed.value_or(0);
        runs += row.runs.value_or(0);
    }
    if (disturbed == 0) return;
    std::cout << fmt::format(
        "\n{} of {} runs of {} had less than 95 % of a processor: the machine did other work, too. These "
        "runs are "
        "left out of ratios of\nseconds to the first solution and within calls.\n",
        disturbed, runs, scene);
}

const study::Engine kUsual;  ///< the engine of planner runs, but for the splits

bool isUsual(const study::Engine& engine) {
    return engine.leafSize == kUsual.leafSize && engine.nodeWidth == kUsual.nodeWidth &&
           engine.instructions == kUsual.instructions;
}

std::string treeName(const study::Engine& engine) {
    std::string name = engine.generalSplit;
    if (engine.leafSize != kUsual.leafSize) name += ", leaves of " + std::to_string(engine.leafSize);
    if (engine.nodeWidth != kUsual.nodeWidth) name += ", width " + std::to_string(engine.nodeWidth);
    if (engine.instructions != kUsual.instructions) name += ", " + engine.instructions;
    return name;
}

struct Ratios {
    const char* title;
    const char* source;
    const char* measure;
    bool isByPlanner;  ///< true: planners with the usual trees; false: all trees, with all planners' calls
};

/// Prints a line for each tree or planner, and a column for each leaf split.
void printRatios(const study::StudyResult& result, const std::string& scene, const Ratios& of) {
    std::vector<std::string> splits, names;
    std::map<std::string, std::map<std::string, std::string>> ratios;
    std::map<std::string, std::tuple<std::string, std::string, bool, int, int>> keys;  // names' sort keys
    std::string baseline;
    for (const study::StatisticRow& row : result.statistics) {
        if (row.scene != scene || row.source != of.source || row.measure != of.measure) continue;
        if ((row.planner == "all") == of.isByPlanner || (of.isByPlanner && !isUsual(row))) continue;
        const std::string& split = row.leafSplit;
        if (std::find(splits.begin(), splits.end(), split) == splits.end()) splits.push_back(split);
        const std::string name = (of.isByPlanner ? row.planner + ", " : "") + treeName(row);
        if (ratios.count(name) == 0) names.push_back(name);
        keys[name] = {of.isByPlanner ? row.planner : "", row.generalSplit,
                      row.instructions != kUsual.instructions, -row.nodeWidth, row.leafSize};
        ratios[name][split] = ratioText(row);
        baseline = row.baseline;
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
    {"seconds within each call, pairs of runs", "runs", "query_seconds_per_call", true},
    {"seconds of the same calls, replayed", "replay", "seconds", true},
    {"seconds of the same calls, replayed, all planners'", "replay", "seconds", false},
    {"triangle tests of the same calls, replayed", "replay", "triangle_tests", false},
    {"share of blocks in use, replayed", "replay", "block_fill", false},
};

/// Clearway's figure, then the thesis's in brackets.
std::string beside(double ours, const study::Measure& thesis) {
    return short3(ours) + (thesis ? " [" + short3(thesis) + "]" : "");
}

void printTrees(const study::StudyResult& result, const std::string& scene) {
    Lines lines = {{"width", "strategy", "build s", "MB", "leaves of 1", "2", "3", "4", "leaves",
                    "collisions/s", "distances/s"}};
    std::string about, thesis;
    for (const study::TreeRow& row : result.trees) {
        if (row.scene != scene) continue;
        lines.push_back(
            {std::to_string(row.nodeWidth), row.generalSplit + "/" + row.leafSplit,
             beside(row.buildSeconds, row.thesisBuildSeconds), beside(row.megabytes, row.thesisMegabytes),
             std::to_string(row.leavesOf1), std::to_string(row.leavesOf2), std::to_string(row.leavesOf3),
             std::to_string(row.leavesOf4), beside(static_cast<double>(row.leaves), row.thesisLeaves),
             beside(row.collisionsPerSecond, row.thesisCollisions),
             beside(row.distancesPerSecond, row.thesisDistances)});
        about = fmt::format("{} triangles, {} of {} poses collide", row.triangles, row.colliding, row.poses);
        if (!row.thesisScene.empty()) thesis = "; in brackets the thesis's " + row.thesisScene;
    }
    printTable(scene + ": trees of the environment, " + about + thesis, lines);
}

void printClaims(const study::StudyResult& result, const std::string& scene) {
    Lines lines = {{"width", "claim", "thesis", "here", "verdict"}};
    for (const study::ClaimRow& row : result.claims) {
        if (row.scene != scene) continue;
        lines.push_back(
            {std::to_string(row.nodeWidth), row.claim, short3(row.thesisRatio), ratioText(row), row.verdict});
    }
    printTable(scene + ": the thesis's claims", lines);
}

}  // namespace

void printStudy(const study::StudyResult& result) {
    std::vector<std::string> scenes;
    for (const study::TreeRow& row : result.trees) {
        if (std::find(scenes.begin(), scenes.end(), row.scene) == scenes.end()) scenes.push_back(row.scene);
    }
    for (const std::string& scene : scenes) {
        printAnswers(result, scene);
        printWork(result, scene);
        printDisturbed(result, scene);
        for (const Ratios& ratios : kRatios) printRatios(result, scene, ratios);
        printTrees(result, scene);
        printClaims(result, scene);
    }
    std::cout << "\nRatios are medians, with intervals of 95 in 100 bootstrap resamples of runs. A ratio of "
                 "seconds below 1 means\nquicker. Planners' seconds for each call are processor time.\n"
              << study::claimRule() << "\n\n";
}

}  // namespace clearway::cli
