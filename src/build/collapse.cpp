#include "build/collapse.h"

#include <cassert>

namespace clearway {

namespace {

/// In units of the root's, whatever the mesh's scale. 1 where the root is a point.
double shareOfRoot(const BinaryTree& tree, std::int32_t node) {
    const double unit = tree.nodes.front().volume.longestExtent();
    const auto area = [unit](Rss volume) {
        volume.halfLength0 /= unit;
        volume.halfLength1 /= unit;
        volume.radius /= unit;
        return volume.area();
    };
    const double share = area(tree.nodes[node].volume) / area(tree.nodes.front().volume);
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
    if (node.isLeaf()) return;  // takes one lane and costs no wide node
    const Choice& left = choices_[node.left];
    const Choice& right = choices_[node.right];
    Choice& choice = choices_[index];
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
    // What is added for each node fills lanes where hardly a query comes: it costs 1 % of the visits less
    // than nothing, and saves 2 bytes a triangle.
    const double perNode = 1.0 / static_cast<double>(tree_.order.size());
    choice.cost[0] = choice.cost[lanes_ - 1] + static_cast<float>(shareOfRoot(tree_, index) + perNode);
    choice.leftLanes[0] = choice.leftLanes[lanes_ - 1];
    for (int lanes = 2; lanes <= lanes_; ++lanes) {
        if (choice.cost[lanes - 2] > choice.cost[lanes - 1]) continue;
        choice.cost[lanes - 1] = choice.cost[lanes - 2];
        choice.leftLanes[lanes - 1] = 0;
    }
}

std::vector<std::int32_t> Collapse::lanesOf(std::int32_t index) const {
    const BinaryNode& node = tree_.nodes[index];
    const int leftLanes = choices_[index].leftLanes[0];
    std::vector<std::int32_t> result;
    appendLanes(node.left, leftLanes, result);
    appendLanes(node.right, lanes_ - leftLanes, result);
    return result;
}

void Collapse::appendLanes(std::int32_t index, int lanes, std::vector<std::int32_t>& result) const {
    const Choice& choice = choices_[index];
    while (lanes > 1 && choice.leftLanes[lanes - 1] == 0) --lanes;
    if (lanes == 1) {
        result.push_back(index);
        return;
    }
    const int leftLanes = choice.leftLanes[lanes - 1];
    appendLanes(tree_.nodes[index].left, leftLanes, result);
    appendLanes(tree_.nodes[index].right, lanes - leftLanes, result);
}

}  // namespace clearway
