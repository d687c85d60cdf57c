// Work that begins with a problem's files and ends with an answer, as a user's process does it. The part from_files of `run` times
// whole processes, so each call does the work once.
//   benchmarks from_files plan PROBLEM.cfg STEP SEED LIMIT OUT.path    OMPL's RRTConnect with FCL at states a step apart
//   benchmarks from_files ask LIBRARY PROBLEM.cfg                      a library's first answer, at the problem's start
//   benchmarks from_files libraries                                    the names of the libraries that this build knows
#include <ompl/base/DiscreteMotionValidator.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/util/Console.h>
#include <ompl/util/RandomNumbers.h>

#include <algorithm>
#include <iostream>
#include <stdexcept>

#include "bench/fcl_planning.h"
#include "bench/peer.h"
#include "clearway/model.h"
#include "clearway/planning/problem_setup.h"
#include "clearway/query.h"
#include "core/clock.h"
#include "core/number.h"
#include "mesh/read/assimp.h"
#include "planning/space/ompl_states.h"

namespace clearway::testing::from_files {

constexpr double kRangePerFineness = 20, kRangePerDiagonal = 0.25;  // as in `clearway plan`
constexpr const char* kClearway = "clearway";

/// The meshes as users of the other libraries read them, with the coordinates that the problem asks for.
SceneMeshes readByAssimpAlone(const Problem& problem) {
    return loadMeshes(problem, [](const std::string& file, const LoadOptions& options) {
        if (options.scale != 1)
            throw std::runtime_error(file + " is scaled, expected a problem without scales");
        return readByAssimp(file, options.reading).mesh;
    });
}

double radiusAboutOrigin(const Mesh& mesh) {
    double most = 0;
    for (const Vector3& vertex : mesh.vertices) most = std::max(most, vertex.norm());
    return most;
}

/// Plans as the documentation of OMPL and FCL says, with motions checked at states a step apart. Prints whether a path was found.
int plan(const Problem& problem, double step, std::uint32_t seed, double limit, const std::string& file) {
    ompl::msg::noOutputHandler();
    ompl::RNG::setSeed(seed);
    const SceneMeshes meshes = readByAssimpAlone(problem);
    const Mesh environment = joinedEnvironment(meshes.worlds);
    const Box partBox = boundingBox(meshes.part);
    const ob::StateSpacePtr space = planning::makeSpace(
        problem.space, boundsOf(problem, boundingBox(environment), partBox), radiusAboutOrigin(meshes.part));
    const auto si = std::make_shared<ob::SpaceInformation>(space);
    si->setStateValidityChecker(
        std::make_shared<FclValidityChecker>(si, makeFclMeshes(meshes.part, environment)));
    space->setLongestValidSegmentFraction(step / space->getMaximumExtent());
    si->setMotionValidator(std::make_shared<ob::DiscreteMotionValidator>(si));
    si->setup();
    const auto definition = std::make_shared<ob::ProblemDefinition>(si);
    definition->setStartAndGoalStates(planning::toOmpl(space, problem.space, problem.start),
                                      planning::toOmpl(space, problem.space, problem.goal));
    og::RRTConnect planner(si);
    planner.setRange(problem.fineness ? kRangePerFineness * *problem.fineness
                                      : kRangePerDiagonal * partBox.diagonal().norm());
    planner.setProblemDefinition(definition);
    planner.setup();
    const Clock::time_point begin = Clock::now();
    planner.solve(ob::PlannerTerminationCondition([&] { return secondsSince(begin) >= limit; }));
    if (definition->hasExactSolution()) {
        const auto& path = *definition->getSolutionPath()->as<og::PathGeometric>();
        writePath(planning::partStates(path), problem.space, file);
    }
    std::cout << (definition->hasExactSolution() ? "found" : "none") << '\n';
    return 0;
}

std::vector<NamedPeer> libraries() {
    std::vector<NamedPeer> all = distancePeers();
#ifdef CLEARWAY_BENCH_WITH_BULLET
    all.push_back({"Bullet", makeBullet});
#endif
    return all;
}

/// Prints the distance, or 0 or 1 for a library that only knows whether the meshes collide.
int ask(const std::string& library, const Problem& problem) {
    const Pose X_environmentPart = poseOf(problem.start);
    if (library == kClearway) {
        const SceneMeshes meshes = loadMeshes(problem);
        const Model part = Model::build(meshes.part);
        const Model environment = Model::build(joinedEnvironment(meshes.worlds));
        Workspace workspace;
        std::cout << formatNumber(distance(part, environment, X_environmentPart, {}, workspace).lower)
                  << '\n';
        return 0;
    }
    const std::vector<NamedPeer> all = libraries();
    const auto found =
        std::find_if(all.begin(), all.end(), [&](const NamedPeer& peer) { return peer.name == library; });
    if (found == all.end()) throw std::runtime_error("this build knows no library '" + library + "'");
    const SceneMeshes meshes = readByAssimpAlone(problem);
    const Peer peer = found->make(meshes.part, joinedEnvironment(meshes.worlds));
    const Answer answer = (peer.distance ? peer.distance : peer.collides)(X_environmentPart);
    std::cout << formatNumber(answer.value) << '\n';
    return 0;
}

int tellUsage() {
    std::cerr << "usage: benchmarks from_files plan PROBLEM.cfg STEP SEED LIMIT OUT.path\n"
                 "       benchmarks from_files ask LIBRARY PROBLEM.cfg\n"
                 "       benchmarks from_files libraries\n";
    return 2;
}

int run(int count, char** words) {
    const std::string what = count > 1 ? words[1] : "";
    if (what == "libraries" && count == 2) {
        std::cout << kClearway << '\n';
        for (const NamedPeer& peer : libraries()) std::cout << peer.name << '\n';
        return 0;
    }
    if (what == "ask" && count == 4) return ask(words[2], readProblem(words[3]));
    if (what != "plan" || count != 7) return tellUsage();
    return plan(readProblem(words[2]), parseNumber(words[3]).value(),
                static_cast<std::uint32_t>(parseInteger(words[4]).value()), parseNumber(words[5]).value(),
                words[6]);
}

}  // namespace clearway::testing::from_files
