#include "program/cli/overlaps.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "mesh/components.h"
#include "model/solids.h"
#include "program/options/print.h"
#include "program/report/frames.h"
#include "program/report/path_line.h"

namespace clearway::cli {
namespace {

constexpr std::size_t kPoses = 41;  ///< along a path
constexpr std::size_t kMostRows = 5;
constexpr double kRounding = 1e-9;        ///< of an overlap
constexpr double kShareOfInterest = 0.1;  ///< of the allowed overlap: depths that differ by less are alike

struct PosedAt {
    double share;
    Pose X_environmentPart;
};

struct Piece {
    Mesh mesh;           ///< one component of an obstacle
    double allowed = 0;  ///< FoundOverlap::allowed
};

void addComponents(const Mesh& mesh, double allowed, std::vector<Piece>& to) {
    const std::size_t count = componentsOf(mesh).size();
    for (std::size_t i = 0; i < count; ++i) {
        Mesh component = meshOfComponents(mesh, {i});
        if (!component.triangles.empty()) to.push_back({std::move(component), allowed});
    }
}

/// Finds, for each piece that reaches into the part, the pose and the point where it is deepest; the deepest piece
/// first. Depths below leastDepth (environment units) may be missed.
std::vector<FoundOverlap> findOverlaps(const Mesh& part, const OverlapMeter& meter,
                                       const std::vector<Piece>& pieces, const std::vector<PosedAt>& poses,
                                       double leastDepth) {
    const Model model = Model::build(part);
    const Solids inPart(part);
    std::vector<FoundOverlap> all;
    Workspace workspace;
    for (const Piece& piece : pieces) {
        const Model tree = Model::build(piece.mesh);
        const Solids inPiece(piece.mesh);
        FoundOverlap found;
        found.obstacle = componentsOf(piece.mesh)[0].name;
        found.allowed = piece.allowed;
        for (const PosedAt& pose : poses) {
            if (!collides(model, tree, pose.X_environmentPart, workspace) &&
                !inPart.holding(pose.X_environmentPart, inPiece, {}))
                continue;
            const DeepestPoint deepest = meter.deepest(piece.mesh, pose.X_environmentPart, leastDepth);
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

std::vector<FoundOverlap> overlapsAlong(const Problem& problem, const SceneMeshes& meshes, const Scene& scene,
                                        const std::vector<PartState>& path) {
    double least = std::numeric_limits<double>::infinity();
    for (const Obstacle& obstacle : scene.obstacles) {
        if (obstacle.shrunk) least = std::min(least, obstacle.shrunk->overlap);
    }
    if (std::isinf(least)) return {};
    const report::PathLine line(path, scene.part.radiusAboutOrigin());
    std::vector<PosedAt> poses;
    for (const double share : report::evenShares(kPoses)) poses.push_back({share, poseOf(line.at(share))});
    const ObstacleGroups obstacles = obstaclesOf(problem, meshes.worlds);
    std::vector<Piece> pieces;
    for (const ObstacleGroup& group : obstacles.groups) {
        if (group.overlap > 0) addComponents(group.mesh, group.overlap, pieces);
    }
    return findOverlaps(meshes.part, OverlapMeter(meshes.part), pieces, poses, kShareOfInterest * least);
}

std::vector<FoundOverlap> overlapsAtStart(const Problem& problem, const SceneMeshes& meshes) {
    Problem allowingNone = problem;
    allowingNone.rules.overlap = {};
    std::vector<Piece> pieces;
    for (const ObstacleGroup& group : obstaclesOf(allowingNone, meshes.worlds).groups)
        addComponents(group.mesh, 0, pieces);
    return findOverlaps(meshes.part, OverlapMeter(meshes.part), pieces, {{0, poseOf(problem.start)}}, 0);
}

void requireAllowed(const std::vector<FoundOverlap>& overlaps) {
    for (const FoundOverlap& found : overlaps) {
        if (found.deepest.lower <= found.allowed * (1 + kRounding)) continue;
        throw std::logic_error(fmt::format(
            "the path is certified, but is not valid: at {} of it an obstacle reaches {}, expected at "
            "most {}; please report this contradiction",
            readable(found.share), describe(found), shownLength(found.allowed)));
    }
}

void printOverlaps(const std::vector<FoundOverlap>& overlaps) {
    for (std::size_t i = 0; i < overlaps.size() && i < kMostRows; ++i) {
        printRow(i == 0 ? "overlap" : "",
                 describe(overlaps[i]) + ", at " + readable(overlaps[i].share) + " of the path");
    }
    if (overlaps.size() > kMostRows)
        printRow("overlap", fmt::format("less in {} more obstacles", overlaps.size() - kMostRows));
}

std::string depthText(double depth) {
    return fmt::format("{:.3g}", depth);
}

std::string describe(const FoundOverlap& found) {
    return fmt::format("{} deep, at {}, triangle {} of '{}'", inUnit(depthText(found.deepest.lower)),
                       shownPlace(found.deepest.point), found.deepest.obstacleTriangle, found.obstacle);
}

Json toJson(const std::vector<FoundOverlap>& overlaps) {
    Json json = Json::array();
    for (const FoundOverlap& found : overlaps) {
        json.push_back(
            {{"obstacle", found.obstacle},
             {"depth", {{"lower", toJson(found.deepest.lower)}, {"upper", toJson(found.deepest.upper)}}},
             {"point", toJson(found.deepest.point)},
             {"triangle", found.deepest.obstacleTriangle},
             {"share_of_path", toJson(found.share)}});
    }
    return json;
}

}  // namespace clearway::cli
