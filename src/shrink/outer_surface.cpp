#include "shrink/outer_surface.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <stdexcept>
#include <string>

#include "clearway/query.h"
#include "mesh/clean.h"

namespace clearway {
namespace {

constexpr double kSliver = 1e-4;
constexpr std::size_t kMostOuterPieces = 8'000'000;
constexpr double kNearCorner = 0.98;  ///< where a piece is looked at, from its middle to its corners

/// Cuts one triangle of a shell.
class TriangleCut {
  public:
    TriangleCut(const std::vector<SurfaceShell>& shells, std::size_t own,
                const std::function<bool(const Vector3&)>& isCovered, double fineness,
                std::atomic<std::size_t>& pieces)
        : shells_(shells), own_(own), isCovered_(isCovered), fineness_(fineness), pieces_(pieces) {}

    std::vector<Corners3> cut(const Corners3& triangle) {
        const auto& [a, b, c] = triangle;
        const Vector3 normal = shells_[own_].outwards * (b - a).cross(c - a);
        if (!(normal.squaredNorm() > 0)) return {};  // its points are those of its neighbours
        ahead_ = fineness_ * normal.normalized();
        isSliver_ = isSliver(triangle, normal);
        std::vector<std::size_t> others;
        for (std::size_t i = 0; i < shells_.size(); ++i) {
            if (i != own_) others.push_back(i);
        }
        look(triangle, others);
        return std::move(kept_);
    }

  private:
    void look(const Corners3& c, const std::vector<std::size_t>& others) {
        if (++pieces_ > kMostOuterPieces) {
            throw std::invalid_argument(
                "overlap needs the outside of a part whose components touch, and this takes "
                "more than " +
                std::to_string(kMostOuterPieces) + " pieces, expected a larger overlap or overlap.tolerance");
        }
        std::vector<std::size_t> near;
        bool isApart = true;
        for (const double side : {1.0, -1.0}) {
            if (side < 0 && !isSliver_) break;
            isApart = isApartFrom(others, {c[0] + side * ahead_, c[1] + side * ahead_, c[2] + side * ahead_},
                                  near) &&
                      isApart;
        }
        const Vector3 middle = (c[0] + c[1] + c[2]) / 3;
        if (isApart) {
            if (isOutside(middle)) kept_.push_back(c);
            return;
        }
        int longest = 0;
        for (int k = 1; k < 3; ++k) {
            if (lengthSquared(c, k) > lengthSquared(c, longest)) longest = k;
        }
        if (lengthSquared(c, longest) <= fineness_ * fineness_) {
            const bool isKept =
                isOutside(middle) || std::any_of(c.begin(), c.end(), [&](const Vector3& corner) {
                    return isOutside(middle + kNearCorner * (corner - middle));
                });
            if (isKept) kept_.push_back(c);
            return;
        }
        const Vector3 &a = c[longest], &b = c[(longest + 1) % 3], &tip = c[(longest + 2) % 3];
        const Vector3 between = 0.5 * (a + b);
        look({a, between, tip}, near);
        look({between, b, tip}, near);
    }

    static double lengthSquared(const Corners3& c, int k) { return (c[(k + 1) % 3] - c[k]).squaredNorm(); }

    /// Whether a triangle touches none of the shells. Adds those near it to `near`.
    bool isApartFrom(const std::vector<std::size_t>& others, const Corners3& c,
                     std::vector<std::size_t>& near) {
        Mesh mesh;
        mesh.vertices.assign(c.begin(), c.end());
        mesh.triangles = {{0, 1, 2}};
        const Box box = boundingBox(mesh);
        std::optional<Model> model;
        bool isApart = true;
        for (const std::size_t i : others) {
            if (!shells_[i].solid.box().intersects(box)) continue;
            if (std::find(near.begin(), near.end(), i) == near.end()) near.push_back(i);
            if (!isApart) continue;
            if (!model) model = Model::build(mesh);
            isApart = !collides(*model, shells_[i].model, {}, workspace_);
        }
        return isApart;
    }

    /// A sliver's normal may point either way, but behind it is the part.
    bool isOutside(const Vector3& point) const {
        return !isCovered_(point + ahead_) || (isSliver_ && !isCovered_(point - ahead_));
    }

    const std::vector<SurfaceShell>& shells_;
    const std::size_t own_;
    const std::function<bool(const Vector3&)>& isCovered_;
    const double fineness_;
    std::atomic<std::size_t>& pieces_;
    Vector3 ahead_ = Vector3::Zero();  ///< from the triangle's plane to where it is looked at
    bool isSliver_ = false;
    std::vector<Corners3> kept_;
    Workspace workspace_;
};

}  // namespace

bool isSliver(const Corners3& triangle, const Vector3& normal) {
    const auto& [a, b, c] = triangle;
    const double longest = std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
    return !(normal.norm() > kSliver * longest);
}

OuterSurface outerSurface(const std::vector<SurfaceShell>& shells,
                          const std::function<bool(const Vector3&)>& isCovered, double fineness) {
    OuterSurface outer;
    std::atomic<std::size_t> pieces{0};
    for (std::size_t i = 0; i < shells.size(); ++i) {
        const Mesh& mesh = shells[i].mesh;
        std::vector<std::vector<Corners3>> kept(mesh.triangles.size());
        tbb::parallel_for(std::size_t(0), kept.size(), [&](std::size_t t) {
            const TriangleIndices& v = mesh.triangles[t];
            kept[t] = TriangleCut(shells, i, isCovered, fineness, pieces)
                          .cut({mesh.vertices[v[0]], mesh.vertices[v[1]], mesh.vertices[v[2]]});
        });
        for (std::size_t t = 0; t < kept.size(); ++t) {
            for (const Corners3& c : kept[t]) {
                const auto first = static_cast<std::uint32_t>(outer.mesh.vertices.size());
                outer.mesh.vertices.insert(outer.mesh.vertices.end(), c.begin(), c.end());
                outer.mesh.triangles.push_back({first, first + 1, first + 2});
                outer.triangles.push_back(shells[i].triangles[t]);
            }
        }
    }
    CleanMesh welded = clean(outer.mesh);
    std::vector<std::uint32_t> triangles;
    for (const std::uint32_t t : welded.triangleIds) triangles.push_back(outer.triangles[t]);
    outer.mesh.vertices = std::move(welded.vertices);
    outer.mesh.triangles = std::move(welded.triangles);
    outer.triangles = std::move(triangles);
    return outer;
}

}  // namespace clearway
