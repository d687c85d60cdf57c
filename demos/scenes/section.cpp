#include "demos/scenes/section.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace clearway::scenes {

namespace {

double cross(const Vector2& a, const Vector2& b) {
    return a.x() * b.y() - a.y() * b.x();
}

Vector2 leftNormal(const Vector2& from, const Vector2& to) {
    const Vector2 along = (to - from).normalized();
    return {-along.y(), along.x()};
}

/// Appends the arc of a fillet at `corner` between the directions to its neighbours.
void appendFillet(Polyline& line, const Vector2& before, const Vector2& corner, const Vector2& after,
                  double radius, int segmentsPerQuarter) {
    const Vector2 in = (corner - before).normalized(), out = (after - corner).normalized();
    const double turn = std::atan2(cross(in, out), in.dot(out));
    const double tangent = std::tan(std::abs(turn) / 2);
    if (radius <= 0 || tangent < 1e-9) {
        line.push_back(corner);
        return;
    }
    const double room = 0.49 * std::min((corner - before).norm(), (after - corner).norm());
    const double r = std::min(radius, room / tangent);
    const Vector2 first = corner - in * (r * tangent);
    const Vector2 toCentre = Vector2(-in.y(), in.x()) * (turn > 0 ? r : -r);
    const int segments =
        std::max(1, static_cast<int>(std::ceil(std::abs(turn) / M_PI_2 * segmentsPerQuarter - 1e-9)));
    for (int i = 0; i <= segments; ++i) {
        line.push_back(first + toCentre - Eigen::Rotation2Dd(turn * i / segments) * toCentre);
    }
}

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

/// Cuts a hole into a cell. corners: those of the cell, the upper right one first, counter-clockwise.
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

Polyline filleted(const Polyline& line, const std::vector<double>& radii, int segmentsPerQuarter) {
    assert(line.size() >= 2 && radii.size() == line.size() - 2);
    Polyline result{line.front()};
    for (std::size_t i = 1; i + 1 < line.size(); ++i) {
        appendFillet(result, line[i - 1], line[i], line[i + 1], radii[i - 1], segmentsPerQuarter);
    }
    result.push_back(line.back());
    return result;
}

Polyline offsetLine(const Polyline& line, double distance) {
    Polyline result;
    result.reserve(line.size());
    for (std::size_t i = 0; i < line.size(); ++i) {
        const Vector2 in = i > 0 ? leftNormal(line[i - 1], line[i]) : leftNormal(line[i], line[i + 1]);
        const Vector2 out = i + 1 < line.size() ? leftNormal(line[i], line[i + 1]) : in;
        const Vector2 sum = in + out;  // its length is 2 cos(turn / 2)
        result.push_back(line[i] + sum * (2 * distance / sum.squaredNorm()));
    }
    return result;
}

Section bandSection(const Polyline& left, const Polyline& right) {
    assert(left.size() == right.size() && left.size() >= 2);
    const auto n = static_cast<std::uint32_t>(left.size());
    Section section;
    section.points = right;
    section.points.insert(section.points.end(), left.rbegin(), left.rend());
    std::vector<std::uint32_t> loop(2 * n);
    for (std::uint32_t i = 0; i < 2 * n; ++i) loop[i] = i;
    section.loops.push_back(loop);
    for (std::uint32_t i = 0; i + 1 < n; ++i) {
        const std::uint32_t l0 = 2 * n - 1 - i, l1 = l0 - 1;
        section.cap.push_back({i, i + 1, l1});
        section.cap.push_back({i, l1, l0});
    }
    return section;
}

Section sheetSection(const Polyline& line, double thickness) {
    return bandSection(offsetLine(line, thickness / 2), offsetLine(line, -thickness / 2));
}

Section ringSection(const Polyline& outer, const Polyline& inner) {
    assert(outer.size() == inner.size() && outer.size() >= 3);
    const auto n = static_cast<std::uint32_t>(outer.size());
    Section section;
    section.points = outer;
    section.points.insert(section.points.end(), inner.begin(), inner.end());
    std::vector<std::uint32_t> outside(n), inside(n);
    for (std::uint32_t i = 0; i < n; ++i) {
        const std::uint32_t next = (i + 1) % n;
        outside[i] = i;
        inside[i] = 2 * n - 1 - i;
        section.cap.push_back({i, next, n + next});
        section.cap.push_back({i, n + next, n + i});
    }
    section.loops = {outside, inside};
    return section;
}

Section fullSection(const Polyline& loop) {
    const auto n = static_cast<std::uint32_t>(loop.size());
    Section section;
    section.points = loop;
    section.loops.emplace_back(n);
    for (std::uint32_t i = 0; i < n; ++i) section.loops[0][i] = i;
    for (std::uint32_t i = 1; i + 1 < n; ++i) section.cap.push_back({0, i, i + 1});
    return section;
}

Polyline circle(const Vector2& centre, double radius, int segments, double from) {
    Polyline loop;
    for (int i = 0; i < segments; ++i) {
        const double angle = from + 2 * M_PI * i / segments;
        loop.push_back(centre + radius * Vector2(std::cos(angle), std::sin(angle)));
    }
    return loop;
}

Polyline roundedRectangle(const Vector2& low, const Vector2& high, double radius, int segmentsPerQuarter) {
    const Vector2 a = low.array() + radius, b = high.array() - radius;  // the arcs' centres
    const Vector2 centres[] = {b, {a.x(), b.y()}, a, {b.x(), a.y()}};
    Polyline loop;
    for (int corner = 0; corner < 4; ++corner) {
        for (int i = 0; i <= segmentsPerQuarter; ++i) {
            const double angle = M_PI_2 * (corner + static_cast<double>(i) / segmentsPerQuarter);
            loop.push_back(centres[corner] + radius * Vector2(std::cos(angle), std::sin(angle)));
        }
    }
    return loop;
}

Section rectangleSection(const Vector2& low, const Vector2& high) {
    return fullSection({low, {high.x(), low.y()}, high, {low.x(), high.y()}});
}

Polyline squareAround(const Vector2& centre, double half, int segments) {
    assert(segments % 4 == 0);
    Polyline loop = circle(Vector2::Zero(), 1, segments, M_PI_4);
    for (Vector2& point : loop) point = centre + point * (half / point.cwiseAbs().maxCoeff());
    return loop;
}

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
