// Error-free sums and products of doubles: the building stones of double-double arithmetic.
// Source: Ogita, Rump, Oishi, Accurate Sum and Dot Product, SIAM J. Sci. Comput. 26 (2005); Dekker 1971;
// Knuth 1969. Exact only without contraction (-ffp-contract=off) and while products stay within 2^-969 ..
// 2^996.
#pragma once

namespace clearway {

/// high + low is exactly the value; |low| <= 2^-53 |high|.
struct DoubleDouble {
    double high;
    double low;
};

inline DoubleDouble twoSum(double a, double b) {
    const double sum = a + b;
    const double bShare = sum - a;
    return {sum, (a - (sum - bShare)) + (b - bShare)};
}

inline DoubleDouble twoProduct(double a, double b) {
    constexpr double kSplitter = 134217729.0;  // 2^27 + 1: halves a double's digits
    const double product = a * b;
    const double aBig = kSplitter * a;
    const double aHigh = aBig - (aBig - a);
    const double aLow = a - aHigh;
    const double bBig = kSplitter * b;
    const double bHigh = bBig - (bBig - b);
    const double bLow = b - bHigh;
    return {product, ((aHigh * bHigh - product) + aHigh * bLow + aLow * bHigh) + aLow * bLow};
}

/// r . p + t as if computed with twice the digits and rounded once: the error is at most
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

}  // namespace clearway
