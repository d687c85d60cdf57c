// Clearway's kernels of pairs (src/kernels/certificate-inl.h, src/kernels/tri_tri_distance-inl.h) in ISPC, a
// pair in each program instance. The comments there hold here.

#include "points.isph"

// Squared lengths of the directions that count (src/kernels/rounding.h).
static const uniform float leastDirectionSquared = 1e-30f, largestDirectionSquared = 1e30f;
static const uniform float leastProvingSquared = 1e-22f;
static const uniform float noGap = -3.4e38f;

struct Edges {
    Point edge[3];
    Point span, normal;
};

static inline Edges edgesOf(const Triangle& t) {
    Edges edges;
    for (uniform int k = 0; k < 3; ++k) edges.edge[k] = t.corner[(k + 1) % 3] - t.corner[k];
    edges.span = t.corner[2] - t.corner[0];
    edges.normal = cross(edges.edge[0], edges.span);
    return edges;
}

static inline float slabGap(Point v, const Triangle& a, const Triangle& b) {
    const float a0 = dot(v, a.corner[0]), a1 = dot(v, a.corner[1]), a2 = dot(v, a.corner[2]);
    const float b0 = dot(v, b.corner[0]), b1 = dot(v, b.corner[1]), b2 = dot(v, b.corner[2]);
    const float above = min(b0, min(b1, b2)) - max(a0, max(a1, a2));
    const float below = min(a0, min(a1, a2)) - max(b0, max(b1, b2));
    const float lengthSquared = dot(v, v);
    const bool usable = lengthSquared > leastDirectionSquared && lengthSquared < largestDirectionSquared;
    return select(usable, max(above, below) / sqrt(lengthSquared), noGap);
}

static inline bool provesApart(float width, float lengthSquared, uniform float needSquared) {
    const float positive = max(width, 0.0f);
    return positive * positive > needSquared * lengthSquared && lengthSquared > leastProvingSquared;
}

/// The corner farthest along v, and v.corner; or the least far.
static inline float support(Point v, const Triangle& t, uniform bool isNearest, Point& corner) {
    float along = dot(v, t.corner[0]);
    corner = t.corner[0];
    for (uniform int k = 1; k < 3; ++k) {
        const float other = dot(v, t.corner[k]);
        const bool better = isNearest ? other < along : other > along;
        along = select(better, other, along);
        corner.x = select(better, t.corner[k].x, corner.x);
        corner.y = select(better, t.corner[k].y, corner.y);
        corner.z = select(better, t.corner[k].z, corner.z);
    }
    return along;
}

static inline bool walkProvesApart(const Triangle& a, const Triangle& b, Point x, uniform float needSquared) {
    bool proved = false;
    for (uniform int step = 0; step < 2; ++step) {
        Point onA, onB;
        const float alongA = support(x, a, false, onA), alongB = support(x, b, true, onB);
        const float width = alongB - alongA, lengthSquared = dot(x, x);
        proved |= provesApart(width, lengthSquared, needSquared);
        if (step == 1) return proved;
        const Point towards = onB - onA - x;
        x = x + clamp((lengthSquared - width) * rcp_fast(dot(towards, towards)), 0.0f, 1.0f) * towards;
    }
    return proved;
}

static inline bool areApart(const Triangle& a, const Triangle& b, uniform float slack, uniform float needSquared) {
    const Point between = (b.corner[0] + b.corner[1] + b.corner[2]) - (a.corner[0] + a.corner[1] + a.corner[2]);
    bool apart = walkProvesApart(a, b, (1.0f / 3) * between, needSquared);
    if (all(apart)) return apart;
    const Edges ofA = edgesOf(a), ofB = edgesOf(b);
    apart |= max(slabGap(ofA.normal, a, b), slabGap(ofB.normal, a, b)) > slack;
    if (all(apart)) return apart;
    float gap = noGap;
    for (uniform int i = 0; i < 3; ++i) {
        for (uniform int j = 0; j < 3; ++j) gap = max(gap, slabGap(cross(ofA.edge[i], ofB.edge[j]), a, b));
    }
    return apart || gap > slack;
}

static inline float clampedToUnit(float s) {
    return clamp(s, 0.0f, 1.0f);
}

static inline float reciprocalOrZero(float v) {
    return select(v > 0, rcp(v), 0.0f);  // an estimate with a Newton step, as in the kernel
}

struct Best {
    Point difference;
    float squared;
};

static inline void take(Point v, Best& best) {
    const float squared = dot(v, v);
    const bool nearer = squared < best.squared;
    best.difference.x = select(nearer, v.x, best.difference.x);
    best.difference.y = select(nearer, v.y, best.difference.y);
    best.difference.z = select(nearer, v.z, best.difference.z);
    best.squared = select(nearer, squared, best.squared);
}

static inline void takeFace(Point w, Point u, Point v, Point ofU, Point ofV, Best& best) {
    const float s = clampedToUnit(dot(w, ofU));
    const float t = clamp(dot(w, ofV), 0.0f, 1 - s);
    take(w - s * u - t * v, best);
}

static inline float distanceOf(const Triangle& a, const Triangle& b, uniform float slack) {
    const Edges ofA = edgesOf(a), ofB = edgesOf(b);
    Best best;
    best.difference = b.corner[0] - a.corner[0];
    best.squared = dot(best.difference, best.difference);
    float uu[3], vv[3], uv[3][3], wu[3][3], wv[3][3];
    for (uniform int i = 0; i < 3; ++i) {
        uu[i] = reciprocalOrZero(dot(ofA.edge[i], ofA.edge[i]));
        vv[i] = reciprocalOrZero(dot(ofB.edge[i], ofB.edge[i]));
        uv[i][0] = dot(ofA.edge[i], ofB.edge[0]);
        uv[i][1] = dot(ofA.edge[i], ofB.edge[1]);
        uv[i][2] = -(uv[i][0] + uv[i][1]);
        wu[i][0] = dot(b.corner[0] - a.corner[i], ofA.edge[i]);
        wu[i][1] = wu[i][0] + uv[i][0];
        wu[i][2] = wu[i][1] + uv[i][1];
    }
    for (uniform int j = 0; j < 3; ++j) {
        wv[0][j] = dot(b.corner[j] - a.corner[0], ofB.edge[j]);
        wv[1][j] = wv[0][j] - uv[0][j];
        wv[2][j] = wv[1][j] - uv[1][j];
    }
    for (uniform int i = 0; i < 3; ++i) {
        for (uniform int j = 0; j < 3; ++j) {
            const Point w = b.corner[j] - a.corner[i], u = ofA.edge[i], v = ofB.edge[j];
            const Point n = cross(u, v);
            float s = clampedToUnit(dot(cross(w, v), n) * reciprocalOrZero(dot(n, n)));
            const float t = clampedToUnit((s * uv[i][j] - wv[i][j]) * vv[j]);
            s = clampedToUnit((t * uv[i][j] + wu[i][j]) * uu[i]);
            take(w + t * v - s * u, best);
        }
    }
    const float perA = reciprocalOrZero(dot(ofA.normal, ofA.normal)), perB = reciprocalOrZero(dot(ofB.normal, ofB.normal));
    const Point ofUA = perA * cross(ofA.span, ofA.normal), ofVA = perA * cross(ofA.normal, ofA.edge[0]);
    const Point ofUB = perB * cross(ofB.span, ofB.normal), ofVB = perB * cross(ofB.normal, ofB.edge[0]);
    for (uniform int k = 0; k < 3; ++k) {
        takeFace(a.corner[k] - b.corner[0], ofB.edge[0], ofB.span, ofUB, ofVB, best);
        takeFace(b.corner[k] - a.corner[0], ofA.edge[0], ofA.span, ofUA, ofVA, best);
    }
    const float lower = max(max(slabGap(ofA.normal, a, b), slabGap(ofB.normal, a, b)), slabGap(best.difference, a, b));
    return select(lower > slack, sqrt(best.squared), 0.0f);
}

/// needSquared: NeedSquared(slack) of src/kernels/certificate-inl.h.
export void clearwayCollides(const uniform float a[], const uniform float rows[], uniform int stride, uniform int count,
                             uniform float slack, uniform float needSquared, uniform int touches[]) {
    const Triangle first = spread(a);
    foreach (i = 0 ... count) {
        touches[i] = areApart(first, load(rows, stride, i), slack, needSquared) ? 0 : 1;
    }
}

export void clearwayDistance(const uniform float a[], const uniform float rows[], uniform int stride, uniform int count,
                             uniform float slack, uniform float distances[]) {
    const Triangle first = spread(a);
    foreach (i = 0 ... count) {
        distances[i] = distanceOf(first, load(rows, stride, i), slack);
    }
}
