// Draws a picture of a problem: the environment, the part at some poses in the colours of their clearances,
// and the path of the part.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "clearway/problem.h"
#include "program/render/image.h"
#include "program/render/surface.h"

namespace clearway::render {

/// The place of a pose in its path. The start and the goal have outlines of their own colours.
enum class PoseRole { kBetween, kStart, kGoal };

struct PosedPart {
    PartState state;
    double clearance = 0;      ///< environment units
    bool isGhost = false;      ///< drawn translucent
    bool isInContact = false;  ///< collides or is too close: drawn in contactColour() and hatched
    PoseRole role = PoseRole::kBetween;
};

struct RenderOptions {
    int width = 1280, height = 720;  ///< at least 16
    int samples = 16;                ///< rays for each pixel

    /// A name of namedViews, or "inside": a close view across the path, with the near half of the environment
    /// cut away.
    std::string view = "iso";
    /// Replace the view: the camera stands at `eye` and looks at `lookAt`, by default the middle of the
    /// scene.
    std::optional<Vector3> eye, lookAt;
    double angle = 30;     ///< field of view along the longer side of the picture, degrees
    bool isClose = false;  ///< the poses of the part fill the picture, not the whole environment
    /// A plane in environment coordinates. It cuts away the environment (not the part) on the camera's side,
    /// whichever way the normal points.
    std::optional<CutPlane> cut;
    /// Clearance at the top of the colour scale. Default: see scaleFor().
    std::optional<double> scaleMost;
    std::string scaleTitle = "clearance";  ///< above the colour scale
    std::string unit;                      ///< of lengths in the legend, such as "mm"; empty: unknown
    bool hasAxes = false;                  ///< the directions of x, y and z are drawn in a corner
    /// Places in environment coordinates around which rings are drawn, over all that hides them.
    std::vector<Vector3> marks;
    bool marksContacts = false;  ///< whether the marks are contacts, too, not only overlaps

    /// Asked often, by any thread. Once true, the picture is given up.
    std::function<bool()> isStopped = [] { return false; };
};

/// poses: the poses the part is shown at, at least one. way: the poses that a line is drawn through, at the
/// middle of the part's box; empty: no line. Returns an image without pixels if stopped. Throws
/// std::invalid_argument when there is no pose or no such view, or the camera stands at the point it looks at.
Image render(const Mesh& part, const Mesh& environment, const std::vector<PosedPart>& poses,
             const std::vector<PosedPart>& way, const RenderOptions& options);

}  // namespace clearway::render
