#include "query/decide.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "exact/ball.h"
#include "exact/integer.h"
#include "exact/triangle_features.h"

namespace clearway {
namespace {

/// The corners of a pair in exact numbers.
template <class Number>
struct Numbers {
    typename TriangleFeatures<Number>::Corners part, environment;  ///< relative to a common point
};

/// A pair in double-double numbers, in a unit of about the pair's size, so that products neither overflow nor
/// vanish.
class Balls {
  public:
    Balls(const PairQuery& query, const TrianglesAt& triangles) : query_(query) {
        const Corners moved = movedCorners(query, triangles.part),
                      fixed = fixedCorners(query, triangles.environment);
        double size = 0;
        for (const Corners* triangle : {&moved, &fixed}) {
            for (const Vector3& corner : triangle->p) {
                size = std::max(size, (corner - fixed.p[0]).cwiseAbs().maxCoeff());
            }
        }
        const int exponent = size > 0 ? std::clamp(std::ilogb(size), -400, 400) : 0;
        unit_ = std::ldexp(1.0, exponent);
        perUnit_ = std::ldexp(1.0, -exponent);
        const std::array<Vector3, 3> part = query.part->corners(triangles.part),
                                     environment = query.environment->corners(triangles.environment);
        const Triple<Ball> base = scaled(environment[0]);
        for (std::size_t k = 0; k < 3; ++k) {
            corners_.part[k] = moved_(part[k]) - base;
            corners_.environment[k] = scaled(environment[k]) - base;
        }
    }

    const Numbers<Ball>& corners() const { return corners_; }
    /// Converts environment units to this unit.
    Ball scaled(double x) const {
        const double y = x * query_.perMeshUnit * perUnit_;
        // The scaling is exact unless it underflows.
        return {y, 0, x == 0 || std::abs(y) >= 0x1p-500 ? 0 : 0x1p-600};
    }
    LengthBounds rootBounds(const Ball& numerator, const Ball& denominator) const {
        const LengthBounds bounds = clearway::rootBounds(numerator, denominator);
        return {bounds.lower * unit_, bounds.upper * unit_};
    }

    /// A lower bound of the distance from the slabs across a direction, query units; 0 at worst.
    double provedAlong(const Vector3& direction) const {
        constexpr double kNoGap = std::numeric_limits<double>::infinity();
        const Triple<Ball> v = {direction[0], direction[1], direction[2]};
        Ball alongPart[3], alongEnvironment[3];
        for (int k = 0; k < 3; ++k) {
            alongPart[k] = corners_.part[k].dot(v);
            alongEnvironment[k] = corners_.environment[k].dot(v);
        }
        double ahead = kNoGap,
               behind = kNoGap;  // gaps with the environment ahead of or behind the part
        for (const Ball& onPart : alongPart) {
            for (const Ball& onEnvironment : alongEnvironment) {
                const Ball difference = onEnvironment - onPart;
                ahead = std::min(ahead, leastOf(difference));
                behind = std::min(behind, -mostOf(difference));
            }
        }
        const double gap = std::max(ahead, behind) / direction.norm() * unit_ * (1 - 0x1p-49);
        return gap > 0 && gap < kNoGap ? gap : 0;
    }

  private:
    Triple<Ball> scaled(const Vector3& v) const { return {scaled(v[0]), scaled(v[1]), scaled(v[2])}; }

    Triple<Ball> moved_(const Vector3& vertex) const {
        const Triple<Ball> v = scaled(vertex);
        const auto row = [&](int i) {
            const double* R = query_.R + 3 * i;
            return Ball(R[0]) * v.x + Ball(R[1]) * v.y + Ball(R[2]) * v.z + scaled(query_.t[i]);
        };
        return {row(0), row(1), row(2)};
    }

    const PairQuery& query_;
    double unit_, perUnit_;  ///< this unit in query units, and its inverse
    Numbers<Ball> corners_;
};

/// A pair in integers, in a power-of-two unit of which all coordinates are whole multiples.
class Integers {
  public:
    /// d: a length that must be a whole multiple too, environment units.
    Integers(const PairQuery& query, const TrianglesAt& triangles, double d) : query_(query) {
        const std::array<Vector3, 3> part = query.part->corners(triangles.part),
                                     environment = query.environment->corners(triangles.environment);
        Pose X_environmentPart;
        for (int row = 0; row < 3; ++row) {
            for (int column = 0; column < 3; ++column) {
                X_environmentPart.rotation(row, column) = query.R[3 * row + column];
            }
            X_environmentPart.translation[row] = query.t[row];
        }
        exponent_ = lastBitOf({}, environment[0]);
        if (d != 0) exponent_ = std::min(exponent_, lastBitOf(d));
        for (std::size_t k = 0; k < 3; ++k) {
            exponent_ =
                std::min({exponent_, lastBitOf({}, environment[k]), lastBitOf(X_environmentPart, part[k])});
        }
        const Triple<Integer> base = scaled(environment[0]);
        for (std::size_t k = 0; k < 3; ++k) {
            corners_.part[k] = movedInteger(X_environmentPart, part[k], exponent_) - base;
            corners_.environment[k] = scaled(environment[k]) - base;
        }
    }

    const Numbers<Integer>& corners() const { return corners_; }
    Integer scaled(double x) const { return scaledInteger(x, exponent_); }
    LengthBounds rootBounds(const Integer& numerator, const Integer& denominator) const {
        return clearway::rootBounds(numerator, denominator, exponent_ - query_.unitExponent);
    }

  private:
    Triple<Integer> scaled(const Vector3& v) const { return {scaled(v[0]), scaled(v[1]), scaled(v[2])}; }

    const PairQuery& query_;
    int exponent_;
    Numbers<Integer> corners_;
};

/// A visitor of TriangleFeatures that decides whether any pair of features is within a distance.
template <class Number>
class AnyWithin {
  public:
    explicit AnyWithin(const Number& d) : dSquared_(d * d) {}

    bool wants(const Number& numerator, const Number& denominator) {
        near_ = isNotNegative(dSquared_ * denominator - numerator);
        return near_ != Verdict::no;
    }
    template <class Place>
    void take(Verdict feasible, std::int32_t /*feature*/, const Place& /*onPart*/,
              const Place& /*onEnvironment*/) {
        const Verdict within = both(near_, feasible);
        if (within != Verdict::no && answer_ != Verdict::yes) answer_ = within;
    }
    bool done() const { return answer_ == Verdict::yes; }
    Verdict answer() const { return answer_; }

  private:
    Number dSquared_;
    Verdict near_ = Verdict::open;
    Verdict answer_ = Verdict::no;
};

/// A visitor of TriangleFeatures that finds the least distance, query units.
template <class Arithmetic>
class Least {
  public:
    explicit Least(const Arithmetic& arithmetic) : arithmetic_(arithmetic) {}

    template <class Number>
    bool wants(const Number& numerator, const Number& denominator) {
        bounds_ = arithmetic_.rootBounds(numerator, denominator);
        return !(bounds_.lower >= upper);
    }
    template <class Place>
    void take(Verdict feasible, std::int32_t newFeature, const Place& newOnPart,
              const Place& newOnEnvironment) {
        if (feasible == Verdict::no) return;
        lower = std::min(lower, bounds_.lower);
        if (feasible != Verdict::yes || !(bounds_.upper < upper)) return;
        upper = bounds_.upper;
        feature = newFeature;
        onPart = rounded(newOnPart);
        onEnvironment = rounded(newOnEnvironment);
    }
    bool done() const { return upper == 0; }
    Verdict contact() const { return upper == 0 ? Verdict::yes : lower > 0 ? Verdict::no : Verdict::open; }

    double lower = std::numeric_limits<double>::infinity();
    double upper = std::numeric_limits<double>::infinity();
    std::int32_t feature = kNoFeature;
    PlaceInTriangle onPart, onEnvironment;

  private:
    template <class Place>
    static PlaceInTriangle rounded(const Place& place) {
        // The quotients are rounded; clamping keeps the place on the triangle.
        const double s = std::min(std::max(0.0, quotient(place.s, place.whole)), 1.0),
                     t = std::min(std::max(0.0, quotient(place.t, place.whole)), 1 - s);
        return {place.corner, s, t};
    }

    const Arithmetic& arithmetic_;
    LengthBounds bounds_{0, 0};
};

/// Resolves a pair with the given numbers.
template <class Arithmetic>
ResolvedPair resolvedWith(const Arithmetic& arithmetic, const PairQuery& query,
                          const TrianglesAt& triangles) {
    Least<Arithmetic> least(arithmetic);
    TriangleFeatures(arithmetic.corners().part, arithmetic.corners().environment).visit(least);
    ResolvedPair resolved;
    resolved.contact = least.contact();
    resolved.feature = least.feature;
    resolved.pointOnPart = pointAt(least.onPart, movedCorners(query, triangles.part));
    resolved.pointOnEnvironment = pointAt(least.onEnvironment, fixedCorners(query, triangles.environment));
    if (resolved.contact != Verdict::yes) {
        resolved.lower = least.lower;
        resolved.upper =
            upperBoundFrom(resolved.pointOnPart, resolved.pointOnEnvironment, query.largestCoordinate);
    }
    return resolved;
}

/// For a pair in contact: whether the middle between the two points is within 16 u64 M of both triangles.
/// Each point is off its own triangle by up to 5.4 u64 M.
bool isOnePoint(const ResolvedPair& pair, double M) {
    return lengthBetween(pair.pointOnPart, pair.pointOnEnvironment) <= 20 * kUnitRoundoffDouble * M;
}

/// Whether contact is decided and the answer as accurate as wanted.
bool isSettled(const ResolvedPair& pair, const WantedWidth& wanted, double M) {
    if (pair.contact == Verdict::open) return false;
    return pair.contact == Verdict::yes ? isOnePoint(pair, M) : wanted.isMetBy(pair);
}

template <class Arithmetic>
Verdict isWithin(const Arithmetic& arithmetic, double d) {
    AnyWithin visitor(arithmetic.scaled(d));
    TriangleFeatures(arithmetic.corners().part, arithmetic.corners().environment).visit(visitor);
    return visitor.answer();
}

}  // namespace

ResolvedPair settlePair(const PairQuery& query, const TrianglesAt& triangles, const WantedWidth& wanted,
                        QueryCounters& counters) {
    const double M = query.largestCoordinate;
    ++counters.refinedPairs;
    ResolvedPair pair = resolvePair(query, triangles);
    if (!isSettled(pair, wanted, M)) {
        ++counters.doubleDoublePairs;
        const Balls balls(query, triangles);
        if (pair.contact != Verdict::yes) {
            pair.lower = std::max(pair.lower, balls.provedAlong(pair.apartAlong));
            if (pair.lower > 0) pair.contact = Verdict::no;
        }
        if (!isSettled(pair, wanted, M)) pair = resolvedWith(balls, query, triangles);
    }
    if (!isSettled(pair, wanted, M)) {
        ++counters.exactPairs;
        pair = resolvedWith(Integers(query, triangles, 0), query, triangles);
        if (pair.contact == Verdict::open)
            pair.contact = Verdict::no;  // they are apart by less than the least double
    }
    if (pair.contact == Verdict::yes) {
        pair.pointOnPart = pair.pointOnEnvironment = 0.5 * (pair.pointOnPart + pair.pointOnEnvironment);
        pair.feature = kNoFeature;
    }
    return pair;
}

namespace {

/// Decides a pair that double arithmetic leaves open. apartAlong: a direction that may separate the pair.
PairWithin isWithinBeyondDouble(const PairQuery& query, const TrianglesAt& triangles, double d,
                                const Vector3& apartAlong, std::int32_t feature, QueryCounters& counters) {
    ++counters.doubleDoublePairs;
    const Balls balls(query, triangles);
    if (balls.provedAlong(apartAlong) > d * query.perMeshUnit) return {false, feature};
    const Verdict within = isWithin(balls, d);
    if (within != Verdict::open) return {within == Verdict::yes, feature};
    ++counters.exactPairs;
    return {isWithin(Integers(query, triangles, d), d) == Verdict::yes, feature};
}

}  // namespace

PairWithin isPairWithin(const PairQuery& query, const TrianglesAt& triangles, double d,
                        QueryCounters& counters) {
    ++counters.refinedPairs;
    if (d == 0) {
        const ContactInDouble pair = contactOf(query, triangles);
        if (pair.contact != Verdict::open) return {pair.contact == Verdict::yes, triangles.feature};
        return isWithinBeyondDouble(query, triangles, d, pair.apartAlong, triangles.feature, counters);
    }
    const ResolvedPair pair = resolvePair(query, triangles);
    // Converting d to query units rounds only below 2^-1022 and above the largest double, where no bound
    // lies.
    const double dInQueryUnits = d * query.perMeshUnit;
    if (pair.lower > dInQueryUnits) return {false, pair.feature};
    if (pair.contact == Verdict::yes || pair.upper <= dInQueryUnits) return {true, pair.feature};
    return isWithinBeyondDouble(query, triangles, d, pair.apartAlong, pair.feature, counters);
}

}  // namespace clearway
