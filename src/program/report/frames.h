// The poses a report page shows, one for each place of its slider, and what is known at and between them.
#pragma once

#include <string>
#include <vector>

#include "clearway/planning/audit.h"
#include "planning/validity/scene_clearance.h"
#include "problem/path_line.h"

namespace clearway::report {

struct ReportFrame {
    double share = 0;  ///< of the way, see PathLine
    Pose X_environmentPart;
    bool isInReach = true;  ///< else nothing but the share and the pose is known
    planning::PoseClearance clearance;
    std::string partMesh, environmentMesh;  ///< the two closest; empty when none is known
};

/// At every state of the path, at the given shares and, evenly, at so many places at least.
std::vector<ReportFrame> framesAlong(const PathLine& line, const planning::SceneClearance& clearance,
                                     std::size_t count, const std::vector<double>& places = {});

/// The share of the way at a time, 0 to 1, of a segment of an audit of the line.
double shareIn(const PathLine& line, std::size_t segment, double time);

/// The share of the way where the audit's path is closest, then where its segments that are not valid are, so
/// many of these at most.
std::vector<double> tightPlaces(const PathLine& line, const planning::PathAudit& audit, std::size_t most);

/// For each of so many equally long stretches of the way: what is certified of clearance everywhere on it; 0
/// or less for nothing. Empty when the audit has no profile.
std::vector<double> certifiedStretches(const PathLine& line, const planning::PathAudit& audit,
                                       std::size_t count);

}  // namespace clearway::report
