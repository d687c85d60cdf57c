#include "demos/study/answer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace clearway::study {
namespace {

/// A tree's times over those of the qualifying tree.
struct Standing {
    Engine engine;
    std::map<std::string, std::vector<double>> logs;  ///< by scene, one for each planner

    double ofScene(const std::string& scene) const {
        double sum = 0;
        for (const double each : logs.at(scene)) sum += each;
        return std::exp(sum / static_cast<double>(logs.at(scene).size()));
    }

    /// The geometric mean over the scenes, whose planners count alike.
    double mean() const {
        double sum = 0;
        for (const auto& scene : logs) sum += std::log(ofScene(scene.first));
        return logs.empty() ? 1 : std::exp(sum / static_cast<double>(logs.size()));
    }

    /// "it takes 22 % less time than in trees of sah/none (26 % less to 3 % more in single scenes)".
    std::string text(const std::string& baseline) const {
        if (engine.name() == baseline) return "no other tree is faster";
        double least = INFINITY, most = 0;
        for (const auto& scene : logs) {
            least = std::min(least, ofScene(scene.first));
            most = std::max(most, ofScene(scene.first));
        }
        if (logs.size() == 1)
            return fmt::format("it takes {} time than in trees of {}", percent(mean()), baseline);
        return fmt::format("it takes {} time than in trees of {} ({} to {} in each of {} scenes)",
                           percent(mean()), baseline, percent(least), percent(most), logs.size());
    }

    static std::string percent(double ratio) {
        return fmt::format("{:.0f} % {}", 100 * std::abs(ratio - 1), ratio <= 1 ? "less" : "more");
    }
};

/// The standings of the planned trees in a measure. The qualifying tree's own is 1 everywhere.
std::vector<Standing> standingsOf(const std::vector<RatioRow>& ratios, const std::string& source,
                                  const std::string& measure, const StudyOptions& options) {
    const Engine qualifying = qualifyingEngine(options);
    std::vector<Standing> all;
    for (const Engine& engine : plannedEngines(options)) {
        Standing standing{engine, {}};
        for (const RatioRow& row : ratios) {
            if (row.source != source || row.measure != measure || row.baseline != qualifying.name()) continue;
            const bool isOfAll = row.planner == "all";
            if (isOfAll != (source == "replay") || !(row.median > 0)) continue;
            if (engine == qualifying) {
                standing.logs[row.scene] = {0};
            } else if (static_cast<const Engine&>(row) == engine) {
                standing.logs[row.scene].push_back(std::log(row.median));
            }
        }
        if (!standing.logs.empty()) all.push_back(standing);
    }
    return all;
}

const Standing& best(const std::vector<Standing>& all) {
    return *std::min_element(all.begin(), all.end(),
                             [](const Standing& a, const Standing& b) { return a.mean() < b.mean(); });
}

/// For each scene the queries after which the second tree has repaid a longer building. Empty for a scene where it never does.
std::vector<double> queriesToRepay(const Engine& first, const Engine& second, const Measured& measured) {
    std::map<std::string, double> moreBuilding, lessAsking, queries;
    for (const FilesRow& row : measured.files) {
        if (row == second) moreBuilding[row.scene] += row.buildSeconds;
        if (row == first) moreBuilding[row.scene] -= row.buildSeconds;
    }
    for (const ReplayRow& row : measured.replays) {
        if (row == first) {
            lessAsking[row.scene] += row.seconds;
            queries[row.scene] += row.queries();
        }
        if (row == second) lessAsking[row.scene] -= row.seconds;
    }
    std::vector<double> all;
    for (const auto& [scene, less] : lessAsking) {
        if (less > 0) all.push_back(std::max(0.0, moreBuilding[scene] * queries[scene] / less));
    }
    return all;
}

}  // namespace

std::string answerOf(const std::vector<RatioRow>& ratios, const Measured& measured,
                     const StudyOptions& options) {
    const std::string baseline = qualifyingEngine(options).name();
    const std::vector<Standing> paths = standingsOf(ratios, "runs", "files_to_path", options),
                                asked = standingsOf(ratios, "replay", "seconds", options);
    std::string text =
        "For one path, too few runs compare: planners found few paths, or decided otherwise in each tree.\n";
    if (!paths.empty())
        text = fmt::format("For one path, from files to the path, take {}: {}.\n", best(paths).engine.name(),
                           best(paths).text(baseline));
    if (asked.empty()) return text + "For thousands of queries, no planner left calls to ask again.\n";
    const Standing& queries = best(asked);
    text +=
        fmt::format("For thousands of queries, take {}: {}", queries.engine.name(), queries.text(baseline));
    if (paths.empty()) return text + ".\n";
    const Engine& onePath = best(paths).engine;
    const std::vector<double> repay = queriesToRepay(onePath, queries.engine, measured);
    if (!(queries.engine == onePath) && !repay.empty()) {
        text += fmt::format(
            "; after {:.0f} queries (median; {:.0f} to {:.0f} in {} of {} scenes) it has repaid what its "
            "building takes "
            "longer than that of {}",
            median(repay), *std::min_element(repay.begin(), repay.end()),
            *std::max_element(repay.begin(), repay.end()), repay.size(), queries.logs.size(), onePath.name());
    }
    return text + ".\n";
}

}  // namespace clearway::study
