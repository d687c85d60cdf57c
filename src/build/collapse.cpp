// The dynamic programming goes from the leaves up; the lanes are then read off from the root down.
#include "build/collapse.h"

#include <cassert>
#include <cstddef>

namespace clearway {

namespace {

/// A node's area, or cost, as a share of the root's area; 1 if the root is a point.
float shareOfRoot(const BinaryTree& tree, float area) {
    const float share = area / tree.nodes.front().area;
    return share >= 0 ? share : 1;  // 1 for NaN
}

}  // namespace

Collapse::Collapse(const BinaryTree& tree, int lanes)
    : tree_(tree), lanes_(lanes), choices_(tree.nodes.size()) {
    assert(lanes >= 2 && lanes <= kMostLanes);
    // Children come after their parents.
    for (std::size_t i = tree.nodes.size(); i-- > 0;) choose(static_cast<std::int32_t>(i));
}

void Collapse::choose(std::int32_t index) {
    const BinaryNode& node = tree_.nodes[index];
    Choice& choice = choices_[index];
    const float asLeaf = node.costAsLeaf > 0 ? shareOfRoot(tree_, node.costAsLeaf) : 0;
    if (node.isLeaf()) {  // takes one lane and costs no wide node
        choice.cost.fill(asLeaf);
        return;
    }
    const Choice& left = choices_[node.left];
    const Choice& right = choices_[node.right];
    for (int lanes = 2; lanes <= lanes_; ++lanes) {
        float& least = choice.cost[lanes - 1];
        for (int k = 1; k < lanes; ++k) {
            const float cost = left.cost[k - 1] + right.cost[lanes - k - 1];
            if (k == 1 || cost < least) {
                least = cost;
                choice.leftLanes[lanes - 1] = static_cast<std::int8_t>(k);
            }
        }
    }
    // The amount added for each node fills the lanes of nodes that queries hardly visit. It saves 1 % of the
    // visits and 2 bytes a triangle.
    const float perNode = 1.0f / static_cast<float>(tree_.order.size());
    choice.cost[0] = choice.cost[lanes_ - 1] + shareOfRoot(tree_, node.area) + perNode;
    choice.leftLanes[0] = choice.leftLanes[lanes_ - 1];
    if (node.costAsLeaf > 0 && asLeaf <= choice.cost[0]) {
        choice.cost[0] = asLeaf;
        choice.leftLanes[0] = 0;
    }
    for (int lanes = 2; lanes <= lanes_; ++lanes) {
        if (choice.cost[lanes - 2] > choice.cost[lanes - 1]) continue;
        choice.cost[lanes - 1] = choice.cost[lanes - 2];
        choice.leftLanes[lanes - 1] = 0;
    }
}

int Collapse::lanesOf(std::int32_t index, Lanes& lanes) const {
    const BinaryNode& node = tree_.nodes[index];
    const int leftLanes = choices_[index].leftLanes[0];
    int count = 0;
    appendLanes(node.left, leftLanes, lanes, count);
    appendLanes(node.right, lanes_ - leftLanes, lanes, count);
    return count;
}

void Collapse::appendLanes(std::int32_t index, int most, Lanes& lanes, int& count) const {
    const Choice& choice = choices_[index];
    while (most > 1 && choice.leftLanes[most - 1] == 0) --most;
    if (most == 1) {
        lanes[count++] = index;
        return;
    }
    const int leftLanes = choice.leftLanes[most - 1];
    appendLanes(tree_.nodes[index].left, leftLanes, lanes, count);
    appendLanes(tree_.nodes[index].right, most - leftLanes, lanes, count);
}

}  // namespace clearway
