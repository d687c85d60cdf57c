// Upper bound: the closest of 9 edge pairs and 6 corners over faces, each of which is a pair of points of the
// triangles. Lower bound: the widest slab gap over directions that include the best one for every kind of
// closest features. Every direction gives a true bound, so the choice only affects its width. Contact is
// proved by an edge that pierces a face by more than rounding. Pairs that neither bound nor piercing decides
// stay open.
#include "query/refine.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "exact/ball.h"

namespace clearway {
namespace {

/// A point of a triangle: its place on the triangle, and its rounded coordinates.
struct OnTriangle {
    Vector3 x = Vector3::Zero();
    PlaceInTriangle place;
};

/// The closest pair of points found so far.
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

/// The projection of x onto the triangle; if x lies beside the face, some point of the triangle. Each further
/// step starts from the point found so far and rounds only in the remaining difference: with two steps a flat
/// triangle gets as good a point as any other.
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

/// Six times the signed volume of the tetrahedron a, b, c, d.
double volumeOf(const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& d) {
    return (b - a).dot((c - a).cross(d - a));
}

/// Whether an edge of one triangle pierces the other, and every volume that decides this exceeds `least`.
/// Then the triangles share a point whatever the rounding. false proves nothing.
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

/// Takes the points where edges of one triangle cross the other's plane, each with its projection onto the
/// other.
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

/// The gap between two triangles' slabs across v, max(min v.b - max v.a, min v.a - max v.b) / |v|; -infinity
/// for a direction without length.
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

/// Tries the normals of each triangle's edges within its plane.
void tryDirectionsInPlanes(const Corners& a, const Corners& b, Slabs& widest) {
    for (const Corners* triangle : {&a, &b}) {
        const Vector3 n = triangle->normal();
        for (int k = 0; k < 3; ++k) {
            const Vector3 v = triangle->edge(k).cross(n);
            const double largest =
                v.cwiseAbs().maxCoeff();  // keeps the square of a short direction from vanishing
            if (largest > 0) keepWider(across(v / largest, a, b), widest);
        }
    }
}

/// Tries more directions, for pairs whose difference and normals give no tight bound: cross products of
/// edges, normals of edges within a face, and the difference made perpendicular to each edge, which removes
/// the rounding of a short difference.
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

/// The widest gap found. More directions are tried if the first three leave it more than `slack` below the
/// distance.
Slabs widestSlabs(const PointPair& closest, const Corners& a, const Corners& b, double slack) {
    Slabs widest = across(closest.difference(), a, b);
    keepWider(across(a.normal(), a, b), widest);
    keepWider(across(b.normal(), a, b), widest);
    if (!(std::sqrt(closest.squared) - widest.gap <= slack)) {
        tryManyDirections(closest.difference(), a, b, widest);
    }
    return widest;
}

/// Turns a slab gap computed here in double into a lower bound of the distance. Rounding, first order, errors
/// of vectors, in u64: moved corners 1.8 M; differences from the base 1.8 + 1.8, products of a slab gap 5.2 +
/// 5.2 and their difference 3.5 times the pair's size. The length of the direction costs 5 of the gap itself.
struct GapRounding {
    GapRounding(double M, double size) : slack(kUnitRoundoffDouble * (2 * M + 18 * size)) {}
    double provedBy(double gap) const { return gap * (1 - 5 * kUnitRoundoffDouble) - slack; }
    double slack;
};

/// Tries one feature and one direction instead of all: the gap across the difference at the guessed feature.
/// If that gap equals the distance of the points up to rounding, the points are proved closest; otherwise
/// there is no gap.
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

/// The corners of a pair relative to a point near both, so that further rounding is in proportion to the
/// pair's size. Differences of nearby doubles are exact.
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
        // In first order the error of a volume is at most 12 size^2 times a corner's error of 4 u64 (M +
        // size), plus 60 u64 size^3.
        const double leastVolume = 512 * kUnitRoundoffDouble * size * size * (size + M);
        return clearway::surelyPierces(a, b, leastVolume) || clearway::surelyPierces(b, a, leastVolume);
    }

    Corners a, b;
    double size = 0;
};

}  // namespace

// Computed with twice the digits and rounded once, the point is off by 1.8 u64, and by another 1.8 where fl(1
// - s) made s + t exceed 1.
Vector3 pointAt(const PlaceInTriangle& place, const Corners& triangle) {
    const Vector3 &first = triangle.p[place.corner], &next = triangle.p[(place.corner + 1) % 3],
                  &last = triangle.p[(place.corner + 2) % 3];
    Vector3 x;
    for (int k = 0; k < 3; ++k) {
        const DoubleDouble u = twoSum(next[k], -first[k]), v = twoSum(last[k], -first[k]);
        const DoubleDouble su = twoProduct(place.s, u.high), tv = twoProduct(place.t, v.high);
        const DoubleDouble way = twoSum(su.high, tv.high), sum = twoSum(first[k], way.high);
        x[k] = sum.high + (sum.low + way.low + su.low + tv.low + place.s * u.low + place.t * v.low);
    }
    return x;
}

double lengthBetween(const Vector3& p, const Vector3& q) {
    DoubleDouble squared{0, 0};
    for (int k = 0; k < 3; ++k) {
        const DoubleDouble difference = twoSum(p[k], -q[k]);
        const DoubleDouble square = twoProduct(difference.high, difference.high);
        const DoubleDouble sum = twoSum(squared.high, square.high);
        squared = {sum.high, squared.low + sum.low + square.low + 2 * difference.high * difference.low};
    }
    return std::sqrt(squared.high + squared.low);
}

ContactInDouble contactOf(const PairQuery& query, const TrianglesAt& triangles) {
    const LocalPair pair(movedCorners(query, triangles.part), fixedCorners(query, triangles.environment));
    if (pair.surelyPierces(query.largestCoordinate)) return {Verdict::yes, Vector3::Zero()};
    const GapRounding rounding(query.largestCoordinate, pair.size);
    Slabs widest = across(pair.a.normal(), pair.a, pair.b);
    keepWider(across(pair.b.normal(), pair.a, pair.b), widest);
    const auto isOpen = [&] { return !(rounding.provedBy(widest.gap) > 0); };
    // Any two disjoint triangles are separated by a normal, a cross product of edges or a normal of an edge
    // within a face. Faces that rest on each other can only be separated within their plane.
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
