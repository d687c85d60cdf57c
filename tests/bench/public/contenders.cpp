#include "bench/public/contenders.h"

#include <ompl/base/SpaceInformation.h>
#include <ompl/base/spaces/SE2StateSpace.h>
#include <ompl/base/spaces/SE3StateSpace.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/util/RandomNumbers.h>

#include <algorithm>

#include "bench/fcl_planning.h"
#include "clearway/planning/check_path.h"
#include "clearway/planning/plan.h"
#include "core/clock.h"
#include "core/number.h"
#include "planning/space/ompl_states.h"
#include "support/oracle.h"
#include "support/path_check.h"

namespace clearway::testing::public_problems {
namespace {

constexpr int kOraclePoses = 100;

struct Run {
    bool isFound = false, isValid = false;
    double seconds = 0, clearance = 0, length = 0, rotation = 0;
    std::uint64_t checks = 0;
    std::string foundBy, note;
    std::vector<PartState> path;
};

Run planWithClearway(const Problem& problem, const Scene& scene, const std::string& contender,
                     std::uint32_t seed, double seconds) {
    planning::PlanOptions options;
    options.seconds = seconds;
    options.seed = seed;
    if (contender != kOurs) {
        options.planner = contender;
        options.threads = 1;
        options.quick = true;
        // OMPL weighs turns and chooses the length of edges, as it does without clearway: with the weights and
        // lengths of `plan`, SBL, EST and KPIECE1 find no path where they otherwise find one within a second.
        options.omplWeights = true;
        if (contender != "PRM") options.parameters = {{"range", "0"}};
    }
    const planning::PlanReport report = plan(problem, scene, options);
    Run run;
    run.isFound = report.outcome == planning::PlanReport::Outcome::kFound;
    run.isValid = run.isFound && report.audit.isValid();
    run.seconds = report.planningSeconds;
    run.checks = report.checks;
    run.foundBy = report.foundBy;
    run.path = report.path;
    run.clearance = report.audit.lowerClearance;
    run.length = report.length;
    run.rotation = report.rotation;
    return run;
}

/// As OMPL.app sets RRTConnect up: its space with OMPL's weights, and motions checked in steps of OMPL's default
/// resolution.
Run planWithFcl(const Problem& problem, const Scene& scene, std::uint32_t seed, double seconds) {
    ompl::RNG::setSeed(seed);
    const Box bounds = boundsOf(problem, scene.environmentBox(), scene.part.box());
    const auto si = std::make_shared<ob::SpaceInformation>(planning::makeSpace(problem.space, bounds, 1));
    si->setStateValidityChecker(
        std::make_shared<FclValidityChecker>(si, makeFclMeshes(loadPart(problem), loadEnvironment(problem))));
    si->setup();
    const auto definition = std::make_shared<ob::ProblemDefinition>(si);
    definition->setStartAndGoalStates(planning::toOmpl(si->getStateSpace(), problem.space, problem.start),
                                      planning::toOmpl(si->getStateSpace(), problem.space, problem.goal));
    og::RRTConnect planner(si);
    planner.setProblemDefinition(definition);
    planner.setup();
    const auto begin = Clock::now();
    planner.solve(ob::timedPlannerTerminationCondition(seconds));
    Run run;
    run.seconds = secondsSince(begin);
    run.foundBy = "RRTConnect";
    run.isFound = definition->hasExactSolution();
    if (!run.isFound) return run;
    for (const ob::State* state : definition->getSolutionPath()->as<og::PathGeometric>()->getStates()) {
        run.path.push_back(planning::fromOmpl(problem.space, state));
    }
    const planning::PathAudit audit = planning::checkPath(problem, scene, run.path, {}).audit;
    run.isValid = audit.isValid();
    run.clearance = audit.lowerClearance;
    run.length = audit.length;
    run.rotation = audit.rotation;
    if (!run.isValid) {
        run.note = std::to_string(audit.notValid.size()) + " of " + std::to_string(audit.segments.size()) +
                   " segments are not valid";
    }
    return run;
}

std::string rowOf(const Run& run, int colliding) {
    std::string row = std::string(run.isFound ? "1," : "0,") + shortNumber(run.seconds) + "," + run.foundBy +
                      "," + (run.isValid ? "1" : "0");
    for (const double value : {run.clearance, run.length, run.rotation * 180 / M_PI}) {
        row += "," + (run.isFound ? shortNumber(value) : std::string());
    }
    return row + "," + std::to_string(run.checks) + "," + std::to_string(colliding) + "," + run.note;
}

}  // namespace

const std::vector<std::string>& contenders() {
    static const std::vector<std::string> all = {"RRTConnect", "KPIECE1", "EST", "STRIDE",
                                                 "SBL",        "PRM",     kFcl};
    return all;
}

std::string runContender(const std::string& file, const std::string& contender, std::uint32_t seed,
                         double seconds, const std::string& path) {
    Run run;
    int colliding = 0;
    try {
        const Problem problem = readProblem(file);
        const Scene scene = loadScene(problem).scene;
        run = contender == kFcl ? planWithFcl(problem, scene, seed, seconds)
                                : planWithClearway(problem, scene, contender, seed, seconds);
        if (run.isFound && problem.rules.overlap.common == 0) {
            const MeshOracle oracle(loadPart(problem), loadEnvironment(problem));
            colliding = collisionsAlong(oracle, run.path, problem, kOraclePoses);
        }
        if (run.isValid) writePath(run.path, problem.space, path);
    } catch (const std::exception& error) {
        run.note = error.what();
    }
    std::replace(run.note.begin(), run.note.end(), ',', ';');
    std::replace(run.foundBy.begin(), run.foundBy.end(), ',', ';');
    return rowOf(run, colliding);
}

}  // namespace clearway::testing::public_problems
