// The poses that a report page shows, one for each place of its slider, with their clearances.
#pragma once

#include <string>
#include <vector>

#include "clearway/planning/audit.h"
#include "clearway/scene_clearance.h"
#include "problem/path_line.h"

namespace clearway::report {

struct ReportFrame {
    double share = 0;  ///< share of the path, see PathLine
    Pose X_environmentPart;
    bool isInRange = true;  ///< when false, only the share and the pose are known
    PoseClearance clearance;
    WhyInvalid whyInvalid;
    std::string partMesh, environmentMesh;  ///< the closest pair; empty when unknown
};

/// Frames at every state of the path, at the given places, at `count` evenly spaced shares, and as many more as
/// show how the part turns.
std::vector<ReportFrame> framesAlong(const PathLine& line, const SceneClearance& clearance, std::size_t count,
                                     const std::vector<double>& places = {});

/// The share of the path at time 0 to 1 of a segment.
double shareIn(const PathLine& line, std::size_t segment, double time);

/// The share of the path at its least clearance, then those of at most `most` segments that are not valid.
std::vector<double> tightPlaces(const PathLine& line, const planning::PathAudit& audit, std::size_t most);

/// The clearance certified everywhere on each of `count` equally long stretches of the path; 0 or less: none.
/// Empty when the audit has no profile.
std::vector<double> certifiedStretches(const PathLine& line, const planning::PathAudit& audit,
                                       std::size_t count);

}  // namespace clearway::report
