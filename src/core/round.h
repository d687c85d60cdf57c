// Directed rounding from double to float.
#pragma once

#include <cmath>
#include <limits>

namespace clearway {

/// The least float that is not below the value.
inline float roundedUp(double value) {
    const float nearest = static_cast<float>(value);
    return nearest < value ? std::nextafter(nearest, std::numeric_limits<float>::infinity()) : nearest;
}

}  // namespace clearway
