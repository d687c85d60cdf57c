// The motion that the kernels of a sweep read.
#pragma once

namespace clearway {

/// The lengths that the part's points move in half a piece of time, in one frame and unit.
struct MovedField {
    float atOrigin[4];  ///< of a point at the frame's origin, and an unused float
    float turn[4];      ///< a point at y moves by atOrigin + turn x y
    float deviation;    ///< any point may move this much further; includes the rounding of the kernels
    float bow;          ///< and further square to the turn, by this times the turn's length
};

}  // namespace clearway
