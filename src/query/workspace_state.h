// What a Workspace holds: the stack, the candidates and the last witness pair.
#pragma once

#include <cstdint>

#include "clearway/query.h"
#include "core/pile.h"
#include "tree/flat_tree.h"

namespace clearway {

/// Two volumes still to be looked into, and a lower bound of their distance in query units.
struct StackEntry {
    float bound;
    VolumeReference part;
    VolumeReference environment;
};

/// A pair of triangles that may be the closest; lower: a true lower bound, query units.
struct Candidate {
    float lower;
    std::uint32_t partTriangle;  ///< positions in the trees
    std::uint32_t environmentTriangle;
};

/// The pair that answered the last query, good for the two models it came from.
struct WarmStart {
    std::uint64_t partId = 0;  ///< Model::id(), never 0; 0: no warm start
    std::uint64_t environmentId = 0;
    std::uint32_t partTriangle = 0;
    std::uint32_t environmentTriangle = 0;
};

struct Workspace::State {
    Pile<StackEntry> stack;
    Pile<Candidate> candidates;
    WarmStart warmStart;
    QueryCounters counters;
};

}  // namespace clearway
