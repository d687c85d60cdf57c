#include "planning/finish.h"

#include "clearway/planning/simplify.h"
#include "planning/shorten.h"

namespace clearway::planning {
namespace {

namespace ob = ompl::base;
namespace og = ompl::geometric;

bool passesSteps(const Setup& setup, const og::PathGeometric& path) {
    for (unsigned int i = 1; i < path.getStateCount(); ++i) {
        if (!setup.discrete->checkMotion(path.getState(i - 1), path.getState(i))) return false;
    }
    return true;
}

PathAudit shortenBySteps(const Setup& setup, og::PathGeometric& path, const std::function<bool()>& isSpent) {
    og::PathGeometric shorter = path;
    shorten(shorter, isSpent);
    PathAudit found = audit(shorter, *setup.auditor);
    if (!found.isValid()) {
        PathAudit own = audit(path, *setup.auditor);
        if (own.isValid() || !passesSteps(setup, shorter)) return own;
    }
    path = shorter;
    return found;
}

}  // namespace

og::PathGeometric solutionOf(const Setup& setup) {
    og::PathGeometric path(setup.si);
    for (const ob::State* state : setup.definition->getSolutionPath()->as<og::PathGeometric>()->getStates()) {
        path.append(state);
    }
    return path;
}

PathAudit finish(const Setup& setup, og::PathGeometric& path, const std::function<bool()>& isSpent) {
    if (setup.discrete) return shortenBySteps(setup, path, isSpent);
    return simplify(path, *setup.auditor, {setup.floor, isSpent});
}

}  // namespace clearway::planning
