#include "program/cli/path_poses.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "clearway/query.h"
#include "program/cli/print.h"

namespace clearway::cli {

/// The tightest pose is drawn solid, and the others are unless they run through one that is.
void chooseGhosts(const Model& part, std::vector<render::PosedPart>& poses) {
    const auto tightest = std::min_element(
        poses.begin(), poses.end(),
        [](const render::PosedPart& a, const render::PosedPart& b) { return a.clearance < b.clearance; });
    Workspace workspace;
    std::vector<Pose> solid{poseOf(tightest->state)};
    for (render::PosedPart& pose : poses) {
        if (&pose == &*tightest) continue;
        const Pose X_part = poseOf(pose.state);
        pose.isGhost = std::any_of(solid.begin(), solid.end(), [&](const Pose& X_other) {
            return collides(part, part, nearestPose(inverse(X_other) * X_part), workspace);
        });
        if (!pose.isGhost) solid.push_back(X_part);
    }
}

namespace {

void printPose(double share, const Scene& scene, const planning::PoseClearance& at) {
    const planning::MeshNames names = planning::meshNames(scene, at.nearest);
    const std::string between = at.nearest.partTriangle < 0
                                    ? " or more"
                                    : ", between '" + names.part + "' and '" + names.environment + "'";
    printRow("pose at " + readable(share),
             std::isinf(at.lower) ? "nothing to keep clear of" : "clearance " + readable(at.lower) + between);
}

}  // namespace

std::vector<render::PosedPart> posesAt(const report::PathLine& line, const std::vector<double>& shares,
                                       const planning::SceneClearance& clearance, bool isPrinted) {
    std::vector<render::PosedPart> poses;
    for (const double share : shares) {
        const PartState state = line.at(share);
        const Pose X_environmentPart = poseOf(state);
        if (clearance.isOutOfReach(X_environmentPart)) {
            poses.push_back({state, std::numeric_limits<double>::infinity()});
            if (isPrinted) printRow("pose at " + readable(share), "out of the problem's bounds");
            continue;
        }
        const planning::PoseClearance at = clearance.at(X_environmentPart);
        poses.push_back({state, at.lower});
        if (isPrinted) printPose(share, clearance.scene(), at);
    }
    return poses;
}

}  // namespace clearway::cli
