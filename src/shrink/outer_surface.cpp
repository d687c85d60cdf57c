#include "shrink/outer_surface.h"

#include <algorithm>
#include <atomic>
#include <string>

#include "clearway/errors.h"
#include "clearway/query.h"
#include "core/parallel.h"
#include "mesh/clean.h"

namespace clearway {
namespace {

constexpr double kSliver = 1e-4;
constexpr std::size_t kMostOuterPieces = 8'000'000;
constexpr double kNearCorner = 0.98;   ///< where a piece is looked at, from its middle to its corners
constexpr double kUprightSine = 1e-6;  ///< sine, more than the rounding of right angles in files of floats
constexpr double kTouch = 1e-6;        ///< of the fineness: how far a triangle must reach into a prism

/// The space between a triangle and its copy at some height.
class Prism {
  public:
    /// normal: the triangle's, of length 1, towards its copy.
    Prism(const Corners3& base, const Vector3& normal, double height)
        : base_(base), normal_(normal), height_(height) {
        const double turned = normal.dot((base[1] - base[0]).cross(base[2] - base[0])) < 0 ? -1 : 1;
        for (int k = 0; k < 3; ++k)
            inwards_[k] = turned * normal.cross(base[(k + 1) % 3] - base[k]).normalized();
        for (const Vector3& corner : base) {
            box_.extend(corner);
            box_.extend(Vector3(corner + height * normal));
        }
    }

    const Box& box() const { return box_; }

    bool reaches(const Corners3& triangle) const {
        std::vector<Vector3> left(triangle.begin(), triangle.end());
        clip(left, [&](const Vector3& p) { return normal_.dot(p - base_[0]); });
        clip(left, [&](const Vector3& p) { return height_ - normal_.dot(p - base_[0]); });
        for (int k = 0; k < 3; ++k)
            clip(left, [&](const Vector3& p) { return inwards_[k].dot(p - base_[k]) - kTouch * height_; });
        return !left.empty();
    }

  private:
    /// Cuts off what lies below a plane. height: above the plane.
    template <class Height>
    static void clip(std::vector<Vector3>& corners, const Height& height) {
        std::vector<Vector3> left;
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const Vector3 &a = corners[i], &b = corners[(i + 1) % corners.size()];
            const double atA = height(a), atB = height(b);
            if (atA >= 0) left.push_back(a);
            if ((atA < 0) != (atB < 0)) left.push_back(a + atA / (atA - atB) * (b - a));
        }
        corners = std::move(left);
    }

    Corners3 base_;
    Vector3 normal_;
    double height_;
    std::array<Vector3, 3> inwards_;
    Box box_;
};

struct Face {
    Corners3 corners;
    Vector3 normal;  ///< outwards, its length is twice the area
    Box box;
};

/// The triangles of a shell, found by their boxes.
class Faces {
  public:
    explicit Faces(const SurfaceShell& shell) {
        for (const TriangleIndices& t : shell.mesh.triangles) {
            const std::vector<Vector3>& v = shell.mesh.vertices;
            Face face{{v[t[0]], v[t[1]], v[t[2]]}, {}, {}};
            const auto& [a, b, c] = face.corners;
            face.normal = shell.outwards * (b - a).cross(c - a);
            for (const Vector3& corner : face.corners) face.box.extend(corner);
            widest_ = std::max(widest_, face.box.sizes().x());
            all_.push_back(face);
        }
        for (const Face& face : all_) byX_.push_back(&face);
        std::sort(byX_.begin(), byX_.end(),
                  [](const Face* a, const Face* b) { return a->box.min().x() < b->box.min().x(); });
    }

    const std::vector<Face>& all() const { return all_; }

    std::vector<const Face*> near(const Box& box) const {
        auto face = std::lower_bound(byX_.begin(), byX_.end(), box.min().x() - widest_,
                                     [](const Face* listed, double x) { return listed->box.min().x() < x; });
        std::vector<const Face*> found;
        for (; face != byX_.end() && (*face)->box.min().x() <= box.max().x(); ++face) {
            if ((*face)->box.intersects(box)) found.push_back(*face);
        }
        return found;
    }

  private:
    std::vector<Face> all_;
    std::vector<const Face*> byX_;
    double widest_ = 0;
};

/// Cuts one triangle of a shell.
class TriangleCut {
  public:
    TriangleCut(const std::vector<SurfaceShell>& shells, std::size_t own, const Faces& ownFaces,
                const std::function<bool(const Vector3&)>& isCovered, double fineness,
                std::atomic<std::size_t>& pieces)
        : shells_(shells),
          own_(own),
          ownFaces_(ownFaces),
          isCovered_(isCovered),
          fineness_(fineness),
          pieces_(pieces) {}

    std::vector<Corners3> cut(const Face& face) {
        if (!(face.normal.squaredNorm() > 0)) return {};  // its points are those of its neighbours
        normal_ = face.normal.normalized();
        isSliver_ = isSliver(face.corners, face.normal);
        Near near;
        for (std::size_t i = 0; i < shells_.size(); ++i) {
            if (i != own_) near.shells.push_back(i);
        }
        Box around;
        for (const Prism& prism : prismsOf(face.corners)) around.extend(prism.box());
        for (const Face* other : ownFaces_.near(around)) {
            if (other != &face && mayFace(*other)) near.faces.push_back(other);
        }
        look(face.corners, near);
        return std::move(kept_);
    }

  private:
    /// The shells and faces that may cover a part of a triangle.
    struct Near {
        std::vector<std::size_t> shells;
        std::vector<const Face*> faces;  ///< of the triangle's own shell
    };

    void look(const Corners3& c, const Near& near) {
        if (++pieces_ > kMostOuterPieces) {
            throw ArgumentError(
                "overlap needs the outside of a part whose components touch, and this takes "
                "more than " +
                std::to_string(kMostOuterPieces) + " pieces, expected a larger overlap or overlap.tolerance");
        }
        int longest = 0;
        for (int k = 1; k < 3; ++k) {
            if (lengthSquared(c, k) > lengthSquared(c, longest)) longest = k;
        }
        Near nearer;
        if (isUniform(c, near, nearer) || lengthSquared(c, longest) <= fineness_ * fineness_) {
            if (isOutsideSomewhere(c)) kept_.push_back(c);
            return;
        }
        const Vector3 &a = c[longest], &b = c[(longest + 1) % 3], &tip = c[(longest + 2) % 3];
        const Vector3 between = 0.5 * (a + b);
        look({a, between, tip}, nearer);
        look({between, b, tip}, nearer);
    }

    static double lengthSquared(const Corners3& c, int k) { return (c[(k + 1) % 3] - c[k]).squaredNorm(); }

    std::vector<Prism> prismsOf(const Corners3& c) const {
        std::vector<Prism> prisms = {Prism(c, normal_, fineness_)};
        if (isSliver_) prisms.emplace_back(c, -normal_, fineness_);
        return prisms;
    }

    /// A way from the triangle along its normal enters the part only through faces that look against it.
    bool mayFace(const Face& other) const {
        return isSliver_ || isSliver(other.corners, other.normal) ||
               other.normal.dot(normal_) < -kUprightSine * other.normal.norm();
    }

    /// Whether all points of the triangle are covered, or none is: the copy of it in front touches no other shell,
    /// and the own one does not come back before that. Lists in `nearer` what is near the triangle.
    bool isUniform(const Corners3& c, const Near& near, Near& nearer) {
        const std::vector<Prism> prisms = prismsOf(c);
        for (const Face* face : near.faces) {
            const bool isReached = std::any_of(prisms.begin(), prisms.end(), [&](const Prism& prism) {
                return face->box.intersects(prism.box()) && prism.reaches(face->corners);
            });
            if (isReached) nearer.faces.push_back(face);
        }
        bool isApart = nearer.faces.empty();
        for (const double side : {1.0, -1.0}) {
            if (side < 0 && !isSliver_) break;
            const Vector3 ahead = side * fineness_ * normal_;
            isApart = isApartFrom(near.shells, {c[0] + ahead, c[1] + ahead, c[2] + ahead}, nearer.shells) &&
                      isApart;
        }
        return isApart;
    }

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
            if (!model) model = smallModel(mesh);
            isApart = !collides(*model, shells_[i].model, {}, workspace_);
        }
        return isApart;
    }

    bool isOutsideSomewhere(const Corners3& c) const {
        const Vector3 middle = (c[0] + c[1] + c[2]) / 3;
        return isOutside(middle) || std::any_of(c.begin(), c.end(), [&](const Vector3& corner) {
                   return isOutside(middle + kNearCorner * (corner - middle));
               });
    }

    /// A sliver's normal may point either way, but behind it is the part.
    bool isOutside(const Vector3& point) const {
        const Vector3 ahead = fineness_ * normal_;
        return !isCovered_(point + ahead) || (isSliver_ && !isCovered_(point - ahead));
    }

    const std::vector<SurfaceShell>& shells_;
    const std::size_t own_;
    const Faces& ownFaces_;
    const std::function<bool(const Vector3&)>& isCovered_;
    const double fineness_;
    std::atomic<std::size_t>& pieces_;
    Vector3 normal_ = Vector3::Zero();
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

Model smallModel(const Mesh& mesh) {
    BuildOptions options;
    options.generalSplit = "mean";
    options.fit = "covariance";
    options.leafSize = kLargestLeafSize;
    options.threads = 1;
    return Model::build(mesh, options);
}

OuterSurface outerSurface(const std::vector<SurfaceShell>& shells,
                          const std::function<bool(const Vector3&)>& isCovered, double fineness) {
    OuterSurface outer;
    std::atomic<std::size_t> pieces{0};
    for (std::size_t i = 0; i < shells.size(); ++i) {
        const Faces faces(shells[i]);
        std::vector<std::vector<Corners3>> kept(faces.all().size());
        forEachInParallel(kept.size(), [&](std::size_t t) {
            kept[t] = TriangleCut(shells, i, faces, isCovered, fineness, pieces).cut(faces.all()[t]);
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
