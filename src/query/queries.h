// The queries on trees, dispatched once each to the instruction set in use.
#pragma once

#include <cstdint>

#include "clearway/query.h"
#include "query/pair_query.h"
#include "query/refine.h"
#include "query/workspace_state.h"

namespace clearway {

/// Lengths in query units.
struct ClosestRequest {
    double relativeError;
    double absoluteError;
    double cap;
};

struct ClosestAnswer {
    bool found =
        false;  ///< false: the distance is larger than the cap, pair.lower >= cap and nothing else counts
    ResolvedPair pair;
    TrianglesAt triangles{0, 0, kNoFeature};
};

struct WithinAnswer {
    bool within = false;
    TrianglesAt triangles{0, 0, kNoFeature};  ///< of a pair that is, when within
};

/// warmStart: a pair of triangles to begin with, or null.
ClosestAnswer closestPair(const PairQuery& query, const ClosestRequest& request, const WarmStart* warmStart,
                          Workspace::State& state);

/// distance: environment units, >= 0.
WithinAnswer anyPairWithin(const PairQuery& query, double distance, const WarmStart* warmStart,
                           Workspace::State& state);

/// Least lower bound first.
void sortByLower(Pile<Candidate>& candidates);

}  // namespace clearway
