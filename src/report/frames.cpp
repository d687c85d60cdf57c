#include "report/frames.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "planning/mesh_names.h"

namespace clearway {

namespace {

ReportFrame frameAt(double share, const PartState& state, const planning::SceneClearance& clearance) {
    ReportFrame frame;
    frame.share = share;
    frame.X_environmentPart = poseOf(state);
    frame.isInReach = !clearance.isOutOfReach(frame.X_environmentPart);
    if (!frame.isInReach) return frame;
    frame.clearance = clearance.at(frame.X_environmentPart);
    const SceneDistance& nearest = frame.clearance.nearest;
    if (nearest.partTriangle >= 0) {
        frame.partMesh = planning::meshName(clearance.scene().part, nearest.partComponent);
        frame.environmentMesh = planning::obstacleName(clearance.scene(), nearest);
    }
    return frame;
}

}  // namespace

std::vector<ReportFrame> framesAlong(const PathLine& line, const planning::SceneClearance& clearance,
                                     std::size_t count) {
    std::vector<double> shares = evenShares(count);
    shares.insert(shares.end(), line.shares().begin(), line.shares().end());
    std::sort(shares.begin(), shares.end());
    shares.erase(std::unique(shares.begin(), shares.end()), shares.end());
    std::vector<ReportFrame> frames;
    for (const double share : shares) frames.push_back(frameAt(share, line.at(share), clearance));
    return frames;
}

std::vector<double> certifiedStretches(const PathLine& line, const planning::PathAudit& audit,
                                       std::size_t count) {
    if (audit.profile.empty()) return {};
    std::vector<double> least(count, std::numeric_limits<double>::infinity());
    const std::vector<double>& shares = line.shares();
    const auto shareOf = [&](const planning::PathProfilePoint& point) {
        const std::size_t next = std::min(point.segment + 1, shares.size() - 1);
        return shares[point.segment] + point.time * (shares[next] - shares[point.segment]);
    };
    for (std::size_t i = 0; i + 1 < audit.profile.size(); ++i) {
        const double from = shareOf(audit.profile[i]), to = shareOf(audit.profile[i + 1]);
        const auto first = static_cast<std::size_t>(from * double(count));
        const auto last = static_cast<std::size_t>(std::ceil(to * double(count)));
        for (std::size_t k = first; k < std::min(std::max(last, first + 1), count); ++k)
            least[k] = std::min(least[k], audit.profile[i].lowerToNext);
    }
    for (double& value : least) value = std::isfinite(value) ? value : 0;
    return least;
}

}  // namespace clearway
