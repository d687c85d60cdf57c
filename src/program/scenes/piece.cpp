#include "program/scenes/piece.h"

#include <algorithm>
#include <cmath>

namespace clearway::scenes {

Piece placed(Piece piece, const Placement& placement) {
    for (Vector3& vertex : piece.vertices) vertex = placement(vertex);
    return piece;
}

Placement standingAt(const Vector3& origin, const Vector3& axis, double turn) {
    Matrix3 upright;
    upright.col(2) = axis.normalized();
    upright.col(0) = upright.col(2).unitOrthogonal();
    upright.col(1) = upright.col(2).cross(upright.col(0));
    const Matrix3 rotation = upright * Eigen::AngleAxisd(turn, Vector3::UnitZ()).toRotationMatrix();
    return [rotation, origin](const Vector3& p) -> Vector3 { return rotation * p + origin; };
}

Placement facing(const Vector3& origin, const Vector3& along, const Vector3& up) {
    Matrix3 rotation;
    rotation.col(2) = up.normalized();
    rotation.col(1) = up.cross(along).normalized();
    rotation.col(0) = rotation.col(1).cross(rotation.col(2));
    return [rotation, origin](const Vector3& p) -> Vector3 { return rotation * p + origin; };
}

void Assembly::add(const std::string& name, const Piece& piece) {
    const auto firstVertex = static_cast<std::uint32_t>(mesh_.vertices.size());
    const auto firstTriangle = static_cast<std::uint32_t>(mesh_.triangles.size());
    mesh_.vertices.insert(mesh_.vertices.end(), piece.vertices.begin(), piece.vertices.end());
    for (const TriangleIndices& triangle : piece.triangles) {
        mesh_.triangles.push_back(
            {triangle[0] + firstVertex, triangle[1] + firstVertex, triangle[2] + firstVertex});
    }
    mesh_.components.push_back({name, firstTriangle, static_cast<std::uint32_t>(piece.triangles.size())});
}

void Assembly::include(const std::string& prefix, const Assembly& other) {
    const auto firstVertex = static_cast<std::uint32_t>(mesh_.vertices.size());
    const auto firstTriangle = static_cast<std::uint32_t>(mesh_.triangles.size());
    mesh_.vertices.insert(mesh_.vertices.end(), other.mesh_.vertices.begin(), other.mesh_.vertices.end());
    for (const TriangleIndices& t : other.mesh_.triangles)
        mesh_.triangles.push_back({t[0] + firstVertex, t[1] + firstVertex, t[2] + firstVertex});
    for (Component component : other.mesh_.components) {
        component.name = prefix + component.name;
        component.firstTriangle += firstTriangle;
        mesh_.components.push_back(component);
    }
}

Box Assembly::boxOf(std::size_t component) const {
    const Component& of = mesh_.components[component];
    Box box;
    for (std::uint32_t i = 0; i < of.triangleCount; ++i)
        for (const std::uint32_t corner : mesh_.triangles[of.firstTriangle + i])
            box.extend(mesh_.vertices[corner]);
    return box;
}

/// Components' vertices follow each other as their triangles do.
Assembly Assembly::keeping(const std::vector<bool>& isKept) const {
    Assembly kept;
    kept.counts_ = counts_;
    for (std::size_t c = 0; c < mesh_.components.size(); ++c) {
        if (!isKept[c]) continue;
        const Component& of = mesh_.components[c];
        std::uint32_t first = UINT32_MAX, last = 0;
        Piece piece;
        for (std::uint32_t i = 0; i < of.triangleCount; ++i) {
            piece.triangles.push_back(mesh_.triangles[of.firstTriangle + i]);
            for (const std::uint32_t corner : piece.triangles.back()) {
                first = std::min(first, corner);
                last = std::max(last, corner);
            }
        }
        piece.vertices.assign(mesh_.vertices.begin() + first, mesh_.vertices.begin() + last + 1);
        for (TriangleIndices& t : piece.triangles)
            for (std::uint32_t& corner : t) corner -= first;
        kept.add(of.name, piece);
    }
    return kept;
}

std::string Assembly::nextName(const std::string& stem) {
    auto found = std::find_if(counts_.begin(), counts_.end(), [&](const auto& c) { return c.first == stem; });
    if (found == counts_.end()) found = counts_.insert(counts_.end(), {stem, 0});
    const int number = ++found->second;
    return stem + (number < 10 ? "_0" : "_") + std::to_string(number);
}

Mesh Assembly::mesh(const Vector3& shift) const {
    Mesh rounded = mesh_;
    for (Vector3& vertex : rounded.vertices) {
        // Adding zero turns -0 into 0, which text formats would not keep apart alike.
        vertex = (vertex + shift).cast<float>().cast<double>() + Vector3::Zero();
    }
    return rounded;
}

}  // namespace clearway::scenes
