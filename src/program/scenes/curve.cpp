#include "program/scenes/curve.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "program/scenes/spine.h"

namespace clearway::scenes {

namespace {

/// Where a section stands on a line: x along the line.
struct Frame {
    Vector3 origin;
    Matrix3 axes;
};

Vector3 directionAt(const Line& line, std::size_t i) {
    const Vector3 in = i > 0 ? (line[i] - line[i - 1]).normalized() : Vector3::Zero();
    const Vector3 out = i + 1 < line.size() ? (line[i + 1] - line[i]).normalized() : Vector3::Zero();
    return (in + out).normalized();
}

/// Each frame is the one before, turned by the least rotation that takes its direction to the next.
std::vector<Frame> framesAlong(const Line& line, const Vector3& first) {
    assert(line.size() >= 2);
    const Vector3 begin = directionAt(line, 0);
    Vector3 across = first - begin * begin.dot(first);
    if (across.norm() < 1e-3 * first.norm()) across = begin.unitOrthogonal();
    Vector3 before = begin;
    std::vector<Frame> frames;
    for (std::size_t i = 0; i < line.size(); ++i) {
        const Vector3 along = directionAt(line, i);
        across = Eigen::Quaterniond::FromTwoVectors(before, along) * across;
        across = (across - along * along.dot(across)).normalized();
        Frame frame{line[i], {}};
        frame.axes << along, across, along.cross(across);
        frames.push_back(frame);
        before = along;
    }
    return frames;
}

/// Between b and c. Source: Barry, Goldman, A Recursive Evaluation Algorithm for a Class of Catmull-Rom
/// Splines, SIGGRAPH 1988.
Vector3 spline(const Vector3 (&p)[4], double share) {
    double t[4] = {0, 0, 0, 0};
    for (int i = 1; i < 4; ++i) t[i] = t[i - 1] + std::sqrt((p[i] - p[i - 1]).norm());
    const double at = t[1] + (t[2] - t[1]) * share;
    const auto mix = [at](const Vector3& a, const Vector3& b, double ta, double tb) -> Vector3 {
        return (a * (tb - at) + b * (at - ta)) / (tb - ta);
    };
    const Vector3 a1 = mix(p[0], p[1], t[0], t[1]), a2 = mix(p[1], p[2], t[1], t[2]),
                  a3 = mix(p[2], p[3], t[2], t[3]);
    return mix(mix(a1, a2, t[0], t[2]), mix(a2, a3, t[1], t[3]), t[1], t[2]);
}

}  // namespace

Line bent(const Line& line, double radius, int segmentsPerQuarter) {
    const Spine spine = Spine::through(line, radius);
    Line result;
    for (const double at : spine.stations(spine.length(), M_PI_2 / segmentsPerQuarter)) {
        result.push_back(spine.frameAt(at).translation);
    }
    return result;
}

Line smooth(const Line& points, double step) {
    assert(points.size() >= 2 && step > 0);
    Line result;
    const std::size_t last = points.size() - 1;
    for (std::size_t i = 0; i < last; ++i) {
        const Vector3 before = i > 0 ? points[i - 1] : Vector3(2 * points[0] - points[1]);
        const Vector3 after = i + 2 <= last ? points[i + 2] : Vector3(2 * points[last] - points[last - 1]);
        const Vector3 span[4] = {before, points[i], points[i + 1], after};
        const int steps = std::max(2, static_cast<int>(std::ceil((points[i + 1] - points[i]).norm() / step)));
        for (int k = 0; k < steps; ++k) result.push_back(spline(span, static_cast<double>(k) / steps));
    }
    result.push_back(points[last]);
    return result;
}

double lengthOf(const Line& line) {
    double length = 0;
    for (std::size_t i = 1; i < line.size(); ++i) length += (line[i] - line[i - 1]).norm();
    return length;
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

}  // namespace clearway::scenes
