#include "swept/cut_surface.h"

#include <algorithm>
#include <unordered_map>

namespace clearway {
namespace {

constexpr double kLeastShare = 1.0 / 64;  ///< of an edge: its points keep so far from its ends

std::uint64_t edgeKey(const CutEdge& edge) {
    return (std::uint64_t(edge.inner) << 32) | edge.outer;
}

class Cutting {
  public:
    Cutting(const Tetrahedra& tetrahedra, const std::vector<double>& heights, const PointOnEdge& pointOn)
        : tetrahedra_(tetrahedra), heights_(heights), pointOn_(pointOn) {}

    void cut(std::uint32_t number) {
        const Tetrahedron& tetrahedron = tetrahedra_.all()[number];
        for (const auto& outline : outlinesIn(tetrahedra_, tetrahedron, heights_)) {
            std::vector<std::uint32_t> corners;
            for (const CutEdge& edge : outline) corners.push_back(at(edge));
            const int count = int(corners.size());
            for (const auto& [a, b, c] : filling(count, tetrahedra_.hasWholeEdges(tetrahedron))) {
                if (c == count && int(corners.size()) == count) corners.push_back(add(mean(corners)));
                surface_.mesh.triangles.push_back({corners[a], corners[b], corners[c]});
                surface_.tetrahedra.push_back(number);
            }
        }
    }

    CutSurface take() { return std::move(surface_); }

  private:
    std::uint32_t add(const Vector3& point) {
        surface_.mesh.vertices.push_back(point);
        return static_cast<std::uint32_t>(surface_.mesh.vertices.size() - 1);
    }

    std::uint32_t at(const CutEdge& edge) {
        const auto [entry, isNew] = onEdges_.try_emplace(edgeKey(edge), 0);
        if (isNew) entry->second = add(pointOn_ ? pointOn_(edge) : cutAt(edge));
        return entry->second;
    }

    Vector3 cutAt(const CutEdge& edge) const {
        const auto& v = tetrahedra_.vertices();
        return cutPoint(v[edge.inner], heights_[edge.inner], v[edge.outer], heights_[edge.outer]);
    }

    Vector3 mean(const std::vector<std::uint32_t>& corners) const {
        Vector3 sum = Vector3::Zero();
        for (const std::uint32_t corner : corners) sum += surface_.mesh.vertices[corner];
        return sum / double(corners.size());
    }

    const Tetrahedra& tetrahedra_;
    const std::vector<double>& heights_;
    const PointOnEdge& pointOn_;
    std::unordered_map<std::uint64_t, std::uint32_t> onEdges_;
    CutSurface surface_;
};

}  // namespace

std::vector<std::vector<CutEdge>> outlinesIn(const Tetrahedra& tetrahedra, const Tetrahedron& tetrahedron,
                                             const std::vector<double>& heights) {
    const bool isUncut = [&] {
        const auto isInner = [&](std::uint32_t v) { return heights[v] >= 0; };
        const auto& c = tetrahedron.corners;
        return std::all_of(c.begin(), c.end(), isInner) || std::none_of(c.begin(), c.end(), isInner);
    }();
    if (isUncut && tetrahedra.hasWholeEdges(tetrahedron)) return {};
    std::vector<std::array<CutEdge, 2>> segments;
    tetrahedra.eachPiece(tetrahedron, [&](const TriangleIndices& piece) {
        std::array<CutEdge, 2> segment{};
        bool isCut = false;
        for (int k = 0; k < 3; ++k) {
            const std::uint32_t a = piece[k], b = piece[(k + 1) % 3];
            const bool isInnerA = heights[a] >= 0, isInnerB = heights[b] >= 0;
            if (isInnerA == isInnerB) continue;
            isCut = true;
            if (isInnerA) {
                segment[1] = {a, b};
            } else {
                segment[0] = {b, a};
            }
        }
        if (isCut) segments.push_back(segment);
    });
    std::vector<std::vector<CutEdge>> outlines;
    const auto isSame = [](const CutEdge& a, const CutEdge& b) {
        return a.inner == b.inner && a.outer == b.outer;
    };
    while (!segments.empty()) {
        std::vector<CutEdge> outline{segments.back()[0]};
        CutEdge end = segments.back()[1];
        segments.pop_back();
        while (!isSame(end, outline.front())) {
            const auto next =
                std::find_if(segments.begin(), segments.end(),
                             [&](const std::array<CutEdge, 2>& segment) { return isSame(segment[0], end); });
            outline.push_back(end);
            end = (*next)[1];
            segments.erase(next);
        }
        outlines.push_back(std::move(outline));
    }
    return outlines;
}

std::vector<std::array<int, 3>> filling(int corners, bool isPlain) {
    if (corners == 3) return {{0, 1, 2}};
    if (corners == 4 && isPlain) return {{0, 1, 2}, {0, 2, 3}};
    std::vector<std::array<int, 3>> fan;
    for (int k = 0; k < corners; ++k) fan.push_back({k, (k + 1) % corners, corners});
    return fan;
}

Vector3 pointOnEdge(const Vector3& from, const Vector3& to, double share) {
    return from + std::clamp(share, kLeastShare, 1 - kLeastShare) * (to - from);
}

Vector3 cutPoint(const Vector3& inner, double innerHeight, const Vector3& outer, double outerHeight) {
    return pointOnEdge(inner, outer, innerHeight / (innerHeight - outerHeight));
}

CutSurface cutSurface(const Tetrahedra& tetrahedra, const std::vector<double>& heights,
                      const PointOnEdge& pointOn) {
    Cutting cutting(tetrahedra, heights, pointOn);
    for (std::uint32_t i = 0; i < tetrahedra.all().size(); ++i) cutting.cut(i);
    return cutting.take();
}

}  // namespace clearway
