// The pair's distance and its proof in double. Upper bound: the closest of 9 edge pairs and 6 corners over
// faces, each a feasible pair of points. Lower bound: the widest slab gap over directions that contain the
// best one for every kind of closest feature; true for any direction, so only its width is at stake. Contact
// is proved by an edge that goes through a face by more than rounding. What neither proves is left open.
#include "query/refine.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "exact/double_double.h"

namespace clearway {
namespace {

/// A point of a triangle, roughly, and where it lies on it.
struct OnTriangle {
    Vector3 x = Vector3::Zero();
    PlaceInTriangle place;
};

struct PointPair {
    OnTriangle onPart, onEnvironment;
    double squared = std::numeric_limits<double>::infinity();
    std::int32_t feature = kNoFeature;

    void take(const OnTriangle& a, const OnTriangle& b, std::int32_t takenFeature) {
        const double candidate = (b.x - a.x).squaredNorm();
        if (candidate < squared) *this = {a, b, candidate, takenFeature};
    }
    Vector3 difference() const { return onEnvironment.x - onPart.x; }
};

double quotientOrZero(double a, double b) {
    return b > 0 ? a / b : 0;
}
double clampToUnit(double x) {
    return std::min(std::max(x, 0.0), 1.0);
}

OnTriangle onEdge(const Corners& triangle, int k, double s) {
    return {triangle.p[k] + s * triangle.edge(k), {k, s, 0}};
}

void takeEdges(const Corners& a, int i, const Corners& b, int j, PointPair& best) {
    const Vector3 u = a.edge(i), v = b.edge(j), w = b.p[j] - a.p[i], n = u.cross(v);
    const double uv = u.dot(v);
    double s = clampToUnit(quotientOrZero(w.cross(v).dot(n), n.squaredNorm()));
    const double t = clampToUnit(quotientOrZero(s * uv - w.dot(v), v.squaredNorm()));
    s = clampToUnit(quotientOrZero(t * uv + w.dot(u), u.squaredNorm()));
    best.take(onEdge(a, i, s), onEdge(b, j, t), 3 * i + j);
}

/// The point of the triangle below x; where it is not below the face, a point of the triangle all the same.
/// Each step but the first sets out from the point found, and so rounds in what is left: with two, a flat
/// triangle's point is as good as another's.
OnTriangle pointBelow(const Vector3& x, const Corners& triangle, int steps) {
    const Vector3 u = triangle.edge(0), v = triangle.p[2] - triangle.p[0], n = u.cross(v);
    const double nn = n.squaredNorm();
    OnTriangle below{triangle.p[0], {0, 0, 0}};
    double &s = below.place.s, &t = below.place.t;
    for (; steps > 0; --steps) {
        const Vector3 rest = x - below.x;
        s = clampToUnit(s + quotientOrZero(rest.cross(v).dot(n), nn));
        t = std::min(std::max(t + quotientOrZero(u.cross(rest).dot(n), nn), 0.0), 1 - s);
        below.x = triangle.p[0] + s * u + t * v;
    }
    return below;
}

void takeFeature(const Corners& a, const Corners& b, std::int32_t feature, PointPair& best, int steps = 1) {
    if (feature < 9) return takeEdges(a, feature / 3, b, feature % 3, best);
    const int k = (feature - 9) / 2;
    if (feature % 2 == 1) {
        best.take(onEdge(a, k, 0), pointBelow(a.p[k], b, steps), feature);
    } else {
        best.take(pointBelow(b.p[k], a, steps), onEdge(b, k, 0), feature);
    }
}

PointPair closestPoints(const Corners& a, const Corners& b) {
    PointPair best;
    for (int feature = 0; feature < kFeatures; ++feature) takeFeature(a, b, feature, best);
    if (best.feature >= 9) takeFeature(a, b, best.feature, best, 2);
    return best;
}

/// Six times the signed volume of a tetrahedron.
double volumeOf(const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& d) {
    return (b - a).dot((c - a).cross(d - a));
}

/// Whether an edge of one triangle goes through the inside of the other by more than `least` shows in every
/// volume that decides it: then they share a point, whatever the rounding. false says nothing.
bool surelyPierces(const Corners& edges, const Corners& face, double least) {
    for (int k = 0; k < 3; ++k) {
        const Vector3 &from = edges.p[k], &to = edges.p[(k + 1) % 3];
        const double below = volumeOf(from, face.p[0], face.p[1], face.p[2]),
                     above = volumeOf(to, face.p[0], face.p[1], face.p[2]);
        if (!(std::min(below, above) < -least && std::max(below, above) > least)) continue;
        double low = std::numeric_limits<double>::infinity(), high = -low;
        for (int side = 0; side < 3; ++side) {
            const double volume = volumeOf(from, to, face.p[side], face.p[(side + 1) % 3]);
            low = std::min(low, volume);
            high = std::max(high, volume);
        }
        if (low > least || high < -least) return true;
    }
    return false;
}

/// Where an edge of one triangle crosses the other's plane, and the point of the other below it.
void takeCrossings(const Corners& edges, const Corners& face, bool edgesAreParts, PointPair& best) {
    const Vector3 n = face.normal();
    for (int k = 0; k < 3; ++k) {
        const double from = n.dot(edges.p[k] - face.p[0]), to = n.dot(edges.p[k] + edges.edge(k) - face.p[0]);
        if (!(from * to <= 0) || from == to) continue;
        const OnTriangle crossing = onEdge(edges, k, clampToUnit(from / (from - to)));
        const OnTriangle below = pointBelow(crossing.x, face, 2);
        if (edgesAreParts) {
            best.take(crossing, below, kNoFeature);
        } else {
            best.take(below, crossing, kNoFeature);
        }
    }
}

/// Two slabs across a direction: (min v.b - max v.a or the other way round) / |v|, -infinity for a direction
/// of no length.
struct Slabs {
    double gap = -std::numeric_limits<double>::infinity();
    Vector3 direction = Vector3::Zero();
};

Slabs across(const Vector3& v, const Corners& a, const Corners& b) {
    const double squared = v.squaredNorm();
    if (!(squared > std::numeric_limits<double>::min()) || !std::isfinite(squared)) return {};
    const Vector3 alongA(v.dot(a.p[0]), v.dot(a.p[1]), v.dot(a.p[2]));
    const Vector3 alongB(v.dot(b.p[0]), v.dot(b.p[1]), v.dot(b.p[2]));
    const double width =
        std::max(alongB.minCoeff() - alongA.maxCoeff(), alongA.minCoeff() - alongB.maxCoeff());
    return {width / std::sqrt(squared), v};
}

void keepWider(const Slabs& slabs, Slabs& widest) {
    if (slabs.gap > widest.gap) widest = slabs;
}

/// The normals of each triangle's edges within its plane.
void tryDirectionsInPlanes(const Corners& a, const Corners& b, Slabs& widest) {
    for (const Corners* triangle : {&a, &b}) {
        const Vector3 n = triangle->normal();
        for (int k = 0; k < 3; ++k) {
            const Vector3 v = triangle->edge(k).cross(n);
            const double largest = v.cwiseAbs().maxCoeff();  // as below
            if (largest > 0) keepWider(across(v / largest, a, b), widest);
        }
    }
}

/// Directions for the pairs that three do not prove tightly: cross products of edges, normals of edges within
/// a face, and the difference made perpendicular to each edge, which takes the rounding of a short difference
/// out of it.
void tryManyDirections(const Vector3& difference, const Corners& a, const Corners& b, Slabs& widest) {
    const auto take = [&](const Vector3& v) {
        const double largest =
            v.cwiseAbs().maxCoeff();  // keeps the square of a short direction from vanishing
        if (largest > 0) keepWider(across(v / largest, a, b), widest);
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
}

/// The lower bound, tried harder while it is not within slack of the distance.
Slabs widestSlabs(const PointPair& closest, const Corners& a, const Corners& b, double slack) {
    Slabs widest = across(closest.difference(), a, b);
    keepWider(across(a.normal(), a, b), widest);
    keepWider(across(b.normal(), a, b), widest);
    if (!(std::sqrt(closest.squared) - widest.gap <= slack)) {
        tryManyDirections(closest.difference(), a, b, widest);
    }
    return widest;
}

/// A lower bound of the distance from a slab gap. First order, vectors, in u64: moved corners 1.8 M;
/// differences from the base 1.8 + 1.8, products of a slab gap 5.2 + 5.2 and their difference 3.5 times the
/// size. The length of the direction costs 5 of the gap itself.
struct GapRounding {
    GapRounding(double M, double size) : slack(kUnitRoundoffDouble * (2 * M + 18 * size)) {}
    double provedBy(double gap) const { return gap * (1 - 5 * kUnitRoundoffDouble) - slack; }
    double slack;
};

/// The slabs across the difference at the feature, when they are as far apart as the points but for rounding,
/// which proves these closest; else none. One feature and one direction instead of all.
Slabs provedByGuess(std::int32_t feature, const Corners& a, const Corners& b, const GapRounding& rounding,
                    PointPair& closest) {
    if (feature != kNoFeature) {
        takeFeature(a, b, feature, closest);
        const Slabs slabs = across(closest.difference(), a, b);
        if (rounding.provedBy(slabs.gap) > 0 && std::sqrt(closest.squared) - slabs.gap <= rounding.slack) {
            return slabs;
        }
    }
    return {};
}

}  // namespace

PairVertices pairVertices(const PairQuery& query, const TrianglesAt& triangles) {
    const FlatTree &part = *query.part, &environment = *query.environment;
    const auto &p = part.triangles[triangles.part], &q = environment.triangles[triangles.environment];
    const Vector3 &p0 = part.vertices[p[0]], &q0 = environment.vertices[q[0]];
    PairVertices pair;
    for (int row = 0; row < 3; ++row) {
        pair.firstCorner[row] = affineRow(query.R + 3 * row, p0.data(), query.t[row]) * query.perMeshUnit -
                                q0[row] * query.perMeshUnit;
        for (int edge = 0; edge < 2; ++edge) {
            pair.partEdge[edge][row] = (part.vertices[p[edge + 1]][row] - p0[row]) * query.perMeshUnit;
            pair.environmentEdge[edge][row] =
                (environment.vertices[q[edge + 1]][row] - q0[row]) * query.perMeshUnit;
        }
    }
    return pair;
}

namespace {

/// The corners of a pair relative to a point near it, so that what follows rounds in the pair's size;
/// differences of near doubles are exact.
struct LocalPair {
    LocalPair(const Corners& moved, const Corners& fixed) : a(moved), b(fixed) {
        const Vector3 base = fixed.p[0];
        for (Corners* triangle : {&a, &b}) {
            for (Vector3& corner : triangle->p) {
                corner -= base;
                size = std::max(size, corner.cwiseAbs().maxCoeff());
            }
        }
    }

    bool surelyPierces(double M) const {
        // In first order a volume is off by at most 12 size^2 times a corner's 4 u64 (M + size), and 60 u64
        // size^3.
        const double leastVolume = 512 * kUnitRoundoffDouble * size * size * (size + M);
        return clearway::surelyPierces(a, b, leastVolume) || clearway::surelyPierces(b, a, leastVolume);
    }

    Corners a, b;
    double size = 0;
};

}  // namespace

ContactInDouble contactOf(const PairQuery& query, const TrianglesAt& triangles) {
    const LocalPair pair(movedCorners(query, triangles.part), fixedCorners(query, triangles.environment));
    if (pair.surelyPierces(query.largestCoordinate)) return {Verdict::yes, Vector3::Zero()};
    const GapRounding rounding(query.largestCoordinate, pair.size);
    Slabs widest = across(pair.a.normal(), pair.a, pair.b);
    keepWider(across(pair.b.normal(), pair.a, pair.b), widest);
    const auto isOpen = [&] { return !(rounding.provedBy(widest.gap) > 0); };
    // Normals, edges' cross products and normals of edges within a face separate whatever can be separated.
    // Faces on each other are separated within their plane, if at all.
    const bool isResting = std::abs(widest.gap) <= 2 * rounding.slack;
    if (isOpen()) tryDirectionsInPlanes(pair.a, pair.b, widest);
    if (isOpen() && !isResting) tryManyDirections(Vector3::Zero(), pair.a, pair.b, widest);
    return {rounding.provedBy(widest.gap) > 0 ? Verdict::no : Verdict::open, widest.direction};
}

ResolvedPair resolvePair(const PairQuery& query, const TrianglesAt& triangles) {
    const Corners moved = movedCorners(query, triangles.part),
                  fixed = fixedCorners(query, triangles.environment);
    const LocalPair pair(moved, fixed);
    const Corners &a = pair.a, &b = pair.b;
    const double M = query.largestCoordinate;
    const GapRounding rounding(M, pair.size);
    PointPair closest;
    Slabs slabs = provedByGuess(triangles.feature, a, b, rounding, closest);
    Verdict contact = Verdict::no;
    if (!(rounding.provedBy(slabs.gap) > 0)) {
        closest = closestPoints(a, b);
        if (pair.surelyPierces(M)) {
            contact = Verdict::yes;
        } else {
            slabs = widestSlabs(closest, a, b, rounding.slack);
            if (!(rounding.provedBy(slabs.gap) > 0)) contact = Verdict::open;
        }
        if (contact != Verdict::no) {
            takeCrossings(a, b, true, closest);
            takeCrossings(b, a, false, closest);
        }
    }
    ResolvedPair resolved;
    resolved.contact = contact;
    resolved.feature = closest.feature;
    resolved.pointOnPart = pointAt(closest.onPart.place, moved);
    resolved.pointOnEnvironment = pointAt(closest.onEnvironment.place, fixed);
    if (contact != Verdict::yes) {
        resolved.lower = std::max(0.0, rounding.provedBy(slabs.gap));
        resolved.apartAlong = slabs.direction;
        resolved.upper = upperBoundFrom(resolved.pointOnPart, resolved.pointOnEnvironment, M);
    }
    return resolved;
}

}  // namespace clearway
