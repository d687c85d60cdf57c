// Colours as light (linear) and as files hold them (sRGB), and the scale that shows clearance.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>

namespace clearway {

/// 0 to 1 for red, green and blue, linear: twice the value is twice the light.
using Colour = Eigen::Vector3f;

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

/// The clearance at the top of a scale for clearances from least to most: a round number that holds them all,
/// or, when most is far more than least, one that still tells the tight places apart. An infinite most counts
/// as far more.
double scaleFor(double least, double most);

}  // namespace clearway
