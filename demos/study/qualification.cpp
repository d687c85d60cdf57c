#include "demos/study/qualification.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "demos/study/statistics.h"

namespace clearway::study {
namespace {

/// Paired runs take longer than their planners by this factor: most trees are slower than the qualifying one, and each run makes a
/// planner and audits its path.
constexpr double kOverhead = 2;

std::size_t leastSolved(const StudyOptions& options) {
    return static_cast<std::size_t>(std::ceil(kLeastSolved * options.seeds - 1e-9));
}

std::size_t solvedOf(const Outcomes& outcomes) {
    return static_cast<std::size_t>(std::count_if(
        outcomes.begin(), outcomes.end(), [](const Measure& seconds) { return seconds.has_value(); }));
}

double secondsOf(const QualifiedRow& row, std::uint64_t seeds, const StudyOptions& options) {
    const auto runs = static_cast<double>(seeds * plannedEngines(options).size());
    return kOverhead * row.medianSeconds.value_or(0) * runs;
}

double sum(const std::vector<QualifiedRow>& rows, const StudyOptions& options) {
    double seconds = 0;
    for (const QualifiedRow& row : rows) seconds += secondsOf(row, row.seeds, options);
    return seconds;
}

}  // namespace

bool isDecided(const Outcomes& outcomes, const StudyOptions& options) {
    const auto seeds = static_cast<std::size_t>(options.seeds);
    if (outcomes.size() >= seeds) return true;
    const std::size_t unsolved = outcomes.size() - solvedOf(outcomes);
    const auto slow =
        static_cast<std::size_t>(std::count_if(outcomes.begin(), outcomes.end(), [&](const Measure& seconds) {
            return !seconds || *seconds > options.mostMedian;
        }));
    return seeds - unsolved < leastSolved(options) || slow > seeds / 2;
}

Columns<QualifiedRow> qualifiedColumns() {
    using Row = QualifiedRow;
    return {{"scene", &Row::scene},
            {"planner", &Row::planner},
            {"runs", &Row::runs},
            {"solved", &Row::solved},
            {"median_seconds", &Row::medianSeconds},
            {"verdict", &Row::verdict},
            {"limit_seconds", &Row::limitSeconds},
            {"seeds", &Row::seeds}};
}

QualifiedRow judge(const std::string& scene, const std::string& planner, const Outcomes& outcomes,
                   const StudyOptions& options) {
    QualifiedRow row;
    row.scene = scene;
    row.planner = planner;
    row.runs = outcomes.size();
    row.solved = solvedOf(outcomes);
    std::vector<double> seconds;
    for (const Measure& each : outcomes) seconds.push_back(each.value_or(options.qualifyingSeconds));
    const double middle = median(seconds);
    if (2 * row.solved > row.runs) row.medianSeconds = middle;
    if (row.solved + static_cast<std::uint64_t>(options.seeds) - row.runs < leastSolved(options)) {
        row.verdict = "solves too few";
    } else if (!row.medianSeconds || middle > options.mostMedian) {
        row.verdict = "too slow";
    } else {
        row.verdict = "enters";
        row.limitSeconds = std::max(options.leastLimit, kLimitOverMedian * middle);
    }
    return row;
}

std::vector<std::string> unablePlanners(const std::vector<QualifiedRow>& rows, const StudyOptions& options) {
    std::set<std::string> scenes;
    for (const QualifiedRow& row : rows) scenes.insert(row.scene);
    std::vector<std::string> unable;
    for (const std::string& planner : options.planners) {
        const auto entered =
            static_cast<std::size_t>(std::count_if(rows.begin(), rows.end(), [&](const QualifiedRow& row) {
                return row.planner == planner && row.enters();
            }));
        if (entered < (scenes.size() < kLeastProblems ? 1 : kLeastProblems)) unable.push_back(planner);
    }
    return unable;
}

void fitSeeds(std::vector<QualifiedRow>& rows, const StudyOptions& options, double seconds) {
    const auto setAll = [&](std::uint64_t seeds) {
        for (QualifiedRow& row : rows) row.seeds = row.enters() ? seeds : 0;
    };
    const auto seeds = static_cast<std::uint64_t>(options.seeds);
    setAll(seeds);
    if (sum(rows, options) > seconds) setAll((seeds + 1) / 2);
    while (sum(rows, options) > seconds) {
        const auto slowest =
            std::max_element(rows.begin(), rows.end(), [&](const QualifiedRow& a, const QualifiedRow& b) {
                return secondsOf(a, a.seeds, options) < secondsOf(b, b.seeds, options);
            });
        slowest->seeds = 0;
    }
}

}  // namespace clearway::study
