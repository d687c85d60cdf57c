#include "exact/integer.h"

#include <cmath>
#include <cstdint>
#include <limits>

namespace clearway {
namespace {

/// value = fraction 2^exponent but for 2 u64, fraction of 63 bits; value > 0.
struct Scaled {
    double fraction;
    int exponent;
};

Scaled leadingBitsOf(const Integer& value) {
    const int extra = int(msb(value)) - 62;
    const Integer leading = extra > 0 ? Integer(value >> unsigned(extra)) : Integer(value);
    return {static_cast<double>(static_cast<std::int64_t>(leading)), extra > 0 ? extra : 0};
}

}  // namespace

int lastBitOf(double x) {
    int exponent;
    const double fraction = std::frexp(x, &exponent);  // of 53 bits
    const auto digits = static_cast<std::int64_t>(std::ldexp(fraction, 53));
    return exponent - 53 + __builtin_ctzll(static_cast<std::uint64_t>(digits));
}

Integer scaledInteger(double x, int exponent) {
    if (x == 0) return 0;
    const int last = lastBitOf(x);
    Integer value = static_cast<std::int64_t>(std::ldexp(x, -last));
    value <<= unsigned(last - exponent);
    return value;
}

double quotient(const Integer& numerator, const Integer& denominator) {
    if (numerator.sign() == 0) return 0;
    const bool negative = numerator.sign() != denominator.sign();
    const Scaled n = leadingBitsOf(abs(numerator)), d = leadingBitsOf(abs(denominator));
    const double size = std::ldexp(n.fraction / d.fraction, n.exponent - d.exponent);
    return negative ? -size : size;
}

LengthBounds rootBounds(const Integer& numerator, const Integer& denominator, int exponent) {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    if (denominator.sign() == 0) return {kInfinity, kInfinity};
    if (numerator.sign() == 0) return {0, 0};
    const Scaled n = leadingBitsOf(numerator), d = leadingBitsOf(denominator);
    const int squareExponent = n.exponent - d.exponent, odd = squareExponent & 1;
    const double root = std::ldexp(std::sqrt(std::ldexp(n.fraction / d.fraction, odd)),
                                   (squareExponent - odd) / 2 + exponent);
    // Among denormal numbers ldexp and the products round by up to the least of them.
    constexpr double kLeast = std::numeric_limits<double>::denorm_min();
    return {std::max(root * (1 - 0x1p-51) - kLeast, 0.0), root * (1 + 0x1p-51) + kLeast};
}

}  // namespace clearway
