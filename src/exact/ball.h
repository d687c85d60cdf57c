// Double-double numbers that carry a bound of their own error. A question that such numbers decide is decided
// for good. Zeros mostly come out exactly, with error 0, so the contacts of resting parts are mostly decided
// here. Sources: van der Hoeven, Ball arithmetic, 2009; for the error-free sums and products, Ogita, Rump,
// Oishi, Accurate Sum and Dot Product, SIAM J. Sci. Comput. 26 (2005), Dekker 1971 and Knuth 1969. They need
// -ffp-contract=off.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "clearway/types.h"
#include "exact/numbers.h"

namespace clearway {

/// The value is exactly high + low; |low| <= 2^-53 |high|.
struct DoubleDouble {
    double high;
    double low;
};

/// a + b without error.
inline DoubleDouble twoSum(double a, double b) {
    const double sum = a + b;
    const double bShare = sum - a;
    return {sum, (a - (sum - bShare)) + (b - bShare)};
}

/// a * b without error, while the product stays within 2^-969 to 2^996.
inline DoubleDouble twoProduct(double a, double b) {
    constexpr double kSplitter = 134217729.0;  // 2^27 + 1 splits a double's digits in two halves
    const double product = a * b;
    const double aBig = kSplitter * a;
    const double aHigh = aBig - (aBig - a);
    const double aLow = a - aHigh;
    const double bBig = kSplitter * b;
    const double bHigh = bBig - (bBig - b);
    const double bLow = b - bHigh;
    return {product, ((aHigh * bHigh - product) + aHigh * bLow + aLow * bHigh) + aLow * bLow};
}

/// r . p + t, computed with twice the digits and rounded once. The error is at most
/// 2^-53 |result| + 2^-102 (|r| . |p| + |t|).
inline double affineRow(const double r[3], const double p[3], double t) {
    DoubleDouble sum{t, 0};
    double rest = 0;
    for (int k = 0; k < 3; ++k) {
        const DoubleDouble product = twoProduct(r[k], p[k]);
        sum = twoSum(sum.high, product.high);
        rest += product.low + sum.low;
    }
    return sum.high + rest;
}

/// A number that is within `error` of high + low; |low| <= 2^-52 |high|. high is NaN or infinite after an
/// overflow.
struct Ball {
    double high = 0;
    double low = 0;
    double error = 0;

    Ball() = default;
    Ball(double value) : high(value) {}
    Ball(double newHigh, double newLow, double newError) : high(newHigh), low(newLow), error(newError) {}
    bool isZero() const { return high == 0 && low == 0 && error == 0; }
};

/// An error bound raised by more than the roundings of the few sums and products that computed it.
inline double raised(double error) {
    return error * (1 + 0x1p-48);
}

inline Ball operator-(const Ball& a) {
    return {-a.high, -a.low, a.error};
}

inline Ball operator+(const Ball& a, const Ball& b) {
    if (a.isZero()) return b;
    if (b.isZero()) return a;
    const DoubleDouble s = twoSum(a.high, b.high);
    if (a.low == 0 && b.low == 0) return {s.high, s.low, raised(a.error + b.error)};
    const DoubleDouble t = twoSum(a.low, b.low);
    const DoubleDouble c = twoSum(s.low, t.high);
    const DoubleDouble v = twoSum(s.high, c.high);
    const DoubleDouble w = twoSum(t.low, c.low);
    const DoubleDouble x = twoSum(v.low, w.high);
    const DoubleDouble sum = twoSum(v.high, x.high);
    return {sum.high, sum.low, raised(a.error + b.error + std::abs(w.low) + std::abs(x.low))};
}

inline Ball operator-(const Ball& a, const Ball& b) {
    return a + -b;
}

inline Ball operator*(const Ball& a, const Ball& b) {
    if (a.isZero() || b.isZero()) return {};
    const DoubleDouble p = twoProduct(a.high, b.high);
    // twoProduct is exact unless the product, or its tail, underflows; kUnderflow covers what is lost then.
    constexpr double kUnderflow = 0x1p-1000, kLeast = 0x1p-900;
    const double underflow = std::abs(p.high) < kLeast ? kUnderflow : 0;
    if (a.low == 0 && b.low == 0 && a.error == 0 && b.error == 0) return {p.high, p.low, underflow};
    const double ab = a.high * b.low, ba = a.low * b.high;
    const DoubleDouble product = twoSum(p.high, p.low + (ab + ba));
    // The tail is computed with three rounded sums and two rounded products, and leaves out a.low * b.low.
    const double rounding = 0x1p-51 * (std::abs(p.low) + std::abs(ab) + std::abs(ba));
    const double carried = std::abs(a.high) * b.error + std::abs(b.high) * a.error + a.error * b.error;
    return {product.high, product.low, raised(carried + rounding + std::abs(a.low * b.low)) + kUnderflow};
}

/// Bounds of the value, correct up to one rounding of the bound itself.
inline double leastOf(const Ball& a) {
    return a.high - raised(a.error + std::abs(a.low));
}
inline double mostOf(const Ball& a) {
    return a.high + raised(a.error + std::abs(a.low));
}

/// Whether a >= 0.
inline Verdict isNotNegative(const Ball& a) {
    if (a.error == 0) return a.high >= 0 ? Verdict::yes : a.high < 0 ? Verdict::no : Verdict::open;
    const double error = raised(a.error);
    return a.high > error ? Verdict::yes : -a.high > error ? Verdict::no : Verdict::open;
}

/// An estimate of the quotient without an error bound; NaN or infinite where the denominator is 0.
inline double quotient(const Ball& numerator, const Ball& denominator) {
    return (numerator.high + numerator.low) / (denominator.high + denominator.low);
}

/// Bounds of sqrt(numerator / denominator). denominator: >= 0; where it may be 0 the upper bound is infinite,
/// where it is known to be 0 both are.
inline LengthBounds rootBounds(const Ball& numerator, const Ball& denominator) {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    const double above = mostOf(denominator) * (1 + 0x1p-51), below = leastOf(denominator) * (1 - 0x1p-51);
    if (above <= 0) return {kInfinity, kInfinity};
    if (numerator.isZero()) return {0, below > 0 ? 0 : kInfinity};
    constexpr double kLeast = 0x1p-1000;  // a quotient below this may have lost digits
    const double least = leastOf(numerator) / above, most = std::max(mostOf(numerator) / below, kLeast);
    return {least > kLeast ? std::sqrt(least) * (1 - 0x1p-51) : 0,
            below > 0 && most < kInfinity ? std::sqrt(most) * (1 + 0x1p-51) : kInfinity};
}

/// The point R p + t that the pose moves p to, each coordinate with a bound of its error.
inline Triple<Ball> movedBall(const Pose& X_ab, const Vector3& p_b) {
    const auto row = [&](int i) {
        Ball sum = X_ab.translation[i];
        for (int k = 0; k < 3; ++k) sum = sum + Ball(X_ab.rotation(i, k)) * Ball(p_b[k]);
        return sum;
    };
    return {row(0), row(1), row(2)};
}

}  // namespace clearway
