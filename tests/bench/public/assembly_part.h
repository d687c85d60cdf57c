// Taking one part out of an assembly, whose parts often touch or overlap.
#pragma once

#include <string>

#include "bench/public/checkouts.h"

namespace clearway::testing::public_problems {

constexpr const char* kPartColumns =
    "triangles,touching,depth,overlap,preparing_seconds,found,seconds,found_by,clearance,straight,"
    "note";

/// Plans one part out of all others to a goal outside, by `clearway plan`'s defaults with seed 1. Obstacles that
/// the part touches at the start may reach into it everywhere on the path, as deep as there, and at least by 0.002
/// of the part's diagonal. Writes the problem to `config`, and a path that is found to `path`.
///
/// Returns a row of kPartColumns. touching: files of such obstacles; depth: how deep they reach into the part at
/// the start; straight: how many of 1,000 straight directions lead outside, counted only if no path was found; note:
/// why there was no problem to plan.
std::string runPart(const Assembly& assembly, std::size_t part, double seconds, const std::string& config,
                    const std::string& path);

}  // namespace clearway::testing::public_problems
