#pragma once

namespace clearway {

/// lower <= a length <= upper.
struct LengthBounds {
    double lower;
    double upper;
};

}  // namespace clearway
