#include "build/leaf/grow_chains.h"

#include <algorithm>
#include <utility>

namespace clearway {

namespace {

int countSharedVertices(const TriangleIndices& a, const TriangleIndices& b) {
    int shared = 0;
    for (int i = 0; i < 3; ++i) {
        const bool seenBefore =
            std::find(a.begin(), a.begin() + i, a[i]) != a.begin() + i;  // degenerate triangles
        if (!seenBefore && std::find(b.begin(), b.end(), a[i]) != b.end()) ++shared;
    }
    return shared;
}

}  // namespace

Chains growChains(const CleanMesh& mesh, std::vector<std::uint32_t> group, int sharedVertices) {
    Chains chains{std::move(group), {}};
    std::vector<std::uint32_t>& triangles = chains.triangles;
    std::size_t chainEnd = 0;
    while (chainEnd < triangles.size()) {
        // [chainStart, chainEnd) is the chain, what follows is free. Each link looks once for its free
        // neighbours.
        std::size_t link = chainEnd++;
        for (; link < chainEnd; ++link) {
            for (std::size_t free = chainEnd; free < triangles.size(); ++free) {
                if (countSharedVertices(mesh.triangles[triangles[link]], mesh.triangles[triangles[free]]) <
                    sharedVertices)
                    continue;
                // Rotated rather than swapped: the free ones keep their order.
                std::rotate(triangles.begin() + chainEnd, triangles.begin() + free,
                            triangles.begin() + free + 1);
                ++chainEnd;
            }
        }
        chains.ends.push_back(chainEnd);
    }
    return chains;
}

BinaryTree treeOfChains(const Chains& chains) {
    struct Pending {
        std::size_t node, firstChain, lastChain;
    };
    BinaryTree tree;
    tree.order = chains.triangles;
    tree.nodes.emplace_back();
    std::vector<Pending> pending{{0, 0, chains.ends.size()}};
    while (!pending.empty()) {
        const auto [node, firstChain, lastChain] = pending.back();
        pending.pop_back();
        const std::size_t start = firstChain == 0 ? 0 : chains.ends[firstChain - 1];
        tree.nodes[node].firstTriangle = static_cast<std::uint32_t>(start);
        tree.nodes[node].triangleCount = static_cast<std::uint32_t>(chains.ends[lastChain - 1] - start);
        if (lastChain - firstChain == 1) continue;

        const std::size_t middle = (firstChain + lastChain + 1) / 2;
        const std::size_t left = tree.nodes.size();
        tree.nodes[node].left = static_cast<std::int32_t>(left);
        tree.nodes[node].right = static_cast<std::int32_t>(left + 1);
        tree.nodes.resize(left + 2);
        pending.push_back({left + 1, middle, lastChain});
        pending.push_back({left, firstChain, middle});
    }
    return tree;
}

}  // namespace clearway
