// Branch and bound for the largest |A v + b| over the vertices v. The length is convex, so within a volume it
// is largest at a corner of the rectangle, plus the radius as stretched by A. The farthest volume is opened
// first, until no other can matter.
#include "tree/largest_displacement.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace clearway {
namespace {

constexpr double kRoundedUp = 1 + 1e-12;  // a few 2^-53 for each step of the arithmetic

/// Rounding relative to the lengths that are added: 3 products and 3 sums for a row, and the differences in A
/// and b.
constexpr double kSumRounding = 0x1p-49;

/// The map v -> axis x v. It turns the part of v across the axis by 90 degrees and keeps that part's length.
struct AcrossAxis {
    const Vector3& axis;
    Vector3 shift = Vector3::Zero();
    double stretch = 1;
    Vector3 operator()(const Vector3& v) const { return axis.cross(v); }
};

/// The map v -> A v + b, the difference of two poses.
struct Difference {
    Matrix3 a;
    Vector3 shift;
    double stretch;  ///< at least |A x| / |x| for any x
    Vector3 operator()(const Vector3& v) const { return a * v; }
};

/// Largest |origin + A x| for x within one lane's volume, tree units. origin: the tree's origin after the
/// map.
template <class Map, int kWidth>
double largestWithin(const WideNode<kWidth>& node, int lane, const Map& map, const Vector3& origin) {
    const auto mapped = [&](const float(&rows)[3][kWidth]) {
        return map(Vector3(rows[0][lane], rows[1][lane], rows[2][lane]));
    };
    const Vector3 centre = origin + mapped(node.centre);
    const Vector3 side0 = node.halfLength0[lane] * mapped(node.axis0);
    const Vector3 side1 = node.halfLength1[lane] * mapped(node.axis1);
    // |centre +- side0 +- side1|^2; a corner and its opposite differ by the sign of the first two products.
    const double along0 = centre.dot(side0), along1 = centre.dot(side1), between = side0.dot(side1);
    const double largest = std::max(std::abs(along0 + along1) + between, std::abs(along0 - along1) - between);
    const double squares = centre.squaredNorm() + side0.squaredNorm() + side1.squaredNorm();
    return std::sqrt(std::max(0.0, squares + 2 * largest)) + map.stretch * node.radius[lane];
}

template <class Map, int kWidth>
class Search {
  public:
    Search(const FlatTree& tree, const Map& map, double excess, double cap)
        : tree_(tree),
          map_(map),
          excess_(excess),
          cap_(cap),
          origin_((map(tree.origin) + map.shift) / tree.unit),
          rounding_(kSumRounding * (map.stretch * tree.radiusAboutMeshOrigin + map.shift.norm())) {}

    double run() {
        open(0);
        return std::max(leftOut_, reached_) * kRoundedUp + rounding_;
    }

  private:
    struct Child {
        double bound;
        std::int32_t reference;
    };

    void open(std::int32_t nodeNumber) {
        const WideNode<kWidth>& node = tree_.nodes<kWidth>()[nodeNumber];
        std::array<Child, kWidth> children;
        int count = 0;
        for (; count < kWidth && node.child[count] != kNoChild; ++count) {
            const double largest = largestWithin(node, count, map_, origin_) * tree_.unit;
            const Child added{largest * kRoundedUp, node.child[count]};
            int place = count;
            for (; place > 0 && children[std::size_t(place - 1)].bound < added.bound; --place) {
                children[std::size_t(place)] = children[std::size_t(place - 1)];
            }
            children[std::size_t(place)] = added;
        }
        for (int i = 0; i < count; ++i) {
            const Child& child = children[std::size_t(i)];
            if (reached_ * (1 - kSumRounding) > cap_ + rounding_) return;
            if (child.bound <= reached_ * (1 + excess_)) {
                leftOut_ = std::max(leftOut_, child.bound);
                return;  // the bounds of the others are no larger
            }
            if (child.reference >= 0) {
                open(child.reference);
            } else {
                reach(tree_.leaf(LeafReference(~child.reference)));
            }
        }
    }

    void reach(const Leaf& leaf) {
        for (std::uint32_t i = 0; i < leaf.triangleCount; ++i) {
            for (const Vector3& corner : tree_.corners({leaf.at, i})) {
                reached_ = std::max(reached_, (map_(corner) + map_.shift).norm());
            }
        }
    }

    const FlatTree& tree_;
    const Map& map_;
    double excess_, cap_;
    Vector3 origin_;
    double rounding_;     ///< mesh units
    double reached_ = 0;  ///< by a vertex, mesh units
    double leftOut_ = 0;  ///< largest bound of the volumes that were not opened, mesh units
};

template <class Map>
double largest(const FlatTree& tree, const Map& map, double excess, double cap) {
    return withNodeWidth(tree.nodeWidth,
                         [&](auto width) { return Search<Map, width>(tree, map, excess, cap).run(); });
}

}  // namespace

double radiusAboutAxis(const FlatTree& tree, const Vector3& unitDirection) {
    return largest(tree, AcrossAxis{unitDirection}, kAxisRadiusExcess,
                   std::numeric_limits<double>::infinity());
}

double largestDisplacement(const FlatTree& tree, const Pose& from, const Pose& to, double cap) {
    const Difference difference{to.rotation - from.rotation, to.translation - from.translation,
                                (to.rotation - from.rotation).norm()};
    return largest(tree, difference, kDisplacementExcess, cap);
}

}  // namespace clearway
