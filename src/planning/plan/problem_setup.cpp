#include "clearway/planning/problem_setup.h"

#include <ompl/util/Console.h>

#include <memory>

#include "clearway/errors.h"
#include "clearway/planning/validity_checker.h"
#include "planning/plan/goals.h"
#include "planning/plan/problem_settings.h"
#include "planning/space/ompl_refusal.h"
#include "planning/space/ompl_states.h"

namespace clearway::planning {

og::SimpleSetup makeSetup(const Problem& problem, const Scene& scene) try {
    const Box bounds = boundsOf(problem, scene.environmentBox(), scene.part.box());
    og::SimpleSetup setup(makeSpace(problem.space, bounds, scene.part.radiusAboutOrigin()));
    const ob::SpaceInformationPtr& si = setup.getSpaceInformation();
    const auto checker = std::make_shared<ValidityChecker>(si, scene);
    si->setStateValidityChecker(checker);
    si->setMotionValidator(std::make_shared<MotionValidator>(si, checker->shared()));

    const auto start = toOmpl(si->getStateSpace(), problem.space, problem.start);
    requireValid(problem, *checker, start.get(), ProblemEnd::kStart);
    if (!problem.outside) {
        const auto goal = toOmpl(si->getStateSpace(), problem.space, problem.goal);
        requireValid(problem, *checker, goal.get(), ProblemEnd::kGoal);
    }
    setup.setStartState(start);
    setup.setGoal(makeGoal(si, problem, scene));

    std::vector<std::string> warnings;
    applySettings(*si, problem, warnings);
    for (const std::string& warning : warnings) OMPL_WARN("%s", warning.c_str());
    return setup;
} catch (const ompl::Exception& refusal) {
    throw OmplRefusal(refusal);
}

const MotionValidator& motionValidatorOf(const ob::SpaceInformationPtr& si) {
    spaceOf(si);
    const auto* validator = dynamic_cast<const MotionValidator*>(si->getMotionValidator().get());
    if (validator != nullptr) return *validator;
    throw ArgumentError(
        "the space information's motion validator certifies nothing, expected a "
        "clearway::planning::MotionValidator to be set before");
}

std::vector<PartState> partStates(const og::PathGeometric& path) {
    const Space kind = kindOf(*path.getSpaceInformation()->getStateSpace());
    std::vector<PartState> states;
    for (std::size_t i = 0; i < path.getStateCount(); ++i) {
        states.push_back(fromOmpl(kind, path.getState(static_cast<unsigned int>(i))));
    }
    return states;
}

og::PathGeometric pathThrough(const ob::SpaceInformationPtr& si, const std::vector<PartState>& states) {
    const Space kind = kindOf(spaceOf(si));
    og::PathGeometric path(si);
    for (const PartState& state : states) path.append(toOmpl(si->getStateSpace(), kind, state).get());
    return path;
}

}  // namespace clearway::planning
