// The two tests of a pair of triangles as PQP makes them, written once for numbers of any kind: double, or
// four floats in a register as in the classes of Embree that the thesis used. Collision looks for a
// separating axis; distance takes the closest points of edges, then of corners and faces, and ends as soon as
// a pair of points is known to be the closest. Sources: Gottschalk, RAPID, 1996, and Larsen et al., TR99-018,
// 1999.
#pragma once

namespace clearway::testing {

template <class Number>
struct PointOf {
    Number x, y, z;
};

template <class Number>
PointOf<Number> operator+(const PointOf<Number>& a, const PointOf<Number>& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}

template <class Number>
PointOf<Number> operator-(const PointOf<Number>& a, const PointOf<Number>& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}

template <class Number>
PointOf<Number> operator*(Number s, const PointOf<Number>& a) {
    return {s * a.x, s * a.y, s * a.z};
}

template <class Number>
Number dot(const PointOf<Number>& a, const PointOf<Number>& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

template <class Number>
PointOf<Number> cross(const PointOf<Number>& a, const PointOf<Number>& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

template <class Number>
struct TriangleOf {
    PointOf<Number> corner[3];
    PointOf<Number> edge(int k) const { return corner[(k + 1) % 3] - corner[k]; }
};

/// Which pairs an axis separates.
template <class Number>
auto isSeparatedBy(const PointOf<Number>& axis, const TriangleOf<Number>& a, const TriangleOf<Number>& b) {
    const Number a0 = dot(axis, a.corner[0]), a1 = dot(axis, a.corner[1]), a2 = dot(axis, a.corner[2]);
    const Number b0 = dot(axis, b.corner[0]), b1 = dot(axis, b.corner[1]), b2 = dot(axis, b.corner[2]);
    return either(greatest(a0, a1, a2) < least(b0, b1, b2), greatest(b0, b1, b2) < least(a0, a1, a2));
}

/// Which pairs are apart: 17 axes, until all pairs are separated.
template <class Number>
auto areApart(const TriangleOf<Number>& a, const TriangleOf<Number>& b) {
    const PointOf<Number> base = a.corner[0];
    TriangleOf<Number> p, q;
    for (int k = 0; k < 3; ++k) {
        p.corner[k] = a.corner[k] - base;
        q.corner[k] = b.corner[k] - base;
    }
    const PointOf<Number> normalP = cross(p.edge(0), p.edge(1)), normalQ = cross(q.edge(0), q.edge(1));
    auto apart = isSeparatedBy(normalP, p, q);
    if (all(apart)) return apart;
    apart = either(apart, isSeparatedBy(normalQ, p, q));
    if (all(apart)) return apart;
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) {
            apart = either(apart, isSeparatedBy(cross(p.edge(i), q.edge(j)), p, q));
            if (all(apart)) return apart;
        }
    }
    for (int k = 0; k < 3; ++k) {  // these axes decide coplanar pairs
        apart = either(apart, isSeparatedBy(cross(p.edge(k), normalP), p, q));
        if (all(apart)) return apart;
        apart = either(apart, isSeparatedBy(cross(q.edge(k), normalQ), p, q));
        if (all(apart)) return apart;
    }
    return apart;
}

/// The least squared distance found so far, and what is known of each pair.
template <class Number, class Mask>
struct Nearest {
    Number squared;
    Mask isFound;  ///< the closest points are found
    Mask isApart;  ///< the triangles do not touch
};

/// The closest points of all edges. They are the triangles' closest points if the two other corners lie
/// beyond the slab between them; and the triangles are apart if these corners leave some of the slab free.
template <class Number, class Mask>
void takeEdges(const TriangleOf<Number>& a, const TriangleOf<Number>& b, Nearest<Number, Mask>& nearest) {
    const Number zero(0);
    for (int i = 0; i < 3; ++i) {
        const PointOf<Number> u = a.edge(i);
        const Number uu = dot(u, u);
        for (int j = 0; j < 3; ++j) {
            const PointOf<Number> v = b.edge(j), w = b.corner[j] - a.corner[i];
            const Number vv = dot(v, v), uv = dot(u, v), wu = dot(w, u), wv = dot(w, v);
            Number s = clampedShare((wu * vv - wv * uv) / (uu * vv - uv * uv));
            const Number t = clampedShare((s * uv - wv) / vv);
            s = clampedShare((t * uv + wu) / uu);
            const PointOf<Number> onA = a.corner[i] + s * u, onB = b.corner[j] + t * v, between = onB - onA;
            const Number squared = dot(between, between);
            const auto isNearer = squared <= nearest.squared;
            nearest.squared = select(isNearer, squared, nearest.squared);
            const Number otherA = dot(a.corner[(i + 2) % 3] - onA, between);
            const Number otherB = dot(b.corner[(j + 2) % 3] - onB, between);
            nearest.isFound = either(nearest.isFound, both(isNearer, both(otherA <= zero, zero <= otherB)));
            nearest.isApart =
                either(nearest.isApart, zero < squared - larger(otherA, zero) + smaller(otherB, zero));
            if (all(nearest.isFound)) return;
        }
    }
}

/// The corner of b that is nearest to the plane of a, if all of them lie on one side of it.
template <class Number, class Mask>
void takeFace(const TriangleOf<Number>& a, const TriangleOf<Number>& b, Nearest<Number, Mask>& nearest) {
    const Number zero(0);
    const PointOf<Number> normal = cross(a.edge(0), a.edge(1));
    const Number h0 = dot(normal, b.corner[0] - a.corner[0]), h1 = dot(normal, b.corner[1] - a.corner[0]),
                 h2 = dot(normal, b.corner[2] - a.corner[0]);
    const Number low = least(h0, h1, h2), high = greatest(h0, h1, h2);
    const auto isAbove = zero < low;
    const auto isBeyond = either(isAbove, high < zero);
    if (none(isBeyond)) return;
    nearest.isApart = either(nearest.isApart, isBeyond);
    const Number height = select(isAbove, low, high);
    PointOf<Number> corner = b.corner[2];
    for (int k = 1; k >= 0; --k) {
        const auto isThis = height == (k == 0 ? h0 : h1);
        corner = {select(isThis, b.corner[k].x, corner.x), select(isThis, b.corner[k].y, corner.y),
                  select(isThis, b.corner[k].z, corner.z)};
    }
    auto isOver = isBeyond;
    for (int k = 0; k < 3; ++k) {
        isOver = both(isOver, zero < dot(corner - a.corner[k], cross(normal, a.edge(k))));
    }
    nearest.squared = select(isOver, height * height / dot(normal, normal), nearest.squared);
    nearest.isFound = either(nearest.isFound, isOver);
}

/// Distances, 0 for pairs that touch. far: larger than any squared distance.
template <class Number>
Number distanceOf(const TriangleOf<Number>& a, const TriangleOf<Number>& b, Number far) {
    const auto no = far < far;
    Nearest<Number, decltype(far < far)> nearest = {far, no, no};
    takeEdges(a, b, nearest);
    if (all(nearest.isFound)) return root(nearest.squared);
    takeFace(a, b, nearest);
    if (!all(nearest.isFound)) takeFace(b, a, nearest);
    return select(either(nearest.isFound, nearest.isApart), root(nearest.squared), Number(0));
}

}  // namespace clearway::testing
