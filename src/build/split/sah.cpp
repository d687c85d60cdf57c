// The surface-area heuristic: each node is cut between two bins of triangles, along an axis of the one of
// three frames that makes the cut cheapest.

#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

#include "build/fit_rss.h"
#include "build/general_splits.h"
#include "build/top_down.h"
#include "tree/normalisation.h"

namespace clearway {

namespace {

using Lanes4 = Eigen::Array4f;  ///< x, y, z and a fourth that does not matter

struct CornerLanes {
    Lanes4 corner[3];
};

/// A growing box.
struct Extent {
    Lanes4 low = Lanes4::Constant(std::numeric_limits<float>::infinity());
    Lanes4 high = Lanes4::Constant(-std::numeric_limits<float>::infinity());

    void add(const Extent& other) {
        low = low.min(other.low);
        high = high.max(other.high);
    }
    float halfArea() const {
        const Lanes4 side = high - low;
        return side[0] * side[1] + side[1] * side[2] + side[2] * side[0];
    }
};

/// A plane between two bins. Its cost is the sum over both sides of area times number of triangles.
struct BinnedPlane {
    float cost = std::numeric_limits<float>::infinity();
    int axis = -1;     ///< of the frame; -1: no plane parts the triangles
    int lastLeft = 0;  ///< bin
};

/// Bins along the three axes of a frame. Reused from node to node for its storage.
class Bins {
  public:
    static constexpr int kMost = 64;

    /// Sorts triangles into bins along the columns of axes and returns the cheapest plane; infinite cost when
    /// all centres coincide.
    BinnedPlane cheapestPlane(const std::vector<CornerLanes>& triangles, const Eigen::Matrix3f& axes);

    /// The bin of each triangle along an axis of the last frame.
    std::vector<std::uint8_t>& binsAlong(int axis) { return binOf_[axis]; }

  private:
    struct Bin {
        Extent extent;
        int count = 0;
    };

    /// Computes the triangles' boxes in a frame; returns the box of twice their centres.
    Extent project(const std::vector<CornerLanes>& triangles, const Eigen::Matrix3f& axes);
    void fill(const Extent& centres, int count);
    BinnedPlane sweep(int axis, int count) const;

    std::vector<Extent> boxes_;
    std::vector<std::uint8_t> binOf_[3];
    std::array<Bin, kMost> bins_[3];
};

constexpr float kInfinity = std::numeric_limits<float>::infinity();

/// Small nodes need few bins; sweeping empty bins would be most of the work.
int binsFor(std::size_t triangles) {
    return static_cast<int>(std::min<std::size_t>(Bins::kMost, 2 * triangles + 4));
}

BinnedPlane Bins::cheapestPlane(const std::vector<CornerLanes>& triangles, const Eigen::Matrix3f& axes) {
    const Extent centres = project(triangles, axes);
    const int count = binsFor(triangles.size());
    fill(centres, count);
    BinnedPlane best;
    for (int axis = 0; axis < 3; ++axis) {
        const BinnedPlane plane = sweep(axis, count);
        if (plane.cost < best.cost) best = plane;
    }
    return best;
}

Extent Bins::project(const std::vector<CornerLanes>& triangles, const Eigen::Matrix3f& axes) {
    Lanes4 rows[3];
    for (int k = 0; k < 3; ++k) rows[k] << axes(k, 0), axes(k, 1), axes(k, 2), 0.0f;
    boxes_.resize(triangles.size());
    Extent centres;
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        const auto projected = [&](int k) -> Lanes4 {
            const Lanes4& corner = triangles[i].corner[k];
            return corner[0] * rows[0] + corner[1] * rows[1] + corner[2] * rows[2];
        };
        const Lanes4 a = projected(0), b = projected(1), c = projected(2);
        boxes_[i].low = a.min(b).min(c);
        boxes_[i].high = a.max(b).max(c);
        const Lanes4 centre = boxes_[i].low + boxes_[i].high;
        centres.add({centre, centre});
    }
    return centres;
}

void Bins::fill(const Extent& centres, int count) {
    // An axis along which all centres coincide gets scale 0, so that all triangles land in bin 0.
    const Lanes4 extent = centres.high - centres.low;
    const Lanes4 scale = (extent > std::numeric_limits<float>::min())
                             .select(static_cast<float>(count) / extent, Lanes4::Zero());
    for (int axis = 0; axis < 3; ++axis) {
        binOf_[axis].resize(boxes_.size());
        std::fill(bins_[axis].begin(), bins_[axis].begin() + count, Bin{});
    }
    for (std::size_t i = 0; i < boxes_.size(); ++i) {
        const Lanes4 place = (boxes_[i].low + boxes_[i].high - centres.low) * scale;
        for (int axis = 0; axis < 3; ++axis) {
            const int index = std::clamp(static_cast<int>(place[axis]), 0, count - 1);
            binOf_[axis][i] = static_cast<std::uint8_t>(index);
            Bin& bin = bins_[axis][index];
            bin.extent.add(boxes_[i]);
            ++bin.count;
        }
    }
}

BinnedPlane Bins::sweep(int axis, int count) const {
    const std::array<Bin, kMost>& bins = bins_[axis];
    std::array<float, kMost> rightCost;
    Extent right;
    int rightCount = 0;
    for (int b = count - 1; b > 0; --b) {
        if (bins[b].count > 0) right.add(bins[b].extent);
        rightCount += bins[b].count;
        rightCost[b - 1] = rightCount > 0 ? right.halfArea() * static_cast<float>(rightCount) : kInfinity;
    }
    BinnedPlane best;
    Extent left;
    int leftCount = 0;
    for (int b = 0; b + 1 < count; ++b) {
        if (bins[b].count == 0) continue;  // the plane before this bin is equal
        left.add(bins[b].extent);
        leftCount += bins[b].count;
        const float cost = left.halfArea() * static_cast<float>(leftCount) + rightCost[b];
        if (cost < best.cost) best = {cost, axis, b};
    }
    return best;
}

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

/// Sums over weighted points.
struct Moments {
    double weight = 0;
    Vector3 sum = Vector3::Zero();
    Matrix3 products = Matrix3::Zero();

    /// Eigenvectors of the covariance. The direct solver is fast and accurate enough to rate planes.
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
    /// Collects the corners relative to one of them, so that small nodes lose no digits.
    void gather(TriangleRun run) {
        const Lanes4 origin = (*allCorners_)[*run.first].corner[0];
        triangles_.resize(run.size());
        for (std::size_t i = 0; i < run.size(); ++i) {
            const CornerLanes& corners = (*allCorners_)[run.first[i]];
            for (int k = 0; k < 3; ++k) triangles_[i].corner[k] = corners.corner[k] - origin;
        }
    }

    /// Sums the moments of the triangles' corners and of their area.
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
            // The integral of x x^T over a triangle is area / 12 (aa^T + bb^T + cc^T + s s^T) with s = a + b
            // + c.
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
