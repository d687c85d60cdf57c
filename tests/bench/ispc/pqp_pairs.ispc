// PQP's tests of pairs (../pqp_tests-inl.h) in ISPC, a pair in each program instance.

#include "points.isph"

static inline bool isSeparatedBy(Point axis, const Triangle& a, const Triangle& b) {
    const float a0 = dot(axis, a.corner[0]), a1 = dot(axis, a.corner[1]), a2 = dot(axis, a.corner[2]);
    const float b0 = dot(axis, b.corner[0]), b1 = dot(axis, b.corner[1]), b2 = dot(axis, b.corner[2]);
    return max(max(a0, a1), a2) < min(min(b0, b1), b2) || max(max(b0, b1), b2) < min(min(a0, a1), a2);
}

static inline bool areApart(const Triangle& a, const Triangle& b) {
    Triangle p, q;
    Point edgeP[3], edgeQ[3];
    for (uniform int k = 0; k < 3; ++k) {
        p.corner[k] = a.corner[k] - a.corner[0];
        q.corner[k] = b.corner[k] - a.corner[0];
    }
    for (uniform int k = 0; k < 3; ++k) {
        edgeP[k] = p.corner[(k + 1) % 3] - p.corner[k];
        edgeQ[k] = q.corner[(k + 1) % 3] - q.corner[k];
    }
    const Point normalP = cross(edgeP[0], edgeP[1]), normalQ = cross(edgeQ[0], edgeQ[1]);
    bool apart = isSeparatedBy(normalP, p, q);
    if (all(apart)) return apart;
    apart |= isSeparatedBy(normalQ, p, q);
    if (all(apart)) return apart;
    for (uniform int i = 0; i < 3; ++i) {
        for (uniform int j = 0; j < 3; ++j) {
            apart |= isSeparatedBy(cross(edgeP[i], edgeQ[j]), p, q);
            if (all(apart)) return apart;
        }
    }
    for (uniform int k = 0; k < 3; ++k) {
        apart |= isSeparatedBy(cross(edgeP[k], normalP), p, q);
        if (all(apart)) return apart;
        apart |= isSeparatedBy(cross(edgeQ[k], normalQ), p, q);
        if (all(apart)) return apart;
    }
    return apart;
}

struct Nearest {
    float squared;
    bool isFound, isApart;
};

/// 0 for NaN.
static inline float clampedShare(float s) {
    return s > 0 ? min(s, 1.0f) : 0;
}

static inline void takeEdges(const Triangle& a, const Triangle& b, Nearest& nearest) {
    for (uniform int i = 0; i < 3; ++i) {
        const Point u = a.corner[(i + 1) % 3] - a.corner[i];
        const float uu = dot(u, u);
        for (uniform int j = 0; j < 3; ++j) {
            const Point v = b.corner[(j + 1) % 3] - b.corner[j], w = b.corner[j] - a.corner[i];
            const float vv = dot(v, v), uv = dot(u, v), wu = dot(w, u), wv = dot(w, v);
            float s = clampedShare((wu * vv - wv * uv) / (uu * vv - uv * uv));
            const float t = clampedShare((s * uv - wv) / vv);
            s = clampedShare((t * uv + wu) / uu);
            const Point onA = a.corner[i] + s * u, onB = b.corner[j] + t * v;
            const Point between = onB - onA;
            const float squared = dot(between, between);
            const bool isNearer = squared <= nearest.squared;
            nearest.squared = select(isNearer, squared, nearest.squared);
            const float otherA = dot(a.corner[(i + 2) % 3] - onA, between);
            const float otherB = dot(b.corner[(j + 2) % 3] - onB, between);
            nearest.isFound |= isNearer && otherA <= 0 && 0 <= otherB;
            nearest.isApart |= 0 < squared - max(otherA, 0.0f) + min(otherB, 0.0f);
            if (all(nearest.isFound)) return;
        }
    }
}

static inline void takeFace(const Triangle& a, const Triangle& b, Nearest& nearest) {
    Point edge[3];
    for (uniform int k = 0; k < 3; ++k) edge[k] = a.corner[(k + 1) % 3] - a.corner[k];
    const Point normal = cross(edge[0], edge[1]);
    float height[3];
    for (uniform int k = 0; k < 3; ++k) height[k] = dot(normal, b.corner[k] - a.corner[0]);
    const float low = min(min(height[0], height[1]), height[2]), high = max(max(height[0], height[1]), height[2]);
    const bool isAbove = 0 < low;
    const bool isBeyond = isAbove || high < 0;
    if (none(isBeyond)) return;
    nearest.isApart |= isBeyond;
    const float over = select(isAbove, low, high);
    Point corner = b.corner[2];
    for (uniform int k = 1; k >= 0; --k) {
        corner.x = select(over == height[k], b.corner[k].x, corner.x);
        corner.y = select(over == height[k], b.corner[k].y, corner.y);
        corner.z = select(over == height[k], b.corner[k].z, corner.z);
    }
    bool isOver = isBeyond;
    for (uniform int k = 0; k < 3; ++k) isOver &= 0 < dot(corner - a.corner[k], cross(normal, edge[k]));
    nearest.squared = select(isOver, over * over / dot(normal, normal), nearest.squared);
    nearest.isFound |= isOver;
}

static inline float distanceOf(const Triangle& a, const Triangle& b) {
    Nearest nearest = {3.4e38f, false, false};
    takeEdges(a, b, nearest);
    if (!all(nearest.isFound)) {
        takeFace(a, b, nearest);
        if (!all(nearest.isFound)) takeFace(b, a, nearest);
    }
    return select(nearest.isFound || nearest.isApart, sqrt(nearest.squared), 0.0f);
}

export void pqpCollides(const uniform float a[], const uniform float rows[], uniform int stride, uniform int count,
                        uniform int touches[]) {
    const Triangle first = spread(a);
    foreach (i = 0 ... count) {
        touches[i] = areApart(first, load(rows, stride, i)) ? 0 : 1;
    }
}

export void pqpDistance(const uniform float a[], const uniform float rows[], uniform int stride, uniform int count,
                        uniform float distances[]) {
    const Triangle first = spread(a);
    foreach (i = 0 ... count) {
        distances[i] = distanceOf(first, load(rows, stride, i));
    }
}
