// Colours as light (linear) and as files store them (sRGB), and the scale that shows clearance.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>

namespace clearway::render {

/// Linear red, green and blue from 0 to 1: twice the value is twice the light.
using Colour = Eigen::Vector3f;

/// The colour of sRGB components from 0 to 255, as in web colours: sRgb(255, 128, 0).
Colour sRgb(int red, int green, int blue);

/// The sRGB components, clamped and rounded to 0 to 255.
std::array<std::uint8_t, 3> toSRgb(const Colour& colour);

/// The part's colour for a share of the scale: 0 (no clearance) is yellow, 1 (the top of the scale) is deep
/// blue. Lightness falls evenly between them, so that the scale can be read in grey and by colour-blind
/// readers.
Colour clearanceColour(double share);

/// The part's colour in a pose that collides or is too close, on which black hatching is drawn: a green that the
/// clearance scale does not hold. To colour-blind readers it is grey, and the hatching still tells it from the scale.
Colour contactColour();

/// The least number of the form 1, 1.5, 2, 3, 4, 5, 6 or 8 times a power of ten that is at least the value; 1
/// if the value is not above 0 or not finite.
double niceCeiling(double value);

/// The clearance at the top of a scale for clearances from `least` to `most`: a round number that is at least
/// `most`. When `most` is far larger than `least` (or infinite), a smaller number, so that tight places stay
/// distinguishable. On a way with contact, near which clearances are as small as can be, a quarter of `most`.
double scaleFor(double least, double most, bool hasContact);

}  // namespace clearway::render
