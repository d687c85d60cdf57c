#include "exact/moved_point.h"

#include <algorithm>
#include <limits>

namespace clearway {
namespace {

constexpr int kNone = std::numeric_limits<int>::max();

int leastLastBit(const double* x, int count) {
    int last = kNone;
    for (int k = 0; k < count; ++k) {
        if (x[k] != 0) last = std::min(last, lastBitOf(x[k]));
    }
    return last;
}

}  // namespace

Triple<Ball> movedBall(const Pose& X_ab, const Vector3& p_b) {
    const auto row = [&](int i) {
        Ball sum = X_ab.translation[i];
        for (int k = 0; k < 3; ++k) sum = sum + Ball(X_ab.rotation(i, k)) * Ball(p_b[k]);
        return sum;
    };
    return {row(0), row(1), row(2)};
}

int lastBitOf(const Pose& X_ab, const Vector3& p_b) {
    const int ofPoint = leastLastBit(p_b.data(), 3), ofTranslation = leastLastBit(X_ab.translation.data(), 3);
    if (ofPoint == kNone) return ofTranslation == kNone ? 0 : ofTranslation;
    return std::min(ofTranslation, leastLastBit(X_ab.rotation.data(), 9) + ofPoint);
}

Triple<Integer> movedInteger(const Pose& X_ab, const Vector3& p_b, int exponent) {
    const int ofR = leastLastBit(X_ab.rotation.data(), 9), ofPoint = leastLastBit(p_b.data(), 3);
    const auto row = [&](int i) {
        Integer sum = scaledInteger(X_ab.translation[i], exponent);
        if (ofPoint == kNone) return sum;
        Integer products = 0;
        for (int k = 0; k < 3; ++k) {
            products += scaledInteger(X_ab.rotation(i, k), ofR) * scaledInteger(p_b[k], ofPoint);
        }
        return Integer(sum + (products << unsigned(ofR + ofPoint - exponent)));
    };
    return {row(0), row(1), row(2)};
}

}  // namespace clearway
