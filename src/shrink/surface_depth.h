// How deep points lie below the closed surface of a part.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "clearway/mesh.h"
#include "clearway/model.h"
#include "clearway/query.h"
#include "model/solids.h"

namespace clearway {

using Corners3 = std::array<Vector3, 3>;

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

/// The closed surfaces of a mesh's components, each of which bounds a piece of the part.
class SurfaceDepth {
  public:
    /// Throws std::invalid_argument, naming the components, if one is not closed, if two pieces of the surface
    /// touch or lie in each other, or if one passes through itself: then a wall within the part would count as
    /// its surface, and depths would be too small.
    explicit SurfaceDepth(const Mesh& mesh);

    const Mesh& mesh() const { return mesh_; }
    const Model& model() const { return distance_.model(); }
    double rounding() const { return rounding_; }  ///< more than the error of computed lengths

    struct Place {
        double depth;  ///< the distance to the surface, negative outside; not rounded in one direction
        std::uint32_t triangle;  ///< the nearest one; its position in the mesh
    };
    Place at(const Vector3& point, Workspace& workspace) const;

    std::uint32_t nearest(const Vector3& point, Workspace& workspace) const;  ///< a triangle

    /// A component with triangles.
    struct Piece {
        std::string name;
        std::uint32_t firstTriangle, triangleCount;
        double outwards;  ///< 1, or -1 if its triangles are listed to face inwards
    };
    std::size_t pieceCount() const { return pieces_.size(); }
    const Piece& piece(std::size_t i) const { return pieces_[i]; }
    Mesh meshOf(std::size_t piece) const;
    std::optional<std::size_t> pieceHolding(const Vector3& point) const;

    bool isInside(const Vector3& point) const { return pieceHolding(point).has_value(); }

    /// Perpendicular to the triangle, of any length; 0 for one without area.
    Vector3 outwardNormal(std::uint32_t triangle) const;

    Corners3 corners(std::uint32_t triangle) const;

    /// One vertex of each connected piece of the surface.
    const std::vector<Vector3>& shellVertices() const { return shellVertices_; }

  private:
    std::optional<bool> isBehindFace(const Vector3& point, std::uint32_t triangle) const;
    /// A connected piece of the surface.
    struct Shell {
        std::size_t piece;
        bool isCavity;
        Solid solid;
        Model model;
    };
    void requireSimple() const;
    void addShells(std::size_t piece, std::vector<Shell>& shells) const;
    [[noreturn]] void refuseMeeting(std::size_t a, std::size_t b) const;
    void requireNoSelfCrossing() const;

    Mesh mesh_;
    PointDistance distance_;
    std::vector<Solid> solids_;
    std::vector<Piece> pieces_;
    std::vector<double> outwards_;  ///< for each triangle: 1, or -1 if it is listed to face inwards
    std::vector<Vector3> shellVertices_;
    double rounding_ = 0;
};

}  // namespace clearway
