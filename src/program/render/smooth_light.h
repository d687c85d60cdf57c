// Removes the grain of light sampled by few rays: neighbouring pixels of one surface share their light.
// Source: Petschnigg and others, Digital Photography with Flash and No-Flash Image Pairs, 2004 (the joint
// bilateral filter).
#pragma once

#include <cstdint>
#include <vector>

#include "program/render/image.h"

namespace clearway::render {

/// Averages over the rays of one pixel.
struct PixelLight {
    float light = 0;  ///< the pixel's colour is proportional to it
    Eigen::Vector3f point = Eigen::Vector3f::Zero(), normal = Eigen::Vector3f::Zero();
    float size = 0;          ///< size of the pixel at the distance of the point
    std::uint32_t body = 0;  ///< the body that all rays met
    bool isPlain = false;    ///< all rays met one body and no ghost; other pixels are not changed
};

constexpr int kSmoothReach = 3;  ///< neighbours to each side that share their light, pixels

/// lights: one entry for each pixel, in the order of the pixels. chosen: as many entries, not 0 for the
/// pixels to smooth; empty: all.
void smoothLight(const std::vector<PixelLight>& lights, Image& image,
                 const std::vector<std::uint8_t>& chosen = {});

}  // namespace clearway::render
