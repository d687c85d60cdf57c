// The surface-area heuristic: each node is cut between two bins of triangles, along an axis of the one of
// three frames that makes the cut cheapest. In large nodes a sample of the triangles chooses the frame.

#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

#include "build/fit_rss.h"
#include "build/general_splits.h"
#include "build/split/bins.h"
#include "build/top_down.h"
#include "tree/normalisation.h"

namespace clearway {

namespace {

using Matrix3f = Eigen::Matrix3f;

/// Corners relative to the centre of the mesh, in a unit that makes the mesh about 1 large. Floats suffice to
/// rate planes.
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

/// Sums over weighted points, in float for a while and then in double.
struct WeightedMoments {
    struct Sums {
        Lanes4 first = Lanes4::Zero();    ///< x, y, z
        Lanes4 squares = Lanes4::Zero();  ///< xx, yy, zz
        Lanes4 mixed = Lanes4::Zero();    ///< xy, yz, zx
        float weight = 0;
    };
    double weight = 0;
    Vector3 sum = Vector3::Zero();
    Vector3 squares = Vector3::Zero();
    Vector3 mixed = Vector3::Zero();

    void add(const Sums& sums) {
        weight += sums.weight;
        sum += sums.first.head<3>().matrix().cast<double>();
        squares += sums.squares.head<3>().matrix().cast<double>();
        mixed += sums.mixed.head<3>().matrix().cast<double>();
    }

    /// Eigenvectors of the covariance. The direct solver is fast and accurate enough to rate planes.
    Matrix3f axes() const {
        const Vector3 mean = sum / weight;
        Matrix3 products = squares.asDiagonal();
        products(0, 1) = products(1, 0) = mixed[0];
        products(1, 2) = products(2, 1) = mixed[1];
        products(0, 2) = products(2, 0) = mixed[2];
        const Matrix3 covariance = products / weight - mean * mean.transpose();
        return Eigen::SelfAdjointEigenSolver<Matrix3>()
            .computeDirect(covariance)
            .eigenvectors()
            .cast<float>();
    }
};

/// <x, y, z> as <y, z, x>.
Lanes4 turned(const Lanes4& v) {
    return Lanes4(v[1], v[2], v[0], v[3]);
}

/// From this many triangles on, a sample chooses the frame: that is two thirds of the work. Every third
/// triangle, because many meshes are rows of pairs of triangles, so that an even stride would see half of each.
constexpr std::size_t kLeastToSample = 2048;
constexpr std::size_t kStride = 3;

class SahSplit {
  public:
    SahSplit(const CleanMesh& mesh, std::shared_ptr<const std::vector<CornerLanes>> corners)
        : mesh_(mesh), allCorners_(std::move(corners)) {}

    std::size_t operator()(TriangleRun run) {
        const std::size_t stride = run.size() < kLeastToSample ? 1 : kStride;
        gather(run, stride);
        cheapest_ = BinnedPlane();
        WeightedMoments corners;
        WeightedMoments area;
        sumMoments(corners, area);
        tryFrame(corners.axes());
        if (area.weight > 0) tryFrame(area.axes());
        tryFrame(Matrix3f::Identity());
        if (stride > 1 && cheapest_.axis >= 0) binAll(run);
        return cheapest_.axis < 0 ? splitAtMean(run) : partition(run);
    }

  private:
    /// Collects corners relative to one of them, so that small nodes lose no digits.
    void gather(TriangleRun run, std::size_t stride) {
        origin_ = (*allCorners_)[*run.first].corner[0];
        triangles_.clear();
        for (std::size_t i = 0; i < run.size(); i += stride) triangles_.push_back(cornersAt(run.first[i]));
    }

    CornerLanes cornersAt(std::uint32_t triangle) const {
        CornerLanes corners = (*allCorners_)[triangle];
        for (Lanes4& corner : corners.corner) corner -= origin_;
        return corners;
    }

    /// Sums the moments of the gathered triangles' corners and of their area.
    void sumMoments(WeightedMoments& corners, WeightedMoments& area) const {
        constexpr std::size_t kInFloat = 256;  // few enough that floats lose little
        for (std::size_t first = 0; first < triangles_.size(); first += kInFloat) {
            WeightedMoments::Sums ofCorners, ofArea;
            const std::size_t last = std::min(first + kInFloat, triangles_.size());
            for (std::size_t i = first; i < last; ++i) addMoments(triangles_[i], ofCorners, ofArea);
            ofCorners.weight = 3.0f * static_cast<float>(last - first);
            corners.add(ofCorners);
            area.add(ofArea);
        }
    }

    static void addMoments(const CornerLanes& triangle, WeightedMoments::Sums& corners,
                           WeightedMoments::Sums& area) {
        const auto& [a, b, c] = triangle.corner;
        const Lanes4 sum = a + b + c;
        const Lanes4 squares = a.square() + b.square() + c.square();
        const Lanes4 mixed = a * turned(a) + b * turned(b) + c * turned(c);
        corners.first += sum;
        corners.squares += squares;
        corners.mixed += mixed;
        // The integral of x x^T over a triangle is area / 12 (aa^T + bb^T + cc^T + s s^T) with s = a + b + c.
        const Lanes4 u = b - a, v = c - a;
        const Lanes4 normal = u * turned(v) - turned(u) * v;    // <z, x, y>
        const float weight = std::sqrt(normal.square().sum());  // the fourth lane is 0
        area.weight += weight;
        area.first += (weight / 3) * sum;
        area.squares += (weight / 12) * (squares + sum.square());
        area.mixed += (weight / 12) * (mixed + sum * turned(sum));
    }

    void tryFrame(const Matrix3f& axes) {
        if (!axes.allFinite()) return;
        const BinnedPlane plane = bins_.cheapestPlane(
            triangles_.size(), [this](std::size_t i) { return triangles_[i]; }, axes);
        if (plane.cost >= cheapest_.cost) return;
        cheapest_ = plane;
        axes_ = axes;
        std::swap(binOf_, bins_.binsAlong(plane.axis));
    }

    /// Bins all triangles in the frame that the sample chose.
    void binAll(TriangleRun run) {
        cheapest_ = bins_.cheapestPlane(
            run.size(), [&](std::size_t i) { return cornersAt(run.first[i]); }, axes_);
        if (cheapest_.axis >= 0) std::swap(binOf_, bins_.binsAlong(cheapest_.axis));
    }

    /// Keeps the order of the triangles on both sides, so that the tree does not depend on the standard
    /// library.
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

    /// Splits in double, because the centres may coincide only as floats.
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
    Lanes4 origin_;
    BinnedPlane cheapest_;
    Matrix3f axes_;                    ///< the frame of the cheapest plane
    std::vector<std::uint8_t> binOf_;  ///< by triangle, along the axis of the cheapest plane
    std::vector<std::uint32_t> rightSide_;
};

}  // namespace

BinaryTree buildBySah(const CleanMesh& mesh, std::vector<std::uint32_t> triangles, std::size_t largestGroup) {
    const auto corners = std::make_shared<const std::vector<CornerLanes>>(normalisedCorners(mesh));
    return buildTopDown(mesh, std::move(triangles), largestGroup, [&] { return SahSplit(mesh, corners); });
}

}  // namespace clearway
