// Integers of any size. Every double is a whole multiple of a power of two, so in a common power-of-two unit
// sums and products of doubles are integers and exact. Fractions are kept as numerator and denominator and
// never reduced.
#pragma once

#include "clearway/types.h"
#include "exact/numbers.h"

#include <boost/multiprecision/cpp_int.hpp>

namespace clearway {

/// An integer that needs no heap up to 2048 bits, which suffices for most triangle pairs.
using Integer = boost::multiprecision::number<boost::multiprecision::cpp_int_backend<2048>,
                                              boost::multiprecision::et_off>;

/// The largest exponent e for which x is a whole multiple of 2^e. x: finite, not 0.
int lastBitOf(double x);

/// x / 2^exponent, which must be whole: x = 0 or exponent <= lastBitOf(x).
Integer scaledInteger(double x, int exponent);

/// Whether a >= 0; never open.
inline Verdict isNotNegative(const Integer& a) {
    return a.sign() >= 0 ? Verdict::yes : Verdict::no;
}

/// numerator / denominator with a relative error of at most 4 u64. denominator: not 0.
double quotient(const Integer& numerator, const Integer& denominator);

/// Bounds of 2^exponent sqrt(numerator / denominator), each with a relative error of at most 6 u64. A bound
/// is 0 only where the root is 0; the lower one also where it underflows. Both are infinite where the
/// denominator is 0. numerator, denominator: >= 0.
LengthBounds rootBounds(const Integer& numerator, const Integer& denominator, int exponent);

/// An exponent e for which all coordinates of the moved point R p + t are whole multiples of 2^e: the largest
/// one that the last bits of R, p and t guarantee. It is 0 where p and t are both 0.
int lastBitOf(const Pose& X_ab, const Vector3& p_b);

/// The moved point R p + t in units of 2^exponent. exponent: at most lastBitOf(X_ab, p_b).
Triple<Integer> movedInteger(const Pose& X_ab, const Vector3& p_b, int exponent);

}  // namespace clearway
