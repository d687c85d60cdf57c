// demos/replan.cpp PROBLEM.cfg OUT_FOLDER: replans when an obstacle appears on a path. Only the new
// obstacle's model is built. The old path is audited among all obstacles, and a new path is planned.
#include <clearway/planning/problem_setup.h>
#include <clearway/planning/simplify.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>

#include <cstdio>
#include <iostream>

namespace cp = clearway::planning;
using clearway::Vector3;
using ompl::geometric::PathGeometric;

/// A planned and shortened path; it has no states when none was found.
PathGeometric plan(ompl::geometric::SimpleSetup setup, const clearway::Problem& problem) {
    const auto& si = setup.getSpaceInformation();
    setup.setPlanner(std::make_shared<ompl::geometric::RRTConnect>(si));
    setup.getPlanner()->params().setParam("range", std::to_string(20 * problem.fineness.value_or(1)));
    if (setup.solve(/*seconds*/ 5.0) != ompl::base::PlannerStatus::EXACT_SOLUTION) {
        std::printf("no path found\n");
        return PathGeometric(si);
    }
    PathGeometric path = setup.getSolutionPath();
    cp::SimplifyOptions keep;
    keep.floor = 1;  // clearance that shortcuts keep, environment units
    const cp::PathAudit audit = cp::simplify(path, cp::motionValidatorOf(si), keep);
    std::printf("planned in %.2f s: %zu segments, length %.0f, certified least clearance %.2f\n",
                setup.getLastPlanComputationTime(), audit.segments.size(), audit.length,
                audit.lowerClearance);
    return path;
}

/// A box with the given half sides, where the path comes closest to the other obstacles. It stays out of the part's range at both ends.
clearway::Mesh boxInTheWayOf(PathGeometric path, const cp::MotionValidator& motions, const Vector3& half,
                             const clearway::Model& part) {
    path.interpolate(100);
    const cp::PathAudit audit = cp::audit(path, motions);
    const double range = part.radiusAboutOrigin() + half.norm();
    const Vector3 start = cp::partStates(path).front().position, goal = cp::partStates(path).back().position;
    const cp::SegmentAudit* closest = nullptr;
    for (const cp::SegmentAudit& segment : audit.segments) {
        const Vector3& place = segment.X_environmentPart.translation;
        if ((place - start).norm() <= range || (place - goal).norm() <= range) continue;
        if (!closest || segment.motion.upperClearance < closest->motion.upperClearance) closest = &segment;
    }
    if (!closest) throw std::runtime_error("the box is in the way at the start or goal wherever it stands");
    const Vector3 place = closest->X_environmentPart.translation;
    return clearway::boxMesh({place - half, place + half}, "forgotten box");
}

int main(int argc, char** argv) try {
    if (argc != 3) throw std::invalid_argument("expected two arguments, PROBLEM.cfg OUT_FOLDER");
    ompl::msg::setLogLevel(ompl::msg::LOG_WARN);
    ompl::RNG::setSeed(1);
    clearway::Problem problem = clearway::readProblem(argv[1]);
    clearway::Scene scene = clearway::loadScene(problem).scene;
    for (const clearway::Obstacle& obstacle : scene.obstacles) {  // one for each margin of the problem
        const clearway::BuildReport& report = obstacle.model.report();
        std::printf("environment: %zu triangles, built in %.2f ms\n", report.triangles, 1e3 * report.seconds);
    }
    const ompl::geometric::SimpleSetup before = cp::makeSetup(problem, scene);
    const PathGeometric old = plan(before, problem);
    if (old.getStateCount() == 0) return 1;

    const double margin = 0.5;
    const clearway::Mesh box =
        boxInTheWayOf(old, cp::motionValidatorOf(before.getSpaceInformation()), {3, 3, 3}, scene.part);
    scene.obstacles.push_back(
        {clearway::Model::build(box), margin});  // the other models are shared, not built again
    std::printf("a box appears: %zu triangles, margin %g, built in %.2f ms\n", box.triangles.size(), margin,
                1e3 * scene.obstacles.back().model.report().seconds);

    const ompl::geometric::SimpleSetup after = cp::makeSetup(problem, scene);
    const auto& si = after.getSpaceInformation();
    const cp::PathAudit audit =
        cp::audit(cp::pathThrough(si, cp::partStates(old)), cp::motionValidatorOf(si));
    for (const std::size_t i : audit.notValid) {
        std::printf("the old path's segment %zu is valid up to t = %.4f, then %s\n", i + 1,
                    audit.segments[i].motion.certifiedTime,
                    audit.segments[i].motion.whyInvalid.words().c_str());
    }
    const PathGeometric path = plan(after, problem);
    if (path.getStateCount() == 0) return 1;

    const std::string folder = std::string(argv[2]) + "/";  // for `clearway check` and `clearway render`
    clearway::saveMesh(box, folder + "box.obj");
    problem.meshes.furtherWorlds.push_back(folder + "box.obj");
    problem.rules.margins["box"] = margin;
    clearway::writeProblem(problem, folder + "with_box.cfg");
    clearway::writePath(cp::partStates(old), problem.space, folder + "old.path");
    clearway::writePath(cp::partStates(path), problem.space, folder + "new.path");
    std::printf("written to %s: with_box.cfg, old.path and new.path\n", argv[2]);
    return 0;
} catch (const std::exception& error) {
    std::cerr << "replan: " << error.what() << "\n";
    return 2;
}
