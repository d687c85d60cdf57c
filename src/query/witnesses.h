// Pairs of triangles that answered the last queries of two models. A distance begins with the closest pair of an earlier distance
// that is nearest at its pose: where poses jump about, as a planner's do, that pair is much nearer than the last one.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "query/pair_query.h"

namespace clearway {

/// Pairs of triangles with one point of either triangle, as structure of arrays. A new pair takes the place of the oldest.
struct Witnesses {
    static constexpr int kMost = 64;
    std::uint64_t partId = 0;  ///< Model::id(), which is never 0
    std::uint64_t environmentId = 0;
    int count = 0;
    int next = 0;  ///< place of the next new pair
    bool isLastKnown = false;
    TrianglesAt last;  ///< answered the last query that had a pair for its answer
    TrianglesAt triangles[kMost] = {};
    alignas(64) float onPart[3][kMost] = {};         ///< part tree's frame and unit
    alignas(64) float onEnvironment[3][kMost] = {};  ///< environment tree's frame and unit

    void forget() {
        count = next = 0;
        isLastKnown = false;
    }
    void setLast(const TrianglesAt& pair) {
        last = pair;
        isLastKnown = true;
    }

    /// Forgets the pairs of other models.
    void serve(std::uint64_t part, std::uint64_t environment) {
        if (partId == part && environmentId == environment) return;
        partId = part;
        environmentId = environment;
        forget();
    }

    /// Keeps the closest pair at a pose. pointOnPart, pointOnEnvironment: its closest points, environment frame, query units.
    void keep(const PairQuery& query, const TrianglesAt& pair, const Vector3& pointOnPart,
              const Vector3& pointOnEnvironment) {
        setLast(pair);
        int place = 0;
        while (place < count &&
               !(triangles[place].part == pair.part && triangles[place].environment == pair.environment)) {
            ++place;
        }
        if (place == count) {  // a new pair
            place = next;
            next = (next + 1) % kMost;
            count = std::max(count, place + 1);
        }
        triangles[place] = pair;
        const auto toTree = [&](const FlatTree& tree, const Vector3& point, float(&rows)[3][kMost]) {
            const double perMeshUnit = std::ldexp(1.0, -tree.unitExponent);
            for (int k = 0; k < 3; ++k)
                rows[k][place] = static_cast<float>((point[k] - tree.origin[k]) * perMeshUnit);
        };
        const double toMeshUnits = std::ldexp(1.0, query.unitExponent);
        const Vector3 moved = pointOnPart * toMeshUnits - Vector3(query.t[0], query.t[1], query.t[2]);
        Vector3 stored;
        for (int k = 0; k < 3; ++k) {
            stored[k] = query.R[k] * moved[0] + query.R[3 + k] * moved[1] + query.R[6 + k] * moved[2];
        }
        toTree(*query.part, stored, onPart);
        toTree(*query.environment, pointOnEnvironment * toMeshUnits, onEnvironment);
    }
};

}  // namespace clearway
