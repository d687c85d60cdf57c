// Parts where they are assembled, in problems to bring them out.
#pragma once

#include <string>
#include <vector>

#include "clearway/mesh.h"
#include "clearway/problem.h"

namespace clearway::testing {

/// The part is assembled at the environment's origin, unturned.
struct AssembledProblem {
    std::string name;
    Mesh part;
    Mesh environment;
};

/// A plug, a lid, a bearing, a dovetail and two puzzles, which touch their surroundings or are pressed into them. They come out by a
/// pull, a slide, or a pull after a slide or a turn. Sizes are 20 to 50.
std::vector<AssembledProblem> touchingProblems();

/// Parts with little play that come out by a pull, a turn about an axis, a screw, or three of these: the gap at the start is 0.0003 to
/// 0.006 of the part's radius. Sizes are 20 to 50.
std::vector<AssembledProblem> tightProblems();

/// A screw in its nut. Thread: radius 6, pitch 1.75, play 0.08.
struct ScrewShape {
    int segments = 24;            ///< of a turn
    double length = 14, nut = 7;  ///< threaded lengths
    int profileParts = 1;         ///< of each of the four lines of the thread's profile
    bool isShutIn = false;        ///< the thread of the nut ends in a face at both ends
};
/// The screw's axis is tilted; shift: of the axis from the origin.
AssembledProblem screwAndNut(const ScrewShape& shape, double shift);
/// Poses of that screw, without a shift, as it is turned along its thread: `count` of them, the first one assembled, each a third of a turn
/// from the one before.
std::vector<PartState> alongThread(std::size_t count);

/// Twelve parts on a base: two screws in nuts, one with a washer, a shaft with a key in its hub, a lid with lugs in its pot, and a clip that
/// no rigid motion takes off its post. Some parts touch. 155 long.
Mesh pumpAssembly();

/// Writes PROBLEM.cfg, PROBLEM_part.obj and PROBLEM_environment.obj into the folder; the goal is outside. keys: further lines. Returns
/// the .cfg file's path.
std::string writeAssembledProblem(const AssembledProblem& problem, const std::string& folder,
                                  const std::string& keys = "");

}  // namespace clearway::testing
