// A point moved by a pose, R p + t, in the numbers that decide: nothing is rounded that they do not know of.
#pragma once

#include "clearway/types.h"
#include "exact/ball.h"
#include "exact/integer.h"
#include "exact/triple.h"

namespace clearway {

Triple<Ball> movedBall(const Pose& X_ab, const Vector3& p_b);

/// The largest exponent known, without trying, of which all coordinates of the moved point are whole
/// multiples; that of the largest numbers when they are 0.
int lastBitOf(const Pose& X_ab, const Vector3& p_b);

/// The moved point in units of 2^exponent; exponent: lastBitOf(X_ab, p_b) or less.
Triple<Integer> movedInteger(const Pose& X_ab, const Vector3& p_b, int exponent);

}  // namespace clearway
