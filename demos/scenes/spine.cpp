#include "demos/scenes/spine.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace clearway::scenes {

namespace {

/// The frame after a length of a straight or a bend, relative to its start.
Pose along(double length, double curvature, double towards) {
    Pose frame;
    if (curvature == 0) {
        frame.translation = {length, 0, 0};
        return frame;
    }
    const double angle = length * curvature;
    const Vector3 inward(0, std::cos(towards), std::sin(towards)), axis = Vector3::UnitX().cross(inward);
    frame.rotation = Eigen::AngleAxisd(angle, axis).toRotationMatrix();
    frame.translation = (std::sin(angle) * Vector3::UnitX() + (1 - std::cos(angle)) * inward) / curvature;
    return frame;
}

Pose standingAtFirst(const Vector3& origin, const Vector3& direction, const Vector3& up) {
    Pose start;
    const Vector3 x = direction.normalized();
    Vector3 y = up.cross(x);
    if (y.norm() < 1e-6 * up.norm()) y = x.unitOrthogonal();
    start.rotation.col(0) = x;
    start.rotation.col(1) = y.normalized();
    start.rotation.col(2) = x.cross(start.rotation.col(1));
    start.translation = origin;
    return start;
}

Vector2 leftOf(const Vector2& direction) {
    return {-direction.y(), direction.x()};
}

/// The spline's point between p[1] and p[2]. Source: Barry, Goldman, A Recursive Evaluation Algorithm for a
/// Class of Catmull-Rom Splines, SIGGRAPH 1988.
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

std::vector<double> stationsBetween(double first, double last, double step) {
    assert(first < last && step > 0);
    const int spans = std::max(1, static_cast<int>(std::ceil((last - first) / step - 1e-9)));
    std::vector<double> stations;
    for (int i = 0; i <= spans; ++i) stations.push_back(first + (last - first) * i / spans);
    return stations;
}

Spine Spine::through(const std::vector<Vector3>& points, double radius, const Vector3& up) {
    assert(points.size() >= 2 && radius > 0);
    Spine spine(standingAtFirst(points[0], points[1] - points[0], up));
    double used = 0;  // length that the bend at the current leg's beginning takes
    for (std::size_t i = 1; i < points.size(); ++i) {
        const Vector3 leg = points[i] - points[i - 1];
        if (i + 1 == points.size()) return spine.straight(leg.norm() - used);
        const Vector3 next = points[i + 1] - points[i];
        const Vector3 turned = spine.end_.rotation.transpose() * next.normalized();
        const double angle = std::atan2(std::hypot(turned.y(), turned.z()), turned.x());
        if (angle < 1e-9) {
            spine.straight(leg.norm() - used);
            used = 0;
            continue;
        }
        const double tangent = std::tan(angle / 2), room = 0.49 * std::min(leg.norm(), next.norm());
        const double fitting = std::min(radius, room / tangent);
        spine.straight(leg.norm() - used - fitting * tangent);
        spine.bend(fitting, angle, std::atan2(turned.z(), turned.y()));
        used = fitting * tangent;
    }
    return spine;
}

Spine& Spine::straight(double length) {
    assert(length > 0);
    pieces_.push_back({end_, length_, length, 0, 0});
    end_ = end_ * along(length, 0, 0);
    length_ += length;
    return *this;
}

Spine& Spine::bend(double radius, double angle, double towards) {
    assert(radius > 0 && angle > 0);
    pieces_.push_back({end_, length_, radius * angle, 1 / radius, towards});
    end_ = end_ * along(radius * angle, 1 / radius, towards);
    length_ += radius * angle;
    return *this;
}

Pose Spine::frameAt(double length) const {
    assert(!pieces_.empty());
    if (length <= 0) return pieces_.front().X_worldStart * along(length, 0, 0);
    if (length >= length_) return end_ * along(length - length_, 0, 0);
    const auto after = std::upper_bound(pieces_.begin(), pieces_.end(), length,
                                        [](double at, const Piece& piece) { return at < piece.start; });
    const Piece& piece = *std::prev(after);
    return piece.X_worldStart * along(length - piece.start, piece.curvature, piece.towards);
}

std::vector<double> Spine::stations(double longestStep, double largestAngle) const {
    std::vector<double> all{0};
    for (const Piece& piece : pieces_) {
        const double step = piece.curvature == 0 ? longestStep : largestAngle / piece.curvature;
        const std::vector<double> own = stationsBetween(piece.start, piece.start + piece.length, step);
        all.insert(all.end(), own.begin() + 1, own.end());
    }
    return all;
}

Profile::Profile(const Polyline& line, const std::vector<double>& radii) : end_(line[0]) {
    assert(line.size() >= 2 && radii.size() == line.size() - 2);
    double used = 0;  // length that the arc at the current leg's beginning takes
    for (std::size_t i = 1; i < line.size(); ++i) {
        const Vector2 leg = line[i] - line[i - 1];
        direction_ = leg.normalized();
        if (i + 1 == line.size()) {
            add(leg.norm() - used, 0);
            break;
        }
        const Vector2 next = line[i + 1] - line[i];
        const Vector2 turned(direction_.dot(next.normalized()), leftOf(direction_).dot(next.normalized()));
        const double angle = std::atan2(turned.y(), turned.x()), tangent = std::tan(std::abs(angle) / 2);
        const double room = 0.49 * std::min(leg.norm(), next.norm());
        const double radius = tangent > 1e-9 ? std::min(radii[i - 1], room / tangent) : 0;
        add(leg.norm() - used - radius * tangent, 0);
        corners_.push_back(length_ + radius * std::abs(angle) / 2);
        used = radius * tangent;
        if (radius > 0) add(radius * std::abs(angle), (angle > 0 ? 1 : -1) / radius);
    }
}

void Profile::add(double length, double curvature) {
    legs_.push_back({length_, length, curvature, end_, direction_});
    length_ += length;
    end_ = at(length_);
    direction_ = Eigen::Rotation2Dd(curvature * length) * direction_;
}

Vector2 Profile::at(double length) const {
    auto leg =
        std::find_if(legs_.begin(), legs_.end(), [&](const Leg& l) { return length < l.start + l.length; });
    if (leg == legs_.end()) --leg;
    const double along = length - leg->start, k = leg->curvature;
    if (k == 0) return leg->from + along * leg->direction;
    return leg->from + std::sin(k * along) / k * leg->direction +
           (1 - std::cos(k * along)) / k * leftOf(leg->direction);
}

std::vector<double> Profile::arcLines(int segmentsPerQuarter) const {
    std::vector<double> lines;
    for (const Leg& leg : legs_) {
        if (leg.curvature == 0) continue;
        const double angle = leg.length * std::abs(leg.curvature);
        const int segments = std::max(1, static_cast<int>(std::ceil(angle / M_PI_2 * segmentsPerQuarter)));
        for (int i = 0; i <= segments; ++i) lines.push_back(leg.start + leg.length * i / segments);
    }
    return lines;
}

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

}  // namespace clearway::scenes
