// Traces the rays of a picture: light and shade, ghosts and outlines, but no legend.
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
    float lightReach = 0.12f;  ///< farther obstacles do not darken the sky; the stage has size 1
    float ghostShare = 0.5f;   ///< opacity of a ghost
    float veilShare = 0.3f;    ///< opacity of a ghost in front of a colour of the scale, which it only pales
    float lineWidth = 1.4f;    ///< width of outlines, pixels; 0: no outlines
    float hatching = 10;       ///< distance of the lines of hatching, pixels

    std::function<bool()> isStopped = [] { return false; };  ///< then the picture is left unfinished, soon
};

/// Takes the picture on the threads of oneTBB. The result does not depend on their number.
Image expose(const Stages& stages, const Camera& camera, const Exposure& exposure);

/// Calls `work` for each pixel, on the threads of oneTBB, until stopped.
void forEachPixel(const Exposure& exposure, const std::function<void(int, int)>& work);

}  // namespace clearway::render
