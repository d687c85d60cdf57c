// How deep points lie below the closed surface of a part.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "clearway/mesh.h"
#include "clearway/model.h"
#include "clearway/query.h"
#include "model/solids.h"
#include "shrink/outer_surface.h"

namespace clearway {

/// The distance from the point to the nearest point of the triangle, or to that of its edges if the triangle is a
/// sliver. Never less than the distance, except for rounding.
double distanceToTriangle(const Vector3& point, const Corners3& triangle);

/// The distance of points to a mesh.
class PointDistance {
  public:
    explicit PointDistance(Model mesh);

    DistanceResult find(const Vector3& point, Workspace& workspace) const;
    double at(const Vector3& point, Workspace& workspace) const { return find(point, workspace).distance; }
    const Model& model() const { return mesh_; }

  private:
    Model mesh_, point_;
};

constexpr double kJoinFineness = 0.125;  ///< of the tolerance: where the part's surfaces meet

/// The closed surfaces of a mesh's components, each of which bounds a piece of the part. Where they touch or lie in
/// each other, only their outside counts: a wall within the part would make depths too small.
class SurfaceDepth {
  public:
    /// fineness: narrower gaps between connected surfaces count as filled; such surfaces meet. Throws
    /// ArgumentError, naming the component, if one is not closed or if a surface passes through itself.
    SurfaceDepth(const Mesh& mesh, double fineness);

    /// No depth is too small by more than this: 0, or twice the fineness where surfaces meet. Where gaps are
    /// filled, depths are those of the filled part.
    double slack() const { return everything_ ? 2 * fineness_ : 0; }

    /// The surface: the mesh itself or, where surfaces meet, pieces of its triangles.
    const Mesh& mesh() const { return mesh_; }
    std::uint32_t partTriangle(std::uint32_t triangle) const {  ///< its position in the given mesh
        return everything_ ? partTriangles_[triangle] : triangle;
    }
    const Model& model() const { return distance_.model(); }
    double rounding() const { return rounding_; }  ///< more than the error of computed lengths

    struct Place {
        double depth;  ///< the distance to the surface, negative outside; not rounded in one direction
        std::uint32_t triangle;  ///< the nearest one; its position in the mesh
        Vector3 nearest;         ///< the nearest point of the surface
    };
    Place at(const Vector3& point, Workspace& workspace) const;

    std::uint32_t nearest(const Vector3& point, Workspace& workspace) const;

    /// A component with triangles. Where surfaces meet, there is one piece for all components.
    struct Piece {
        std::string name;
        std::uint32_t firstTriangle, triangleCount;  ///< in mesh()
    };
    std::size_t pieceCount() const { return pieces_.size(); }
    const Piece& piece(std::size_t i) const { return pieces_[i]; }
    bool isInside(const Vector3& point) const;

    /// The part's connected bodies, each called as a component in it.
    const std::vector<std::string>& bodyNames() const { return bodyNames_; }

    /// The body with the triangle nearest to the point: for a point inside the part the one that holds it.
    std::size_t bodyNear(const Vector3& point, Workspace& workspace) const;

    /// Perpendicular to the triangle, of any length; 0 for one without area.
    Vector3 outwardNormal(std::uint32_t triangle) const;

    Corners3 corners(std::uint32_t triangle) const;

    /// One vertex of each shell of the given mesh.
    const std::vector<Vector3>& shellVertices() const { return shellVertices_; }

    /// Points of the surface, at least one on each connected piece of it.
    std::vector<Vector3> surfacePoints() const;

  private:
    std::optional<bool> isBehindFace(const Vector3& point, std::uint32_t triangle) const;
    bool isInComponent(const Vector3& point) const;
    bool isInGap(const Vector3& point, double distance, Workspace& workspace) const;
    std::vector<SurfaceShell> findShellsOf(const Component& component, std::size_t number);
    void requireNoSelfCrossing(const SurfaceShell& shell) const;
    static std::optional<std::size_t> shellAround(const std::vector<SurfaceShell>& shells, std::size_t i,
                                                  std::size_t component);
    void findBodies(const std::vector<SurfaceShell>& shells);
    Box grown(const Box& box) const;  ///< by the fineness
    bool doMeet(const std::vector<SurfaceShell>& shells) const;
    void join(const std::vector<SurfaceShell>& shells);

    Mesh mesh_;
    PointDistance distance_;
    double fineness_;
    std::optional<PointDistance> everything_;   ///< to all shells, where they meet
    std::vector<std::uint32_t> partTriangles_;  ///< where surfaces meet
    std::vector<Solid> solids_;
    std::vector<Piece> pieces_;
    bool hasFlatShell_ = false;  ///< one that encloses nothing
    std::vector<std::string> bodyNames_;
    std::vector<std::size_t> bodyOfTriangle_;  ///< of the given mesh
    std::vector<double> outwards_;  ///< for each triangle: 1, or -1 if it is listed to face inwards
    std::vector<Vector3> shellVertices_;
    double rounding_ = 0;
};

}  // namespace clearway
