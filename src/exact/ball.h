// Double-double numbers that carry a bound of their error, 0 where every step was exact: what is decided with
// them is decided for good. Resting parts are mostly decided so, since their zeros come out exactly.
// Source: van der Hoeven, Ball arithmetic, 2009; sums and products as in double_double.h.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "exact/double_double.h"
#include "exact/length_bounds.h"
#include "exact/verdict.h"

namespace clearway {

/// The value is within `error` of high + low; |low| <= 2^-52 |high|. Not a number where something overflowed.
struct Ball {
    double high = 0;
    double low = 0;
    double error = 0;

    Ball() = default;
    Ball(double value) : high(value) {}
    Ball(double newHigh, double newLow, double newError) : high(newHigh), low(newLow), error(newError) {}
    bool isZero() const { return high == 0 && low == 0 && error == 0; }
};

/// Raised by more than the roundings of the few sums and products that made it.
inline double roundedUp(double error) {
    return error * (1 + 0x1p-48);
}

inline Ball operator-(const Ball& a) {
    return {-a.high, -a.low, a.error};
}

inline Ball operator+(const Ball& a, const Ball& b) {
    if (a.isZero()) return b;
    if (b.isZero()) return a;
    const DoubleDouble s = twoSum(a.high, b.high);
    if (a.low == 0 && b.low == 0) return {s.high, s.low, roundedUp(a.error + b.error)};
    const DoubleDouble t = twoSum(a.low, b.low);
    const DoubleDouble c = twoSum(s.low, t.high);
    const DoubleDouble v = twoSum(s.high, c.high);
    const DoubleDouble w = twoSum(t.low, c.low);
    const DoubleDouble x = twoSum(v.low, w.high);
    const DoubleDouble sum = twoSum(v.high, x.high);
    return {sum.high, sum.low, roundedUp(a.error + b.error + std::abs(w.low) + std::abs(x.low))};
}

inline Ball operator-(const Ball& a, const Ball& b) {
    return a + -b;
}

inline Ball operator*(const Ball& a, const Ball& b) {
    if (a.isZero() || b.isZero()) return {};
    const DoubleDouble p = twoProduct(a.high, b.high);
    // A product is exact, or rounded as it should be, as long as it does not underflow.
    constexpr double kUnderflow = 0x1p-1000, kLeast = 0x1p-900;
    const double underflow = std::abs(p.high) < kLeast ? kUnderflow : 0;
    if (a.low == 0 && b.low == 0 && a.error == 0 && b.error == 0) return {p.high, p.low, underflow};
    const double ab = a.high * b.low, ba = a.low * b.high;
    const DoubleDouble product = twoSum(p.high, p.low + (ab + ba));
    // Of the tail: three sums and two products rounded, the product of both tails left out.
    const double rounding = 0x1p-51 * (std::abs(p.low) + std::abs(ab) + std::abs(ba));
    const double carried = std::abs(a.high) * b.error + std::abs(b.high) * a.error + a.error * b.error;
    return {product.high, product.low, roundedUp(carried + rounding + std::abs(a.low * b.low)) + kUnderflow};
}

/// Bounds of the value, but for one rounding of the bound itself.
inline double leastOf(const Ball& a) {
    return a.high - roundedUp(a.error + std::abs(a.low));
}
inline double mostOf(const Ball& a) {
    return a.high + roundedUp(a.error + std::abs(a.low));
}

inline Verdict isNotNegative(const Ball& a) {
    if (a.error == 0) return a.high >= 0 ? Verdict::yes : a.high < 0 ? Verdict::no : Verdict::open;
    const double error = roundedUp(a.error);
    return a.high > error ? Verdict::yes : -a.high > error ? Verdict::no : Verdict::open;
}

/// Near the quotient of the values, which need not be known to be a number.
inline double quotient(const Ball& numerator, const Ball& denominator) {
    return (numerator.high + numerator.low) / (denominator.high + denominator.low);
}

/// Of sqrt(numerator / denominator), denominator >= 0; infinite where that is 0.
inline LengthBounds rootBounds(const Ball& numerator, const Ball& denominator) {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    const double above = mostOf(denominator) * (1 + 0x1p-51), below = leastOf(denominator) * (1 - 0x1p-51);
    if (above <= 0) return {kInfinity, kInfinity};
    if (numerator.isZero()) return {0, below > 0 ? 0 : kInfinity};
    constexpr double kLeast = 0x1p-1000;  // a quotient below it has not all its digits
    const double least = leastOf(numerator) / above, most = std::max(mostOf(numerator) / below, kLeast);
    return {least > kLeast ? std::sqrt(least) * (1 - 0x1p-51) : 0,
            below > 0 && most < kInfinity ? std::sqrt(most) * (1 + 0x1p-51) : kInfinity};
}

}  // namespace clearway
