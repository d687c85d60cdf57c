#include "isosurface/cut_surface.h"

#include <algorithm>
#include <unordered_map>

namespace clearway {
namespace {

constexpr double kLeastShare = 1.0 / 64;  ///< of an edge: its points keep so far from its ends

using PointOn = std::function<Vector3(std::uint32_t, std::uint32_t)>;

class Cutting {
  public:
    Cutting(const Tetrahedra& tetrahedra, const std::vector<double>& heights, const PointOn& pointOn)
        : tetrahedra_(tetrahedra), heights_(heights), pointOn_(pointOn) {}

    void cut(std::uint32_t number) {
        const auto& corners = tetrahedra_.all()[number].corners;
        for (const auto& edges : surfaceIn(corners, heights_)) {
            TriangleIndices triangle{at(edges[0]), at(edges[1]), at(edges[2])};
            if (!isRightHanded(corners)) std::swap(triangle[1], triangle[2]);
            surface_.mesh.triangles.push_back(triangle);
            surface_.tetrahedra.push_back(number);
        }
    }

    CutSurface take() { return std::move(surface_); }

  private:
    std::uint32_t at(const CutEdge& edge) {
        const std::uint64_t key = (std::uint64_t(edge.inner) << 32) | edge.outer;
        auto& vertices = surface_.mesh.vertices;
        const auto [entry, isNew] = points_.try_emplace(key, static_cast<std::uint32_t>(vertices.size()));
        if (isNew) vertices.push_back(pointOn_(edge.inner, edge.outer));
        return entry->second;
    }

    bool isRightHanded(const std::array<std::uint32_t, 4>& corners) const {
        const auto& v = tetrahedra_.vertices();
        const Vector3& base = v[corners[0]];
        return (v[corners[1]] - base).cross(v[corners[2]] - base).dot(v[corners[3]] - base) > 0;
    }

    const Tetrahedra& tetrahedra_;
    const std::vector<double>& heights_;
    const PointOn& pointOn_;
    std::unordered_map<std::uint64_t, std::uint32_t> points_;
    CutSurface surface_;
};

/// Whether it takes an odd number of exchanges to bring the first order into the second.
bool isOddOrder(const std::array<std::uint32_t, 4>& first, std::array<std::uint32_t, 4> second) {
    bool isOdd = false;
    for (int i = 0; i < 4; ++i) {
        const auto place = std::find(second.begin() + i, second.end(), first[i]);
        if (place == second.begin() + i) continue;
        std::swap(*place, second[i]);
        isOdd = !isOdd;
    }
    return isOdd;
}

}  // namespace

std::vector<std::array<CutEdge, 3>> surfaceIn(const std::array<std::uint32_t, 4>& corners,
                                              const std::vector<double>& heights) {
    std::array<std::uint32_t, 4> s = corners;  // the inner ones first
    const auto middle =
        std::stable_partition(s.begin(), s.end(), [&](std::uint32_t c) { return heights[c] >= 0; });
    const auto inside = middle - s.begin();
    std::vector<std::array<CutEdge, 3>> found;
    if (inside == 1) found = {{{{s[0], s[1]}, {s[0], s[2]}, {s[0], s[3]}}}};
    if (inside == 3) found = {{{{s[0], s[3]}, {s[1], s[3]}, {s[2], s[3]}}}};
    if (inside == 2) {
        const CutEdge a{s[0], s[2]}, b{s[1], s[2]}, c{s[1], s[3]}, d{s[0], s[3]};
        found = {{{a, b, c}}, {{a, c, d}}};
    }
    // In a right-handed order these face outwards if one corner or three are inside, and inwards if two are.
    const bool isTurned = isOddOrder(corners, s) != (inside == 2);
    for (auto& edges : found) {
        if (isTurned) std::swap(edges[1], edges[2]);
    }
    return found;
}

Vector3 pointOnEdge(const Vector3& from, const Vector3& to, double share) {
    return from + std::clamp(share, kLeastShare, 1 - kLeastShare) * (to - from);
}

Vector3 cutPoint(const Vector3& inner, double innerHeight, const Vector3& outer, double outerHeight) {
    return pointOnEdge(inner, outer, innerHeight / (innerHeight - outerHeight));
}

CutSurface cutSurface(const Tetrahedra& tetrahedra, const std::vector<double>& heights,
                      const PointOn& pointOn) {
    const PointOn usual = [&](std::uint32_t inner, std::uint32_t outer) {
        const auto& v = tetrahedra.vertices();
        return cutPoint(v[inner], heights[inner], v[outer], heights[outer]);
    };
    Cutting cutting(tetrahedra, heights, pointOn ? pointOn : usual);
    for (std::uint32_t i = 0; i < tetrahedra.all().size(); ++i) cutting.cut(i);
    return cutting.take();
}

}  // namespace clearway
