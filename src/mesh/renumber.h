// New numbers for the vertices of a mesh of which only some are used.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "clearway/mesh.h"

namespace clearway {

/// Numbers vertices 0, 1, 2, ... in the order of their first use.
class FirstUseOrder {
  public:
    explicit FirstUseOrder(std::size_t vertices) : numbers_(vertices, 0) {}

    /// The new number of a vertex. On the vertex's first use calls add(vertex), which appends it to the new
    /// list.
    template <class Add>
    std::uint32_t operator()(std::uint32_t vertex, const Add& add) {
        std::uint32_t& number = numbers_[vertex];
        if (number < first_) {
            number = next_++;
            add(vertex);
        }
        return number - first_;
    }

    /// Forgets all uses; the next new number is 0.
    void restart() { first_ = next_; }

  private:
    std::vector<std::uint32_t> numbers_;  ///< below first_: not used since the last restart
    std::uint32_t first_ = 1;
    std::uint32_t next_ = 1;
};

/// The vertices that the triangles use, in the given order. The triangles then refer to the returned
/// vertices. Takes time in proportion to the triangles and to the range of the vertices they use.
inline std::vector<Vector3> takeUsedVertices(const std::vector<Vector3>& vertices,
                                             std::vector<TriangleIndices>& triangles) {
    if (triangles.empty()) return {};
    std::uint32_t lowest = triangles.front()[0], highest = lowest;
    for (const TriangleIndices& triangle : triangles) {
        lowest = std::min({lowest, triangle[0], triangle[1], triangle[2]});
        highest = std::max({highest, triangle[0], triangle[1], triangle[2]});
    }
    std::vector<bool> isUsed(highest - lowest + std::size_t(1), false);
    for (const TriangleIndices& triangle : triangles) {
        for (const std::uint32_t vertex : triangle) isUsed[vertex - lowest] = true;
    }
    std::vector<std::uint32_t> numbers(isUsed.size());
    std::vector<Vector3> used;
    for (std::size_t i = 0; i < isUsed.size(); ++i) {
        if (!isUsed[i]) continue;
        numbers[i] = static_cast<std::uint32_t>(used.size());
        used.push_back(vertices[lowest + i]);
    }
    for (TriangleIndices& triangle : triangles) {
        for (std::uint32_t& vertex : triangle) vertex = numbers[vertex - lowest];
    }
    return used;
}

}  // namespace clearway
