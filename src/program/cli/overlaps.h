// How deep obstacles reach into the part, or an open part into obstacles, at given poses, for those who look at a path.
#pragma once

#include <string>
#include <vector>

#include "clearway/overlap.h"
#include "clearway/problem.h"
#include "clearway/scene.h"
#include "program/options/facts.h"

namespace clearway::cli {

struct FoundOverlap {
    std::string obstacle;  ///< name of the component
    double share = 0;      ///< of the path, where it is deepest
    DeepestPoint deepest;
    double allowed = 0;         ///< the overlap
    bool isPartInside = false;  ///< the part is open: it reaches into the obstacle, not the obstacle into it
};

/// For each obstacle for which the problem allows an overlap, where it reaches deepest into the part, or an open part into it; the deepest
/// first; at poses along the path, to a tenth of the allowed overlap. Empty when the problem allows none.
std::vector<FoundOverlap> overlapsAlong(const Problem& problem, const SceneMeshes& meshes, const Scene& scene,
                                        const std::vector<PartState>& path);

/// For each obstacle that reaches into the part at the problem's start, or an open part into it, where it reaches deepest; the deepest
/// first. Throws ArgumentError if the part is open and touches an obstacle that is open, too.
std::vector<FoundOverlap> overlapsAtStart(const Problem& problem, const SceneMeshes& meshes);

/// Cross-checks a path that was certified as valid: throws std::logic_error if a measured overlap is deeper than
/// allowed.
void requireAllowed(const std::vector<FoundOverlap>& overlaps);

/// Prints a row for each, a few at most; none when there is none.
void printOverlaps(const std::vector<FoundOverlap>& overlaps);

/// Three digits, because a depth is known to 1 %.
std::string depthText(double depth);

/// "0.0312 deep, at (1, 2, 3), triangle 17 of 'bolt'"
std::string describe(const FoundOverlap& found);

Json toJson(const std::vector<FoundOverlap>& overlaps);

}  // namespace clearway::cli
