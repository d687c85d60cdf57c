// How the program shows an audited path: rows, a table of its segments, a plot of its clearance.
#pragma once

#include <string>
#include <vector>

#include "clearway/planning/audit.h"
#include "clearway/problem.h"
#include "clearway/scene.h"
#include "clearway/scene_clearance.h"
#include "program/options/print.h"

namespace clearway::cli {

/// Prints rows about whether the path is valid, and where it is closest: both points, their triangles and the pose.
void printAudit(const planning::PathAudit& audit, const Scene& scene);

/// Where on the path obstacles were left out because the part was within a contact zone; no rows if nowhere.
Rows contactRows(const planning::PathAudit& audit);

/// Says that obstacles are left out at a pose within a contact zone: "" or ", leaving out ...".
std::string leftOutAt(const PoseClearance& at);

/// Ends the words about a slack: " before the overlap may exceed 0.5 mm". Empty in a scene without overlaps, and where nothing is near.
std::string slackLimit(const Scene& scene, const SceneDistance& nearest);

/// The row of the bounds: "least clearance", "1.2 to 1.25".
Rows leastClearanceRow(const planning::PathAudit& audit, const Scene& scene);

/// Prints one line for each segment.
void printSegments(const planning::PathAudit& audit, const Scene& scene);

/// Prints the profile as a plot below 80 columns wide: # certified clearance, : clearance found at poses.
/// Prints nothing for a path that does not move.
void printProfile(const planning::PathAudit& audit, const Scene& scene);

/// Writes the profile as CSV, with numbers of 17 digits: where on the path, the clearances, the pose, and the two
/// closest triangles with their closest points, which are left empty where nothing is near. Throws std::runtime_error
/// when the file cannot be written.
void writeProfile(const planning::PathAudit& audit, const Scene& scene, const std::vector<PartState>& path,
                  const std::string& file);

}  // namespace clearway::cli
