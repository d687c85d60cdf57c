// Where a picture is taken from, and how much it takes in.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "program/render/rays.h"

namespace clearway::render {

/// A direction to look from. z is up.
struct NamedView {
    const char* name;
    const char* about;  ///< for --help
    Vector3 from;       ///< from what is looked at towards the camera
};

/// In the order of lists. "inside" is not among them: it depends on the path.
const std::vector<NamedView>& namedViews();

/// Throws std::invalid_argument that lists the names.
const NamedView& viewNamed(const std::string& name);

/// A rectangle of a picture, in pixels; y goes down.
struct Area {
    double left = 0, top = 0, right = 0, bottom = 0;
};

/// A pinhole camera. Pixel (0, 0) is the corner of the picture at its top left.
struct Camera {
    Vector3f eye = Vector3f::Zero();
    Vector3f right = Vector3f::UnitX(), up = Vector3f::UnitZ(), forward = Vector3f::UnitY();
    float focal = 1;                 ///< pixels
    float centreX = 0, centreY = 0;  ///< the pixel straight ahead

    Ray rayThrough(float x, float y) const;
};

/// Standing at eye, looking at a point. angle: what the area takes in, radians, along its longer side.
Camera cameraAt(const Vector3& eye, const Vector3& target, double angle, const Area& area);

/// Looking against `from`, as near as it can with all points in the area.
Camera cameraAround(const std::vector<Vector3f>& points, const Vector3& from, double angle, const Area& area);

}  // namespace clearway::render
