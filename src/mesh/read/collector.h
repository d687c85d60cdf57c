// Collects what readers of mesh files find: vertices, polygons, components and notes.
#pragma once

#include <fmt/format.h>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

#include "clearway/mesh.h"

namespace clearway {

/// An affine map from the coordinates of a node, an object or an instance to those of the file; in double.
struct Placement {
    Matrix3 linear = Matrix3::Identity();
    Vector3 translation = Vector3::Zero();

    Vector3 operator()(const Vector3& point) const { return linear * point + translation; }
    bool isMirrored() const { return linear.determinant() < 0; }
};

/// First b, then a.
inline Placement operator*(const Placement& a, const Placement& b) {
    return {a.linear * b.linear, a(b.translation)};
}

/// Collects a mesh from a file. Polygons are triangulated as they come.
class MeshCollector {
  public:
    /// file: the path, for messages and for files that the file refers to.
    explicit MeshCollector(const std::string& file);

    const std::string& file() const { return mesh_.origin.file; }

    /// Throws FileError: cannot read mesh 'FILE': REASON. The reason names the element and its number, the value and what was
    /// expected.
    [[noreturn]] void refuse(const std::string& reason) const;
    template <class... Values>
    [[noreturn]] void refuse(fmt::format_string<Values...> reason, Values&&... values) const {
        refuse(fmt::format(reason, std::forward<Values>(values)...));
    }

    /// Faces from here on belong to a component of this name; it may be empty, or another component's.
    void beginComponent(std::string_view name, double deflection = 0);

    void reserve(std::size_t vertices, std::size_t triangles);

    std::size_t vertexCount() const { return mesh_.vertices.size(); }

    /// Returns the position among the vertices.
    std::uint32_t addVertex(const Vector3& vertex);

    /// A face of three or more corners, which are positions of vertices that have been added. The caller has checked that they are in
    /// range. Counts a face of one or two corners as ignored.
    void addFace(const std::uint32_t* corners, std::size_t count);

    /// The fastest way to add a triangle.
    void addTriangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        mesh_.triangles.push_back({a, b, c});
    }

    /// Counts points and lines, which a mesh leaves out.
    void ignoreFaces(std::size_t count) { mesh_.origin.ignoredFaces += count; }

    void note(std::string text) { mesh_.origin.notes.push_back(std::move(text)); }
    template <class... Values>
    void note(fmt::format_string<Values...> text, Values&&... values) {
        note(fmt::format(text, std::forward<Values>(values)...));
    }

    /// Judges the bytes after the last element that the file declares. Notes up to `most` bytes, and accepts any number of zeros and blanks: some
    /// writers add them. Refuses more, which may be elements that the file does not count. declared: what it counts, such as "its 12
    /// triangles".
    void acceptTail(std::string_view tail, std::size_t most, const std::string& declared);

    /// The unit that the file states, in metres, and its up axis ('x', 'y' or 'z'). Both are shown, and never applied in the stored reading.
    void setUnit(double metres) { mesh_.origin.unitMetres = metres; }
    void setUpAxis(char axis) { mesh_.origin.upAxis = axis; }

    /// The mesh; components without faces are left out, the others get names as loadMesh promises. Refuses a mesh without triangles.
    Mesh take();

  private:
    void closeComponent();

    Mesh mesh_;
    std::string name_;
    double deflection_ = 0;
    std::size_t first_ = 0;  ///< triangle of the component that is being collected
};

}  // namespace clearway
