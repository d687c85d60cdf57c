#include "mesh/topology.h"

#include <algorithm>
#include <cstdint>

namespace clearway {

namespace {

/// A triangle's side, told from the same side run the other way by `isReversed` alone.
struct Side {
    std::uint32_t low;
    std::uint32_t high;
    bool isReversed;
};

bool isSameEdge(const Side& a, const Side& b) {
    return a.low == b.low && a.high == b.high;
}

std::vector<Side> sidesOf(const std::vector<TriangleIndices>& triangles) {
    std::vector<Side> sides;
    sides.reserve(3 * triangles.size());
    for (const TriangleIndices& t : triangles) {
        if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) continue;
        for (int i = 0; i < 3; ++i) {
            const auto [low, high] = std::minmax(t[i], t[(i + 1) % 3]);
            sides.push_back({low, high, t[i] != low});
        }
    }
    return sides;
}

void count(const Side* sides, std::size_t number, EdgeReport& report) {
    if (number == 1) {
        ++report.openEdges;
    } else if (number > 2) {
        ++report.overfullEdges;
    } else if (sides[0].isReversed == sides[1].isReversed) {
        ++report.twistedEdges;
    } else {
        ++report.closedEdges;
    }
}

}  // namespace

EdgeReport checkEdges(const std::vector<TriangleIndices>& triangles) {
    std::vector<Side> sides = sidesOf(triangles);
    std::sort(sides.begin(), sides.end(),
              [](const Side& a, const Side& b) { return a.low != b.low ? a.low < b.low : a.high < b.high; });
    EdgeReport report;
    for (std::size_t first = 0, last; first < sides.size(); first = last) {
        for (last = first + 1; last < sides.size() && isSameEdge(sides[first], sides[last]);) ++last;
        count(&sides[first], last - first, report);
    }
    return report;
}

}  // namespace clearway
