// The insides of closed surfaces. A point's position is decided by the signed crossings of a ray, each by
// exact predicates.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "clearway/scene.h"
#include "model/box_tree.h"

namespace clearway {

class ZRay;
struct Shells;
struct WeldedSurface;

/// The inside of one closed mesh.
class Solid {
  public:
    /// Takes all the mesh's shells together: an inner shell that faces the other way bounds a cavity. A mesh
    /// whose outermost shells all face inwards is turned over. Throws ArgumentError that names the
    /// mesh and why it encloses nothing: its edges are open or twisted, more than two triangles share an edge and do
    /// not face in pairs there, or some of its surface faces outwards and some inwards.
    Solid(const Mesh& mesh, const std::string& name);

    /// Makes the solid of a mesh that is already welded, without a copy.
    Solid(WeldedSurface surface, const std::string& name);

    /// Takes a mesh as it is, with equal triangles and others that face inwards: along each edge as many sides must lead one way as the
    /// other way, which is not checked.
    static Solid oriented(const Mesh& mesh);

    bool isTurnedOver() const { return isTurnedOver_; }
    const Box& box() const { return box_; }  ///< mesh coordinates

    /// How often the surface, moved by X_aMesh, winds around the point moved by X_aPoint, in exact arithmetic
    /// of both maps: above 0 inside. For a point on the surface the answer is that of one of its sides.
    int winding(const Pose& X_aMesh, const Pose& X_aPoint, const Vector3& point) const;
    int winding(const ZRay& fromPoint) const;  ///< fromPoint: a ray in this mesh

    /// One vertex of each shell. If this vertex is outside another surface and the two surfaces do not touch,
    /// the whole shell is outside.
    const std::vector<Vector3>& shellVertices() const { return shellVertices_; }

  private:
    /// Calls take(triangle, sign) for the triangles that the ray crosses. sign: as ZRay::crossing.
    template <class Take>
    void eachCrossing(const ZRay& ray, const Take& take) const;
    Solid() = default;
    void boxTriangles();
    std::vector<bool> findOutermost(const Shells& shells) const;
    void orient(const Shells& shells, const std::string& name);
    void lookInFront(const std::string& name) const;

    std::vector<Vector3> vertices_;
    std::vector<TriangleIndices> triangles_;
    BoxTree tree_;  ///< of the triangles
    std::vector<Vector3> shellVertices_;
    Box box_;
    bool isTurnedOver_ = false;
};

/// The insides of a mesh's closed components, and one vertex of each of its connected pieces.
class Solids {
  public:
    /// Records why components enclose nothing and which were turned over. Throws ArgumentError as
    /// Model::build does.
    explicit Solids(const Mesh& mesh);

    /// A solid of each component, as Solid::oriented takes it.
    static Solids oriented(const Mesh& mesh);

    /// The solid and the pieces of one component alone.
    Solids ofComponent(std::size_t component) const;

    /// Whether one of the solids holds the point, in mesh coordinates. For a point on the surface the answer is that of one of its sides.
    bool hold(const Vector3& point) const;

    const std::vector<std::string>& refusals() const { return refusals_; }
    const std::vector<std::string>& turnedOver() const { return turnedOver_; }

    /// A component of one mesh that holds a piece of the other.
    struct Enclosure {
        const std::string* outer;
        const std::string* inner;
    };

    /// A solid of this mesh that holds a piece of `inner`, both moved, provided that no two of their surfaces
    /// touch. Exact; allocates nothing.
    std::optional<Enclosure> holding(const Pose& X_aThis, const Solids& inner, const Pose& X_aInner) const;

  private:
    struct NamedSolid {
        Solid solid;
        std::size_t component;
    };
    struct Piece {
        Vector3 vertex;
        std::size_t component;
    };
    Solids() = default;
    void findTrees();
    Box boxIn(const Pose& X_aOther, const Pose& X_aThis) const;

    std::vector<std::string> names_;  ///< of the components
    std::vector<NamedSolid> solids_;
    std::vector<Piece> pieces_;
    Box box_;  ///< around all solids
    BoxTree solidTree_, pieceTree_;
    std::vector<std::string> refusals_, turnedOver_;
};

}  // namespace clearway
