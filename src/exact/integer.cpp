#include "exact/integer.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace clearway {
namespace {

/// A positive value as fraction * 2^exponent with a relative error of at most 2 u64; the fraction has 63
/// bits.
struct Scaled {
    double fraction;
    int exponent;
};

Scaled leadingBitsOf(const Integer& value) {
    const int extra = int(msb(value)) - 62;
    const Integer leading = extra > 0 ? Integer(value >> unsigned(extra)) : Integer(value);
    return {static_cast<double>(static_cast<std::int64_t>(leading)), extra > 0 ? extra : 0};
}

constexpr int kNoBit = std::numeric_limits<int>::max();

/// The least lastBitOf of the numbers that are not 0; kNoBit if all are 0.
int leastLastBit(const double* x, int count) {
    int last = kNoBit;
    for (int k = 0; k < count; ++k) {
        if (x[k] != 0) last = std::min(last, lastBitOf(x[k]));
    }
    return last;
}

}  // namespace

int lastBitOf(double x) {
    int exponent;
    const double fraction = std::frexp(x, &exponent);  // has 53 bits
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
    constexpr double kUnbounded = std::numeric_limits<double>::infinity();
    if (denominator.sign() == 0) return {kUnbounded, kUnbounded};
    if (numerator.sign() == 0) return {0, 0};
    const Scaled n = leadingBitsOf(numerator), d = leadingBitsOf(denominator);
    const int squareExponent = n.exponent - d.exponent, odd = squareExponent & 1;
    const double root = std::ldexp(std::sqrt(std::ldexp(n.fraction / d.fraction, odd)),
                                   (squareExponent - odd) / 2 + exponent);
    // For denormal numbers ldexp and the products round by up to the least denormal.
    constexpr double kLeast = std::numeric_limits<double>::denorm_min();
    return {std::max(root * (1 - 0x1p-51) - kLeast, 0.0), root * (1 + 0x1p-51) + kLeast};
}

int lastBitOf(const Pose& X_ab, const Vector3& p_b) {
    const int ofPoint = leastLastBit(p_b.data(), 3), ofTranslation = leastLastBit(X_ab.translation.data(), 3);
    if (ofPoint == kNoBit) return ofTranslation == kNoBit ? 0 : ofTranslation;
    return std::min(ofTranslation, leastLastBit(X_ab.rotation.data(), 9) + ofPoint);
}

Triple<Integer> movedInteger(const Pose& X_ab, const Vector3& p_b, int exponent) {
    const int ofR = leastLastBit(X_ab.rotation.data(), 9), ofPoint = leastLastBit(p_b.data(), 3);
    const auto row = [&](int i) {
        Integer sum = scaledInteger(X_ab.translation[i], exponent);
        if (ofPoint == kNoBit) return sum;
        Integer products = 0;
        for (int k = 0; k < 3; ++k) {
            products += scaledInteger(X_ab.rotation(i, k), ofR) * scaledInteger(p_b[k], ofPoint);
        }
        return Integer(sum + (products << unsigned(ofR + ofPoint - exponent)));
    };
    return {row(0), row(1), row(2)};
}

}  // namespace clearway
