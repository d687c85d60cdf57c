#include "clearway/planning/objectives.h"

#include <ompl/base/objectives/MechanicalWorkOptimizationObjective.h>
#include <ompl/base/objectives/PathLengthOptimizationObjective.h>

#include <boost/algorithm/string/predicate.hpp>
#include <limits>
#include <memory>

#include "clearway/errors.h"
#include "clearway/planning/clearance_objectives.h"
#include "core/text.h"

namespace clearway::planning {
namespace {

namespace ob = ompl::base;

template <class Objective>
ob::OptimizationObjectivePtr make(const ob::SpaceInformationPtr& si, const SharedScene&,
                                  const ObjectiveChoice&) {
    return std::make_shared<Objective>(si);
}

template <class Objective>
ob::OptimizationObjectivePtr makeInScene(const ob::SpaceInformationPtr& si, const SharedScene& scene,
                                         const ObjectiveChoice&) {
    return std::make_shared<Objective>(si, scene);
}

LengthWithClearanceOptions wantedOf(const ObjectiveChoice& choice) {
    LengthWithClearanceOptions options;
    options.wanted = choice.wantedClearance;
    return options;
}

ob::OptimizationObjectivePtr makeWanted(const ob::SpaceInformationPtr& si, const SharedScene& scene,
                                        const ObjectiveChoice& choice) {
    return std::make_shared<LengthWithClearanceObjective>(si, scene, wantedOf(choice));
}

double none(const ObjectiveChoice&, const Model&) {
    return 0;
}

double diagonal(const ObjectiveChoice&, const Model& part) {
    return part.box().diagonal().norm();
}

double unbounded(const ObjectiveChoice&, const Model&) {
    return std::numeric_limits<double>::infinity();
}

double wanted(const ObjectiveChoice& choice, const Model& part) {
    return wantedClearance(wantedOf(choice), part);
}

struct NamedObjective {
    const char* name;
    ob::OptimizationObjectivePtr (*make)(const ob::SpaceInformationPtr&, const SharedScene&,
                                         const ObjectiveChoice&);
    double (*largestClearance)(const ObjectiveChoice&, const Model&);
};

constexpr NamedObjective kObjectives[] = {
    {"length", make<ob::PathLengthOptimizationObjective>, none},
    {"max_min_clearance", makeInScene<MinClearanceObjective>, unbounded},
    {"clearance_integral", makeInScene<ClearanceIntegralObjective>, diagonal},
    {"length_with_clearance", makeWanted, wanted},
    {"mechanical_work", make<ob::MechanicalWorkOptimizationObjective>, none},
};

const NamedObjective& findObjective(const std::string& name) {
    const std::string asked = boost::iequals(name, "min_clearance") ? "max_min_clearance" : name;
    for (const NamedObjective& row : kObjectives) {
        if (boost::iequals(row.name, asked)) return row;
    }
    const std::vector<std::string> known = namesOf(kObjectives);
    throw ArgumentError("unknown objective '" + name + "'" + didYouMean(name, known) + ", expected one of " +
                        joined(known));
}

}  // namespace

std::vector<std::string> objectiveNames() {
    return namesOf(kObjectives);
}

std::string objectiveName(const std::string& name) {
    return findObjective(name).name;
}

ob::OptimizationObjectivePtr makeObjective(const ob::SpaceInformationPtr& si, const SharedScene& scene,
                                           const ObjectiveChoice& choice) {
    return findObjective(choice.name).make(si, scene, choice);
}

double largestClearance(const ObjectiveChoice& choice, const Model& part) {
    return findObjective(choice.name).largestClearance(choice, part);
}

}  // namespace clearway::planning
