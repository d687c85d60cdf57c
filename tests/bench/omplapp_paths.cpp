// Judges OMPL.app's sample problems and paths, read from a user's checkout of OMPL.app: loads each problem as
// OMPL.app does and asks clearway and FCL about every state of every path. The oracle decides who is right.
//   bench_omplapp_paths CHECKOUT OUT.csv
#include <algorithm>
#include <exception>
#include <filesystem>
#include <iostream>
#include <limits>

#include "bench/peer.h"
#include "clearway/planning/motion_validator.h"
#include "core/number.h"
#include "core/replace_file.h"
#include "planning/validity/ompl_states.h"
#include "support/oracle.h"

namespace clearway::testing {
namespace {

namespace fs = std::filesystem;
namespace ob = ompl::base;

constexpr int kSkipped = 77;  ///< the exit code that CTest takes for a skipped test
/// A .path file has 6 digits, so a path along the bounds may be printed slightly outside of them.
constexpr double kPrinted = 1e-5;

struct Figures {
    int states = 0, colliding = 0, outOfBounds = 0;
    int fclColliding = 0, oracleColliding = 0;
    int clearwayWrong = 0, fclWrong = 0;  ///< the oracle decides which answers are wrong
    double least = std::numeric_limits<double>::infinity();
    int motions = 0, certified = 0;
    int collidingMotions = 0;  ///< motions with a pose that the oracle finds colliding
};

Box grown(const Box& box) {
    const Vector3 slack = Vector3::Constant(kPrinted * box.diagonal().norm());
    return Box(box.min() - slack, box.max() + slack);
}

void judgeState(const PartState& state, const Model& part, const Model& environment, const Peer& fcl,
                const MeshOracle& oracle, Figures& figures) {
    Workspace workspace;
    const Pose pose = poseOf(state);
    const DistanceResult d = distance(part, environment, pose, {}, workspace);
    const bool isColliding = collides(part, environment, pose, workspace);
    const bool truth = oracle.collides(pose), fclSays = fcl.collides(pose).value != 0;
    ++figures.states;
    figures.colliding += isColliding;
    figures.fclColliding += fclSays;
    figures.oracleColliding += truth;
    figures.clearwayWrong += isColliding != truth;
    figures.fclWrong += fclSays != truth;
    figures.least = std::min(figures.least, d.lower);
}

/// Judges the motions between the states; OMPL.app had checked them in steps.
void judgeMotions(const Problem& problem, const std::vector<PartState>& path, const Box& bounds,
                  const Scene& scene, const MeshOracle& oracle, Figures& figures) {
    const auto si = std::make_shared<ob::SpaceInformation>(
        planning::makeSpace(problem.space, grown(bounds), scene.part.radiusAboutOrigin()));
    si->setStateValidityChecker(
        [](const ob::State*) { return true; });  // unused: only the validator is asked
    const planning::MotionValidator validator(si, scene);
    for (std::size_t i = 0; i + 1 < path.size(); ++i) {
        const auto from = planning::toOmpl(si->getStateSpace(), problem.space, path[i]);
        const auto to = planning::toOmpl(si->getStateSpace(), problem.space, path[i + 1]);
        ++figures.motions;
        if (validator.checkMotion(from.get(), to.get())) {
            ++figures.certified;
            continue;
        }
        const planning::MotionReport report = validator.report(from.get(), to.get());
        ob::ScopedState<> closest(to);
        if (report.closestTime < 1) {
            si->getStateSpace()->interpolate(from.get(), to.get(), report.closestTime, closest.get());
        }
        figures.collidingMotions += oracle.collides(poseOf(planning::fromOmpl(problem.space, closest.get())));
    }
}

Figures judge(const Problem& problem, const std::vector<PartState>& path) {
    const Mesh partMesh = loadPart(problem), environmentMesh = loadEnvironment(problem);
    const Model part = Model::build(partMesh), environment = Model::build(environmentMesh);
    const MeshOracle oracle(partMesh, environmentMesh);
    const Peer fcl = makeFclObbRss(partMesh, environmentMesh);
    const Box bounds = boundsOf(problem, environment.box());
    Figures figures;
    for (const PartState& state : path) {
        judgeState(state, part, environment, fcl, oracle, figures);
        figures.outOfBounds += !grown(bounds).contains(state.position);
    }
    judgeMotions(problem, path, bounds, Scene{part, environment, 0}, oracle, figures);
    return figures;
}

std::string rowOf(const std::string& name, const Figures& figures) {
    std::string row = name;
    for (const int value : {figures.states, figures.colliding, figures.outOfBounds, figures.fclColliding,
                            figures.oracleColliding, figures.clearwayWrong, figures.fclWrong, figures.motions,
                            figures.certified, figures.collidingMotions}) {
        row += "," + std::to_string(value);
    }
    return row + "," + shortNumber(figures.least) + "\n";
}

std::vector<fs::path> pathsIn(const fs::path& folder) {
    std::vector<fs::path> paths;
    for (const auto& entry : fs::directory_iterator(folder)) {
        if (entry.path().extension() == ".path") paths.push_back(entry.path());
    }
    std::sort(paths.begin(), paths.end());
    return paths;
}

int run(int count, char** words) {
    if (count < 2 || std::string(words[1]).empty()) {
        std::cout << "skipped: no checkout of OMPL.app, configure with -DCLEARWAY_OMPLAPP=DIR\n";
        return kSkipped;
    }
    const fs::path resources = fs::path(words[1]) / "resources";
    std::string table =
        "path,states,colliding,out_of_bounds,fcl_colliding,oracle_colliding,clearway_wrong,fcl_wrong,motions,"
        "motions_certified,motions_colliding,least_distance\n";
    std::cout << table;
    int paths = 0, invalid = 0;
    for (const char* folder : {"3D", "2D"}) {
        for (const fs::path& file : pathsIn(resources / folder)) {
            const Problem problem = readProblem(fs::path(file).replace_extension(".cfg").string());
            if (!fs::exists(problem.robot) || !fs::exists(problem.world)) {
                std::cout << folder << "/" << file.stem().string()
                          << " left out: the checkout lacks its meshes\n";
                continue;
            }
            const Figures figures = judge(problem, readPath(file.string(), problem.space));
            const std::string row = rowOf(std::string(folder) + "/" + file.stem().string(), figures);
            std::cout << row << std::flush;
            table += row;
            ++paths;
            invalid += figures.colliding > 0 || figures.outOfBounds > 0 || figures.clearwayWrong > 0;
        }
    }
    std::cout << invalid << " of " << paths << " paths with a state that is not valid\n";
    if (count > 2) replaceFile(words[2], [&](std::ostream& out) { out << table; });
    return invalid == 0 && paths > 0 ? 0 : 1;
}

}  // namespace
}  // namespace clearway::testing

int main(int count, char** words) {
    try {
        return clearway::testing::run(count, words);
    } catch (const std::exception& error) {
        std::cerr << "bench_omplapp_paths: " << error.what() << "\n";
        return 2;
    }
}
