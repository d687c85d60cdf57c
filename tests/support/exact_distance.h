// The distance of two triangles in integer arithmetic: a power of two makes all coordinates integers, and
// squared distances are fractions that are never reduced. Checked against CGAL and closed forms.
#pragma once

#include <array>

#include "clearway/types.h"

// g++ 12 reports accesses beyond the storage of small numbers where it inlines them.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Warray-bounds"
#include <boost/multiprecision/cpp_int.hpp>
#pragma GCC diagnostic pop

namespace clearway::testing {

using Rational =
    boost::multiprecision::number<boost::multiprecision::cpp_rational_backend, boost::multiprecision::et_off>;

/// The length sqrt(numerator / denominator) 2^exponent, without error. denominator > 0.
struct ExactDistance {
    using Integer = boost::multiprecision::number<boost::multiprecision::cpp_int_backend<512>,
                                                  boost::multiprecision::et_off>;
    Integer numerator = 0;
    Integer denominator = 1;
    int exponent = 0;

    bool isZero() const { return numerator == 0; }

    /// The sign of this length minus d. d: >= 0 or infinite.
    int compare(double d) const;
    int compare(const ExactDistance& other) const;

    /// The length rounded, with a relative error of about 2^-62.
    long double rounded() const;

    Rational squared() const;
};

/// The distance between R x + t, from the pose's 12 doubles, and the environment's corners, without rounding.
/// Degenerate triangles count as segments or points. All numbers must be finite.
ExactDistance exactDistance(const Pose& X_environmentPart, const std::array<Vector3, 3>& part,
                            const std::array<Vector3, 3>& environment);

inline ExactDistance exactDistance(const std::array<Vector3, 3>& a, const std::array<Vector3, 3>& b) {
    return exactDistance(Pose{}, a, b);
}

}  // namespace clearway::testing
