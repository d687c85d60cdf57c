#include "program/report/frames.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace clearway::report {

namespace {

/// A turn is shown at every kTurnStep, or less finely where that would take more than kMostTurnSteps.
constexpr double kTurnStep = 6 * M_PI / 180;  ///< radians
constexpr double kMostTurnSteps = 1500;

std::vector<double> turnPlaces(const PathLine& line) {
    const std::vector<PartState>& states = line.states();
    std::vector<double> turns;
    for (std::size_t i = 0; i + 1 < states.size(); ++i)
        turns.push_back(states[i].rotation.angularDistance(states[i + 1].rotation));
    const double all = std::accumulate(turns.begin(), turns.end(), 0.0);
    std::vector<double> places;
    for (std::size_t i = 0; i < turns.size(); ++i) {
        const double steps = std::ceil(turns[i] / std::max(kTurnStep, all / kMostTurnSteps));
        for (double k = 1; k < steps; ++k) places.push_back(shareIn(line, i, k / steps));
    }
    return places;
}

ReportFrame frameAt(double share, const PartState& state, const SceneClearance& clearance) {
    ReportFrame frame;
    frame.share = share;
    frame.X_environmentPart = poseOf(state);
    frame.isInRange = !clearance.isOutOfRange(frame.X_environmentPart);
    if (!frame.isInRange) return frame;
    frame.clearance = clearance.at(frame.X_environmentPart);
    frame.whyInvalid = clearance.whyInvalid(frame.X_environmentPart, frame.clearance);
    const MeshNames names = distinctMeshNames(clearance.scene(), frame.clearance.nearest);
    frame.partMesh = names.part;
    frame.environmentMesh = names.environment;
    return frame;
}

}  // namespace

std::vector<ReportFrame> framesAlong(const PathLine& line, const SceneClearance& clearance, std::size_t count,
                                     const std::vector<double>& places) {
    std::vector<double> shares = evenShares(count);
    shares.insert(shares.end(), line.shares().begin(), line.shares().end());
    shares.insert(shares.end(), places.begin(), places.end());
    const std::vector<double> turns = turnPlaces(line);
    shares.insert(shares.end(), turns.begin(), turns.end());
    std::sort(shares.begin(), shares.end());
    shares.erase(std::unique(shares.begin(), shares.end()), shares.end());
    std::vector<ReportFrame> frames;
    for (const double share : shares) frames.push_back(frameAt(share, line.at(share), clearance));
    return frames;
}

double shareIn(const PathLine& line, std::size_t segment, double time) {
    const std::vector<double>& shares = line.shares();
    const std::size_t next = std::min(segment + 1, shares.size() - 1);  // a path of one state has one segment
    return shares[segment] + time * (shares[next] - shares[segment]);
}

std::vector<double> tightPlaces(const PathLine& line, const planning::PathAudit& audit, std::size_t most) {
    if (audit.segments.empty()) return {};
    const auto placeOf = [&](std::size_t segment) {
        return shareIn(line, segment, audit.segments[segment].motion.closestTime);
    };
    std::vector<double> places = {placeOf(audit.closest)};
    for (std::size_t i = 0; i < std::min(most, audit.notValid.size()); ++i)
        places.push_back(placeOf(audit.notValid[i]));
    return places;
}

std::vector<double> certifiedStretches(const PathLine& line, const planning::PathAudit& audit,
                                       std::size_t count) {
    if (audit.profile.empty()) return {};
    std::vector<double> least(count, std::numeric_limits<double>::infinity());
    const auto shareOf = [&](const planning::PathProfilePoint& point) {
        return shareIn(line, point.segment, point.time);
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

}  // namespace clearway::report
