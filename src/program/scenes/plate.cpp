#include "program/scenes/plate.h"

#include <cassert>
#include <cmath>

namespace clearway::scenes {

namespace {

using Index = std::uint32_t;

/// The border of a grid of columns x rows points, counter-clockwise.
std::vector<Index> borderOf(Index columns, Index rows) {
    std::vector<Index> loop;
    for (Index i = 0; i + 1 < columns; ++i) loop.push_back(i);
    for (Index j = 0; j + 1 < rows; ++j) loop.push_back(j * columns + columns - 1);
    for (Index i = columns - 1; i > 0; --i) loop.push_back((rows - 1) * columns + i);
    for (Index j = rows - 1; j > 0; --j) loop.push_back(j * columns);
    return loop;
}

/// corners: upper right, then counter-clockwise.
void addHole(Section& section, const Index (&corners)[4], const Vector2& centre, double radius,
             int segments) {
    const auto first = static_cast<Index>(section.points.size()), n = static_cast<Index>(segments);
    const Polyline hole = circle(centre, radius, segments, M_PI_4);
    section.points.insert(section.points.end(), hole.begin(), hole.end());
    const auto at = [&](Index i) { return first + i % n; };
    for (Index side = 0; side < 4; ++side) {
        const Index from = side * n / 4, middle = from + n / 8, to = from + n / 4;
        const Index near = corners[side], far = corners[(side + 1) % 4];
        for (Index i = from; i < middle; ++i) section.cap.push_back({near, at(i + 1), at(i)});
        section.cap.push_back({near, far, at(middle)});
        for (Index i = middle; i < to; ++i) section.cap.push_back({far, at(i + 1), at(i)});
    }
    std::vector<Index> loop(n);  // the material is outside
    for (Index i = 0; i < n; ++i) loop[i] = first + n - 1 - i;
    section.loops.push_back(loop);
}

}  // namespace

Section holedSection(const std::vector<double>& xs, const std::vector<double>& ys, const HoleRadius& radiusOf,
                     int holeSegments) {
    assert(xs.size() >= 2 && ys.size() >= 2 && holeSegments >= 4 && holeSegments % 4 == 0);
    const auto columns = static_cast<Index>(xs.size()), rows = static_cast<Index>(ys.size());
    Section section;
    for (const double y : ys) {
        for (const double x : xs) section.points.emplace_back(x, y);
    }
    section.loops.push_back(borderOf(columns, rows));
    for (Index j = 0; j + 1 < rows; ++j) {
        for (Index i = 0; i + 1 < columns; ++i) {
            const Index low = j * columns + i, high = low + columns;
            const double radius = radiusOf(i, j);
            if (radius <= 0) {
                section.cap.push_back({low, low + 1, high + 1});
                section.cap.push_back({low, high + 1, high});
                continue;
            }
            const Vector2 centre(0.5 * (xs[i] + xs[i + 1]), 0.5 * (ys[j] + ys[j + 1]));
            addHole(section, {high + 1, high, low, low + 1}, centre, radius, holeSegments);
        }
    }
    return section;
}

}  // namespace clearway::scenes
