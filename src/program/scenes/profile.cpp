#include "program/scenes/profile.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace clearway::scenes {

namespace {

Vector2 leftOf(const Vector2& direction) {
    return {-direction.y(), direction.x()};
}

}  // namespace

Profile::Profile(const Polyline& line, const std::vector<double>& radii) : end_(line[0]) {
    assert(line.size() >= 2 && radii.size() == line.size() - 2);
    double used = 0;  // of the present leg, by the arc at its beginning
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

}  // namespace clearway::scenes
