// Final answers about a pair of triangles: in double where that suffices, else in double-double, else in
// integers of any size, which leave nothing open.
#pragma once

#include <cstdint>

#include "clearway/query.h"
#include "query/refine.h"

namespace clearway {

/// How narrow a pair's interval must be, query units.
struct WantedWidth {
    double absolute;    ///< at least PairQuery::defaultWidth
    double relative;    ///< share of lower
    double leastUpper;  ///< pairs proved to be at least this far apart may stay as wide as they are

    bool isMetBy(const ResolvedPair& pair) const {
        return pair.lower >= leastUpper || pair.upper - pair.lower <= absolute ||
               pair.upper - pair.lower <= relative * pair.lower;
    }
};

/// Resolves a pair until contact is decided. On contact both points are one point within 16 u64 M of both
/// triangles; without contact the interval is as narrow as wanted.
ResolvedPair settlePair(const PairQuery& query, const TrianglesAt& triangles, const WantedWidth& wanted,
                        QueryCounters& counters);

/// Whether a pair is within a distance.
struct PairWithin {
    bool within;
    std::int32_t feature;  ///< on which the pair is closest, a guess
};

/// Decides exactly whether the pair's distance is <= d. d: environment units, >= 0.
PairWithin isPairWithin(const PairQuery& query, const TrianglesAt& triangles, double d,
                        QueryCounters& counters);

}  // namespace clearway
