#include "build/fit_volumes.h"

#include <tbb/parallel_invoke.h>

#include "build/tasks.h"
#include "tree/normalisation.h"

namespace clearway {

namespace {

/// Of each node. Children come after their parents, so backwards.
std::vector<AreaMoments> momentsOf(const BinaryTree& tree, const LeafOrder& mesh) {
    const Normalisation normalised = normalisationOf(mesh.vertices());
    std::vector<AreaMoments> moments(tree.nodes.size());
    for (std::size_t i = tree.nodes.size(); i-- > 0;) {
        const BinaryNode& node = tree.nodes[i];
        if (!node.isLeaf()) {
            moments[i] = moments[node.left];
            moments[i] += moments[node.right];
            continue;
        }
        for (std::uint32_t k = 0; k < node.triangleCount; ++k) {
            const auto& [a, b, c] = mesh.triangles()[node.firstTriangle + k];
            const auto& v = mesh.vertices();
            moments[i] += AreaMoments::ofTriangle(normalised(v[a]), normalised(v[b]), normalised(v[c]));
        }
    }
    return moments;
}

class Fitting {
  public:
    Fitting(BinaryTree& tree, const LeafOrder& mesh, Fit fit)
        : tree_(tree), mesh_(mesh), fit_(fit), moments_(momentsOf(tree, mesh)) {}

    void run() { fitLarge(0, nullptr); }

  private:
    struct Scratch {
        FitScratch fit;
        LeafOrder::Gathered gathered;
        std::vector<std::pair<std::int32_t, const Matrix3*>> pending;
    };

    void fitOne(std::int32_t index, const Matrix3* parentAxes, Scratch& scratch) {
        BinaryNode& node = tree_.nodes[index];
        mesh_.gatherVertices(node.firstTriangle, node.triangleCount, scratch.gathered);
        node.volume = fit_({mesh_, node.firstTriangle, node.triangleCount, scratch.gathered.points,
                            moments_[index], parentAxes},
                           scratch.fit);
    }

    void fitLarge(std::int32_t index, const Matrix3* parentAxes) {
        const BinaryNode& node = tree_.nodes[index];
        Scratch scratch;
        if (node.triangleCount <= kTaskTriangles || node.isLeaf())
            return fitAllBelow(index, parentAxes, scratch);
        fitOne(index, parentAxes, scratch);
        tbb::parallel_invoke([&] { fitLarge(node.left, &node.volume.axes); },
                             [&] { fitLarge(node.right, &node.volume.axes); });
    }

    void fitAllBelow(std::int32_t root, const Matrix3* parentAxes, Scratch& scratch) {
        scratch.pending.push_back({root, parentAxes});
        while (!scratch.pending.empty()) {
            const auto [index, axes] = scratch.pending.back();
            scratch.pending.pop_back();
            fitOne(index, axes, scratch);
            const BinaryNode& node = tree_.nodes[index];
            if (node.isLeaf()) continue;
            scratch.pending.push_back({node.right, &node.volume.axes});
            scratch.pending.push_back({node.left, &node.volume.axes});
        }
    }

    BinaryTree& tree_;
    const LeafOrder& mesh_;
    const Fit fit_;
    const std::vector<AreaMoments> moments_;
};

}  // namespace

void fitVolumes(BinaryTree& tree, const LeafOrder& mesh, Fit fit) {
    Fitting(tree, mesh, fit).run();
}

}  // namespace clearway
