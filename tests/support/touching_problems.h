// Parts that touch their surroundings, or are pressed into them, where they are assembled, and that come out by a pull, a slide, or a
// pull after a slide or a turn.
#pragma once

#include <string>
#include <vector>

#include "clearway/mesh.h"

namespace clearway::testing {

/// The part is assembled at the environment's origin, unturned.
struct TouchingProblem {
    std::string name;
    Mesh part;
    Mesh environment;
};

/// A plug, a lid, a bearing, a dovetail and two puzzles. Sizes are 20 to 50.
std::vector<TouchingProblem> touchingProblems();

/// Writes PROBLEM.cfg, PROBLEM_part.obj and PROBLEM_environment.obj into the folder; the goal is outside. keys: further lines. Returns
/// the .cfg file's path.
std::string writeTouchingProblem(const TouchingProblem& problem, const std::string& folder,
                                 const std::string& keys = "");

}  // namespace clearway::testing
