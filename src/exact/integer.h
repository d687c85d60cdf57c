// Whole numbers of any size: doubles are whole multiples of a power of two, so sums and products of them are
// exact here, and rational numbers need no fractions reduced.
#pragma once

#include "exact/length_bounds.h"
#include "exact/verdict.h"

// g++ 12 takes the small numbers' storage for uninitialised where it inlines them.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#include <boost/multiprecision/cpp_int.hpp>
#pragma GCC diagnostic pop

namespace clearway {

/// Of up to 2048 bits without the heap, which is most of them.
using Integer = boost::multiprecision::number<boost::multiprecision::cpp_int_backend<2048>,
                                              boost::multiprecision::et_off>;

/// The largest exponent e for which x is a whole multiple of 2^e; x: finite, not 0.
int lastBitOf(double x);

/// x / 2^exponent, which is whole: exponent <= lastBitOf(x), or x = 0.
Integer scaledInteger(double x, int exponent);

inline Verdict isNotNegative(const Integer& a) {
    return a.sign() >= 0 ? Verdict::yes : Verdict::no;
}

/// numerator / denominator, off by at most 4 u64 of itself; denominator not 0.
double quotient(const Integer& numerator, const Integer& denominator);

/// Of 2^exponent sqrt(numerator / denominator), each off by at most 6 u64 of itself and 0 only where the
/// root is (lower also where it underflows); infinite where the denominator is 0. Both >= 0.
LengthBounds rootBounds(const Integer& numerator, const Integer& denominator, int exponent);

}  // namespace clearway
