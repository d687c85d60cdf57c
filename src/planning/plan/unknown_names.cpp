// Looks up the names that a problem file gives to planning: objective, samplers, planners and their parameters.
#include <ompl/base/spaces/SE3StateSpace.h>

#include <algorithm>
#include <memory>
#include <stdexcept>

#include "clearway/errors.h"
#include "clearway/planning/objectives.h"
#include "clearway/planning/ompl_messages.h"
#include "clearway/planning/plan.h"
#include "clearway/planning/planners.h"
#include "core/text.h"
#include "planning/plan/problem_settings.h"

namespace clearway::planning {
namespace {

namespace ob = ompl::base;

class Judge {
  public:
    explicit Judge(const Problem& problem) : problem_(problem) {}

    /// Calls look, which throws for an unknown name. consequence: what becomes of such a name in a file of OMPL.app's.
    /// Returns whether the name is known.
    template <class Look>
    bool require(const Look& look, const std::string& consequence) {
        try {
            look();
            return true;
        } catch (const std::invalid_argument& error) {
            const std::string what = (problem_.file.empty() ? "" : problem_.file + ": ") + error.what();
            const bool isOmplApps = problem_.meshes.asOmplApp && !problem_.meshes.isReadingStated;
            if (!isOmplApps) throw ArgumentError(what);
            const std::string warning = what + consequence;
            if (std::find(warnings.begin(), warnings.end(), warning) == warnings.end())
                warnings.push_back(warning);
            return false;
        }
    }

    std::vector<std::string> warnings;

  private:
    const Problem& problem_;
};

/// A planner in an empty space: it has its parameters.
ob::PlannerPtr anyPlanner(const std::string& name) {
    const OmplMessages unobserved;
    return makePlanner(std::make_shared<ob::SpaceInformation>(std::make_shared<ob::SE3StateSpace>()), name);
}

void requireParameters(const PlannerChoice& choice, Judge& judge) {
    const std::string name = plannerClassName(choice.name);
    const ob::PlannerPtr planner = anyPlanner(name);
    std::vector<std::string> known;
    planner->params().getParamNames(known);
    for (const auto& [parameter, value] : choice.parameters) {
        if (parameter == "name" || hasParameter(*planner, parameter)) continue;
        const std::string what = "planner " + name + " has no parameter '" + parameter + "'" +
                                 didYouMean(parameter, known) + ", expected one of " + joined(known);
        judge.require([&] { throw ArgumentError(what); }, "; it is left out");
    }
}

}  // namespace

std::vector<std::string> unknownNames(const Problem& problem) {
    Judge judge(problem);
    judge.require([&] { objectiveName(problem.planning.objective); }, "; paths are judged by length");
    if (!problem.planning.sampler.empty())
        judge.require([&] { requireSampler(problem.planning.sampler); }, "");
    for (const PlannerChoice& choice : problem.planning.planners) {
        for (const auto& [name, value] : choice.settings) {
            if (name == "sampler") judge.require([&, &sampler = value] { requireSampler(sampler); }, "");
        }
        const bool isKnown = judge.require([&] { plannerClassName(choice.name); }, "");
        if (isKnown && !choice.parameters.empty()) requireParameters(choice, judge);
    }
    return judge.warnings;
}

}  // namespace clearway::planning
