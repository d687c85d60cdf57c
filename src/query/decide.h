// The pair's last word: in double where that suffices, else in double-double, else in whole numbers of any
// size, which leave nothing open.
#pragma once

#include <cstdint>

#include "clearway/query.h"
#include "query/refine.h"

namespace clearway {

/// How narrow a pair's interval must be, query units.
struct WantedWidth {
    double absolute;    ///< at least PairQuery::defaultWidth
    double relative;    ///< of lower
    double leastUpper;  ///< pairs proved to be this far apart may stay as wide as they are

    bool isMetBy(const ResolvedPair& pair) const {
        return pair.lower >= leastUpper || pair.upper - pair.lower <= absolute ||
               pair.upper - pair.lower <= relative * pair.lower;
    }
};

/// contact is decided; on contact both points are one, off its triangles by at most 16 u64 M. Else the
/// interval is as narrow as wanted.
ResolvedPair settlePair(const PairQuery& query, const TrianglesAt& triangles, const WantedWidth& wanted,
                        QueryCounters& counters);

struct PairWithin {
    bool within;
    std::int32_t feature;  ///< where the pair is closest, a guess
};

/// Whether the pair's distance is <= d, exactly. d: environment units, >= 0.
PairWithin isPairWithin(const PairQuery& query, const TrianglesAt& triangles, double d,
                        QueryCounters& counters);

}  // namespace clearway
