// demos/clearance_optimal.cpp PROBLEM.cfg OUT.path: plans for the path that stays farthest from everything.
// An optimising planner of OMPL improves the path, whose least clearance is certified at any time.
#include <clearway/planning/clearance_objectives.h>
#include <clearway/planning/problem_setup.h>
#include <clearway/planning/simplify.h>
#include <ompl/base/terminationconditions/IterationTerminationCondition.h>
#include <ompl/geometric/planners/rrt/RRTstar.h>

#include <cstdio>
#include <iostream>

namespace cp = clearway::planning;

int main(int argc, char** argv) try {
    if (argc != 3) throw std::invalid_argument("expected two arguments, PROBLEM.cfg OUT.path");
    ompl::msg::setLogLevel(ompl::msg::LOG_WARN);
    ompl::RNG::setSeed(1);
    const clearway::Problem problem = clearway::readProblem(argv[1]);
    const clearway::Scene scene = clearway::loadScene(problem).scene;
    ompl::geometric::SimpleSetup setup = cp::makeSetup(problem, scene);
    const auto& si = setup.getSpaceInformation();

    const auto objective = std::make_shared<cp::MinClearanceObjective>(si, cp::sceneOf(si));
    setup.setOptimizationObjective(objective);
    setup.setPlanner(std::make_shared<ompl::geometric::RRTstar>(si));

    std::printf("iterations  seconds  least clearance, certified   length\n");
    double seconds = 0;
    for (unsigned int total = 0; total < 700; total += 100) {
        ompl::base::IterationTerminationCondition hundred(100);
        setup.solve(hundred);  // continues where it stopped
        seconds += setup.getLastPlanComputationTime();
        std::printf("%10u  %7.2f  ", total + 100, seconds);
        if (setup.haveExactSolutionPath()) {
            const ompl::geometric::PathGeometric& path = setup.getSolutionPath();
            std::printf("%26.3f  %7.0f\n", path.cost(objective).value(), path.length());
        } else {
            std::printf("%26s\n", "no path yet");
        }
        std::fflush(stdout);
    }
    if (!setup.haveExactSolutionPath()) return 1;

    ompl::geometric::PathGeometric path = setup.getSolutionPath();
    cp::SimplifyOptions keep;
    keep.floor = path.cost(objective).value();  // so that shortcuts keep it
    const cp::PathAudit audit = cp::simplify(path, cp::motionValidatorOf(si), keep);
    std::printf("shortened by motions that keep it, to a length of %.0f\n", path.length());
    const cp::SegmentAudit& tight = audit.segments[audit.closest];
    std::printf("audit: %s, least clearance %.3f to %.3f",
                audit.isValid() ? "valid along the whole path" : "NOT valid", audit.lowerClearance,
                audit.upperClearance);
    if (const auto& witness = tight.motion.closest.witness) {
        const clearway::Vector3& at = witness->pointOnEnvironment;
        std::printf(", between '%s' and '%s' at (%.1f, %.1f, %.1f)", tight.partMesh.c_str(),
                    tight.environmentMesh.c_str(), at.x(), at.y(), at.z());
    }
    std::printf("\n");
    clearway::writePath(cp::partStates(path), problem.space, argv[2]);
    std::printf("written to %s\n", argv[2]);
    return audit.isValid() ? 0 : 1;
} catch (const std::exception& error) {
    std::cerr << "clearance_optimal: " << error.what() << "\n";
    return 2;
}
