#include "program/cli/overlaps.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "mesh/components.h"
#include "program/cli/load_guard.h"
#include "program/cli/print.h"
#include "program/report/frames.h"
#include "program/report/path_line.h"

namespace clearway::cli {
namespace {

constexpr std::size_t kPoses = 41;  ///< along a path
constexpr std::size_t kMostRows = 5;
constexpr double kShareOfInterest = 0.1;  ///< of the allowed overlap: depths that differ by less are alike

struct PosedAt {
    double share;
    Pose X_environmentPart;
};

template <class Wanted>
std::vector<Mesh> componentsIn(const ObstacleGroups& obstacles, const Wanted& isWanted) {
    std::vector<Mesh> meshes;
    for (const ObstacleGroup& group : obstacles.groups) {
        if (!isWanted(group)) continue;
        const std::size_t count = componentsOf(group.mesh).size();
        for (std::size_t i = 0; i < count; ++i) {
            Mesh component = meshOfComponents(group.mesh, {i});
            if (!component.triangles.empty()) meshes.push_back(std::move(component));
        }
    }
    return meshes;
}

/// For each obstacle, a mesh of one component, where it reaches deepest into the part.
std::vector<FoundOverlap> findOverlaps(const Mesh& part, const std::vector<Mesh>& obstacles,
                                       const std::vector<PosedAt>& poses, double leastDepth) {
    const OverlapMeter meter(part);
    const Model model = Model::build(part);
    std::vector<FoundOverlap> all;
    Workspace workspace;
    for (const Mesh& obstacle : obstacles) {
        const Model tree = Model::build(obstacle);
        FoundOverlap found;
        found.obstacle = componentsOf(obstacle)[0].name;
        for (const PosedAt& pose : poses) {
            if (!collides(model, tree, pose.X_environmentPart, workspace)) continue;
            const DeepestPoint deepest = meter.deepest(obstacle, pose.X_environmentPart, leastDepth);
            if (deepest.lower <= found.deepest.lower) continue;
            found.deepest = deepest;
            found.share = pose.share;
        }
        if (found.deepest.obstacleTriangle >= 0) all.push_back(found);
    }
    std::sort(all.begin(), all.end(),
              [](const FoundOverlap& a, const FoundOverlap& b) { return a.deepest.lower > b.deepest.lower; });
    return all;
}

}  // namespace

std::vector<FoundOverlap> overlapsAlong(const Problem& problem, const Scene& scene,
                                        const std::vector<PartState>& path) {
    double least = std::numeric_limits<double>::infinity();
    for (const Obstacle& obstacle : scene.obstacles) {
        if (obstacle.shrunk) least = std::min(least, obstacle.shrunk->overlap);
    }
    if (std::isinf(least)) return {};
    const report::PathLine line(path, scene.part.radiusAboutOrigin());
    std::vector<PosedAt> poses;
    for (const double share : report::evenShares(kPoses)) poses.push_back({share, poseOf(line.at(share))});
    const ObstacleGroups obstacles = obstaclesOf(problem, loadWorlds(problem, guardedLoadMesh));
    return findOverlaps(loadPart(problem, guardedLoadMesh),
                        componentsIn(obstacles, [](const ObstacleGroup& group) { return group.overlap > 0; }),
                        poses, kShareOfInterest * least);
}

std::vector<FoundOverlap> overlapsAtStart(const Problem& problem) {
    Problem allowingNone = problem;
    allowingNone.rules.overlap = {};
    const ObstacleGroups obstacles = obstaclesOf(allowingNone, loadWorlds(problem, guardedLoadMesh));
    return findOverlaps(loadPart(problem, guardedLoadMesh),
                        componentsIn(obstacles, [](const ObstacleGroup&) { return true; }),
                        {{0, poseOf(problem.start)}}, 0);
}

void printOverlaps(const std::vector<FoundOverlap>& overlaps) {
    for (std::size_t i = 0; i < overlaps.size() && i < kMostRows; ++i) {
        printRow(i == 0 ? "overlap" : "",
                 describe(overlaps[i]) + ", at " + readable(overlaps[i].share) + " of the path");
    }
    if (overlaps.size() > kMostRows)
        printRow("overlap", "less in " + std::to_string(overlaps.size() - kMostRows) + " more obstacles");
}

std::string depthText(double depth) {
    char text[32];
    std::snprintf(text, sizeof text, "%.3g", depth);
    return text;
}

std::string describe(const FoundOverlap& found) {
    return depthText(found.deepest.lower) + " deep, at " + readable(found.deepest.point) + ", triangle " +
           std::to_string(found.deepest.obstacleTriangle) + " of '" + found.obstacle + "'";
}

}  // namespace clearway::cli
