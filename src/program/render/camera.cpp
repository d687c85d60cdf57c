#include "program/render/camera.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "core/text.h"

namespace clearway::render {

namespace {

/// Places a camera along one axis of the picture, so that both of its side planes touch the points, and tells
/// how far back the camera then stands.
struct Span {
    float most = -std::numeric_limits<float>::infinity();
    float least = std::numeric_limits<float>::infinity();
    float tangent;  ///< tangent of half the field of view

    explicit Span(float halfTangent) : tangent(halfTangent) {}
    void add(float across, float depth) {
        most = std::max(most, across - tangent * depth);
        least = std::min(least, across + tangent * depth);
    }
    float centre() const { return (least + most) / 2; }
    float depth() const { return (least - most) / (2 * tangent); }
};

/// A camera at the origin with the given direction and field of view.
Camera lookingAlong(const Vector3f& forward, double angle, const Area& area) {
    Camera camera;
    camera.forward = forward.normalized();
    const bool isUpright =
        camera.forward.head<2>().norm() < 1e-4f;  // looking straight down or up: y is up in the picture
    camera.right = camera.forward.cross(isUpright ? Vector3f::UnitY() : Vector3f::UnitZ()).normalized();
    camera.up = camera.right.cross(camera.forward);
    const double width = area.right - area.left, height = area.bottom - area.top;
    camera.focal = static_cast<float>(std::max(width, height) / (2 * std::tan(angle / 2)));
    camera.centreX = static_cast<float>((area.left + area.right) / 2);
    camera.centreY = static_cast<float>((area.top + area.bottom) / 2);
    return camera;
}

}  // namespace

const std::vector<NamedView>& namedViews() {
    static const std::vector<NamedView> views = {
        {"iso", "from the front, the right and above", {0.62, -1, 0.62}},
        {"front", "along y", {0, -1, 0}},
        {"back", "against y", {0, 1, 0}},
        {"right", "against x", {1, 0, 0}},
        {"left", "along x", {-1, 0, 0}},
        {"side", "another name of right", {1, 0, 0}},
        {"top", "from above, y up", {0, 0, 1}},
        {"bottom", "from below, y up", {0, 0, -1}},
    };
    return views;
}

const NamedView& viewNamed(const std::string& name) {
    for (const NamedView& view : namedViews()) {
        if (name == view.name) return view;
    }
    std::vector<std::string> known{"inside"};
    for (const NamedView& view : namedViews()) known.push_back(view.name);
    throw std::invalid_argument("view is '" + name + "'" + didYouMean(name, known) + ", expected one of " +
                                joined(known));
}

Ray Camera::rayThrough(float x, float y) const {
    const Vector3f direction = forward + (x - centreX) / focal * right + (centreY - y) / focal * up;
    return {eye, direction.normalized()};
}

std::optional<Eigen::Vector2f> Camera::placeOf(const Vector3f& point) const {
    const Vector3f seen = point - eye;
    const float depth = forward.dot(seen);
    if (!(depth > 0)) return std::nullopt;
    return Eigen::Vector2f(centreX + focal * right.dot(seen) / depth, centreY - focal * up.dot(seen) / depth);
}

Camera cameraAt(const Vector3& eye, const Vector3& target, double angle, const Area& area) {
    const Vector3 towards = target - eye;
    if (!(towards.norm() > 0)) {
        throw std::invalid_argument(
            "the camera stands at the point it looks at, expected two different points");
    }
    Camera camera = lookingAlong(towards.cast<float>(), angle, area);
    camera.eye = eye.cast<float>();
    return camera;
}

Camera cameraAround(const std::vector<Vector3f>& points, const Vector3& from, double angle,
                    const Area& area) {
    Camera camera = lookingAlong(-from.cast<float>(), angle, area);
    Span across(static_cast<float>(area.right - area.left) / (2 * camera.focal));
    Span upwards(static_cast<float>(area.bottom - area.top) / (2 * camera.focal));
    for (const Vector3f& point : points) {
        const float depth = camera.forward.dot(point);
        across.add(camera.right.dot(point), depth);
        upwards.add(camera.up.dot(point), depth);
    }
    camera.eye = across.centre() * camera.right + upwards.centre() * camera.up +
                 std::min(across.depth(), upwards.depth()) * camera.forward;
    return camera;
}

}  // namespace clearway::render
