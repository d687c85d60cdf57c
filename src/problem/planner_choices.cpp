#include "problem/planner_choices.h"

#include <algorithm>
#include <boost/algorithm/string/case_conv.hpp>
#include <stdexcept>

#include "core/lines.h"

namespace clearway {

namespace {

/// The last planner of the name, made when there is none: OMPL.app lets the parameters come first.
PlannerChoice& lastOf(std::vector<PlannerChoice>& planners, const std::string& name) {
    const auto last = std::find_if(planners.rbegin(), planners.rend(),
                                   [&](const PlannerChoice& planner) { return planner.name == name; });
    if (last != planners.rend()) return *last;
    planners.push_back({name, {}});
    return planners.back();
}

void setParameter(PlannerChoice& planner, const std::string& parameter, const std::string& value) {
    for (auto& [name, old] : planner.parameters) {
        if (name == parameter) {
            old = value;
            return;
        }
    }
    planner.parameters.push_back({parameter, value});
}

}  // namespace

std::vector<PlannerChoice> plannerChoices(const std::string& file, const std::vector<ConfigEntry>& entries,
                                          std::vector<std::string>& warnings) {
    std::vector<PlannerChoice> planners;
    for (const ConfigEntry& entry : entries) {
        if (sectionOf(entry.name) != "planner") continue;
        const std::string key = boost::to_lower_copy(keyOf(entry.name));
        const std::size_t dot = key.find('.');
        const std::string name = key.substr(0, dot);
        const std::string parameter = dot == std::string::npos ? "" : key.substr(dot + 1);
        if (name.empty() || (dot != std::string::npos && parameter.empty())) {
            throw std::invalid_argument(place(file, entry.line) + "[planner] key is " + quote(key) +
                                        ", expected NAME = or NAME.PARAMETER = VALUE");
        }
        if (name == "problem") {  // OMPL.app's way to set the state space's parameters for one planner
            warnings.push_back(place(file, entry.line) + shown(entry.name) + " has no effect here");
        } else if (dot != std::string::npos) {
            setParameter(lastOf(planners, name), parameter, entry.value);
        } else {
            planners.push_back({name, {}});
            if (!entry.value.empty()) {
                warnings.push_back(place(file, entry.line) + shown(entry.name) + " is " + quote(entry.value) +
                                   ", which has no effect: parameters are set as NAME.PARAMETER = VALUE");
            }
        }
    }
    return planners;
}

}  // namespace clearway
