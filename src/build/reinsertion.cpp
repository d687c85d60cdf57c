// The volume of a node is, while it is searched for a place, a box with nine slabs: unions are then minima, and an area is cheap.
// Its area is the least of four boxes, whose axes are pairs and sums of those of the model.
#include "build/reinsertion.h"

#include <algorithm>
#include <vector>

#include "build/top_down.h"
#include "core/hash.h"
#include "core/parallel.h"
#include "tree/normalisation.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "build/reinsertion.cpp"
#include "hwy/foreach_target.h"  // must come before highway.h

#include "build/frames-inl.h"
#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace clearway {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// A box in each of four lanes: along x, y, z; z, x + y, x - y; y, x + z, x - z; x, y + z, y - z. Of each of its sides the least
/// place and the negated greatest.
struct Slabs {
    alignas(16) float low[3][4];
    alignas(16) float negatedHigh[3][4];
};

using BoxLanes = hn::CappedTag<float, 4>;

/// Half the area of the smallest of the four boxes around two nodes.
HWY_INLINE float AreaOfUnion(const Slabs& a, const Slabs& b) {
    const BoxLanes d;
    float least = kInfinity;
    for (std::size_t k = 0; k < 4; k += hn::Lanes(d)) {
        const auto side = [&](int i) HWY_ATTR {  // negated; the products are those of the sides
            return hn::Add(hn::Min(hn::Load(d, a.low[i] + k), hn::Load(d, b.low[i] + k)),
                           hn::Min(hn::Load(d, a.negatedHigh[i] + k), hn::Load(d, b.negatedHigh[i] + k)));
        };
        const auto x = side(0), y = side(1), z = side(2);
        least = std::min(least, LeastOf(d, hn::Add(hn::Mul(x, hn::Add(y, z)), hn::Mul(y, z))));
    }
    return least;
}

HWY_INLINE void Enlarge(Slabs& slabs, const Slabs& by) {
    const BoxLanes d;
    for (int i = 0; i < 3; ++i) {
        for (std::size_t k = 0; k < 4; k += hn::Lanes(d)) {
            hn::Store(hn::Min(hn::Load(d, slabs.low[i] + k), hn::Load(d, by.low[i] + k)), d,
                      slabs.low[i] + k);
            hn::Store(hn::Min(hn::Load(d, slabs.negatedHigh[i] + k), hn::Load(d, by.negatedHigh[i] + k)), d,
                      slabs.negatedHigh[i] + k);
        }
    }
}

class Reinsertion {
  public:
    Reinsertion(const BinaryTree& tree, const CleanMesh& mesh)
        : tree_(tree), mesh_(mesh), normalised_(normalisationOf(mesh.vertices)) {}

    void run() {
        makeUpperNodes();
        const auto count = static_cast<std::int32_t>(nodes_.size());
        for (std::int32_t node = count; node-- > 0;) {
            if (node == root_) continue;
            const std::int32_t place = bestPlace(node);
            if (place >= 0) move(node, place);
        }
    }

    /// Notes what is below each node now. Returns the most nodes from the root to a subtree that was not looked into.
    int noteContents() {
        contents_.assign(nodes_.size(), 0);
        int deepest = 0;
        struct Pending {
            std::int32_t node;
            int depth;
        };
        std::vector<Pending> pending{{root_, 1}};
        std::vector<std::int32_t> preorder;
        while (!pending.empty()) {
            const auto [index, depth] = pending.back();
            pending.pop_back();
            preorder.push_back(index);
            deepest = std::max(deepest, depth);
            if (nodes_[index].left < 0) continue;
            pending.push_back({nodes_[index].right, depth + 1});
            pending.push_back({nodes_[index].left, depth + 1});
        }
        for (auto index = preorder.rbegin(); index != preorder.rend(); ++index) {
            const Node& node = nodes_[*index];
            contents_[*index] = node.left < 0 ? node.content : contents_[node.left] + contents_[node.right];
        }
        return deepest;
    }

    /// The tree with all subtrees in their new places, after noteContents.
    BinaryTree result() {
        BinaryTree result;
        result.nodes.reserve(tree_.nodes.size());
        result.order.reserve(tree_.order.size());
        struct Pending {
            std::int32_t upper;   ///< -1 for a node below
            std::int32_t source;  ///< the binary node that it was
            std::int32_t parent;  ///< in the result
            bool isLeft;
        };
        std::vector<Pending> pending{{root_, nodes_[root_].source, -1, false}};
        while (!pending.empty()) {
            const Pending next = pending.back();
            pending.pop_back();
            const auto index = static_cast<std::int32_t>(result.nodes.size());
            const BinaryNode& source = tree_.nodes[next.source];
            BinaryNode node = source;
            node.firstTriangle = static_cast<std::uint32_t>(result.order.size());
            if (next.parent >= 0)
                (next.isLeft ? result.nodes[next.parent].left : result.nodes[next.parent].right) = index;
            if (next.upper >= 0 && nodes_[next.upper].left >= 0) {
                const Node& upper = nodes_[next.upper];
                if (contents_[next.upper] != upper.content) node.area = kNotRated;
                pending.push_back({upper.right, nodes_[upper.right].source, index, false});
                pending.push_back({upper.left, nodes_[upper.left].source, index, true});
            } else if (source.isLeaf()) {
                const auto first = tree_.order.begin() + source.firstTriangle;
                result.order.insert(result.order.end(), first, first + source.triangleCount);
            } else {
                pending.push_back({-1, source.right, index, false});
                pending.push_back({-1, source.left, index, true});
            }
            result.nodes.push_back(node);
        }
        for (std::size_t i = result.nodes.size(); i-- > 0;) {
            BinaryNode& node = result.nodes[i];
            if (!node.isLeaf()) {
                node.triangleCount =
                    result.nodes[node.left].triangleCount + result.nodes[node.right].triangleCount;
            }
        }
        return result;
    }

  private:
    struct alignas(64) Node {
        Slabs slabs;
        float area;
        std::int32_t left = -1, right = -1;  ///< -1 for a subtree that is not looked into
        std::int32_t parent = -1;
        std::int32_t source = 0;    ///< the binary node that this node was
        std::uint64_t content = 0;  ///< a sum of hashes over the subtrees that were below it
    };

    void makeUpperNodes() {
        nodes_.reserve(1 + tree_.nodes.size() / 2);
        nodes_.emplace_back();
        std::vector<std::int32_t> pending{0};  // depth first, so that neighbours lie together
        while (!pending.empty()) {
            const std::int32_t i = pending.back();
            pending.pop_back();
            const BinaryNode& source = tree_.nodes[nodes_[i].source];
            if (source.isLeaf() || source.triangleCount <= kLargestMovedWhole) {
                nodes_[i].content = mixed(std::uint64_t(i) + 1);
                continue;
            }
            const auto addChild = [&](std::int32_t from) {
                Node child;
                child.parent = i;
                child.source = from;
                nodes_.push_back(child);
                return static_cast<std::int32_t>(nodes_.size()) - 1;
            };
            const std::int32_t left = addChild(source.left), right = addChild(source.right);
            nodes_[i].left = left;
            nodes_[i].right = right;
            pending.push_back(right);
            pending.push_back(left);
        }
        constexpr std::size_t kNodesAtATime = 1024;
        forEachRun(nodes_.size(), kNodesAtATime, [&](std::size_t first, std::size_t last) {
            for (std::size_t i = first; i < last; ++i) {
                if (nodes_[i].left < 0) nodes_[i].slabs = slabsOf(tree_.nodes[nodes_[i].source]);
            }
        });
        for (std::size_t i = nodes_.size(); i-- > 0;) {
            Node& node = nodes_[i];
            if (node.left >= 0) node.content = nodes_[node.left].content + nodes_[node.right].content;
            refitOne(node);
        }
    }

    Slabs slabsOf(const BinaryNode& node) const {
        Slabs slabs;
        std::fill(&slabs.low[0][0], &slabs.low[0][0] + 24, kInfinity);
        const float sqrtHalf = 0.70710678f;
        for (std::uint32_t i = node.firstTriangle; i < node.firstTriangle + node.triangleCount; ++i) {
            for (const std::uint32_t vertex : mesh_.triangles[tree_.order[i]]) {
                const Vector3 point = normalised_(mesh_.vertices[vertex]);
                const float x = float(point.x()), y = float(point.y()), z = float(point.z());
                const float places[3][4] = {{x, z, y, x},
                                            {y, (x + y) * sqrtHalf, (x + z) * sqrtHalf, (y + z) * sqrtHalf},
                                            {z, (x - y) * sqrtHalf, (x - z) * sqrtHalf, (y - z) * sqrtHalf}};
                for (int k = 0; k < 3; ++k) {
                    for (int box = 0; box < 4; ++box) {
                        slabs.low[k][box] = std::min(slabs.low[k][box], places[k][box]);
                        slabs.negatedHigh[k][box] = std::min(slabs.negatedHigh[k][box], -places[k][box]);
                    }
                }
            }
        }
        return slabs;
    }

    void refitOne(Node& node) {
        if (node.left >= 0) {
            node.slabs = nodes_[node.left].slabs;
            Enlarge(node.slabs, nodes_[node.right].slabs);
        }
        node.area = AreaOfUnion(node.slabs, node.slabs);
    }

    void refitUpward(std::int32_t node) {
        for (; node >= 0; node = nodes_[node].parent) refitOne(nodes_[node]);
    }

    std::int32_t siblingOf(std::int32_t node) const {
        const Node& parent = nodes_[nodes_[node].parent];
        return parent.left == node ? parent.right : parent.left;
    }

    /// The node whose sibling this one should become; -1 if none is better than the place it has.
    std::int32_t bestPlace(std::int32_t index) const {
        constexpr int kMostLooks = 50;  // 20 to 28 are used on average
        const Node& node = nodes_[index];
        float best = 0;  // the largest gain: by how much the sum of areas falls
        std::int32_t place = -1;
        struct Waiting {
            float most;  ///< no place below gains more than this less the node's area
            std::int32_t node;
        };
        Waiting waiting[2 * kMostLooks];
        int waitingCount = 0, looks = 0;
        const auto look = [&](float freed, std::int32_t at, bool isPlace) {
            ++looks;
            const float gain = freed - AreaOfUnion(nodes_[at].slabs, node.slabs);
            if (isPlace && gain > best) {
                best = gain;
                place = at;
            }
            return Waiting{gain + nodes_[at].area, nodes_[at].left >= 0 ? at : -1};
        };
        const auto wait = [&](const Waiting& next) {
            if (next.node >= 0 && next.most - node.area > best) waiting[waitingCount++] = next;
        };
        std::int32_t pivot = node.parent, sibling = siblingOf(index);
        float freed = nodes_[pivot].area;    // by taking the node out of all below the pivot
        Slabs rest = nodes_[sibling].slabs;  // of what stays there
        for (bool isOwnSibling = true;; isOwnSibling = false) {
            wait(look(freed, sibling, !isOwnSibling));
            while (waitingCount > 0 && looks < kMostLooks) {
                const Waiting next = waiting[--waitingCount];
                if (!(next.most - node.area > best)) continue;
                const Waiting left = look(next.most, nodes_[next.node].left, true);
                const Waiting right = look(next.most, nodes_[next.node].right, true);
                const bool isLeftBetter = left.most > right.most;
                wait(isLeftBetter ? right : left);
                wait(isLeftBetter ? left : right);
            }
            if (looks >= kMostLooks) return place;
            if (!isOwnSibling) {
                Enlarge(rest, nodes_[sibling].slabs);
                freed += nodes_[pivot].area - AreaOfUnion(rest, rest);
            }
            if (pivot == root_) return place;
            sibling = siblingOf(pivot);
            pivot = nodes_[pivot].parent;
        }
    }

    void replaceChild(std::int32_t parent, std::int32_t child, std::int32_t by) {
        nodes_[by].parent = parent;
        if (parent < 0) {
            root_ = by;
        } else {
            (nodes_[parent].left == child ? nodes_[parent].left : nodes_[parent].right) = by;
        }
    }

    /// Takes a node out with its parent, and puts both in above another node.
    void move(std::int32_t node, std::int32_t place) {
        const std::int32_t parent = nodes_[node].parent, above = nodes_[parent].parent;
        replaceChild(above, parent, siblingOf(node));
        replaceChild(nodes_[place].parent, place, parent);
        nodes_[parent].left = place;
        nodes_[parent].right = node;
        nodes_[place].parent = parent;
        refitUpward(parent);
        refitUpward(above);
    }

    const BinaryTree& tree_;
    const CleanMesh& mesh_;
    const Normalisation normalised_;
    LargeVector<Node>
        nodes_;  ///< the root and all nodes above subtrees that are not looked into, and those; parents first
    std::vector<std::uint64_t> contents_;  ///< as Node::content, for the nodes' new places
    std::int32_t root_ = 0;
};

void ReinsertSubtrees(BinaryTree& tree, const CleanMesh& mesh) {
    Reinsertion reinsertion(tree, mesh);
    reinsertion.run();
    // Moves may make a tree deeper; no real mesh comes near this, but searches must never run out of stack.
    if (reinsertion.noteContents() <= kDeepestSplit) tree = reinsertion.result();
}

}  // namespace HWY_NAMESPACE
}  // namespace clearway
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace clearway {

HWY_EXPORT(ReinsertSubtrees);

void reinsertSubtrees(BinaryTree& tree, const CleanMesh& mesh) {
    const BinaryNode& root = tree.nodes.front();
    if (!root.isLeaf() && root.triangleCount > kLargestMovedWhole)
        HWY_DYNAMIC_DISPATCH(ReinsertSubtrees)(tree, mesh);
}

}  // namespace clearway

#endif  // HWY_ONCE
