// What a closed surface encloses. Whether a point lies inside is decided by the signed crossings of a ray,
// each by exact predicates; a point whose ray meets an edge or a corner counts as moved aside by less than
// any number ("Simulation of Simplicity", Edelsbrunner and Muecke, ACM Trans. Graphics 9, 1990).
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "clearway/mesh.h"
#include "clearway/types.h"

namespace clearway {

struct Shells;

class Solid {
  public:
    /// Of all the mesh's shells together: an inner shell that faces the other way bounds a cavity. A mesh
    /// whose outermost shells all face inwards is turned over. Throws std::invalid_argument that names the
    /// mesh and why it encloses nothing: edges that are open, twisted or shared by more than two triangles,
    /// or outermost shells of which some face outwards and some inwards.
    Solid(const Mesh& mesh, const std::string& name);

    bool isTurnedOver() const { return isTurnedOver_; }
    const Box& box() const { return box_; }  ///< mesh coordinates

    /// How often the surface, moved by X_aMesh, winds around the point moved by X_aPoint: above 0 inside,
    /// where both maps are exact. On the surface it is that of one of its sides.
    int winding(const Pose& X_aMesh, const Pose& X_aPoint, const Vector3& point) const;

    /// A vertex of each shell: where one is outside another surface and the two do not touch, all of it is.
    const std::vector<Vector3>& shellVertices() const { return shellVertices_; }

  private:
    /// Triangles sorted into boxes as seen along z.
    struct Node {
        double min[2], max[2], top;
        std::uint32_t first, last;  ///< of order_
        std::uint32_t right;        ///< child; the left one follows; 0 in a leaf
    };

    void addNode(std::uint32_t first, std::uint32_t last, int axis);
    /// Hands over the triangles that the ray from the point along the mesh's z crosses, and 1 where it leaves
    /// through the triangle's front, -1 where it enters there.
    template <class Take>
    void eachCrossing(const Pose& X_aMesh, const Pose& X_aPoint, const Vector3& point,
                      const Take& take) const;
    bool isOutermost(const Shells& shells, std::uint32_t shell) const;
    void orient(const std::string& name);

    std::vector<Vector3> vertices_;
    std::vector<TriangleIndices> triangles_;
    std::vector<std::uint32_t> order_;
    std::vector<Node> nodes_;
    std::vector<Vector3> shellVertices_;
    Box box_;
    bool isTurnedOver_ = false;
};

}  // namespace clearway
