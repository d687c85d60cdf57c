#include "planning/setup/problem_settings.h"

#include <algorithm>
#include <set>
#include <stdexcept>

#include "clearway/planning/planners.h"
#include "core/number.h"
#include "planning/setup/planning_space.h"

namespace clearway::planning {
namespace {

namespace ob = ompl::base;

/// Values that the set takes; returns the names of those it has.
std::set<std::string> apply(ob::ParamSet& parameters, const NamedTexts& settings) {
    std::set<std::string> known;
    for (const auto& [name, value] : settings) {
        if (!parameters.hasParam(name)) continue;
        known.insert(name);
        bool isSet = false;
        try {
            isSet = parseNumber(value) && parameters.setParam(name, value);
        } catch (const std::exception&) {  // a number out of OMPL's range
        }
        if (isSet) continue;
        throw std::invalid_argument("the problem's setting " + name + " is '" + value +
                                    "', expected a number that OMPL takes");
    }
    return known;
}

}  // namespace

Problem problemFor(const std::string& planner, const Problem& problem) {
    Problem result = problem;
    const auto choice =
        std::find_if(problem.planners.begin(), problem.planners.end(),
                     [&](const PlannerChoice& each) { return plannerClassName(each.name) == planner; });
    if (choice == problem.planners.end()) return result;
    for (const auto& [name, value] : choice->settings) {
        if (name == "sampler") {
            result.sampler = value;
        } else if (name == "objective.threshold") {
            result.objectiveThreshold = parseNumber(value);
        } else {
            result.settings.emplace_back(name, value);  // the later one counts
        }
    }
    return result;
}

bool mayUseSampler(const Problem& problem, const std::string& sampler) {
    const std::pair<std::string, std::string> wanted("sampler", sampler);
    return problem.sampler == sampler ||
           std::any_of(problem.planners.begin(), problem.planners.end(), [&](const PlannerChoice& planner) {
               const NamedTexts& settings = planner.settings;
               return std::find(settings.begin(), settings.end(), wanted) != settings.end();
           });
}

void setUp(ob::SpaceInformation& si, const Problem& problem, std::vector<std::string>& warnings) {
    std::set<std::string> known = apply(si.getStateSpace()->params(), problem.settings);
    const bool isDefault = problem.sampler.empty() && !problem.settings.empty();
    setSampler(
        si, isDefault ? "uniform" : problem.sampler,
        [settings = problem.settings](ob::ValidStateSampler& sampler) { apply(sampler.params(), settings); });
    si.setup();
    known.merge(apply(si.params(), problem.settings));  // projections come with the setup
    known.merge(apply(si.allocValidStateSampler()->params(), problem.settings));
    for (const auto& [name, value] : problem.settings) {
        if (known.count(name)) continue;
        warnings.push_back(problem.file + ": neither the space nor the sampler has a setting '" + name +
                           "'; it is left out");
    }
}

}  // namespace clearway::planning
