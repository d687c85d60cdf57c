// The closest features of two triangles, found with sums and products alone. Corners, edges and faces are
// tried against each other; each pair's squared distance is a fraction, which counts if the closest points
// lie on both features, and signs decide that. With Ball numbers a sign may stay open, with Integer numbers
// never. Degenerate triangles are fine. Source of the case split: Ericson, Real-Time Collision Detection,
// 2005, ch. 5.
#pragma once

#include <array>

#include "exact/ball.h"
#include "exact/integer.h"
#include "exact/numbers.h"

namespace clearway {

/// A point of a triangle: corner + s / whole (next corner - corner) + t / whole (last corner - corner).
template <class Number>
struct PlaceOnTriangle {
    int corner;
    Number s, t, whole;
};

/// Offers all pairs of features to a visitor until the visitor is done. A visitor has
///   bool wants(numerator, denominator)       whether a squared distance of numerator / denominator may
///                                            matter; denominator >= 0
///   void take(feasible, feature, onA, onB)   the closest points of the features that wants() accepted last.
///                                            feasible: whether the points lie on the features.  feature: the
///                                            number of the pair of features in query/pair_query.h, or -1
///                                            where an edge pierces a face
///   bool done() const                        whether no further pair matters
template <class Number>
class TriangleFeatures {
  public:
    using Corners = std::array<Triple<Number>, 3>;

    TriangleFeatures(const Corners& a, const Corners& b) : a_(a), b_(b) {
        for (int k = 0; k < 3; ++k) {
            edgeA_[k] = a[(k + 1) % 3] - a[k];
            edgeB_[k] = b[(k + 1) % 3] - b[k];
            for (int j = 0; j < 3; ++j) between_[k][j] = b[j] - a[k];
        }
        normalA_ = edgeA_[0].cross(edgeA_[1]);
        normalB_ = edgeB_[0].cross(edgeB_[1]);
        normalASquared_ = normalA_.dot(normalA_);
        normalBSquared_ = normalB_.dot(normalB_);
    }

    template <class Visitor>
    void visit(Visitor& visitor) const {
        visitFaces(visitor);  // first, because parts rest on faces
        if (visitor.done()) return;
        visitCorners(visitor);
        if (visitor.done()) return;
        for (int i = 0; i < 3; ++i) {
            for (int j = 0; j < 3; ++j) {
                visitEdges(i, j, visitor);
                visitCornerAndEdges(i, j, visitor);
                if (visitor.done()) return;
            }
        }
    }

  private:
    using Place = PlaceOnTriangle<Number>;

    static Place atCorner(int k) { return {k, 0, 0, 1}; }

    /// Whether 0 <= share <= whole and whole > 0. A feature without extent is left to its corners.
    static Verdict isBetween(const Number& share, const Number& whole) {
        const Verdict above = isNotNegative(share);
        if (above == Verdict::no) return above;
        return both(both(above, isNotNegative(whole - share)), opposite(isNotNegative(-whole)));
    }

    template <class Visitor>
    void visitCorners(Visitor& visitor) const {
        for (int i = 0; i < 3; ++i) {
            for (int j = 0; j < 3; ++j) {
                const Triple<Number>& w = between_[i][j];
                if (visitor.wants(w.dot(w), Number(1)))
                    visitor.take(Verdict::yes, 3 * i + j, atCorner(i), atCorner(j));
                if (visitor.done()) return;
            }
        }
    }

    /// Corners over the other triangle's face, and edges that pierce the face.
    template <class Visitor>
    void visitFaces(Visitor& visitor) const {
        std::array<Number, 3> heights;  // of the corners above the face, times the length of its normal
        for (int k = 0; k < 3; ++k) heights[k] = between_[k][0].dot(normalB_);
        for (int k = 0; k < 3 && !visitor.done(); ++k) {
            if (!visitor.wants(heights[k] * heights[k], normalBSquared_)) continue;
            Place below;
            const Verdict feasible = isBelow(a_[k], b_, edgeB_[0], normalBSquared_, below);
            visitor.take(feasible, 9 + 2 * k, atCorner(k), below);
        }
        visitPiercing(edgeA_, heights, edgeB_, false, visitor);
        if (visitor.done()) return;
        for (int k = 0; k < 3; ++k) heights[k] = between_[0][k].dot(normalA_);
        for (int k = 0; k < 3 && !visitor.done(); ++k) {
            if (!visitor.wants(heights[k] * heights[k], normalASquared_)) continue;
            Place below;
            const Verdict feasible = isBelow(b_[k], a_, edgeA_[0], normalASquared_, below);
            visitor.take(feasible, 10 + 2 * k, below, atCorner(k));
        }
        visitPiercing(edgeB_, heights, edgeA_, true, visitor);
    }

    /// Whether x projects into the face. place: where x projects to.
    static Verdict isBelow(const Triple<Number>& x, const Corners& face, const Triple<Number>& edge,
                           const Number& normalSquared, Place& place) {
        const Triple<Number> span = face[2] - face[0], w = x - face[0];
        const Number ee = edge.dot(edge), es = edge.dot(span), ss = span.dot(span), we = w.dot(edge),
                     ws = w.dot(span);
        place = {0, we * ss - ws * es, ws * ee - we * es, normalSquared};
        const Verdict inside = both(isNotNegative(place.s), isNotNegative(place.t));
        return inside == Verdict::no ? inside : both(inside, isBetween(place.s + place.t, normalSquared));
    }

    /// Edges that pierce a face: their ends lie on both sides of the face's plane, or on it, and they pass
    /// inside the face's three edges. An edge within the plane is left to the other features.
    template <class Visitor>
    void visitPiercing(const std::array<Triple<Number>, 3>& edges, const std::array<Number, 3>& heights,
                       const std::array<Triple<Number>, 3>& faceEdges, bool edgesAreBs,
                       Visitor& visitor) const {
        for (int k = 0; k < 3 && !visitor.done(); ++k) {
            const Number &from = heights[k], &to = heights[(k + 1) % 3];
            const Verdict up = both(isNotNegative(from), isNotNegative(-to)),
                          down = both(isNotNegative(-from), isNotNegative(to));
            if ((up == Verdict::no && down == Verdict::no) || (up == Verdict::yes && down == Verdict::yes)) {
                continue;
            }
            std::array<Number, 3> volumes;
            Verdict left = Verdict::yes, right = Verdict::yes;
            for (int side = 0; side < 3; ++side) {
                const Triple<Number>& w = edgesAreBs ? between_[side][k] : between_[k][side];
                volumes[side] = w.dot(edges[k].cross(faceEdges[side]));
                left = both(left, isNotNegative(volumes[side]));
                right = both(right, isNotNegative(-volumes[side]));
            }
            if (left == Verdict::no && right == Verdict::no) continue;
            const Verdict crosses = up == Verdict::yes || down == Verdict::yes ? Verdict::yes : Verdict::open,
                          inside =
                              left == Verdict::yes || right == Verdict::yes ? Verdict::yes : Verdict::open;
            const Place through{0, volumes[2], volumes[0], volumes[0] + volumes[1] + volumes[2]},
                onEdge{k, from, 0, from - to};
            if (!visitor.wants(Number(0), Number(1))) continue;
            visitor.take(both(crosses, inside), -1, edgesAreBs ? through : onEdge,
                         edgesAreBs ? onEdge : through);
        }
    }

    template <class Visitor>
    void visitEdges(int i, int j, Visitor& visitor) const {
        const Triple<Number>&u = edgeA_[i], &v = edgeB_[j], &w = between_[i][j];
        const Triple<Number> n = u.cross(v);
        const Number height = w.dot(n), whole = n.dot(n);
        if (!visitor.wants(height * height, whole)) return;
        const Number s = w.cross(v).dot(n), t = w.cross(u).dot(n);
        visitor.take(both(isBetween(s, whole), isBetween(t, whole)), 3 * i + j, Place{i, s, 0, whole},
                     Place{j, t, 0, whole});
    }

    /// Corner j of b against edge i of a, and corner i of a against edge j of b.
    template <class Visitor>
    void visitCornerAndEdges(int i, int j, Visitor& visitor) const {
        const Triple<Number>& w = between_[i][j];
        const auto visitOne = [&](const Triple<Number>& edge, bool edgeIsAs) {
            const Triple<Number> away = w.cross(edge);
            const Number whole = edge.dot(edge);
            if (!visitor.wants(away.dot(away), whole)) return;
            const Number along = edgeIsAs ? w.dot(edge) : -w.dot(edge);
            const Place onEdge{edgeIsAs ? i : j, along, 0, whole};
            visitor.take(isBetween(along, whole), 3 * i + j, edgeIsAs ? onEdge : atCorner(i),
                         edgeIsAs ? atCorner(j) : onEdge);
        };
        visitOne(edgeA_[i], true);
        visitOne(edgeB_[j], false);
    }

    Corners a_, b_;
    std::array<Triple<Number>, 3> edgeA_, edgeB_;
    std::array<std::array<Triple<Number>, 3>, 3> between_;  ///< b's corner j - a's corner i
    Triple<Number> normalA_, normalB_;
    Number normalASquared_, normalBSquared_;
};

}  // namespace clearway
