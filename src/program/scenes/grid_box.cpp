#include "program/scenes/grid_box.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <map>

namespace clearway::scenes {

namespace {

using Cells = std::array<int, 3>;  // along x, y, z

Cells cellsFor(const Vector3& sizes, double perLength) {
    Cells cells;
    for (int axis = 0; axis < 3; ++axis) {
        cells[axis] = std::max(1, static_cast<int>(std::lround(sizes[axis] * perLength)));
    }
    return cells;
}

std::size_t trianglesOf(const Cells& cells) {
    return 4 * static_cast<std::size_t>(cells[0] * cells[1] + cells[1] * cells[2] + cells[2] * cells[0]);
}

/// The finest grid that has no more triangles than that.
Cells finest(const Vector3& sizes, std::size_t triangles) {
    double low = 0, high = std::sqrt(static_cast<double>(triangles)) / sizes.minCoeff();
    for (int i = 0; i < 60; ++i) {
        const double middle = (low + high) / 2;
        (trianglesOf(cellsFor(sizes, middle)) <= triangles ? low : high) = middle;
    }
    return cellsFor(sizes, low);
}

class Builder {
  public:
    Builder(const Box& box, const Cells& cells, std::size_t quartered)
        : box_(box), cells_(cells), quartered_(quartered) {}

    /// The face that looks along the axis, or against it.
    void addFace(int axis, bool isUpper) {
        const int u = (axis + 1) % 3, v = (axis + 2) % 3;
        for (int j = 0; j < cells_[v]; ++j) {
            for (int i = 0; i < cells_[u]; ++i) {
                const auto corner = [&](int di, int dj) {
                    Cells at{};
                    at[axis] = isUpper ? cells_[axis] : 0;
                    at[u] = i + di;
                    at[v] = j + dj;
                    return vertex(at);
                };
                std::array<std::uint32_t, 4> loop{corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)};
                if (!isUpper) std::swap(loop[1], loop[3]);
                addCell(loop);
            }
        }
    }

    Piece piece;

  private:
    std::uint32_t vertex(const Cells& at) {
        const auto [found, isNew] = vertices_.insert({at, static_cast<std::uint32_t>(piece.vertices.size())});
        if (isNew) {
            Vector3 p;
            for (int axis = 0; axis < 3; ++axis) {
                const double share = static_cast<double>(at[axis]) / cells_[axis];
                p[axis] = (1 - share) * box_.min()[axis] + share * box_.max()[axis];
            }
            piece.vertices.push_back(p);
        }
        return found->second;
    }

    void addCell(const std::array<std::uint32_t, 4>& loop) {
        if (quartered_ == 0) {
            piece.triangles.push_back({loop[0], loop[1], loop[2]});
            piece.triangles.push_back({loop[0], loop[2], loop[3]});
            return;
        }
        --quartered_;
        const auto middle = static_cast<std::uint32_t>(piece.vertices.size());
        piece.vertices.push_back((piece.vertices[loop[0]] + piece.vertices[loop[2]]) / 2);
        for (int k = 0; k < 4; ++k) piece.triangles.push_back({loop[k], loop[(k + 1) % 4], middle});
    }

    Box box_;
    Cells cells_;
    std::size_t quartered_;  ///< cells still to be cut into four
    std::map<Cells, std::uint32_t> vertices_;
};

}  // namespace

Piece gridBox(const Box& box, std::size_t triangles) {
    assert(triangles >= 12);
    const Cells cells = finest(box.sizes(), triangles);
    Builder builder(box, cells, (triangles - trianglesOf(cells)) / 2);
    for (const int axis : {2, 1, 0}) {
        for (const bool isUpper : {true, false}) builder.addFace(axis, isUpper);
    }
    return std::move(builder.piece);
}

}  // namespace clearway::scenes
