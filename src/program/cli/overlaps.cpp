#include "program/cli/overlaps.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>

#include "clearway/errors.h"
#include "mesh/components.h"
#include "model/solids.h"
#include "problem/path_line.h"
#include "problem/start_remedies.h"
#include "program/options/print.h"

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

/// Measures each component of an obstacle, which may reach into the part or, if the part is open, the part into it.
class Measuring {
  public:
    explicit Measuring(const Mesh& part)
        : part_(part), model_(Model::build(part)), inPart_(part), isPartOpen_(!inPart_.refusals().empty()) {
        if (!isPartOpen_) inPartMeter_.emplace(part);
    }

    /// Depths below leastDepth (environment units) may be missed. allowed: FoundOverlap::allowed.
    std::optional<FoundOverlap> deepest(const Mesh& component, double allowed,
                                        const std::vector<PosedAt>& poses, double leastDepth) {
        const Model tree = Model::build(component);
        const Solids inComponent(component);
        std::optional<OverlapMeter> inComponentMeter;
        FoundOverlap found;
        for (const PosedAt& at : poses) {
            const Pose& pose = at.X_environmentPart;
            const bool holds = isPartOpen_ ? inComponent.holding({}, inPart_, pose).has_value()
                                           : inPart_.holding(pose, inComponent, {}).has_value();
            if (!holds && !collides(model_, tree, pose, workspace_)) continue;
            if (isPartOpen_ && !inComponentMeter) inComponentMeter.emplace(meterOf(component));
            DeepestPoint deepest = isPartOpen_ ? inComponentMeter->deepest(part_, inverse(pose), leastDepth)
                                               : inPartMeter_->deepest(component, pose, leastDepth);
            if (deepest.lower <= found.deepest.lower) continue;
            if (isPartOpen_) deepest.point = pose * deepest.point;
            found.deepest = deepest;
            found.share = at.share;
        }
        if (found.deepest.obstacleTriangle < 0) return std::nullopt;
        found.allowed = allowed;
        found.isPartInside = isPartOpen_;
        found.obstacle = componentsOf(component)[0].name;
        return found;
    }

    /// The deepest first.
    std::vector<FoundOverlap> all(const ObstacleGroups& obstacles, bool ofAllowed,
                                  const std::vector<PosedAt>& poses, double leastDepth) {
        std::vector<FoundOverlap> all;
        for (const ObstacleGroup& group : obstacles.groups) {
            if (ofAllowed && group.overlap == 0) continue;
            const std::size_t count = componentsOf(group.mesh).size();
            for (std::size_t i = 0; i < count; ++i) {
                const Mesh component = meshOfComponents(group.mesh, {i});
                if (component.triangles.empty()) continue;
                if (const auto found = deepest(component, group.overlap, poses, leastDepth))
                    all.push_back(*found);
            }
        }
        std::sort(all.begin(), all.end(), [](const FoundOverlap& a, const FoundOverlap& b) {
            return a.deepest.lower > b.deepest.lower;
        });
        return all;
    }

  private:
    OverlapMeter meterOf(const Mesh& obstacles) const {
        try {
            return OverlapMeter(obstacles);
        } catch (const std::invalid_argument& error) {
            throw ArgumentError(error.what() + openPartAdvice(inPart_.refusals()[0]));
        }
    }

    const Mesh& part_;
    const Model model_;
    const Solids inPart_;
    const bool isPartOpen_;
    std::optional<OverlapMeter> inPartMeter_;
    Workspace workspace_;
};

}  // namespace

std::vector<FoundOverlap> overlapsAlong(const Problem& problem, const SceneMeshes& meshes, const Scene& scene,
                                        const std::vector<PartState>& path) {
    double least = std::numeric_limits<double>::infinity();
    for (const Obstacle& obstacle : scene.obstacles) {
        if (obstacle.overlap() > 0) least = std::min(least, obstacle.overlap());
    }
    if (std::isinf(least)) return {};
    const PathLine line(path, scene.part.radiusAboutOrigin());
    std::vector<PosedAt> poses;
    for (const double share : evenShares(kPoses)) poses.push_back({share, poseOf(line.at(share))});
    return Measuring(meshes.part)
        .all(obstaclesOf(problem, meshes.worlds), true, poses, kShareOfInterest * least);
}

std::vector<FoundOverlap> overlapsAtStart(const Problem& problem, const SceneMeshes& meshes) {
    Problem allowingNone = problem;
    allowingNone.rules.overlap = {};
    return Measuring(meshes.part)
        .all(obstaclesOf(allowingNone, meshes.worlds), false, {{0, poseOf(problem.start)}}, 0);
}

void requireAllowed(const std::vector<FoundOverlap>& overlaps) {
    for (const FoundOverlap& found : overlaps) {
        if (found.deepest.lower <= found.allowed * (1 + kRounding)) continue;
        throw std::logic_error(
            fmt::format("the path is certified, but is not valid: at {} of it {} reaches {}, expected at "
                        "most {}; please report this contradiction",
                        readable(found.share), found.isPartInside ? "the part" : "an obstacle",
                        describe(found), shownLength(found.allowed)));
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
    return fmt::format("{} deep, at {}, triangle {} of {}'{}'", inUnit(depthText(found.deepest.lower)),
                       shownPlace(found.deepest.point), found.deepest.obstacleTriangle,
                       found.isPartInside ? "the part in " : "", found.obstacle);
}

Json toJson(const std::vector<FoundOverlap>& overlaps) {
    Json json = Json::array();
    for (const FoundOverlap& found : overlaps) {
        json.push_back(
            {{"obstacle", found.obstacle},
             {"depth", {{"lower", toJson(found.deepest.lower)}, {"upper", toJson(found.deepest.upper)}}},
             {"point", toJson(found.deepest.point)},
             {"triangle", found.deepest.obstacleTriangle},
             {"triangle_of", found.isPartInside ? "part" : "obstacle"},
             {"share_of_path", toJson(found.share)}});
    }
    return json;
}

}  // namespace clearway::cli
