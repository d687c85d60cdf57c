// What a Workspace holds: the stack, the candidates and the last witness pair.
#pragma once

#include <cstdint>

#include "clearway/query.h"
#include "core/pile.h"
#include "query/refine.h"
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
    TrianglesAt triangles;
};

/// The pair that answered the last query, good for the two models it came from.
struct WarmStart {
    std::uint64_t partId = 0;  ///< Model::id(), never 0; 0: no warm start
    std::uint64_t environmentId = 0;
    TrianglesAt triangles{0, 0, kNoFeature};
};

struct Workspace::State {
    Pile<StackEntry> stack;
    Pile<Candidate> candidates;
    WarmStart warmStart;
    QueryCounters counters;
};

}  // namespace clearway
