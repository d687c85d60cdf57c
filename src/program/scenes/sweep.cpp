#include "program/scenes/sweep.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace clearway::scenes {

Piece sweep(const Section& section, const std::vector<double>& stations) {
    assert(stations.size() >= 2);
    const auto n = static_cast<std::uint32_t>(section.points.size());
    Piece piece;
    for (const double x : stations) {
        for (const Vector2& p : section.points) piece.vertices.emplace_back(x, p.x(), p.y());
    }
    const auto last = static_cast<std::uint32_t>(stations.size() - 1);
    for (std::uint32_t k = 0; k < last; ++k) {
        for (const auto& loop : section.loops) {
            for (std::size_t i = 0; i < loop.size(); ++i) {
                const std::uint32_t a = k * n + loop[i], b = k * n + loop[(i + 1) % loop.size()];
                piece.triangles.push_back({a, b, b + n});
                piece.triangles.push_back({a, b + n, a + n});
            }
        }
    }
    for (const TriangleIndices& t : section.cap) {
        piece.triangles.push_back({t[0], t[2], t[1]});
        piece.triangles.push_back({last * n + t[0], last * n + t[1], last * n + t[2]});
    }
    return piece;
}

Piece sweepAlongY(const Section& section, const std::vector<double>& stations) {
    std::vector<double> backwards;  // pulled along -y: x, z and -y are right-handed
    for (std::size_t i = stations.size(); i-- > 0;) backwards.push_back(-stations[i]);
    return placed(sweep(section, backwards), [](const Vector3& p) { return Vector3(p.y(), -p.x(), p.z()); });
}

Piece sweepAlongZ(const Section& section, const std::vector<double>& stations) {
    return placed(sweep(section, stations), [](const Vector3& p) { return Vector3(p.y(), p.z(), p.x()); });
}

std::vector<double> stationsBetween(double first, double last, double step) {
    assert(first < last && step > 0);
    const int spans = std::max(1, static_cast<int>(std::ceil((last - first) / step - 1e-9)));
    std::vector<double> stations;
    for (int i = 0; i <= spans; ++i) stations.push_back(first + (last - first) * i / spans);
    return stations;
}

Piece turned(const Polyline& outline, int segments) {
    assert(outline.size() >= 3 && outline.front().x() == 0 && outline.back().x() == 0);
    const auto n = static_cast<std::uint32_t>(segments);
    const auto rings = static_cast<std::uint32_t>(outline.size() - 2);
    Piece piece;
    for (std::uint32_t k = 1; k <= rings; ++k) {
        for (const Vector2& p : circle(Vector2::Zero(), outline[k].x(), segments)) {
            piece.vertices.emplace_back(p.x(), p.y(), outline[k].y());
        }
    }
    const std::uint32_t bottom = rings * n, top = bottom + 1;
    piece.vertices.emplace_back(0, 0, outline.front().y());
    piece.vertices.emplace_back(0, 0, outline.back().y());
    for (std::uint32_t i = 0; i < n; ++i) {
        const std::uint32_t next = (i + 1) % n;
        piece.triangles.push_back({bottom, next, i});
        for (std::uint32_t k = 0; k + 1 < rings; ++k) {
            const std::uint32_t a0 = k * n + i, a1 = k * n + next;
            piece.triangles.push_back({a0, a1, a1 + n});
            piece.triangles.push_back({a0, a1 + n, a0 + n});
        }
        piece.triangles.push_back({(rings - 1) * n + i, (rings - 1) * n + next, top});
    }
    return piece;
}

Polyline bossOutline(const BossShape& shape, int segmentsPerQuarter) {
    const double pad = shape.radius + 2.1 * shape.foot;  // a fillet takes up to half of a line (see filleted)
    const Polyline line{
        {0, 0},           {pad, 0}, {pad, shape.pad}, {shape.radius, shape.pad}, {shape.radius, shape.height},
        {0, shape.height}};
    return filleted(line, {0, 0, shape.foot, shape.rounding}, segmentsPerQuarter);
}

Polyline cupOutline(const CupShape& shape, int segmentsPerQuarter) {
    const double inner = shape.radius - shape.wall, floor = -shape.depth + shape.wall;
    const Polyline line{{0, -shape.depth}, {shape.radius, -shape.depth},
                        {shape.radius, 0}, {inner, 0},
                        {inner, floor},    {0, floor}};
    return filleted(line, {shape.rounding + shape.wall, 0, 0, shape.rounding}, segmentsPerQuarter);
}

Polyline domeOutline(double radius, double height, int segmentsPerQuarter) {
    Polyline line{{0, 0}};
    for (int i = 0; i <= segmentsPerQuarter; ++i) {
        const double angle = M_PI_2 * i / segmentsPerQuarter;
        line.push_back({i == segmentsPerQuarter ? 0 : radius * std::cos(angle), height * std::sin(angle)});
    }
    return line;
}

}  // namespace clearway::scenes
