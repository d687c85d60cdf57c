// Thins pairs of triangles near each other to those where the distance between the two surfaces has a local minimum.
#pragma once

#include <vector>

#include "clearway/model.h"
#include "clearway/query.h"
#include "query/pair_query.h"

namespace clearway {

/// A resolved pair, and the places of its triangles in the trees.
struct PlacedPair {
    DistanceResult result;  ///< with a witness
    TrianglesAt triangles;
};

/// Leaves out each pair from which a step over an edge or a corner into a neighbouring triangle of either mesh comes nearer, as far as
/// the pair of that triangle is among the pairs.
void keepLocalMinima(const Model& part, const Model& environment, const Pose& X_environmentPart,
                     std::vector<PlacedPair>& pairs);

}  // namespace clearway
