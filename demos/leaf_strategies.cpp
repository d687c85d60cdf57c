// demos/leaf_strategies.cpp PROBLEM.cfg: compares how fast trees with different leaf splits answer a
// planner's queries. The states of one run of RRTConnect are asked again of trees built with each leaf split,
// so that all of them answer equal questions.
#include <clearway/planning/discrete_motion_validator.h>
#include <clearway/planning/problem_setup.h>
#include <clearway/planning/validity_checker.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>

#include <chrono>
#include <cstdio>
#include <functional>
#include <iostream>

namespace cp = clearway::planning;

/// The poses of the first states that a planner asks about.
std::vector<clearway::Pose> recordRun(const clearway::Problem& problem, const clearway::Scene& scene,
                                      std::size_t most) {
    std::vector<clearway::Pose> poses;
    ompl::geometric::SimpleSetup setup = cp::makeSetup(problem, scene);
    const auto si = setup.getSpaceInformation();
    const double step = problem.fineness.value_or(1);
    si->setMotionValidator(
        std::make_shared<cp::DiscreteMotionValidator>(si, scene.part, step));  // asks for states
    const auto checker = std::make_shared<cp::ValidityChecker>(si, scene);
    setup.setStateValidityChecker([&](const ompl::base::State* state) {
        if (poses.size() < most) poses.push_back(checker->pose(state));
        return checker->isValid(state);
    });
    setup.setPlanner(std::make_shared<ompl::geometric::RRTConnect>(si));
    setup.getPlanner()->params().setParam("range", std::to_string(20 * step));
    setup.solve(ompl::base::PlannerTerminationCondition([&] { return poses.size() >= most; }));
    return poses;
}

struct Replay {
    double microseconds = 0;  ///< per query, the least of three rounds
    clearway::QueryCounters work;
    std::size_t near = 0;  ///< poses that collide
};

/// Calls the query, which returns true when the part collides, for all poses in the planner's order, each
/// with the warm start of the last.
Replay replay(const std::vector<clearway::Pose>& poses,
              const std::function<bool(const clearway::Pose&, clearway::Workspace&)>& query) {
    Replay best;
    for (int round = 0; round < 3; ++round) {
        Replay now;
        clearway::Workspace workspace;
        const auto begin = std::chrono::steady_clock::now();
        for (const clearway::Pose& X : poses) {
            now.near += query(X, workspace);
            now.work += workspace.counters();
        }
        const std::chrono::duration<double, std::micro> took = std::chrono::steady_clock::now() - begin;
        now.microseconds = took.count() / poses.size();
        if (round == 0 || now.microseconds < best.microseconds) best = now;
    }
    return best;
}

int main(int argc, char** argv) try {
    if (argc != 2) throw std::invalid_argument("expected one argument, PROBLEM.cfg");
    ompl::msg::setLogLevel(ompl::msg::LOG_ERROR);
    ompl::RNG::setSeed(1);
    const clearway::Problem problem = clearway::readProblem(argv[1]);
    const std::vector<clearway::Pose> poses = recordRun(problem, clearway::loadScene(problem).scene, 4000);
    std::printf("%zu states of one run of RRTConnect, asked again of trees with each leaf split\n\n",
                poses.size());
    std::printf(
        "leaf   build          collides: tests of           distance: tests of\n"
        "split     ms  leaves        us  volumes triangles        us  volumes triangles  colliding\n");
    for (const std::string& name : clearway::leafSplitNames()) {
        clearway::BuildOptions options;
        options.leafSplit = name;
        const clearway::Scene scene = clearway::loadScene(problem, options).scene;
        if (scene.obstacles.size() != 1)
            throw std::invalid_argument(
                "the problem's obstacles do not all count alike, expected one margin");
        const clearway::Model &part = scene.part, &environment = scene.obstacles.at(0).model;
        const Replay c =
            replay(poses, [&](const auto& X, auto& w) { return collides(part, environment, X, w); });
        const Replay d = replay(
            poses, [&](const auto& X, auto& w) { return distance(part, environment, X, {}, w).collides(); });
        const double n = poses.size();
        std::printf("%-6s %5.0f %7zu   %7.2f %8.1f %9.1f   %7.2f %8.1f %9.1f  %9zu\n", name.c_str(),
                    1e3 * (part.report().seconds + environment.report().seconds),
                    part.report().tree.leaves + environment.report().tree.leaves, c.microseconds,
                    c.work.volumeTests / n, c.work.triangleTests / n, d.microseconds, d.work.volumeTests / n,
                    d.work.triangleTests / n, d.near);
        if (c.near != d.near) return 1;
    }
    return 0;
} catch (const std::exception& error) {
    std::cerr << "leaf_strategies: " << error.what() << "\n";
    return 2;
}
