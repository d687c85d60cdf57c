#include "isosurface/cut_surface.h"

#include <algorithm>
#include <unordered_map>

namespace clearway {
namespace {

/// Of an edge's length.
constexpr double kLeastShare = 1.0 / 64;

class Cutting {
  public:
    Cutting(const Tetrahedra& tetrahedra, const std::vector<double>& heights)
        : tetrahedra_(tetrahedra), heights_(heights) {}

    void cut(std::uint32_t number) {
        const auto& corners = tetrahedra_.all()[number].corners;
        std::array<std::uint32_t, 4> sorted = corners;
        const auto middle = std::stable_partition(sorted.begin(), sorted.end(),
                                                  [&](std::uint32_t c) { return heights_[c] >= 0; });
        const auto inside = middle - sorted.begin();
        if (inside == 0 || inside == 4) return;
        const auto& s = sorted;
        const bool isRightHanded = determinant(s) > 0;
        if (inside == 1) add(number, {at(s[0], s[1]), at(s[0], s[2]), at(s[0], s[3])}, !isRightHanded);
        if (inside == 3) add(number, {at(s[0], s[3]), at(s[1], s[3]), at(s[2], s[3])}, !isRightHanded);
        if (inside == 2) {
            const std::uint32_t a = at(s[0], s[2]), b = at(s[1], s[2]), c = at(s[1], s[3]),
                                d = at(s[0], s[3]);
            add(number, {a, b, c}, isRightHanded);
            add(number, {a, c, d}, isRightHanded);
        }
    }

    CutSurface take() { return std::move(surface_); }

  private:
    std::uint32_t at(std::uint32_t inner, std::uint32_t outer) {
        const std::uint64_t key = (std::uint64_t(inner) << 32) | outer;
        auto& vertices = surface_.mesh.vertices;
        const auto [entry, isNew] = points_.try_emplace(key, static_cast<std::uint32_t>(vertices.size()));
        if (isNew) {
            vertices.push_back(cutPoint(tetrahedra_.vertices()[inner], heights_[inner],
                                        tetrahedra_.vertices()[outer], heights_[outer]));
        }
        return entry->second;
    }

    double determinant(const std::array<std::uint32_t, 4>& corners) const {
        const auto& v = tetrahedra_.vertices();
        const Vector3& base = v[corners[0]];
        return (v[corners[1]] - base).cross(v[corners[2]] - base).dot(v[corners[3]] - base);
    }

    void add(std::uint32_t number, TriangleIndices triangle, bool isTurned) {
        if (isTurned) std::swap(triangle[1], triangle[2]);
        surface_.mesh.triangles.push_back(triangle);
        surface_.tetrahedra.push_back(number);
    }

    const Tetrahedra& tetrahedra_;
    const std::vector<double>& heights_;
    std::unordered_map<std::uint64_t, std::uint32_t> points_;
    CutSurface surface_;
};

}  // namespace

Vector3 cutPoint(const Vector3& inner, double innerHeight, const Vector3& outer, double outerHeight) {
    const double share = std::clamp(innerHeight / (innerHeight - outerHeight), kLeastShare, 1 - kLeastShare);
    return inner + share * (outer - inner);
}

CutSurface cutSurface(const Tetrahedra& tetrahedra, const std::vector<double>& heights) {
    Cutting cutting(tetrahedra, heights);
    for (std::uint32_t i = 0; i < tetrahedra.all().size(); ++i) cutting.cut(i);
    return cutting.take();
}

}  // namespace clearway
