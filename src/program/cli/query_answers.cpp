#include "program/cli/query_answers.h"

#include <fmt/format.h>

#include <algorithm>
#include <ostream>

#include "core/number.h"
#include "program/cli/csv_cells.h"
#include "program/options/facts.h"
#include "program/options/print.h"

namespace clearway::cli {

namespace {

Json answerFacts(const Question& question, const Answer& answer, const Model& part,
                 const Model& environment) {
    if (question.kind != Question::Kind::kDistance) return answer.verdict;
    const DistanceResult& found = answer.distance;
    Json json = {
        {"distance", toJson(found.distance)}, {"lower", toJson(found.lower)}, {"upper", toJson(found.upper)}};
    if (!found.witness) return json;
    json["part"] = {{"mesh", nameAt(part, found.witness->partComponent)},
                    {"triangle", found.witness->partTriangle},
                    {"point", toJson(found.witness->pointOnPart)}};
    json["environment"] = {{"mesh", nameAt(environment, found.witness->environmentComponent)},
                           {"triangle", found.witness->environmentTriangle},
                           {"point", toJson(found.witness->pointOnEnvironment)}};
    return json;
}

std::string rowOf(const DistanceResult& result) {
    const auto& witness = result.witness;
    return fmt::format("{},{},{},{},{}", formatNumber(result.distance), formatNumber(result.lower),
                       formatNumber(result.upper), witness ? witness->partTriangle : -1,
                       witness ? witness->environmentTriangle : -1);
}

/// The names and closest points of an answer; empty cells beyond the cap.
std::string pairCells(const DistanceResult& found, const Model& part, const Model& environment) {
    if (!found.witness) return ",,,,,,,";
    return textCell(nameAt(part, found.witness->partComponent)) + "," +
           numberCells(found.witness->pointOnPart) + "," +
           textCell(nameAt(environment, found.witness->environmentComponent)) + "," +
           numberCells(found.witness->pointOnEnvironment);
}

}  // namespace

DistanceStatistics statisticsOf(const std::vector<Answer>& answers) {
    DistanceStatistics all;
    const auto at = [&](std::size_t pose) { return answers[pose].distance.distance; };
    for (std::size_t pose = 0; pose < answers.size(); ++pose) {
        const DistanceResult& found = answers[pose].distance;
        if (!found.witness) {
            ++all.beyond;
            continue;
        }
        if (found.collides()) ++all.colliding;
        all.widest = std::max(all.widest, found.upper - found.lower);
        if (!all.least || at(pose) < at(*all.least)) all.least = pose;
        if (!all.most || at(pose) > at(*all.most)) all.most = pose;
    }
    return all;
}

std::size_t countYes(const QueryRun& run) {
    return static_cast<std::size_t>(std::count_if(run.answers.begin(), run.answers.end(),
                                                  [](const Answer& answer) { return answer.verdict; }));
}

double queriesPerSecond(const QueryRun& run) {
    std::int64_t nanoseconds = 0;
    for (const Answer& answer : run.answers) nanoseconds += answer.nanoseconds;
    return static_cast<double>(run.answers.size()) /
           (1e-9 * static_cast<double>(std::max<std::int64_t>(nanoseconds, 1)));
}

std::string nameAt(const Model& model, std::int64_t component) {
    const auto& components = model.components();
    return component < 0 || static_cast<std::size_t>(component) >= components.size()
               ? ""
               : components[static_cast<std::size_t>(component)].name;
}

void keepAnswers(const Question& question, const std::vector<Pose>& poses, const QueryRun& run,
                 const Model& part, const Model& environment) {
    Json& all = facts();
    all["part"] = toJson(part);
    all["environment"] = toJson(environment);
    for (const Pose& pose : poses) all["poses"].push_back(toJson(pose));
    for (const Answer& answer : run.answers)
        all["answers"].push_back(answerFacts(question, answer, part, environment));
}

void writeAnswers(const Question& question, const std::vector<Pose>& poses, const QueryRun& run,
                  const Model& part, const Model& environment, const std::string& file) {
    const bool isDistance = question.kind == Question::Kind::kDistance;
    writeOut(file, [&](std::ostream& stream) {
        stream << (isDistance ? "pose,distance,lower,upper,part_triangle,environment_triangle,nanoseconds"
                              : "pose,verdict,nanoseconds")
               << ",x,y,z,qx,qy,qz,qw"
               << (isDistance
                       ? ",part_mesh,part_x,part_y,part_z,environment_mesh,environment_x,environment_y,"
                         "environment_z\n"
                       : "\n");
        for (std::size_t pose = 0; pose < run.answers.size(); ++pose) {
            const Answer& answer = run.answers[pose];
            stream << pose << ","
                   << (isDistance       ? rowOf(answer.distance)
                       : answer.verdict ? "1"
                                        : "0")
                   << "," << answer.nanoseconds << "," << numberCells(poses[pose])
                   << (isDistance ? "," + pairCells(answer.distance, part, environment) : "") << "\n";
        }
    });
}

}  // namespace clearway::cli
