// demos/console.cpp PROBLEM.cfg OUT.path: plans a part's way out of an assembly with motions that are
// certified along their whole length, shortens the path without letting it come closer, writes it and prints
// its audit.
#include <clearway/planning/problem_setup.h>
#include <clearway/planning/simplify.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>

#include <cstdio>
#include <iostream>

namespace cp = clearway::planning;

void printAudit(const cp::PathAudit& audit) {
    const cp::SegmentAudit& tight = audit.segments[audit.closest];
    std::printf("  %zu segments, length %.0f, turned %.0f degrees; %s\n", audit.segments.size(), audit.length,
                audit.turned * 180 / M_PI, audit.isValid() ? "valid along the whole path" : "NOT valid");
    std::printf("  least clearance %.3f to %.3f, in segment %zu at t = %.3f, between '%s' and '%s'\n",
                audit.lowerClearance, audit.upperClearance, audit.closest + 1, tight.motion.closestTime,
                tight.partMesh.c_str(), tight.environmentMesh.c_str());
}

int main(int argc, char** argv) try {
    if (argc != 3) throw std::invalid_argument("expected two arguments, PROBLEM.cfg OUT.path");
    ompl::msg::setLogLevel(ompl::msg::LOG_WARN);
    ompl::RNG::setSeed(1);

    const clearway::Problem problem = clearway::readProblem(argv[1]);
    const clearway::Scene scene = clearway::loadScene(problem).scene;
    std::printf("part: %zu triangles\n", scene.part.report().triangles);
    for (const clearway::Obstacle& obstacle : scene.obstacles)  // one for each margin of the problem
        std::printf("environment: %zu triangles, margin %g\n", obstacle.model.report().triangles,
                    obstacle.margin);

    // OMPL's space, with our checker and motion validator, and the problem's start and goal.
    ompl::geometric::SimpleSetup setup = cp::makeSetup(problem, scene);
    setup.setPlanner(std::make_shared<ompl::geometric::RRTConnect>(setup.getSpaceInformation()));
    setup.getPlanner()->params().setParam("range", std::to_string(20 * problem.fineness.value_or(1)));
    const auto status = setup.solve(/*seconds*/ 30.0);
    const cp::MotionValidator& motions = cp::motionValidatorOf(setup.getSpaceInformation());
    const cp::MotionCounters counters = motions.counters();
    std::printf("%s after %.2f s: %lu motions asked about, %lu certified, %lu undecided\n",
                status == ompl::base::PlannerStatus::EXACT_SOLUTION ? "path found" : "no path",
                setup.getLastPlanComputationTime(), counters.valid + counters.invalid, counters.valid,
                counters.undecided);
    if (status != ompl::base::PlannerStatus::EXACT_SOLUTION) return 1;

    ompl::geometric::PathGeometric path = setup.getSolutionPath();
    std::printf("as planned:\n");
    printAudit(cp::audit(path, motions));
    cp::SimplifyOptions keep;
    keep.floor = 1;  // clearance that shortcuts keep, environment units
    const cp::PathAudit audit = cp::simplify(path, motions, keep);
    std::printf("shortened, by motions that keep %g or, where it had less, no less than that:\n", keep.floor);
    printAudit(audit);
    clearway::writePath(cp::partStates(path), problem.space, argv[2]);
    std::printf("written to %s\n", argv[2]);
    return audit.isValid() ? 0 : 1;
} catch (const std::exception& error) {
    std::cerr << "console: " << error.what() << "\n";
    return 2;
}
