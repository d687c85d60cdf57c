#include "program/cli/describe_problem.h"

#include "program/cli/print.h"

namespace clearway::cli {

namespace {

std::string description(const PartState& state) {
    const auto& q = state.rotation;
    return "position " + readable(state.position) + ", quaternion (x, y, z, w) (" + readable(q.x()) + ", " +
           readable(q.y()) + ", " + readable(q.z()) + ", " + readable(q.w()) + ")";
}

std::string description(const PlannerChoice& planner) {
    std::string text = planner.name;
    for (const auto& [name, value] : planner.parameters) text += ", " + name + " = " + value;
    for (const auto& [name, value] : planner.settings) text += ", problem." + name + " = " + value;
    return text;
}

void printContact(const char* where, const std::optional<ContactRule>& contact) {
    if (contact) printRow(where, readable(contact->distance));
}

}  // namespace

void describeProblem(const Problem& problem, const Box& environmentBox) {
    const Box bounds = boundsOf(problem, environmentBox);
    printRow("problem", problem.file + (problem.name.empty() ? "" : " (" + problem.name + ")"));
    printRow("space", problem.space == Space::kSe3 ? "SE(3)" : "SE(2)");
    printRow("start", description(problem.start));
    printRow("goal", description(problem.goal));
    printRow("bounds", readable(bounds) +
                           (problem.volume ? "" : " (the environment's box, grown to hold start and goal)"));
    printRow("objective", problem.objective + (problem.objectiveThreshold
                                                   ? ", threshold " + readable(*problem.objectiveThreshold)
                                                   : std::string()));
    if (!problem.sampler.empty()) printRow("sampler", problem.sampler);
    if (problem.goalThreshold) printRow("goal threshold", readable(*problem.goalThreshold));
    for (const auto& [name, value] : problem.settings) printRow("setting", name + " = " + value);
    printRow("margin", readable(problem.margin));
    printContact("contact at start", problem.rules.startContact);
    printContact("contact at goal", problem.rules.goalContact);
    printRow("step", problem.step ? readable(*problem.step) : "not stated");
    printRow("planners", problem.planners.empty() ? "not stated" : std::to_string(problem.planners.size()));
    for (const PlannerChoice& planner : problem.planners) printRow("  planner", description(planner));
    if (problem.timeLimit) printRow("time limit", readable(*problem.timeLimit) + " s");
    if (problem.memoryLimit) printRow("memory limit", readable(*problem.memoryLimit) + " MB");
    if (problem.runCount) printRow("runs", std::to_string(*problem.runCount));
    if (!problem.outputFolder.empty()) printRow("log folder", problem.outputFolder);
    for (const std::string& warning : problem.warnings) printRow("warning", warning);
}

}  // namespace clearway::cli
