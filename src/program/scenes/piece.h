// The stuff scenes are made of: closed solids, placed in space and collected under names.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "clearway/mesh.h"

namespace clearway::scenes {

/// One closed solid, its triangles counter-clockwise seen from outside.
struct Piece {
    std::vector<Vector3> vertices;
    std::vector<TriangleIndices> triangles;
};

/// Where a point of a piece goes. It must keep right-handed axes right-handed, or the piece turns inside out.
using Placement = std::function<Vector3(const Vector3&)>;

Piece placed(Piece piece, const Placement& placement);

/// The placement that puts a piece's origin at `origin` and its z axis along `axis`, turned by `turn` radians
/// about it.
Placement standingAt(const Vector3& origin, const Vector3& axis, double turn = 0);

/// The placement that puts a piece's origin at `origin`, its z axis along `up` and its x axis, as nearly as
/// that allows, along `along`.
Placement facing(const Vector3& origin, const Vector3& along, const Vector3& up);

/// Pieces as the named components of one mesh, in the order they were added.
class Assembly {
  public:
    void add(const std::string& name, const Piece& piece);

    /// Adds the other's components, the prefix before their names.
    void include(const std::string& prefix, const Assembly& other);

    /// The number of components whose name is `stem` or begins with `stem` and an underscore, plus one, in
    /// two digits: "rib" gives "rib_01", "rib_02", ...
    std::string nextName(const std::string& stem);

    void addNumbered(const std::string& stem, const Piece& piece) { add(nextName(stem), piece); }

    std::size_t triangleCount() const { return mesh_.triangles.size(); }
    const std::vector<Component>& components() const { return mesh_.components; }

    /// Only the components of which `isKept` is true, by their places.
    Assembly keeping(const std::vector<bool>& isKept) const;

    /// Of a component.
    Box boxOf(std::size_t component) const;

    /// The mesh moved by `shift`, its coordinates rounded to float: mesh files hold no more.
    Mesh mesh(const Vector3& shift = Vector3::Zero()) const;

  private:
    Mesh mesh_;
    std::vector<std::pair<std::string, int>> counts_;
};

}  // namespace clearway::scenes
