// Does a triangle have an area? Decided exactly for the doubles given.
// Filter after Shewchuk, Adaptive Precision Floating-Point Arithmetic and Fast Robust Geometric Predicates,
// 1997.
#pragma once

#include "clearway/types.h"

namespace clearway {

/// True when the three points lie on one line, or in one point, in exact arithmetic. The points are finite.
bool isDegenerate(const Vector3& a, const Vector3& b, const Vector3& c);

}  // namespace clearway
