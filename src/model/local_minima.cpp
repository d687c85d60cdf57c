#include "model/local_minima.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <tuple>

#include "model/model_data.h"
#include "tree/flat_tree.h"

namespace clearway {
namespace {

/// A neighbour counts as nearer when its distance is smaller by this share: a step towards it leads nearer by more than a sine of 0.02.
constexpr double kNearer = 2e-4;
constexpr double kOnBorder =
    1e-9;  ///< of the triangle's size: a point so close to an edge or a corner is on it

/// The corners of a triangle on whose feature a point lies: one for a corner, two for an edge, none inside.
struct Feature {
    std::array<Vector3, 2> corners;
    int count = 0;
};

Feature featureAt(const Vector3& point, const std::array<Vector3, 3>& corners) {
    const double size = std::max((corners[1] - corners[0]).norm(), (corners[2] - corners[0]).norm());
    const double close = kOnBorder * (size + point.cwiseAbs().maxCoeff());
    Feature feature;
    for (const Vector3& corner : corners) {
        if ((point - corner).norm() > close) continue;
        feature.corners[0] = corner;
        feature.count = 1;
        return feature;
    }
    for (int k = 0; k < 3; ++k) {
        const Vector3 &a = corners[std::size_t(k)], &b = corners[std::size_t((k + 1) % 3)];
        const Vector3 along = (b - a).normalized(), from = point - a;
        if ((from - from.dot(along) * along).norm() > close) continue;
        feature.corners = {a, b};
        feature.count = 2;
        return feature;
    }
    return feature;
}

bool touches(const std::array<Vector3, 3>& corners, const Feature& feature) {
    return std::all_of(feature.corners.begin(), feature.corners.begin() + feature.count,
                       [&](const Vector3& wanted) {
                           return std::find(corners.begin(), corners.end(), wanted) != corners.end();
                       });
}

/// One of the two meshes, whose triangles a pair may step over.
struct OfMesh {
    const FlatTree& tree;
    TriangleAt TrianglesAt::*own;
    TriangleAt TrianglesAt::*other;
    Vector3 Witness::*point;
    Pose X_meshEnvironment;
};

/// Marks the pairs that come nearer within this mesh. Pairs with the same triangle of the other mesh stand together in the order.
void markSteps(const OfMesh& side, const std::vector<PlacedPair>& pairs, std::vector<bool>& isLeft) {
    std::vector<std::size_t> order(pairs.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    const auto keyOf = [&](std::size_t i) {
        const TriangleAt& at = pairs[i].triangles.*side.other;
        return std::tuple(at.leaf, at.number, pairs[i].result.distance, i);
    };
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return keyOf(a) < keyOf(b); });
    for (std::size_t first = 0, k = 0; k < order.size(); ++k) {
        const PlacedPair& pair = pairs[order[k]];
        if (!(pairs[order[first]].triangles.*side.other == pair.triangles.*side.other)) first = k;
        if (k == first || isLeft[order[k]]) continue;
        const Feature feature = featureAt(side.X_meshEnvironment * (*pair.result.witness.*side.point),
                                          side.tree.corners(pair.triangles.*side.own));
        if (feature.count == 0) continue;
        for (std::size_t near = first; near < k; ++near) {
            const PlacedPair& neighbour = pairs[order[near]];
            if (!(neighbour.result.distance < (1 - kNearer) * pair.result.distance)) break;
            if (!touches(side.tree.corners(neighbour.triangles.*side.own), feature)) continue;
            isLeft[order[k]] = true;
            break;
        }
    }
}

}  // namespace

void keepLocalMinima(const Model& part, const Model& environment, const Pose& X_environmentPart,
                     std::vector<PlacedPair>& pairs) {
    std::vector<bool> isLeft(pairs.size(), false);
    markSteps({treeOf(part), &TrianglesAt::part, &TrianglesAt::environment, &Witness::pointOnPart,
               inverse(X_environmentPart)},
              pairs, isLeft);
    markSteps({treeOf(environment), &TrianglesAt::environment, &TrianglesAt::part,
               &Witness::pointOnEnvironment, Pose{}},
              pairs, isLeft);
    std::size_t kept = 0;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        if (isLeft[i]) continue;
        if (kept != i) pairs[kept] = std::move(pairs[i]);
        ++kept;
    }
    pairs.resize(kept);
}

}  // namespace clearway
