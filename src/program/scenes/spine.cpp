#include "program/scenes/spine.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace clearway::scenes {

namespace {

/// The frame after a length of a straight or a bend, seen from its start.
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

}  // namespace

Spine Spine::through(const std::vector<Vector3>& points, double radius, const Vector3& up) {
    assert(points.size() >= 2 && radius > 0);
    Spine spine(standingAtFirst(points[0], points[1] - points[0], up));
    double used = 0;  // of the present leg, by the bend at its beginning
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

}  // namespace clearway::scenes
