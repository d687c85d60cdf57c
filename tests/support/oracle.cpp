#include "support/oracle.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "support/box_tree.h"
#include "support/exact_distance.h"
#include "support/triangle_distance.h"

namespace clearway::testing {
namespace {

// Below this share of the largest coordinate the long double distance is not trusted, and integer arithmetic
// decides. It is far above the error of long double (1e-17 for the worst needles) and far below the gaps that
// tests are about.
constexpr long double kDoubtful = 1e-14L;

struct Closest {
    long double distance = std::numeric_limits<long double>::infinity();
    std::size_t partTriangle = 0;
    std::size_t environmentTriangle = 0;
};

long double largestCoordinate(const std::vector<LongVector>& points) {
    long double largest = 0;
    for (const LongVector& point : points) largest = std::max(largest, point.cwiseAbs().maxCoeff());
    return largest;
}

double diagonal(const Mesh& mesh) {
    Box box;
    for (const TriangleIndices& triangle : mesh.triangles) {
        for (const auto index : triangle) box.extend(mesh.vertices[index]);
    }
    return box.isEmpty() ? 0.0 : box.diagonal().norm();
}

std::vector<LongVector> movedVertices(const Mesh& mesh, const Pose& pose) {
    std::vector<LongVector> result;
    result.reserve(mesh.vertices.size());
    for (const Vector3& vertex : mesh.vertices) result.push_back(moved(pose, vertex));
    return result;
}

// One query: moves the part once, then walks through both trees together, the nearer pair of children first.
class Search {
  public:
    Search(const Mesh& part, const Mesh& environment, const std::vector<LongVector>& environmentVertices,
           const Pose& pose)
        : part_(part),
          environment_(environment),
          pose_(pose),
          partVertices_(movedVertices(part, pose)),
          environmentVertices_(environmentVertices),
          doubtful_(kDoubtful *
                    std::max(largestCoordinate(partVertices_), largestCoordinate(environmentVertices_))) {}

    const std::vector<LongVector>& partVertices() const { return partVertices_; }
    long double doubtful() const { return doubtful_; }

    void tryPair(Closest& best, std::size_t p, std::size_t e) const {
        long double distance = triangleDistance(trianglePoints(part_, partVertices_, p),
                                                trianglePoints(environment_, environmentVertices_, e))
                                   .distance;
        if (distance > std::max(best.distance, doubtful_)) return;
        if (distance <= doubtful_)
            distance = exactDistance(pose_, cornersOf(part_, p), cornersOf(environment_, e)).rounded();
        if (distance < best.distance) best = {distance, p, e};
    }

    void walk(Closest& best, const BoxTree& partTree, const BoxTree& environmentTree) const {
        if (part_.triangles.empty() || environment_.triangles.empty()) return;
        descend(best, partTree.nodes, environmentTree.nodes, 0, 0);
    }

  private:
    static LongTriangle trianglePoints(const Mesh& mesh, const std::vector<LongVector>& points,
                                       std::size_t t) {
        const TriangleIndices& indices = mesh.triangles[t];
        return {points[indices[0]], points[indices[1]], points[indices[2]]};
    }

    void descend(Closest& best, const std::vector<BoxNode>& a, const std::vector<BoxNode>& b, int i,
                 int j) const {
        if (best.distance == 0 || lowerBound(a[i], b[j]) > best.distance) return;
        if (a[i].isLeaf() && b[j].isLeaf()) return tryPair(best, a[i].triangle, b[j].triangle);
        const bool openA = b[j].isLeaf() || (!a[i].isLeaf() && diagonalSquared(a[i]) > diagonalSquared(b[j]));
        std::pair<int, int> first = openA ? std::pair(a[i].left, j) : std::pair(i, b[j].left);
        std::pair<int, int> second = openA ? std::pair(a[i].right, j) : std::pair(i, b[j].right);
        if (lowerBound(a[second.first], b[second.second]) < lowerBound(a[first.first], b[first.second])) {
            std::swap(first, second);
        }
        descend(best, a, b, first.first, first.second);
        descend(best, a, b, second.first, second.second);
    }

    const Mesh& part_;
    const Mesh& environment_;
    const Pose& pose_;
    std::vector<LongVector> partVertices_;
    const std::vector<LongVector>& environmentVertices_;
    long double doubtful_;
};

OracleAnswer rounded(const Closest& closest) {
    const auto nearest = static_cast<double>(closest.distance);
    const bool vanished = nearest == 0 && closest.distance > 0;  // the distance was below the least double
    return {vanished ? std::numeric_limits<double>::denorm_min() : nearest, closest.partTriangle,
            closest.environmentTriangle};
}

}  // namespace

struct MeshOracle::Data {
    Mesh part;
    Mesh environment;
    BoxTree partTree;
    BoxTree environmentTree;
    std::vector<LongVector> environmentVertices;
};

MeshOracle::MeshOracle(const Mesh& part, const Mesh& environment)
    : data_(std::make_unique<Data>(Data{part, environment, BoxTree(part), BoxTree(environment),
                                        movedVertices(environment, Pose{})})) {}

MeshOracle::~MeshOracle() = default;

OracleAnswer MeshOracle::distance(const Pose& X_environmentPart) const {
    const Search search(data_->part, data_->environment, data_->environmentVertices, X_environmentPart);
    Closest best;
    search.walk(best, data_->partTree.refitted(data_->part, search.partVertices()), data_->environmentTree);
    return rounded(best);
}

bool MeshOracle::collides(const Pose& X_environmentPart) const {
    const Search search(data_->part, data_->environment, data_->environmentVertices, X_environmentPart);
    Closest best;
    best.distance = search.doubtful();  // pairs farther apart do not touch
    search.walk(best, data_->partTree.refitted(data_->part, search.partVertices()), data_->environmentTree);
    return best.distance == 0;
}

double MeshOracle::sceneSize() const {
    return diagonal(data_->part) + diagonal(data_->environment);
}

double MeshOracle::pairDistance(const Pose& X_environmentPart, std::size_t partTriangle,
                                std::size_t environmentTriangle) const {
    const std::array<Vector3, 3> a = cornersOf(data_->part, partTriangle);
    const std::array<Vector3, 3> b = cornersOf(data_->environment, environmentTriangle);
    const LongTriangle movedPart = moved(X_environmentPart, a), fixed = toLong(b);
    const long double largest = std::max(largestCoordinate({movedPart.begin(), movedPart.end()}),
                                         largestCoordinate({fixed.begin(), fixed.end()}));
    const long double distance = triangleDistance(movedPart, fixed).distance;
    return static_cast<double>(
        distance > kDoubtful * largest ? distance : exactDistance(X_environmentPart, a, b).rounded());
}

OracleAnswer bruteForceDistance(const Mesh& part, const Mesh& environment, const Pose& X_environmentPart) {
    const std::vector<LongVector> environmentVertices = movedVertices(environment, Pose{});
    const Search search(part, environment, environmentVertices, X_environmentPart);
    Closest best;
    for (std::size_t p = 0; p < part.triangles.size(); ++p) {
        for (std::size_t e = 0; e < environment.triangles.size(); ++e) search.tryPair(best, p, e);
    }
    return rounded(best);
}

std::array<Vector3, 3> cornersOf(const Mesh& mesh, std::size_t triangle) {
    const TriangleIndices& indices = mesh.triangles[triangle];
    return {mesh.vertices[indices[0]], mesh.vertices[indices[1]], mesh.vertices[indices[2]]};
}

}  // namespace clearway::testing
