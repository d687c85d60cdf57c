// The pair's distance and its proof in double. Upper bound: the closest of 9 edge pairs and 6 corners over
// faces, each a feasible pair of points. Lower bound: the widest slab gap over directions that contain the
// best one for every kind of closest feature; true for any direction, so only its width is at stake. A pair
// that pierces has no direction with a positive gap: it is contact, and its witness is where an edge crosses
// a face.
#include "query/refine.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "exact/double_double.h"

namespace clearway {
namespace {

struct Corners {
    Vector3 p[3];
    Vector3 edge(int k) const { return p[(k + 1) % 3] - p[k]; }
    Vector3 normal() const { return edge(0).cross(p[2] - p[0]); }
};

struct PointPair {
    Vector3 onPart = Vector3::Zero();
    Vector3 onEnvironment = Vector3::Zero();
    double squared = std::numeric_limits<double>::infinity();

    void take(const Vector3& a, const Vector3& b) {
        const double candidate = (b - a).squaredNorm();
        if (candidate < squared) *this = {a, b, candidate};
    }
};

double quotientOrZero(double a, double b) {
    return b > 0 ? a / b : 0;
}
double clampToUnit(double x) {
    return std::min(std::max(x, 0.0), 1.0);
}

void takeEdges(const Vector3& p, const Vector3& u, const Vector3& q, const Vector3& v, PointPair& best) {
    const Vector3 w = q - p, n = u.cross(v);
    const double uv = u.dot(v);
    double s = clampToUnit(quotientOrZero(w.cross(v).dot(n), n.squaredNorm()));
    const double t = clampToUnit(quotientOrZero(s * uv - w.dot(v), v.squaredNorm()));
    s = clampToUnit(quotientOrZero(t * uv + w.dot(u), u.squaredNorm()));
    best.take(p + s * u, q + t * v);
}

/// The point of the triangle below x; where it is not below the face, a point of the triangle all the same.
Vector3 pointBelow(const Vector3& x, const Corners& triangle) {
    const Vector3 u = triangle.edge(0), v = triangle.p[2] - triangle.p[0], n = u.cross(v),
                  w = x - triangle.p[0];
    const double nn = n.squaredNorm();
    const double s = clampToUnit(quotientOrZero(w.cross(v).dot(n), nn));
    const double t = std::min(std::max(quotientOrZero(u.cross(w).dot(n), nn), 0.0), 1 - s);
    return triangle.p[0] + s * u + t * v;
}

PointPair closestPoints(const Corners& a, const Corners& b) {
    PointPair best;
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) takeEdges(a.p[i], a.edge(i), b.p[j], b.edge(j), best);
    }
    for (int k = 0; k < 3; ++k) {
        best.take(a.p[k], pointBelow(a.p[k], b));
        best.take(pointBelow(b.p[k], a), b.p[k]);
    }
    return best;
}

/// Where an edge of one triangle crosses the other's plane, and the point of the other below it.
void takeCrossings(const Corners& edges, const Corners& face, bool edgesAreParts, PointPair& best) {
    const Vector3 n = face.normal();
    for (int k = 0; k < 3; ++k) {
        const Vector3 start = edges.p[k], along = edges.edge(k);
        const double from = n.dot(start - face.p[0]), to = n.dot(start + along - face.p[0]);
        if (!(from * to <= 0) || from == to) continue;
        const Vector3 crossing = start + along * clampToUnit(from / (from - to));
        const Vector3 below = pointBelow(crossing, face);
        if (edgesAreParts) {
            best.take(crossing, below);
        } else {
            best.take(below, crossing);
        }
    }
}

/// (min v.b - max v.a or the other way round) / |v|; -infinity for a direction of no length.
double slabGap(const Vector3& v, const Corners& a, const Corners& b) {
    const double squared = v.squaredNorm();
    if (!(squared > std::numeric_limits<double>::min()) || !std::isfinite(squared)) {
        return -std::numeric_limits<double>::infinity();
    }
    const Vector3 alongA(v.dot(a.p[0]), v.dot(a.p[1]), v.dot(a.p[2]));
    const Vector3 alongB(v.dot(b.p[0]), v.dot(b.p[1]), v.dot(b.p[2]));
    return std::max(alongB.minCoeff() - alongA.maxCoeff(), alongA.minCoeff() - alongB.maxCoeff()) /
           std::sqrt(squared);
}

/// Directions for the pairs that three do not prove tightly: cross products of edges, normals of edges within
/// a face, and the difference made perpendicular to each edge, which takes the rounding of a short difference
/// out of it.
double bestOfManyGaps(const Vector3& difference, const Corners& a, const Corners& b) {
    double gap = -std::numeric_limits<double>::infinity();
    const auto take = [&](const Vector3& v) {
        const double largest =
            v.cwiseAbs().maxCoeff();  // keeps the square of a short direction from vanishing
        if (largest > 0) gap = std::max(gap, slabGap(v / largest, a, b));
    };
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) take(a.edge(i).cross(b.edge(j)));
    }
    for (const Corners* triangle : {&a, &b}) {
        const Vector3 n = triangle->normal();
        take(n);
        for (int k = 0; k < 3; ++k) {
            const Vector3 e = triangle->edge(k);
            take(e.cross(n));
            take(e.cross(difference.cross(e)));
        }
    }
    take(difference);
    return gap;
}

Corners movedCorners(const PairQuery& query, std::uint32_t triangle) {
    const FlatTree& tree = *query.part;
    Corners corners;
    for (int k = 0; k < 3; ++k) {
        const Vector3& vertex = tree.vertices[tree.triangles[triangle][k]];
        for (int row = 0; row < 3; ++row) {
            corners.p[k][row] = affineRow(query.R + 3 * row, vertex.data(), query.t[row]) * query.perMeshUnit;
        }
    }
    return corners;
}

Corners fixedCorners(const PairQuery& query, std::uint32_t triangle) {
    const FlatTree& tree = *query.environment;
    Corners corners;
    for (int k = 0; k < 3; ++k) corners.p[k] = tree.vertices[tree.triangles[triangle][k]] * query.perMeshUnit;
    return corners;
}

}  // namespace

ResolvedPair resolvePair(const PairQuery& query, std::uint32_t partTriangle,
                         std::uint32_t environmentTriangle) {
    Corners a = movedCorners(query, partTriangle), b = fixedCorners(query, environmentTriangle);
    // Near the pair, so that what follows rounds in the pair's size; differences of near doubles are exact.
    const Vector3 base = b.p[0];
    double size = 0;
    for (Corners* triangle : {&a, &b}) {
        for (Vector3& corner : triangle->p) {
            corner -= base;
            size = std::max(size, corner.cwiseAbs().maxCoeff());
        }
    }

    PointPair closest = closestPoints(a, b);
    const double M = query.largestCoordinate;
    // First order, vectors, in u64: moved corners 1.8 M; differences from the base 1.8 + 1.8, products of a
    // slab gap 5.2 + 5.2 and their difference 3.5 times the size. The lengths of the direction and of the
    // point pair cost 5 of the gap itself.
    const double slack = kUnitRoundoffDouble * (2 * M + 18 * size);
    constexpr double kLengthRoundoffs = 5 * kUnitRoundoffDouble;
    const double distance = std::sqrt(closest.squared);

    double gap = std::max({slabGap(closest.onEnvironment - closest.onPart, a, b), slabGap(a.normal(), a, b),
                           slabGap(b.normal(), a, b)});
    if (!(distance - gap <= slack)) {
        gap = std::max(gap, bestOfManyGaps(closest.onEnvironment - closest.onPart, a, b));
    }

    ResolvedPair resolved;
    resolved.contact = !(gap > std::max(kContactRoundoffs * kUnitRoundoffDouble * M, slack));
    if (resolved.contact) {
        takeCrossings(a, b, true, closest);
        takeCrossings(b, a, false, closest);
        closest.onPart = closest.onEnvironment = 0.5 * (closest.onPart + closest.onEnvironment);
    } else {
        resolved.lower = std::max(0.0, gap * (1 - kLengthRoundoffs) - slack);
        resolved.upper = distance * (1 + kLengthRoundoffs) + slack;
    }
    for (int k = 0; k < 3; ++k) {
        resolved.pointOnPart[k] = closest.onPart[k] + base[k];
        resolved.pointOnEnvironment[k] = closest.onEnvironment[k] + base[k];
    }
    return resolved;
}

}  // namespace clearway
