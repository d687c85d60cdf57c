// Branch and bound: the distance from a line is convex, so a volume's largest is at a corner of its
// rectangle, plus its radius. The farthest volume is opened first, until no other can matter.
#include "tree/radius_about_axis.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace clearway {
namespace {

constexpr double kRoundedUp = 1 + 1e-12;    // a few 2^-53 for each step of the arithmetic
constexpr double kCrossRounding = 0x1p-49;  // of a vertex's length: 3 in 2^-53 for a cross product, the axis'

/// The largest distance from the axis within one lane's volume, tree units. origin: of the tree, as
/// axis x origin, tree units. (Vectors from the axis turn by 90 degrees in a cross product with it, their
/// lengths stay.)
template <int kWidth>
double largestDistance(const WideNode<kWidth>& node, int lane, const Vector3& axis, const Vector3& origin) {
    const auto across = [&](const float(&rows)[3][kWidth]) {
        return axis.cross(Vector3(rows[0][lane], rows[1][lane], rows[2][lane])).eval();
    };
    const Vector3 centre = origin + across(node.centre);
    const Vector3 side0 = node.halfLength0[lane] * across(node.axis0);
    const Vector3 side1 = node.halfLength1[lane] * across(node.axis1);
    // |centre +- side0 +- side1|^2; a corner and its opposite differ by the sign of the first two products.
    const double along0 = centre.dot(side0), along1 = centre.dot(side1), between = side0.dot(side1);
    const double largest = std::max(std::abs(along0 + along1) + between, std::abs(along0 - along1) - between);
    const double squares = centre.squaredNorm() + side0.squaredNorm() + side1.squaredNorm();
    return std::sqrt(std::max(0.0, squares + 2 * largest)) + node.radius[lane];
}

template <int kWidth>
class Search {
  public:
    Search(const FlatTree& tree, const Vector3& axis)
        : tree_(tree),
          axis_(axis),
          unit_(std::ldexp(1.0, tree.unitExponent)),
          origin_(axis.cross(tree.origin) / unit_) {}

    double run() {
        open(0);
        return std::max(leftOut_, reached_) * kRoundedUp + kCrossRounding * tree_.radiusAboutMeshOrigin;
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
            const Child added{largestDistance(node, count, axis_, origin_) * unit_ * kRoundedUp,
                              node.child[count]};
            int place = count;
            for (; place > 0 && children[std::size_t(place - 1)].bound < added.bound; --place) {
                children[std::size_t(place)] = children[std::size_t(place - 1)];
            }
            children[std::size_t(place)] = added;
        }
        for (int i = 0; i < count; ++i) {
            const Child& child = children[std::size_t(i)];
            if (child.bound <= reached_ * (1 + kAxisRadiusExcess)) {
                leftOut_ = std::max(leftOut_, child.bound);
                return;  // so are the others
            }
            if (child.reference >= 0) {
                open(child.reference);
            } else {
                reach(tree_.leaves[std::size_t(~child.reference)]);
            }
        }
    }

    void reach(const Leaf& leaf) {
        for (std::uint32_t i = 0; i < leaf.triangleCount; ++i) {
            for (const std::uint32_t vertex : tree_.triangles[leaf.firstTriangle + i]) {
                reached_ = std::max(reached_, axis_.cross(tree_.vertices[vertex]).norm());
            }
        }
    }

    const FlatTree& tree_;
    const Vector3& axis_;
    double unit_;
    Vector3 origin_;
    double reached_ = 0;  ///< by a vertex, mesh units
    double leftOut_ = 0;  ///< largest bound of the volumes that were not opened, mesh units
};

}  // namespace

double radiusAboutAxis(const FlatTree& tree, const Vector3& unitDirection) {
    if (tree.nodeWidth == 2) return Search<2>(tree, unitDirection).run();
    return Search<8>(tree, unitDirection).run();
}

}  // namespace clearway
