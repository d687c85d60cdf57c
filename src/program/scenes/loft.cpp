#include "program/scenes/loft.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace clearway::scenes {

namespace {

constexpr double kMostCorner = 0.45;  // of a box's shorter side; half of it would leave no side

/// `segments` points on a hexagon, the corners among them; segments is a multiple of 6.
Polyline hexagon(double halfWidth, int segments) {
    Polyline loop = circle(Vector2::Zero(), 1, segments);
    for (int i = 0; i < segments; ++i) {
        const double fromFlat = std::remainder(2 * M_PI * i / segments - M_PI / 6, M_PI / 3);
        loop[i] *= halfWidth / std::cos(fromFlat);
    }
    return loop;
}

double fittingCorner(const Vector3& low, const Vector3& high, double corner) {
    return std::min(corner, kMostCorner * std::min(high.x() - low.x(), high.y() - low.y()));
}

}  // namespace

Piece stacked(const std::vector<StackedLoop>& loops) {
    assert(loops.size() >= 2);
    const auto n = static_cast<std::uint32_t>(loops.front().loop.size());
    Piece piece;
    for (const StackedLoop& layer : loops) {
        assert(layer.loop.size() == n);
        for (const Vector2& p : layer.loop) piece.vertices.emplace_back(p.x(), p.y(), layer.height);
    }
    const auto last = static_cast<std::uint32_t>(loops.size() - 1);
    for (std::uint32_t k = 0; k < last; ++k) {
        for (std::uint32_t i = 0; i < n; ++i) {
            const std::uint32_t a = k * n + i, b = k * n + (i + 1) % n;
            piece.triangles.push_back({a, b, b + n});
            piece.triangles.push_back({a, b + n, a + n});
        }
    }
    for (std::uint32_t i = 1; i + 1 < n; ++i) {
        piece.triangles.push_back({0, i + 1, i});
        piece.triangles.push_back({last * n, last * n + i, last * n + i + 1});
    }
    return piece;
}

Piece pressed(const Polyline& profile, const Vector2& low, const Vector2& high, double cornerRadius,
              int segmentsPerQuarter) {
    std::vector<StackedLoop> loops;
    for (const Vector2& p : profile) {
        const Vector2 in = Vector2::Constant(p.x());
        assert(p.x() < cornerRadius);
        loops.push_back(
            {roundedRectangle(low + in, high - in, cornerRadius - p.x(), segmentsPerQuarter), p.y()});
    }
    return stacked(loops);
}

Piece roundedBox(const Vector3& low, const Vector3& high, double corner, double edge,
                 int segmentsPerQuarter) {
    corner = fittingCorner(low, high, corner);
    const double in = 0.98 * corner;  // a profile ends just before the corner's centre
    const Polyline profile = filleted({{in, low.z()}, {0, low.z()}, {0, high.z()}, {in, high.z()}},
                                      {edge, edge}, segmentsPerQuarter);
    return pressed(profile, low.head<2>(), high.head<2>(), corner, segmentsPerQuarter);
}

Piece tray(const Vector3& low, const Vector3& high, double corner, double wall, int segmentsPerQuarter) {
    corner = fittingCorner(low, high, corner);
    assert(wall < corner);
    const double in = 0.98 * corner, floor = low.z() + wall;
    const double outside = std::min(0.45 * corner, 0.4 * (high.z() - low.z()));
    const Polyline profile =
        filleted({{in, low.z()}, {0, low.z()}, {0, high.z()}, {wall, high.z()}, {wall, floor}, {in, floor}},
                 {outside, 0, 0, std::max(0.0, outside - wall)}, segmentsPerQuarter);
    return pressed(profile, low.head<2>(), high.head<2>(), corner, segmentsPerQuarter);
}

Piece ring(const Polyline& loop, int segments) {
    const auto n = static_cast<std::uint32_t>(segments), rows = static_cast<std::uint32_t>(loop.size());
    Piece piece;
    for (const Vector2& p : loop) {
        assert(p.x() > 0);
        for (const Vector2& q : circle(Vector2::Zero(), p.x(), segments)) {
            piece.vertices.emplace_back(q.x(), q.y(), p.y());
        }
    }
    for (std::uint32_t k = 0; k < rows; ++k) {
        const std::uint32_t row = k * n, next = (k + 1) % rows * n;
        for (std::uint32_t i = 0; i < n; ++i) {
            const std::uint32_t j = (i + 1) % n;
            piece.triangles.push_back({row + i, row + j, next + j});
            piece.triangles.push_back({row + i, next + j, next + i});
        }
    }
    return piece;
}

Piece bolt(const BoltShape& shape, int segments) {
    const int n = 6 * std::max(1, (segments + 6) / 12);
    const double flange = 1.35 * shape.head, rise = 0.22 * shape.height;
    const auto round = [n](double radius) { return circle(Vector2::Zero(), radius, n); };
    return stacked({{round(0.8 * shape.shank), -shape.length},
                    {round(shape.shank), -shape.length + 0.25 * shape.shank},
                    {round(shape.shank), 0},
                    {round(flange), 0},
                    {round(flange), 0.5 * rise},
                    {hexagon(shape.head, n), rise},
                    {hexagon(shape.head, n), 0.9 * shape.height},
                    {round(0.95 * shape.head), shape.height}});
}

}  // namespace clearway::scenes
