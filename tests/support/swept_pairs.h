// Pairs of meshes and motions of one past the other.
#pragma once

#include <string>
#include <vector>

#include "clearway/model.h"
#include "clearway/sweep.h"
#include "support/random_meshes.h"

namespace clearway::testing {

/// Two meshes to sweep one past the other.
struct SweptPair {
    SweptPair(std::string name, const Mesh& partMesh, const Mesh& environmentMesh, int nodeWidth);

    std::string name;
    Model part, environment;
    double size;                       ///< the sum of both diagonals
    Vector3 centre = Vector3::Zero();  ///< motions begin around it
};

/// Triangles 1,000 times longer than wide.
Mesh stretchedSoup(Random& random, int count);

/// Pairs of all kinds: those of meshPairs, needles, and meshes far from the origin.
std::vector<SweptPair> sweptPairs(int nodeWidth);

Pose poseAt(const RigidMotion& motion, double time);

/// A motion that begins near the pair's centre, of any length and turn, with or without either.
RigidMotion randomMotion(Random& random, const SweptPair& pair);

/// A pipe of 200 sides, tube(2, 3, 4, 200), rolls over a plate, box({40, 40, 1}), each of its edges coming as near as `gap`.
RigidMotion rolling(double gap);

/// Options that leave hardly any motion undecided.
SweepOptions optionsFor(const SweptPair& pair, double margin);

}  // namespace clearway::testing
