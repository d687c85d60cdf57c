// How the program shows an audited path: rows, a table of its segments, a plot of its clearance.
#pragma once

#include <string>

#include "clearway/planning/audit.h"

namespace clearway::cli {

/// Rounds to so many digits towards zero, because a certified value must not be rounded up.
std::string shortened(double value, int digits = 4);

/// Prints two rows: whether the path is valid, and where it is closest.
void printAudit(const planning::PathAudit& audit);

/// The bounds of the least clearance: "1.2 to 1.25".
std::string leastClearanceOf(const planning::PathAudit& audit);

/// Prints one line for each segment.
void printSegments(const planning::PathAudit& audit);

/// Prints the profile as a plot below 80 columns wide: # certified clearance, : clearance found at poses.
/// Prints nothing for a path that does not move.
void printProfile(const planning::PathAudit& audit);

/// Writes the profile as CSV: segment,t,travel,clearance,clearance_to_next; numbers with 17 digits. Throws
/// std::runtime_error when the file cannot be written.
void writeProfile(const planning::PathAudit& audit, const std::string& file);

}  // namespace clearway::cli
