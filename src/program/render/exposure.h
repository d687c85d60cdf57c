// From a stage and a camera to a picture without lettering.
#pragma once

#include <functional>

#include "program/render/camera.h"
#include "program/render/image.h"
#include "program/render/stage.h"

namespace clearway::render {

struct Exposure {
    int width = 1280, height = 720;
    int samples = 16;  ///< rays for each pixel
    Colour background{1, 1, 1};
    float lightReach = 0.12f;  ///< see Light
    float ghostShare = 0.5f;   ///< of the light, what comes from a ghost and not from behind it
    float veilShare = 0.3f;    ///< likewise before what has a colour of the scale, which a ghost only pales
    float lineWidth = 1.4f;    ///< of outlines, pixels; 0 for none
};

/// Uses as many threads as oneTBB gives; the picture does not depend on their number.
Image expose(const Stages& stages, const Camera& camera, const Exposure& exposure);

}  // namespace clearway::render
