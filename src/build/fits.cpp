// The fits of the table, and the fitting of all nodes of a tree.
#include "build/fits.h"

#include <algorithm>
#include <array>

#include "build/top_down.h"
#include "core/parallel.h"
#include "tree/normalisation.h"

namespace clearway {

namespace {

/// The moments of each node, computed backwards because children come after their parents.
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
        invokeBoth([&] { fitLarge(node.left, &node.volume.axes); },
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

constexpr int kEdgeFrames = 4;
constexpr std::uint32_t kMostForEdges = 64;

/// Whether frames along edges are worth their time. Above kMostForEdges triangles, a single one says little
/// about the shape of all. Nodes of 5 to 16 triangles find the good edge frames above them in their parent's
/// axes: trying their own, too, saves no visits.
bool triesEdges(std::uint32_t triangles) {
    return triangles <= 4 || (triangles > 16 && triangles <= kMostForEdges);
}

struct EdgeFrame {
    double areaSquared = 0;  ///< of the triangle, times 4
    Matrix3 axes;
};

/// The frame along the triangle's longest edge and its normal; not orthonormal for a triangle without area.
EdgeFrame edgeFrame(const Vector3& a, const Vector3& b, const Vector3& c) {
    Vector3 longest = b - a;
    for (const Vector3& edge : {Vector3(c - b), Vector3(a - c)}) {
        if (edge.squaredNorm() > longest.squaredNorm()) longest = edge;
    }
    const Vector3 normal = (b - a).cross(c - a);
    EdgeFrame frame;
    frame.areaSquared = normal.squaredNorm();
    frame.axes.col(0) = longest.stableNormalized();
    frame.axes.col(2) = normal.stableNormalized();
    frame.axes.col(1) = frame.axes.col(2).cross(frame.axes.col(0)).normalized();
    return frame;
}

bool isOrthonormal(const Matrix3& axes) {
    return (axes.transpose() * axes - Matrix3::Identity()).cwiseAbs().maxCoeff() < 1e-9;
}

void considerLargestTriangles(const FitInput& node, FrameSearch& frames) {
    std::array<std::pair<double, std::uint32_t>, kMostForEdges> byArea;
    for (std::uint32_t i = 0; i < node.triangleCount; ++i) {
        const auto& [a, b, c] = node.mesh.triangles()[node.firstTriangle + i];
        const auto& v = node.mesh.vertices();
        byArea[i] = {-(v[b] - v[a]).cross(v[c] - v[a]).squaredNorm(), i};
    }
    const std::size_t count = std::min<std::size_t>(kEdgeFrames, node.triangleCount);
    std::partial_sort(byArea.begin(), byArea.begin() + count, byArea.begin() + node.triangleCount);
    for (std::size_t i = 0; i < count; ++i) {
        const auto& [a, b, c] = node.mesh.triangles()[node.firstTriangle + byArea[i].second];
        const auto& v = node.mesh.vertices();
        const EdgeFrame frame = edgeFrame(v[a], v[b], v[c]);
        if (isOrthonormal(frame.axes)) frames.consider(frame.axes);
    }
}

}  // namespace

AreaMoments AreaMoments::ofTriangle(const Vector3& a, const Vector3& b, const Vector3& c) {
    AreaMoments moments;
    moments.area = 0.5 * (b - a).cross(c - a).norm();
    moments.mean = (a + b + c) / 3;
    const Vector3 u = a - moments.mean, v = b - moments.mean, w = c - moments.mean;
    moments.scatter = (moments.area / 12) * (u * u.transpose() + v * v.transpose() + w * w.transpose());
    return moments;
}

AreaMoments& AreaMoments::operator+=(const AreaMoments& other) {
    if (other.area == 0) return *this;
    const double share = other.area / (area + other.area);
    const Vector3 offset = other.mean - mean;
    scatter += other.scatter + (area * share) * offset * offset.transpose();
    mean += share * offset;
    area += other.area;
    return *this;
}

Matrix3 AreaMoments::axes() const {
    return spreadAxes(scatter / area);
}

void fitVolumes(BinaryTree& tree, const LeafOrder& mesh, Fit fit) {
    Fitting(tree, mesh, fit).run();
}

Rss fitByCovariance(const FitInput& node, FitScratch& scratch) {
    scratch.corners.clear();
    for (std::uint32_t i = 0; i < node.triangleCount; ++i) {
        for (const std::uint32_t vertex : node.mesh.triangles()[node.firstTriangle + i])
            scratch.corners.push_back(node.mesh.vertices()[vertex]);
    }
    return fitRss(node.points, principalFrame(scratch.corners).axes);
}

Rss fitLeastOfFrames(const FitInput& node, FitScratch& scratch) {
    FrameSearch& frames = scratch.frames;
    frames.begin(node.points);
    frames.consider(principalFrame(node.points).axes);
    if (node.moments.area > 0) frames.consider(node.moments.axes());
    if (node.parentAxes != nullptr) frames.consider(*node.parentAxes);
    frames.consider(Matrix3::Identity());
    if (triesEdges(node.triangleCount)) considerLargestTriangles(node, frames);
    return frames.leastArea();
}

}  // namespace clearway
