// Audits of paths that others published.
#pragma once

#include <string>
#include <vector>

#include "bench/public/checkouts.h"

namespace clearway::testing::public_problems {

/// The audit of one path, as rows of tables.
struct PathVerdict {
    std::string row;                       ///< see kPathColumns
    std::vector<std::string> invalidRows;  ///< for each segment that is not valid; see kSegmentColumns
    int refuted = 0;                       ///< verdicts that the oracle contradicts
};

/// confirmed: of the segments that are not valid, those at whose worst pose the oracle finds a contact or that
/// leave the bounds. refuted: segments called valid at one of whose poses the oracle finds a contact.
constexpr const char* kPathColumns =
    "problem,path,states,segments,not_valid,confirmed,undecided,out_of_bounds,refuted,poses_asked,least_"
    "clearance";
/// The pose is a line for a path file or a pose file: x y z qx qy qz qw.
constexpr const char* kSegmentColumns =
    "problem,path,segment,t,x,y,z,qx,qy,qz,qw,verdict,part_mesh,part_triangle,environment_mesh,environment_"
    "triangle";

/// Audits a path of the problem. Path files have 6 digits, so positions may be outside of the bounds by 1e-5 of
/// their diagonal.
PathVerdict judgePath(const PublicProblem& problem, const std::string& path);

}  // namespace clearway::testing::public_problems
