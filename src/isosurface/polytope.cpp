#include "isosurface/polytope.h"

namespace clearway {
namespace {

bool isEdge(const Polytope::Corner& a, const Polytope::Corner& b) {
    const std::uint32_t shared = a.planes & b.planes;
    return (shared & (shared - 1)) != 0;  // two planes or more
}

}  // namespace

Polytope::Polytope(const std::array<Vector3, 4>& tetrahedron) {
    for (std::uint32_t k = 0; k < 4; ++k) corners_.push_back({tetrahedron[k], 15u & ~(1u << k)});
}

Vector3 Polytope::centre() const {
    Vector3 sum = Vector3::Zero();
    for (const Corner& corner : corners_) sum += corner.point;
    return sum / double(corners_.size());
}

Polytope Polytope::cut(const std::vector<double>& values) const {
    Polytope piece;
    const std::uint32_t plane = 1u << planeCount_;
    piece.planeCount_ = planeCount_ + 1;
    for (std::size_t i = 0; i < corners_.size(); ++i) {
        if (values[i] >= 0) piece.corners_.push_back(corners_[i]);
        if (values[i] == 0) piece.corners_.back().planes |= plane;
        for (std::size_t j = 0; j < i; ++j) {
            const double a = values[i], b = values[j];
            if (!((a > 0 && b < 0) || (a < 0 && b > 0)) || !isEdge(corners_[i], corners_[j])) continue;
            const Vector3 &p = corners_[i].point, &q = corners_[j].point;
            piece.corners_.push_back(
                {p + a / (a - b) * (q - p), (corners_[i].planes & corners_[j].planes) | plane});
        }
    }
    return piece;
}

Mesh Polytope::surface() const {
    Mesh mesh;
    const auto count = static_cast<std::uint32_t>(corners_.size());
    for (const Corner& corner : corners_) mesh.vertices.push_back(corner.point);
    for (std::uint32_t i = 0; i < count; ++i) {
        for (std::uint32_t j = i + 1; j < count; ++j) {
            for (std::uint32_t k = j + 1; k < count; ++k) {
                if ((corners_[i].planes & corners_[j].planes & corners_[k].planes) != 0) {
                    mesh.triangles.push_back({i, j, k});
                }
            }
        }
    }
    return mesh;
}

}  // namespace clearway
