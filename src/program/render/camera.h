// The camera of a picture: where it stands, where it looks, and how much it shows.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "program/render/rays.h"

namespace clearway::render {

/// A viewing direction with a name. z is up.
struct NamedView {
    const char* name;
    const char* about;  ///< a few words for --help
    Vector3 from;       ///< points from the scene to the camera
};

/// All views, in the order --help lists them. "inside" is missing here because it depends on the path.
const std::vector<NamedView>& namedViews();

/// Finds a view. Throws std::invalid_argument with the list of names when there is none.
const NamedView& viewNamed(const std::string& name);

/// A rectangle in a picture, in pixels; y points down.
struct Area {
    double left = 0, top = 0, right = 0, bottom = 0;
};

/// A pinhole camera. (0, 0) is the top left corner of the picture.
struct Camera {
    Vector3f eye = Vector3f::Zero();
    Vector3f right = Vector3f::UnitX(), up = Vector3f::UnitZ(), forward = Vector3f::UnitY();
    float focal = 1;                 ///< pixels
    float centreX = 0, centreY = 0;  ///< the pixel in direction `forward`

    Ray rayThrough(float x, float y) const;
    /// Where a point is seen in the picture, pixels; nothing for a point behind the camera.
    std::optional<Eigen::Vector2f> placeOf(const Vector3f& point) const;
};

/// A camera at `eye` that looks at `target`. angle: field of view along the longer side of the area, radians.
/// Throws std::invalid_argument when both points are one.
Camera cameraAt(const Vector3& eye, const Vector3& target, double angle, const Area& area);

/// The nearest camera that looks against `from` and has all points in the area.
Camera cameraAround(const std::vector<Vector3f>& points, const Vector3& from, double angle, const Area& area);

}  // namespace clearway::render
