#include "program/cli/query_run.h"

#include <algorithm>
#include <chrono>
#include <numeric>
#include <ostream>
#include <random>
#include <stdexcept>
#include <string>

#include "core/number.h"
#include "core/replace_file.h"
#include "program/cli/print.h"

namespace clearway::cli {

namespace {

/// Fisher-Yates on the engine itself: std::shuffle and the standard's distributions differ between libraries.
std::vector<std::size_t> orderOf(std::size_t count, std::optional<std::uint64_t> shuffleSeed) {
    std::vector<std::size_t> order(count);
    std::iota(order.begin(), order.end(), std::size_t{0});
    if (!shuffleSeed) return order;
    std::mt19937_64 random(*shuffleSeed);
    for (std::size_t left = count; left > 1; --left) std::swap(order[left - 1], order[random() % left]);
    return order;
}

Answer askOnce(const Question& question, const Model& part, const Model& environment,
               const Pose& X_environmentPart, Workspace& workspace) {
    Answer answer;
    const auto begin = std::chrono::steady_clock::now();
    switch (question.kind) {
        case Question::Kind::kDistance:
            answer.distance = distance(part, environment, X_environmentPart, question.distance, workspace);
            break;
        case Question::Kind::kCollide:
            answer.verdict = collides(part, environment, X_environmentPart, workspace);
            break;
        case Question::Kind::kWithin:
            answer.verdict = isWithin(part, environment, X_environmentPart, question.within, workspace);
            break;
    }
    const auto end = std::chrono::steady_clock::now();
    answer.nanoseconds = std::chrono::duration_cast<std::chrono::nanoseconds>(end - begin).count();
    return answer;
}

/// A refusal says which pose it is about, counted as in the table.
Answer askAbout(std::size_t pose, const Question& question, const Model& part, const Model& environment,
                const Pose& X_environmentPart, Workspace& workspace) {
    try {
        return askOnce(question, part, environment, X_environmentPart, workspace);
    } catch (const std::invalid_argument& refusal) {
        throw std::invalid_argument("pose " + std::to_string(pose) + ": " + refusal.what());
    }
}

std::string outOf(std::size_t count, const QueryRun& run) {
    return std::to_string(count) + " of " + std::to_string(run.answers.size());
}

bool isBeyondCap(const DistanceResult& result) {
    return result.partTriangle < 0;
}

void printDistances(const QueryRun& run) {
    std::size_t colliding = 0;
    std::size_t beyond = 0;
    const Answer* least = nullptr;
    const Answer* most = nullptr;
    double width = 0;
    for (const Answer& answer : run.answers) {
        if (isBeyondCap(answer.distance)) {
            ++beyond;
            continue;
        }
        if (answer.distance.collides()) ++colliding;
        width = std::max(width, answer.distance.upper - answer.distance.lower);
        if (!least || answer.distance.distance < least->distance.distance) least = &answer;
        if (!most || answer.distance.distance > most->distance.distance) most = &answer;
    }
    const auto row = [&](const char* label, const Answer& answer) {
        printRow(label, readable(answer.distance.distance) + " at pose " +
                            std::to_string(&answer - run.answers.data()));
    };
    printRow("colliding", outOf(colliding, run));
    if (beyond > 0) printRow("beyond the cap", outOf(beyond, run));
    if (!least) return;
    row("least distance", *least);
    row("most distance", *most);
    printRow("widest interval", readable(width));
}

std::string rowOf(const DistanceResult& result) {
    return formatNumber(result.distance) + "," + formatNumber(result.lower) + "," +
           formatNumber(result.upper) + "," + std::to_string(result.partTriangle) + "," +
           std::to_string(result.environmentTriangle);
}

}  // namespace

QueryRun ask(const Question& question, const Model& part, const Model& environment,
             const std::vector<Pose>& poses) {
    QueryRun run;
    run.answers.resize(poses.size());
    Workspace workspace;
    for (const std::size_t pose : orderOf(poses.size(), question.shuffleSeed)) {
        if (question.isCold) workspace.forgetWarmStart();
        run.answers[pose] = askAbout(pose, question, part, environment, poses[pose], workspace);
        run.counters += workspace.counters();
    }
    return run;
}

void printSummary(const Question& question, const QueryRun& run) {
    if (question.kind == Question::Kind::kDistance) return printDistances(run);
    const auto yes = std::count_if(run.answers.begin(), run.answers.end(),
                                   [](const Answer& answer) { return answer.verdict; });
    const bool isWithin = question.kind == Question::Kind::kWithin;
    printRow(isWithin ? "within " + readable(question.within) : "colliding",
             outOf(static_cast<std::size_t>(yes), run));
}

void printCosts(const QueryRun& run, const Model& part, const Model& environment) {
    const double count = static_cast<double>(run.answers.size());
    std::int64_t nanoseconds = 0;
    for (const Answer& answer : run.answers) nanoseconds += answer.nanoseconds;
    const double bytes = static_cast<double>(part.report().tree.bytes + environment.report().tree.bytes);
    const double triangles = static_cast<double>(part.report().triangles + environment.report().triangles);
    printRow("queries/s",
             readable(count / (1e-9 * static_cast<double>(std::max<std::int64_t>(nanoseconds, 1)))));
    printRow("volume tests per query", readable(static_cast<double>(run.counters.volumeTests) / count));
    printRow("triangle tests per query", readable(static_cast<double>(run.counters.triangleTests) / count));
    printRow("pairs in double per query", readable(static_cast<double>(run.counters.refinedPairs) / count));
    printRow("  in double-double", readable(static_cast<double>(run.counters.doubleDoublePairs) / count));
    printRow("  exact", readable(static_cast<double>(run.counters.exactPairs) / count));
    printRow("bytes per triangle", readable(bytes / triangles));
    printRow("build seconds", readable(part.report().seconds + environment.report().seconds));
}

void writeCsv(const Question& question, const QueryRun& run, const std::string& file) {
    const bool isDistance = question.kind == Question::Kind::kDistance;
    replaceFile(file, [&](std::ostream& stream) {
        stream << (isDistance ? "pose,distance,lower,upper,part_triangle,environment_triangle,nanoseconds\n"
                              : "pose,verdict,nanoseconds\n");
        for (std::size_t pose = 0; pose < run.answers.size(); ++pose) {
            const Answer& answer = run.answers[pose];
            stream << pose << ","
                   << (isDistance       ? rowOf(answer.distance)
                       : answer.verdict ? "1"
                                        : "0")
                   << "," << answer.nanoseconds << "\n";
        }
    });
}

}  // namespace clearway::cli
