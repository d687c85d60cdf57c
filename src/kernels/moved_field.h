// What the kernels of a sweep read about a motion.
#pragma once

namespace clearway {

/// The lengths that the part's points move in half a piece of time, in the frame and unit of one tree.
struct MovedField {
    float atOrigin[4];  ///< of a point at the tree's origin, and an unused float
    float turn[4];      ///< a point at y moves by atOrigin + turn x y
    float
        deviation;  ///< how much further any point may move; includes the rounding of what kernels do with it
    float bow;      ///< and how much further square to the turn, divided by the turn's length
};

}  // namespace clearway
