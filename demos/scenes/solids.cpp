#include "demos/scenes/solids.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <map>

namespace clearway::scenes {

namespace {

/// The place of a section on a line; the first axis points along the line.
struct Frame {
    Vector3 origin;
    Matrix3 axes;
};

Vector3 directionAt(const Line& line, std::size_t i) {
    const Vector3 in = i > 0 ? (line[i] - line[i - 1]).normalized() : Vector3::Zero();
    const Vector3 out = i + 1 < line.size() ? (line[i + 1] - line[i]).normalized() : Vector3::Zero();
    return (in + out).normalized();
}

/// The least rotation that takes one unit vector to another. The operations are those of Eigen's
/// FromTwoVectors, which also handles opposite vectors, by an SVD that takes 20 s to compile.
Eigen::Quaterniond leastRotation(const Vector3& from, const Vector3& to) {
    const Vector3 v0 = from.normalized(), v1 = to.normalized();
    const double c = v1.dot(v0);
    assert(c >= -1 + Eigen::NumTraits<double>::dummy_precision());
    const Vector3 axis = v0.cross(v1);
    const double s = std::sqrt((1 + c) * 2), inverse = 1 / s;
    Eigen::Quaterniond rotation;
    rotation.vec() = axis * inverse;
    rotation.w() = s * 0.5;
    return rotation;
}

/// Each frame is the previous one, turned by the least rotation that takes its direction to the next.
std::vector<Frame> framesAlong(const Line& line, const Vector3& first) {
    assert(line.size() >= 2);
    const Vector3 begin = directionAt(line, 0);
    Vector3 across = first - begin * begin.dot(first);
    if (across.norm() < 1e-3 * first.norm()) across = begin.unitOrthogonal();
    Vector3 before = begin;
    std::vector<Frame> frames;
    for (std::size_t i = 0; i < line.size(); ++i) {
        const Vector3 along = directionAt(line, i);
        across = leastRotation(before, along) * across;
        across = (across - along * along.dot(across)).normalized();
        Frame frame{line[i], {}};
        frame.axes << along, across, along.cross(across);
        frames.push_back(frame);
        before = along;
    }
    return frames;
}

constexpr double kMostCorner = 0.45;  // of a box's shorter side; half of it would leave no side

/// A hexagon as `segments` points, its corners among them; segments is a multiple of 6.
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

/// The finest grid with at most `triangles` triangles.
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

    /// Adds the face whose normal points along the axis (isUpper) or against it.
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

Piece sweptAlong(const Spine& spine, const Section& section, const std::vector<double>& stations,
                 const std::vector<double>& scales) {
    assert(scales.empty() || scales.size() == stations.size());
    Piece piece = sweep(section, stations);
    const std::size_t perStation = section.points.size();
    for (std::size_t k = 0; k < stations.size(); ++k) {
        const Pose X_worldStation = spine.frameAt(stations[k]);
        const double scale = scales.empty() ? 1 : scales[k];
        for (std::size_t i = 0; i < perStation; ++i) {
            Vector3& vertex = piece.vertices[k * perStation + i];
            vertex = X_worldStation * Vector3(0, scale * vertex.y(), scale * vertex.z());
        }
    }
    return piece;
}

Piece pulled(const Section& section, const Line& line, const Vector3& first) {
    std::vector<double> stations(line.size());
    for (std::size_t i = 0; i < line.size(); ++i) stations[i] = static_cast<double>(i);
    Piece piece = sweep(section, stations);
    const std::vector<Frame> frames = framesAlong(line, first);
    const std::size_t n = section.points.size();
    for (std::size_t i = 0; i < piece.vertices.size(); ++i) {
        Vector3& vertex = piece.vertices[i];
        const Frame& frame = frames[i / n];
        vertex = frame.origin + frame.axes * Vector3(0, vertex.y(), vertex.z());
    }
    return piece;
}

Piece rod(const Line& line, double radius, int segments) {
    return pulled(fullSection(circle(Vector2::Zero(), radius, segments)), line);
}

Piece pipe(const Line& line, double radius, double wall, int segments) {
    return pulled(ringSection(circle(Vector2::Zero(), radius, segments),
                              circle(Vector2::Zero(), radius - wall, segments)),
                  line);
}

Piece variedRod(const Line& line, const std::function<double(double)>& radiusAt, int segments) {
    Piece piece = rod(line, 1, segments);
    const auto n = static_cast<std::size_t>(segments);
    double along = 0;
    for (std::size_t i = 0; i < line.size(); ++i) {
        if (i > 0) along += (line[i] - line[i - 1]).norm();
        const double radius = radiusAt(along);
        for (std::size_t k = i * n; k < (i + 1) * n; ++k) {
            piece.vertices[k] = line[i] + radius * (piece.vertices[k] - line[i]);
        }
    }
    return piece;
}

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
