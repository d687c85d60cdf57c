#include "mesh/read/polygon.h"

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <limits>

#include "exact/ball.h"

namespace clearway {
namespace {

/// Twice the vector area of a unit-size polygon below which it has no side: what rounding alone makes.
constexpr double kNoArea = 1e-14;
/// Distance from a line below which a polygon of unit size is a line.
constexpr double kNoWidth = 1e-12;

/// The outline of a polygon, seen along its normal. Corners go counter-clockwise.
class Outline {
  public:
    Outline(const std::vector<Vector3>& vertices, const std::uint32_t* corners, std::size_t count) {
        for (std::size_t i = 0; i < count; ++i) corners_.push_back(vertices[corners[i]]);
        Box box;
        for (const Vector3& corner : corners_) box.extend(corner);
        size_ = box.diagonal().norm();
        Vector3 mean = Vector3::Zero();
        for (const Vector3& corner : corners_) mean += (corner - box.min()) / double(count);
        for (std::size_t i = 0; i < count; ++i) {
            normal_ += scaled(corners_[i]).cross(scaled(corners_[(i + 1) % count]));
        }
        const Vector3 direction = normal_.normalized();
        const Vector3 x = direction.unitOrthogonal(), y = direction.cross(x);
        for (const Vector3& corner : corners_) {
            const Vector3 from = corner - box.min();
            height_ = std::max(height_, std::abs(direction.dot(from - mean)));
            flat_.push_back({x.dot(from), y.dot(from)});
        }
    }

    double size() const { return size_; }
    double height() const { return height_; }
    bool hasArea() const { return normal_.norm() > kNoArea; }

    bool isFinite() const {
        return std::isfinite(size_) &&
               std::all_of(corners_.begin(), corners_.end(), [](const Vector3& v) { return v.allFinite(); });
    }

    bool isLine() const {
        if (size_ == 0) return true;
        Vector3 longest = Vector3::Zero();
        for (const Vector3& corner : corners_) {
            if (scaled(corner).squaredNorm() > longest.squaredNorm()) longest = scaled(corner);
        }
        return std::all_of(corners_.begin(), corners_.end(), [&](const Vector3& corner) {
            return scaled(corner).cross(longest).norm() <= kNoWidth;
        });
    }

    /// 1 if corner c is left of the line from a to b, -1 if it is right of it, 0 on it; exact.
    int side(std::size_t a, std::size_t b, std::size_t c) const {
        const Vector3 u = corners_[b] - corners_[a], v = corners_[c] - corners_[a];
        const Vector3 left(u.y() * v.z(), u.z() * v.x(), u.x() * v.y());
        const Vector3 right(u.z() * v.y(), u.x() * v.z(), u.y() * v.x());
        const double value = normal_.dot(left - right);
        const double error =
            kRelativeError * normal_.cwiseAbs().dot(left.cwiseAbs() + right.cwiseAbs()) + kLeast;
        if (std::abs(value) > error && std::isfinite(error)) return value > 0 ? 1 : -1;
        return exactSide(a, b, c);
    }

    /// Whether the boxes around two sets of corners, as they are seen, are apart.
    template <std::size_t m, std::size_t n>
    bool areApart(const std::array<std::size_t, m>& a, const std::array<std::size_t, n>& b) const {
        for (int axis = 0; axis < 2; ++axis) {
            if (least(a, axis) > most(b, axis) || least(b, axis) > most(a, axis)) return true;
        }
        return false;
    }

    /// Whether edges cross, each from one side of the other to the other side. By less than rounding to six digits, they may only touch.
    enum class Crossing { none, touching, crossing };
    Crossing crossing() const {
        const std::size_t count = corners_.size();
        std::vector<std::array<std::size_t, 2>> edges;
        for (std::size_t i = 0; i < count; ++i) edges.push_back({i, (i + 1) % count});
        std::sort(edges.begin(), edges.end(),
                  [&](const auto& a, const auto& b) { return least(a, 0) < least(b, 0); });
        double deepest = 0;
        for (std::size_t i = 0; i < count; ++i) {
            const double end = most(edges[i], 0);
            for (std::size_t j = i + 1; j < count && least(edges[j], 0) <= end; ++j) {
                deepest = std::max(deepest, crossingDepth(edges[i], edges[j]));
                if (deepest > kTouching * size_) return Crossing::crossing;
            }
        }
        return deepest > 0 ? Crossing::touching : Crossing::none;
    }

    /// As side(), but 0 for a corner that rounding may have moved off the line.
    int roundedSide(std::size_t a, std::size_t b, std::size_t c) const {
        return offset({a, b}, c) <= kTouching * size_ ? 0 : side(a, b, c);
    }

  private:
    static constexpr double kRelativeError = 2e-15;  ///< of nine roundings and more
    static constexpr double kLeast = 1e-290;         ///< smaller products may have lost digits
    static constexpr double kTouching = 1e-6;        ///< share of the size
    static constexpr double kSlack = 1e-12;          ///< of flat coordinates, share of the size

    Vector3 scaled(const Vector3& corner) const { return (corner - corners_[0]) / (size_ > 0 ? size_ : 1); }

    template <std::size_t n>
    double least(const std::array<std::size_t, n>& corners, int axis) const {
        double value = flat_[corners[0]][axis];
        for (const std::size_t corner : corners) value = std::min(value, flat_[corner][axis]);
        return value - kSlack * size_;
    }

    template <std::size_t n>
    double most(const std::array<std::size_t, n>& corners, int axis) const {
        double value = flat_[corners[0]][axis];
        for (const std::size_t corner : corners) value = std::max(value, flat_[corner][axis]);
        return value + kSlack * size_;
    }

    /// How far the edge that reaches less far beyond the other one does so; 0 if they do not cross.
    double crossingDepth(const std::array<std::size_t, 2>& a, const std::array<std::size_t, 2>& b) const {
        if (a[0] == b[1] || a[1] == b[0] || areApart(a, b)) return 0;
        if (side(a[0], a[1], b[0]) * side(a[0], a[1], b[1]) >= 0) return 0;
        if (side(b[0], b[1], a[0]) * side(b[0], b[1], a[1]) >= 0) return 0;
        const double depth = std::min({offset(a, b[0]), offset(a, b[1]), offset(b, a[0]), offset(b, a[1])});
        return std::max(depth, std::numeric_limits<double>::min());
    }

    /// Distance of a corner from an edge's line, as they are seen; rounded.
    double offset(const std::array<std::size_t, 2>& edge, std::size_t corner) const {
        const auto &p = flat_[edge[0]], &q = flat_[edge[1]], &r = flat_[corner];
        const double x = q[0] - p[0], y = q[1] - p[1];
        return std::abs(x * (r[1] - p[1]) - y * (r[0] - p[0])) / std::hypot(x, y);
    }

    template <class Number>
    Triple<Number> numbers(const Vector3& point) const {
        return {Number(point.x()), Number(point.y()), Number(point.z())};
    }

    template <class Number>
    Number determinant(std::size_t a, std::size_t b, std::size_t c) const {
        const Triple<Number> from = numbers<Number>(corners_[a]);
        const Triple<Number> u = numbers<Number>(corners_[b]) - from, v = numbers<Number>(corners_[c]) - from;
        return numbers<Number>(normal_).dot(u.cross(v));
    }

    int exactSide(std::size_t a, std::size_t b, std::size_t c) const {
        const Ball near = determinant<Ball>(a, b, c);
        if (near.isZero()) return 0;
        if (leastOf(near) > 0) return 1;
        if (mostOf(near) < 0) return -1;
        return determinant<boost::multiprecision::cpp_rational>(a, b, c).sign();
    }

    std::vector<Vector3> corners_;
    std::vector<std::array<double, 2>> flat_;  ///< for boxes only: rounded
    Vector3 normal_ = Vector3::Zero();         ///< twice the vector area of the polygon at unit size
    double size_ = 0;
    double height_ = 0;
};

/// Cuts ears off an outline until a triangle is left.
class EarClipper {
  public:
    /// isRounded: corners count as on a line that they miss by no more than rounding.
    EarClipper(const Outline& outline, std::size_t count, bool isRounded)
        : outline_(outline), isRounded_(isRounded), next_(count), previous_(count), isLeft_(count, true) {
        for (std::size_t i = 0; i < count; ++i) {
            next_[i] = (i + 1) % count;
            previous_[i] = (i + count - 1) % count;
        }
        for (std::size_t i = 0; i < count; ++i) {
            if (!isConvex(i)) reflex_.push_back(i);
        }
    }

    /// Calls add(a, b, c) for each triangle. Returns false when no ear is left, as in an outline that crosses itself.
    template <class Add>
    bool run(const Add& add) {
        std::size_t corner = 1, refused = 0;
        bool takesFlat =
            false;  // corners on a line are left for the ears beside them, as long as there are any
        for (std::size_t left = next_.size(); left > 3;) {
            if (isEar(corner, takesFlat)) {
                add(previous_[corner], corner, next_[corner]);
                next_[previous_[corner]] = next_[corner];
                previous_[next_[corner]] = previous_[corner];
                isLeft_[corner] = false;
                --left;
                refused = 0;
                takesFlat = false;
            } else if (++refused == left) {
                if (takesFlat) return false;
                refused = 0;
                takesFlat = true;
            }
            corner = next_[corner];
        }
        if (sideOf(previous_[corner], corner, next_[corner]) < 0) return false;
        add(previous_[corner], corner, next_[corner]);
        return true;
    }

  private:
    bool isConvex(std::size_t corner) const { return sideOf(previous_[corner], corner, next_[corner]) > 0; }

    /// Only corners that are not convex can reach into an ear. Once convex, a corner stays so.
    bool isEar(std::size_t corner, bool takesFlat) {
        const std::array<std::size_t, 3> ear = {previous_[corner], corner, next_[corner]};
        const int turn = sideOf(ear[0], ear[1], ear[2]);
        if (turn <= 0) return turn == 0 && takesFlat;
        const auto isDone = [&](std::size_t i) { return !isLeft_[i] || isConvex(i); };
        for (std::size_t k = 0; k < reflex_.size();) {
            const std::size_t i = reflex_[k];
            const bool isNear = !outline_.areApart(ear, std::array<std::size_t, 1>{i});
            if ((isNear || !isLeft_[i]) && isDone(i)) {
                reflex_[k] = reflex_.back();
                reflex_.pop_back();
                continue;
            }
            if (isNear && i != corner && reachesInto(ear, i)) return false;
            ++k;
        }
        return true;
    }

    /// Whether the corner lies inside the triangle, or on its border with an edge that goes inside. Outlines touch themselves around holes,
    /// where corners coincide.
    bool reachesInto(const std::array<std::size_t, 3>& ear, std::size_t corner) const {
        std::array<int, 3> side{};
        for (std::size_t k = 0; k < 3; ++k) {
            side[k] = sideOf(ear[k], ear[(k + 1) % 3], corner);
            if (side[k] < 0) return false;
        }
        for (const std::size_t other : {previous_[corner], next_[corner]}) {
            bool goesInside = true;
            for (std::size_t k = 0; k < 3; ++k) {
                goesInside = goesInside && (side[k] > 0 || sideOf(ear[k], ear[(k + 1) % 3], other) > 0);
            }
            if (goesInside) return true;
        }
        return false;
    }

    int sideOf(std::size_t a, std::size_t b, std::size_t c) const {
        return isRounded_ ? outline_.roundedSide(a, b, c) : outline_.side(a, b, c);
    }

    const Outline& outline_;
    bool isRounded_;
    std::vector<std::size_t> next_, previous_;
    std::vector<char> isLeft_;
    std::vector<std::size_t> reflex_;  ///< the corners that may not be convex, in any order
};

bool isConvexQuad(const Outline& outline, std::size_t count) {
    return count == 4 && outline.side(0, 1, 2) > 0 && outline.side(1, 2, 3) > 0 &&
           outline.side(2, 3, 0) > 0 && outline.side(3, 0, 1) > 0;
}

}  // namespace

PolygonShape triangulate(const std::vector<Vector3>& vertices, const std::uint32_t* corners,
                         std::size_t count, std::vector<TriangleIndices>& triangles) {
    const auto add = [&](std::size_t a, std::size_t b, std::size_t c) {
        triangles.push_back({corners[a], corners[b], corners[c]});
    };
    const auto addFan = [&] {
        for (std::size_t i = 1; i + 1 < count; ++i) add(0, i, i + 1);
    };
    const Outline outline(vertices, corners, count);
    if (!outline.isFinite() || outline.isLine()) {  // the mesh's check refuses what is not finite
        addFan();
        return {};
    }
    PolygonShape shape{true, outline.height(), outline.size()};
    const std::size_t first = triangles.size();
    if (isConvexQuad(outline, count)) {
        addFan();
        return shape;
    }
    const Outline::Crossing found = outline.hasArea() ? outline.crossing() : Outline::Crossing::crossing;
    shape.isFilled = found != Outline::Crossing::crossing &&
                     EarClipper(outline, count, found == Outline::Crossing::touching).run(add);
    if (!shape.isFilled) triangles.resize(first);
    return shape;
}

}  // namespace clearway
