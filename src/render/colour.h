// Colours as light (linear) and as files hold them (sRGB), and the scale that shows clearance.
#pragma once

#include <array>
#include <cstdint>

#include "render/surface.h"

namespace clearway {

/// 0 to 1 for red, green and blue, linear: twice the value is twice the light.
using Colour = Vector3f;

/// From the 0 to 255 of web colours: sRgb(255, 128, 0).
Colour sRgb(int red, int green, int blue);

/// Rounded, clamped.
std::array<std::uint8_t, 3> toSRgb(const Colour& colour);

/// The part's colour for a share of the scale: 0, no clearance, is yellow; 1, all of it, deep blue. Lightness
/// falls evenly between, so that it can be read in grey and by the colour-blind.
Colour clearanceColour(double share);

/// The least of 1, 1.5, 2, 3, 4, 5, 6, 8 times a power of ten that is at least the value; 1 for what is not
/// above 0 or not finite.
double niceCeiling(double value);

}  // namespace clearway
