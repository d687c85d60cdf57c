#include "shrink/thin_places.h"

#include <algorithm>
#include <cmath>

namespace clearway {
namespace {

constexpr double kDeepEnough = 8.0 / 9;  ///< of the depth that faces move
constexpr double kBeforeMiddle = 1.04;   ///< the other sheet stays so many times as far as the move is deep
constexpr double kOutside = 0.4;         ///< a move that leads out of the surface is shortened to this
constexpr int kMostBalls = 8;
constexpr double kSettled = 1e-3;

/// The largest share of a move, below `share`, after which the point is as far from where it began as is wanted; at the beginning it is.
double shareBeforeMiddle(const Vector3& fromOther, const Vector3& move, double depth, double share) {
    const double wanted = kBeforeMiddle * depth;
    const double a = move.squaredNorm() - wanted * wanted, b = fromOther.dot(move),
                 c = fromOther.squaredNorm();
    const double root = b * b - a * c;
    if (root < 0) return share;
    const double sum = -b + std::sqrt(root);  // the lesser root above 0 is c / sum, also where a is 0
    return sum > 0 ? std::min(share, c / sum) : share;
}

}  // namespace

double depthOf(const Vector3& place, NearestTriangle& nearest, const OrientedSurface& nearestSurface) {
    const NearestTriangle::Place found = nearest.of(place);
    const auto [a, b, c] = nearestSurface.corners(found.triangle);
    const bool isBehind = (b - a).cross(c - a).dot(place - found.point) <= 0;
    return isBehind ? found.distance : -found.distance;
}

std::vector<bool> keepBeforeMiddles(const OrientedSurface& surface, NearestTriangle& nearest,
                                    const OrientedSurface& nearestSurface, double depth,
                                    MovedSurface& moved) {
    std::vector<bool> isShortened(moved.places.size(), false);
    for (std::size_t i = 0; i < moved.places.size(); ++i) {
        const Vector3& vertex = surface.vertices[moved.places[i].vertex];
        Vector3& move = moved.places[i].move;
        double share = 1;
        for (int k = 0; k < kMostBalls; ++k) {
            const Vector3 place = vertex + share * move;
            const NearestTriangle::Place found = nearest.of(place);
            const auto [a, b, c] = nearestSurface.corners(found.triangle);
            const bool isOutside = (b - a).cross(c - a).dot(place - found.point) > 0;
            if (!isOutside && found.distance >= kDeepEnough * share * depth) break;
            const double next =
                isOutside ? kOutside * share : shareBeforeMiddle(vertex - found.point, move, depth, share);
            const bool isSettled = next >= (1 - kSettled) * share;
            share = next;
            if (isSettled) break;
        }
        if (share == 1) continue;
        move *= share;
        isShortened[i] = true;
    }
    return isShortened;
}

}  // namespace clearway
