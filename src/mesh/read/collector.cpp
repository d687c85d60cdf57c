#include "mesh/read/collector.h"

#include <algorithm>
#include <filesystem>
#include <limits>

#include "clearway/errors.h"
#include "mesh/components.h"
#include "mesh/read/polygon.h"

namespace clearway {
namespace {

/// Share of a polygon's size. Rounding to float, or to six digits of a text, bends polygons by less.
constexpr double kFlat = 1e-4;

}  // namespace

MeshCollector::MeshCollector(const std::string& file) {
    mesh_.origin.file = file;
}

void MeshCollector::refuse(const std::string& reason) const {
    throw FileError(fmt::format("cannot read mesh '{}': {}", file(), reason));
}

void MeshCollector::beginComponent(std::string_view name, double deflection) {
    closeComponent();
    name_ = name;
    deflection_ = deflection;
}

void MeshCollector::closeComponent() {
    const std::size_t count = mesh_.triangles.size() - first_;
    if (count > 0) {
        mesh_.components.push_back(
            {name_, static_cast<std::uint32_t>(first_), static_cast<std::uint32_t>(count), deflection_});
        mesh_.origin.deflection = std::max(mesh_.origin.deflection, deflection_);
    }
    first_ = mesh_.triangles.size();
}

void MeshCollector::reserve(std::size_t vertices, std::size_t triangles) {
    mesh_.vertices.reserve(vertices);
    mesh_.triangles.reserve(triangles);
}

std::uint32_t MeshCollector::addVertex(const Vector3& vertex) {
    if (mesh_.vertices.size() == std::numeric_limits<std::uint32_t>::max())
        refuse("it has more than 2^32 - 1 vertices");
    mesh_.vertices.push_back(vertex);
    return static_cast<std::uint32_t>(mesh_.vertices.size() - 1);
}

void MeshCollector::addFace(const std::uint32_t* corners, std::size_t count) {
    if (count == 3) return addTriangle(corners[0], corners[1], corners[2]);
    if (count < 3) return ignoreFaces(1);
    MeshOrigin& origin = mesh_.origin;
    const PolygonShape shape = triangulate(mesh_.vertices, corners, count, mesh_.triangles);
    if (!shape.isFilled) {
        ++origin.crossingFaces;
        origin.ignoredFaces += count - 2;
    } else if (shape.height > kFlat * shape.size) {
        ++origin.bentFaces;
        origin.bentBy = std::max(origin.bentBy, shape.height);
    }
}

void MeshCollector::acceptTail(std::string_view tail, std::size_t most, const std::string& declared) {
    if (tail.empty()) return;
    const std::string follow = fmt::format("{} bytes after {}", tail.size(), declared);
    const bool isBlank = tail.find_first_not_of(std::string_view(" \t\r\n\f\v\0", 7)) == tail.npos;
    if (tail.size() > most && !isBlank) refuse("it has {}, expected none", follow);
    if (!isBlank) note("left out: " + follow);
}

Mesh MeshCollector::take() {
    closeComponent();
    if (mesh_.triangles.empty()) {
        const std::size_t crossing = mesh_.origin.crossingFaces;
        refuse("it holds no triangle{}, expected at least one",
               crossing > 0 ? fmt::format(": the outlines of its {} faces cross themselves", crossing)
                            : std::string());
    }
    if (mesh_.triangles.size() > std::numeric_limits<std::uint32_t>::max())
        refuse("it has more than 2^32 - 1 triangles");
    makeNamesDistinct(mesh_.components, std::filesystem::path(file()).stem().string());
    return std::move(mesh_);
}

}  // namespace clearway
