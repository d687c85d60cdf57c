// Takes the grain out of light that few rays sampled: pixels of one surface share it with their neighbours.
// Source: Petschnigg and others, Digital Photography with Flash and No-Flash Image Pairs, 2004 (the joint
// bilateral filter).
#pragma once

#include <cstdint>
#include <vector>

#include "program/render/image.h"

namespace clearway::render {

/// What the rays of one pixel met.
struct PixelLight {
    float light = 0;  ///< mean over its rays; its colour is proportional to it
    Eigen::Vector3f point = Eigen::Vector3f::Zero(), normal = Eigen::Vector3f::Zero();  ///< means
    float size = 0;          ///< of the pixel, where the point is
    std::uint32_t body = 0;  ///< the one that all of them met
    bool isPlain = false;    ///< false: they met several, or nothing, or a ghost; such a pixel stays as it is
};

/// lights: of the image's pixels, in their order.
void smoothLight(const std::vector<PixelLight>& lights, Image& image);

}  // namespace clearway::render
