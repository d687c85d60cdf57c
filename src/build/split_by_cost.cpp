// CostSplit: the faces of a sheet cost less as two flat leaves than as one slab, around whose rim a rectangle swept sphere is round
// and holds much that is not near to the triangles. Each group becomes a tree over the parts that cost least. The collapse decides
// which of its nodes become leaves, because more leaves take more lanes of wide nodes.
#include <algorithm>
#include <memory>
#include <vector>

#include "build/leaf_splits.h"
#include "build/rate_nodes.h"
#include "core/parallel.h"
#include "tree/normalisation.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "build/split_by_cost.cpp"
#include "hwy/foreach_target.h"  // must come before highway.h

#include "build/part_costs-inl.h"
#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace clearway {
namespace HWY_NAMESPACE {

class CostSplit {
  public:
    CostSplit(BinaryTree& tree, const CleanMesh& mesh)
        : tree_(tree), mesh_(mesh), inverseUnit_(normalisationOf(mesh.vertices).inverseUnit) {
        const BinaryNode& root = tree.nodes.front();
        costOfOneMore_ = root.isLeaf() ? 0 : root.area / static_cast<float>(tree.order.size());
    }

    void run() {
        std::vector<std::size_t> leaves;
        for (std::size_t i = 0; i < tree_.nodes.size(); ++i) {
            if (tree_.nodes[i].isLeaf()) leaves.push_back(i);
        }
        constexpr std::size_t kLeavesAtATime = 64 * kLaneBlock;
        std::vector<LargeVector<BinaryNode>> below((leaves.size() + kLeavesAtATime - 1) / kLeavesAtATime);
        const auto endOf = [&](std::size_t task) {
            return std::min(leaves.size(), (task + 1) * kLeavesAtATime);
        };
        forEachInParallel(below.size(), [&](std::size_t task) {
            const auto costs = std::make_unique<PartCosts>();
            for (std::size_t i = task * kLeavesAtATime; i < endOf(task); i += kLaneBlock)
                split(leaves.data() + i, std::min(kLaneBlock, endOf(task) - i), *costs, below[task]);
        });
        for (std::size_t task = 0; task < below.size(); ++task) {
            const auto shift = static_cast<std::int32_t>(tree_.nodes.size());
            for (std::size_t i = task * kLeavesAtATime; i < endOf(task); ++i)
                shiftChildren(tree_.nodes[leaves[i]], shift);
            for (BinaryNode& node : below[task]) shiftChildren(node, shift);
            tree_.nodes.insert(tree_.nodes.end(), below[task].begin(), below[task].end());
        }
    }

  private:
    /// Weight of a leaf's cost against the areas of wide nodes. A larger weight divides more: 0.67 saves 1 % of the triangle tests in tunnels and
    /// takes 3 % more memory there.
    static constexpr float kCostOfLeaves = 0.5f;

    static void shiftChildren(BinaryNode& node, std::int32_t shift) {
        if (node.isLeaf()) return;
        node.left += shift;
        node.right += shift;
    }

    /// A group's cheapest division into two, for each of its parts.
    struct Group {
        const PartCosts& costs;
        std::size_t lane;
        std::uint32_t triangles[kMostByCost];
        Part left[kParts] = {};  ///< 0 for a part that costs least as one leaf
    };

    /// below: gets the new nodes, whose children are indices into it.
    void split(const std::size_t* leaves, std::size_t count, PartCosts& costs,
               LargeVector<BinaryNode>& below) {
        for (std::size_t lane = 0; lane < kLaneBlock; ++lane)
            gather(tree_.nodes[leaves[lane < count ? lane : 0]], lane, costs);
        costs.rate();
        for (std::size_t lane = 0; lane < count; ++lane) {
            BinaryNode& leaf = tree_.nodes[leaves[lane]];
            Group group = {costs, lane, {}, {}};
            std::copy_n(tree_.order.begin() + leaf.firstTriangle, leaf.triangleCount, group.triangles);
            const Part all = (1u << leaf.triangleCount) - 1;
            chooseDivisions(all, group);
            place(leaf, all, group, below);
        }
    }

    void gather(const BinaryNode& leaf, std::size_t lane, PartCosts& costs) const {
        const auto corner = [&](std::size_t triangle, std::size_t number) -> const Vector3& {
            return mesh_.vertices[mesh_.triangles[tree_.order[leaf.firstTriangle + triangle]][number]];
        };
        double corners[kMostByCost][3][3];
        const Vector3& origin = corner(0, 0);
        for (std::size_t t = 0; t < leaf.triangleCount; ++t) {
            for (std::size_t c = 0; c < 3; ++c) {
                const Vector3& point = corner(t, c);
                for (int k = 0; k < 3; ++k) corners[t][c][k] = (point[k] - origin[k]) * inverseUnit_;
            }
        }
        costs.set(lane, corners, leaf.triangleCount);
    }

    /// Tries each division once: its left part holds the last triangle.
    static void chooseDivisions(Part all, Group& group) {
        float least[kParts];
        for (Part part = 1; part <= all; ++part) {  // smaller parts come before those they are in
            least[part] = group.costs.cost(part, group.lane);
            for (Part left = (part - 1) & part; left > (part ^ left); left = (left - 1) & part) {
                const float cost = least[left] + least[part ^ left];
                if (!(cost < least[part])) continue;
                least[part] = cost;
                group.left[part] = left;
            }
        }
    }

    /// Makes a node of a part, and nodes of those that it is divided into.
    void place(BinaryNode& node, Part part, const Group& group, LargeVector<BinaryNode>& below) {
        const float unit = group.costs.unit(group.lane);
        node.costAsLeaf = kCostOfLeaves * group.costs.cost(part, group.lane) * unit + costOfOneMore_;
        const Part left = group.left[part];
        if (left == 0) {
            std::uint32_t* place = tree_.order.data() + node.firstTriangle;
            for (std::size_t t = 0; t < kMostByCost; ++t) {
                if (isIn(part, t)) *place++ = group.triangles[t];
            }
            return;
        }
        node.area = group.costs.area(part, group.lane) * unit;
        std::uint32_t leftCount = 0;
        for (Part rest = left; rest != 0; rest = withoutFirst(rest)) ++leftCount;
        const std::size_t first = below.size();
        node.left = static_cast<std::int32_t>(first);
        node.right = static_cast<std::int32_t>(first + 1);
        BinaryNode children[2];
        children[0].axes = children[1].axes = node.axes;
        children[0].firstTriangle = node.firstTriangle;
        children[0].triangleCount = leftCount;
        children[1].firstTriangle = node.firstTriangle + leftCount;
        children[1].triangleCount = node.triangleCount - leftCount;
        below.resize(first + 2);
        place(children[0], left, group, below);
        place(children[1], part ^ left, group, below);
        std::copy(children, children + 2, below.begin() + static_cast<std::ptrdiff_t>(first));
    }

    BinaryTree& tree_;
    const CleanMesh& mesh_;
    const double inverseUnit_;
    float
        costOfOneMore_;  ///< of each further leaf: the root's area / triangles, as the collapse adds for each wide node
};

void SplitByCost(BinaryTree& tree, const CleanMesh& mesh) {
    CostSplit(tree, mesh).run();
}

}  // namespace HWY_NAMESPACE
}  // namespace clearway
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace clearway {

HWY_EXPORT(SplitByCost);

void splitByCost(BinaryTree& tree, const CleanMesh& mesh, GeneralSplit general) {
    const auto isLarge = [](const BinaryNode& node) {
        return node.isLeaf() && node.triangleCount > kMostByCost;
    };
    if (std::any_of(tree.nodes.begin(), tree.nodes.end(), isLarge))
        splitEachGroup(tree, mesh, general, splitIntoSmallGroups);
    rateNodes(tree, mesh);  // costs are weighed against the areas of wide nodes
    HWY_DYNAMIC_DISPATCH(SplitByCost)(tree, mesh);
}

}  // namespace clearway

#endif  // HWY_ONCE
