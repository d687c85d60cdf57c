// A picture of a problem: the environment, the part at some poses in the colours of their clearances, and
// the way it goes.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "clearway/problem.h"
#include "program/render/image.h"
#include "program/render/surface.h"

namespace clearway::render {

struct PosedPart {
    PartState state;
    double clearance = 0;  ///< environment units
    bool isGhost = false;  ///< drawn to be seen through
};

struct RenderOptions {
    int width = 1280, height = 720;
    int samples = 16;  ///< for each pixel

    /// A name of namedViews, or "inside": across the way the part goes, with the near half of the environment
    /// cut away, close up.
    std::string view = "iso";
    /// In place of the view: where the camera stands and, by default, the middle of the scene as what it
    /// looks at.
    std::optional<Vector3> eye, lookAt;
    double angle = 30;     ///< degrees the picture's longer side takes in
    bool isClose = false;  ///< the part's poses fill the picture, rather than the whole environment
    /// Environment coordinates. The side of it that the camera stands on is cut away, of the environment
    /// alone; which way the normal points does not matter.
    std::optional<CutPlane> cut;
    /// Clearance at the top of the colour scale. Else a round number: that holds all, or, when some is far
    /// more than the least, tells the tight places apart.
    std::optional<double> scaleMost;
};

/// poses: where the part is shown, at least one. way: what a line is drawn along, through the middle of the
/// part's box; empty for none. Throws std::invalid_argument, naming the option, when one is wrong.
Image render(const Mesh& part, const Mesh& environment, const std::vector<PosedPart>& poses,
             const std::vector<PosedPart>& way, const RenderOptions& options);

}  // namespace clearway::render
