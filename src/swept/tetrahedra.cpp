#include "swept/tetrahedra.h"

#include <algorithm>
#include <cmath>

#include "core/parallel.h"

namespace clearway {
namespace {

constexpr double kMostCubes = 8;  ///< along the box's longest side

/// The power of two of which the length has 4 to 8.
double cubeFor(double length) {
    return std::exp2(std::ceil(std::log2(length / kMostCubes)));
}

/// The orders in which a way from a cube's least corner to its greatest one can take the three axes.
constexpr std::array<std::array<int, 3>, 6> kOrders{
    {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}}};

}  // namespace

Tetrahedra::Tetrahedra(const Box& box) {
    const double cube = cubeFor(box.sizes().maxCoeff());
    std::array<std::int64_t, 3> first, count;
    for (int k = 0; k < 3; ++k) {
        first[k] = static_cast<std::int64_t>(std::floor(box.min()[k] / cube)) - 1;
        count[k] = static_cast<std::int64_t>(std::floor(box.max()[k] / cube)) + 2 - first[k];
    }
    const auto number = [&](const std::array<std::int64_t, 3>& place) {
        return static_cast<std::uint32_t>((place[2] * (count[1] + 1) + place[1]) * (count[0] + 1) + place[0]);
    };
    for (std::int64_t z = 0; z <= count[2]; ++z) {
        for (std::int64_t y = 0; y <= count[1]; ++y) {
            for (std::int64_t x = 0; x <= count[0]; ++x) {
                vertices_.push_back(
                    cube * Vector3(double(first[0] + x), double(first[1] + y), double(first[2] + z)));
            }
        }
    }
    for (std::int64_t z = 0; z < count[2]; ++z) {
        for (std::int64_t y = 0; y < count[1]; ++y) {
            for (std::int64_t x = 0; x < count[0]; ++x) {
                for (const auto& order : kOrders) {
                    std::array<std::int64_t, 3> place{x, y, z};
                    Tetrahedron made;
                    made.corners[0] = number(place);
                    for (int k = 0; k < 3; ++k) {
                        ++place[order[k]];
                        made.corners[k + 1] = number(place);
                    }
                    all_.push_back(made);
                }
            }
        }
    }
}

void Tetrahedra::bisect(std::size_t tetrahedron) {
    const Tetrahedron whole = all_[tetrahedron];
    const auto& c = whole.corners;
    const auto [entry, isNew] =
        middles_.try_emplace(keyOf(c[0], c[whole.tag]), static_cast<std::uint32_t>(vertices_.size()));
    if (isNew) vertices_.push_back(0.5 * (vertices_[c[0]] + vertices_[c[whole.tag]]));
    Tetrahedron near, far;
    near.tag = far.tag = whole.tag > 1 ? whole.tag - 1 : 3;
    near.isShallow = far.isShallow = whole.isShallow;
    near.corners = far.corners = c;
    near.corners[whole.tag] = entry->second;
    for (int k = 0; k < whole.tag; ++k) far.corners[k] = c[k + 1];
    far.corners[whole.tag] = entry->second;
    all_[tetrahedron] = near;
    all_.push_back(far);
}

bool Tetrahedra::hasWholeEdges(const Tetrahedron& tetrahedron) const {
    const auto& c = tetrahedron.corners;
    for (int i = 0; i < 4; ++i) {
        for (int j = i + 1; j < 4; ++j) {
            if (middles_.count(keyOf(c[i], c[j])) > 0) return false;
        }
    }
    return true;
}

std::vector<std::uint32_t> Tetrahedra::verticesOn(const Tetrahedron& tetrahedron) const {
    std::vector<std::uint32_t> vertices;
    if (hasWholeEdges(tetrahedron)) return vertices;
    const auto& c = tetrahedron.corners;
    eachPiece(tetrahedron, [&](const TriangleIndices& piece) {
        for (const std::uint32_t v : piece) {
            if (std::find(c.begin(), c.end(), v) == c.end()) vertices.push_back(v);
        }
    });
    return vertices;
}

std::vector<std::size_t> Tetrahedra::withVerticesFrom(std::size_t first) const {
    std::vector<std::uint8_t> has(all_.size(), false);
    if (first >= vertices_.size()) return {};
    forEachInParallel(all_.size(), [&](std::size_t i) {
        const std::vector<std::uint32_t> vertices = verticesOn(all_[i]);
        has[i] = std::any_of(vertices.begin(), vertices.end(), [&](std::uint32_t v) { return v >= first; });
    });
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < has.size(); ++i) {
        if (has[i]) found.push_back(i);
    }
    return found;
}

bool Tetrahedra::isRightHanded(const std::array<std::uint32_t, 4>& corners) const {
    const Vector3& base = vertices_[corners[0]];
    const Vector3 a = vertices_[corners[1]] - base, b = vertices_[corners[2]] - base;
    return a.cross(b).dot(vertices_[corners[3]] - base) > 0;
}

std::optional<Tetrahedra::HalvedEdge> Tetrahedra::halvedEdgeOf(const TriangleIndices& triangle) const {
    std::optional<HalvedEdge> longest;
    double most = 0;
    std::uint64_t mostKey = 0;  // decides between edges of one length alike for both sides of a face
    for (int k = 0; k < 3; ++k) {
        const std::uint32_t a = triangle[k], b = triangle[(k + 1) % 3];
        const std::uint64_t key = keyOf(a, b);
        const auto found = middles_.find(key);
        if (found == middles_.end()) continue;
        const double length = (vertices_[a] - vertices_[b]).squaredNorm();
        if (longest && (length < most || (length == most && key < mostKey))) continue;
        longest = {k, found->second};
        most = length;
        mostKey = key;
    }
    return longest;
}

}  // namespace clearway
