#include "isosurface/tetrahedra.h"

#include <algorithm>
#include <cmath>

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

std::uint64_t Tetrahedra::keyOf(std::uint32_t a, std::uint32_t b) {
    return (std::uint64_t(std::min(a, b)) << 32) | std::max(a, b);
}

void Tetrahedra::bisect(std::size_t tetrahedron) {
    const Tetrahedron whole = all_[tetrahedron];
    const auto& c = whole.corners;
    const auto [entry, isNew] =
        middles_.try_emplace(keyOf(c[0], c[whole.tag]), static_cast<std::uint32_t>(vertices_.size()));
    if (isNew) {
        vertices_.push_back(0.5 * (vertices_[c[0]] + vertices_[c[whole.tag]]));
        newlyHalved_.push_back({c[0], c[whole.tag]});
    }
    Tetrahedron near, far;
    near.tag = far.tag = whole.tag > 1 ? whole.tag - 1 : 3;
    near.isShallow = far.isShallow = whole.isShallow;
    near.corners = far.corners = c;
    near.corners[whole.tag] = entry->second;
    for (int k = 0; k < whole.tag; ++k) far.corners[k] = c[k + 1];
    far.corners[whole.tag] = entry->second;
    changed_.push_back(tetrahedron);
    changed_.push_back(all_.size());
    all_[tetrahedron] = near;
    all_.push_back(far);
}

bool Tetrahedra::hasHalvedEdge(const Tetrahedron& tetrahedron) const {
    const auto& c = tetrahedron.corners;
    for (int i = 0; i < 4; ++i) {
        for (int j = i + 1; j < 4; ++j) {
            if (middles_.count(keyOf(c[i], c[j])) > 0) return true;
        }
    }
    return false;
}

std::vector<std::size_t> Tetrahedra::makeConforming() {
    std::vector<std::size_t> open;
    std::vector<bool> isEnd;  // of an edge that was halved since all tetrahedra were looked at
    while (!changed_.empty()) {
        // Bisecting appends to the list.
        std::size_t old = changed_.size();
        for (std::size_t i = 0; i < changed_.size(); ++i) {
            if (hasHalvedEdge(all_[changed_[i]])) bisect(changed_[i]);
        }
        open.insert(open.end(), changed_.begin() + old, changed_.end());
        changed_.clear();
        isEnd.assign(vertices_.size(), false);
        for (const auto& edge : newlyHalved_) isEnd[edge[0]] = isEnd[edge[1]] = true;
        newlyHalved_.clear();
        const std::size_t count = all_.size();
        for (std::size_t i = 0; i < count; ++i) {
            const auto& c = all_[i].corners;
            const int ends = isEnd[c[0]] + isEnd[c[1]] + isEnd[c[2]] + isEnd[c[3]];
            if (ends >= 2 && hasHalvedEdge(all_[i])) bisect(i);
        }
        open.insert(open.end(), changed_.begin(), changed_.end());
    }
    std::sort(open.begin(), open.end());
    open.erase(std::unique(open.begin(), open.end()), open.end());
    return open;
}

}  // namespace clearway
