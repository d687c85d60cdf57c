#include "build/split/sah.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <memory>
#include <utility>

#include "build/fit/point_covariance.h"
#include "build/split/bins.h"
#include "build/split/plane.h"
#include "build/top_down.h"
#include "tree/normalisation.h"

namespace clearway {

namespace {

using Matrix3f = Eigen::Matrix3f;

/// Centred on the mesh, in a unit that makes it about 1 large. Floats, since they only rate planes.
std::vector<CornerLanes> normalisedCorners(const CleanMesh& mesh) {
    const Normalisation normalised = normalisationOf(mesh.vertices);
    std::vector<CornerLanes> corners(mesh.triangles.size());
    for (std::size_t i = 0; i < corners.size(); ++i) {
        for (int k = 0; k < 3; ++k) {
            const Vector3 point = normalised(mesh.vertices[mesh.triangles[i][k]]);
            corners[i].corner[k] << point.cast<float>().array(), 0.0f;
        }
    }
    return corners;
}

/// Sums over weighted points.
struct Moments {
    double weight = 0;
    Vector3 sum = Vector3::Zero();
    Matrix3 products = Matrix3::Zero();

    /// Eigenvectors of the covariance. The direct solver is good enough to rate planes with, and fast.
    Matrix3f axes() const {
        const Vector3 mean = sum / weight;
        const Matrix3 covariance = products / weight - mean * mean.transpose();
        return Eigen::SelfAdjointEigenSolver<Matrix3>()
            .computeDirect(covariance)
            .eigenvectors()
            .cast<float>();
    }
};

class SahSplit {
  public:
    SahSplit(const CleanMesh& mesh, std::shared_ptr<const std::vector<CornerLanes>> corners)
        : mesh_(mesh), allCorners_(std::move(corners)) {}

    std::size_t operator()(TriangleRun run) {
        gather(run);
        cheapest_ = BinnedPlane();
        Moments corners;
        Moments area;
        sumMoments(corners, area);
        tryFrame(corners.axes());
        if (area.weight > 0) tryFrame(area.axes());
        tryFrame(Matrix3f::Identity());
        return cheapest_.axis < 0 ? splitAtMean(run) : partition(run);
    }

  private:
    /// Relative to one of them, so that small nodes lose no digits.
    void gather(TriangleRun run) {
        const Lanes4 origin = (*allCorners_)[*run.first].corner[0];
        triangles_.resize(run.size());
        for (std::size_t i = 0; i < run.size(); ++i) {
            const CornerLanes& corners = (*allCorners_)[run.first[i]];
            for (int k = 0; k < 3; ++k) triangles_[i].corner[k] = corners.corner[k] - origin;
        }
    }

    /// Of the triangles' corners and of their area.
    void sumMoments(Moments& corners, Moments& area) const {
        for (const CornerLanes& triangle : triangles_) {
            const Eigen::Vector3f a = triangle.corner[0].head<3>().matrix();
            const Eigen::Vector3f b = triangle.corner[1].head<3>().matrix();
            const Eigen::Vector3f c = triangle.corner[2].head<3>().matrix();
            const Eigen::Vector3f sum = a + b + c;
            const Matrix3f products = a * a.transpose() + b * b.transpose() + c * c.transpose();
            corners.weight += 3;
            corners.sum += sum.cast<double>();
            corners.products += products.cast<double>();
            // The integral of x x^T over a triangle is area / 12 (aa^T + bb^T + cc^T + (a + b + c)(a + b +
            // c)^T).
            const float weight = (b - a).cross(c - a).norm();
            area.weight += weight;
            area.sum += (weight / 3 * sum).cast<double>();
            area.products += (weight / 12 * (products + sum * sum.transpose())).cast<double>();
        }
    }

    void tryFrame(const Matrix3f& axes) {
        if (!axes.allFinite()) return;
        const BinnedPlane plane = bins_.cheapestPlane(triangles_, axes);
        if (plane.cost >= cheapest_.cost) return;
        cheapest_ = plane;
        std::swap(binOf_, bins_.binsAlong(plane.axis));
    }

    /// Keeps the triangles' order on either side, whatever the library.
    std::size_t partition(TriangleRun run) {
        std::size_t leftCount = 0;
        rightSide_.clear();
        for (std::size_t i = 0; i < run.size(); ++i) {
            if (binOf_[i] <= cheapest_.lastLeft) {
                run.first[leftCount++] = run.first[i];
            } else {
                rightSide_.push_back(run.first[i]);
            }
        }
        std::copy(rightSide_.begin(), rightSide_.end(), run.first + leftCount);
        return leftCount;
    }

    /// In double: the centres may coincide only as floats.
    std::size_t splitAtMean(TriangleRun run) const {
        std::vector<Vector3> corners;
        gatherCorners(mesh_, run.first, run.size(), corners);
        const PrincipalFrame frame = principalFrame(corners);
        return partitionByPlane(mesh_, run, {frame.mean, frame.axes.col(0)});
    }

    const CleanMesh& mesh_;
    std::shared_ptr<const std::vector<CornerLanes>> allCorners_;
    std::vector<CornerLanes> triangles_;
    Bins bins_;
    BinnedPlane cheapest_;
    std::vector<std::uint8_t> binOf_;  ///< by triangle, along the axis of the cheapest plane
    std::vector<std::uint32_t> rightSide_;
};

}  // namespace

BinaryTree buildBySah(const CleanMesh& mesh, std::vector<std::uint32_t> triangles, std::size_t largestGroup) {
    const auto corners = std::make_shared<const std::vector<CornerLanes>>(normalisedCorners(mesh));
    return buildTopDown(mesh, std::move(triangles), largestGroup, [&] { return SahSplit(mesh, corners); });
}

}  // namespace clearway
