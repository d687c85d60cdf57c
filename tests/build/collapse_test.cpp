#include "build/collapse.h"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <set>

#include "build/build.h"
#include "build/sample_meshes.h"

namespace clearway::testing {
BOOST_AUTO_TEST_SUITE(collapse_test)

/// A binary tree of random shape over single triangles, with random areas that shrink from parent to child.
BinaryTree randomTree(Random& random, int leaves) {
    BinaryTree tree;
    tree.nodes.emplace_back();
    tree.nodes[0].triangleCount = static_cast<std::uint32_t>(leaves);
    tree.nodes[0].area = 1;
    for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
        const BinaryNode node = tree.nodes[i];
        if (node.triangleCount == 1) continue;
        BinaryNode left, right;
        left.firstTriangle = node.firstTriangle;
        left.triangleCount =
            1 + static_cast<std::uint32_t>(random.below(static_cast<int>(node.triangleCount) - 1));
        right.firstTriangle = left.firstTriangle + left.triangleCount;
        right.triangleCount = node.triangleCount - left.triangleCount;
        left.area = node.area * static_cast<float>(random.uniform(0.1, 1));
        right.area = node.area * static_cast<float>(random.uniform(0.1, 1));
        tree.nodes[i].left = static_cast<std::int32_t>(tree.nodes.size());
        tree.nodes[i].right = tree.nodes[i].left + 1;
        tree.nodes.push_back(left);
        tree.nodes.push_back(right);
    }
    for (int i = 0; i < leaves; ++i) tree.order.push_back(static_cast<std::uint32_t>(i));
    return tree;
}

std::vector<std::int32_t> lanesOf(const Collapse& collapse, std::int32_t node) {
    Collapse::Lanes lanes;
    const int count = collapse.lanesOf(node, lanes);
    return {lanes.begin(), lanes.begin() + count};
}

/// The cost of one wide node.
double costOf(const BinaryTree& tree, std::int32_t node) {
    return double(tree.nodes[node].area) / tree.nodes[0].area + 1.0 / double(tree.order.size());
}

/// The cost of a leaf.
double costAsLeaf(const BinaryTree& tree, std::int32_t node) {
    return double(tree.nodes[node].costAsLeaf) / tree.nodes[0].area;
}

/// Tries every way to cut the tree below a wide node. forest: the nodes in its lanes so far; those from
/// `next` on may still be opened.
double leastCost(const BinaryTree& tree, int lanes, std::int32_t node);
double leastOverForests(const BinaryTree& tree, int lanes, std::vector<std::int32_t> forest,
                        std::size_t next) {
    if (next == forest.size()) {
        double cost = 0;
        for (const std::int32_t lane : forest) cost += leastCost(tree, lanes, lane);
        return cost;
    }
    double least = leastOverForests(tree, lanes, forest, next + 1);
    const BinaryNode& node = tree.nodes[forest[next]];
    if (!node.isLeaf() && forest.size() < std::size_t(lanes)) {
        forest[next] = node.left;
        forest.insert(forest.begin() + next + 1, node.right);
        least = std::min(least, leastOverForests(tree, lanes, forest, next));
    }
    return least;
}
double leastCost(const BinaryTree& tree, int lanes, std::int32_t index) {
    const BinaryNode& node = tree.nodes[index];
    if (node.isLeaf()) return costAsLeaf(tree, index);
    const double divided = costOf(tree, index) + leastOverForests(tree, lanes, {node.left, node.right}, 0);
    return node.costAsLeaf > 0 ? std::min(divided, costAsLeaf(tree, index)) : divided;
}

/// The cost of the wide nodes that lanesOf leads to; checks that they hold every leaf once.
double collapsedCost(const BinaryTree& tree, int lanes, const Collapse& collapse) {
    double cost = 0;
    std::multiset<std::uint32_t> leaves;
    std::vector<std::int32_t> pending{0};
    while (!pending.empty()) {
        const std::int32_t wide = pending.back();
        pending.pop_back();
        cost += costOf(tree, wide);
        const std::vector<std::int32_t> children = lanesOf(collapse, wide);
        BOOST_TEST((children.size() >= 2 && children.size() <= std::size_t(lanes)));
        for (const std::int32_t child : children) {
            const BinaryNode& node = tree.nodes[child];
            if (collapse.isLeaf(child)) {
                cost += costAsLeaf(tree, child);
                BOOST_TEST((node.isLeaf() || node.costAsLeaf > 0));
                for (std::uint32_t i = 0; i < node.triangleCount; ++i) leaves.insert(node.firstTriangle + i);
            } else {
                pending.push_back(child);
            }
        }
    }
    BOOST_TEST((leaves == std::multiset<std::uint32_t>(tree.order.begin(), tree.order.end())));
    return cost;
}

BOOST_AUTO_TEST_CASE(no_other_cut_costs_less) {
    constexpr std::uint64_t kSeed = 91;
    BOOST_TEST_CONTEXT("seed " << kSeed) {
        Random random(kSeed);
        for (int round = 0; round < 300; ++round) {
            BinaryTree tree = randomTree(random, 2 + random.below(9));
            if (round % 2 == 1) {  // small nodes may become leaves
                for (std::size_t i = 1; i < tree.nodes.size(); ++i) {
                    BinaryNode& node = tree.nodes[i];
                    if (node.triangleCount <= 4)
                        node.costAsLeaf = static_cast<float>(random.uniform(0, 0.5)) * node.area;
                }
            }
            for (const int lanes : {2, 3, 4, 8}) {
                const Collapse collapse(tree, lanes);
                const double least = leastCost(tree, lanes, 0);
                BOOST_TEST(collapsedCost(tree, lanes, collapse) == least, boost::test_tools::tolerance(1e-5));
                BOOST_TEST(collapse.cost() == least, boost::test_tools::tolerance(1e-5));
            }
        }
    }
}

BOOST_AUTO_TEST_CASE(eight_leaves_fill_one_node) {
    Random random(92);
    const BinaryTree tree = randomTree(random, 8);
    BOOST_TEST(lanesOf(Collapse(tree, 8), 0).size() == 8u);
}

BOOST_AUTO_TEST_CASE(trees_without_extent_and_of_any_scale_collapse) {
    Random random(93);
    for (const float scale : {0.0f, 0x1p100f, 0x1p-60f}) {
        BinaryTree tree = randomTree(random, 100);
        const std::vector<std::int32_t> unscaled = lanesOf(Collapse(tree, 8), 0);
        for (BinaryNode& node : tree.nodes) node.area *= scale;
        const Collapse collapse(tree, 8);
        if (scale > 0) BOOST_TEST((lanesOf(collapse, 0) == unscaled));
        std::size_t leaves = 0;
        std::vector<std::int32_t> pending{0};
        while (!pending.empty()) {
            const std::int32_t wide = pending.back();
            pending.pop_back();
            for (const std::int32_t child : lanesOf(collapse, wide)) {
                tree.nodes[child].isLeaf() ? void(++leaves) : pending.push_back(child);
            }
        }
        BOOST_TEST(leaves == 100u);
    }
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::testing
