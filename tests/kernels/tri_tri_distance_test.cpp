// The bounds of the triangle kernels hold up to the rounding of sums and products, in float and in double, on
// any instruction set, for triangles of any shape.
#include <boost/test/unit_test.hpp>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include "kernels/framed_pairs.h"
#include "query/refine.h"
#include "support/each_target.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/tri_tri_distance_test.cpp"
#include "hwy/foreach_target.h"  // must come before highway.h and the kernels

#include "hwy/highway.h"
#include "kernels/tri_tri_distance-inl.h"
#include "kernels/triangle_lanes-inl.h"

#ifndef CLEARWAY_TESTS_MEASURED
#define CLEARWAY_TESTS_MEASURED
namespace clearway::testing {

/// The kernels' bounds of each pair.
template <class T>
struct Measured {
    std::vector<T> face, edge, lower, upper, feature;
};

}  // namespace clearway::testing
#endif

HWY_BEFORE_NAMESPACE();
namespace clearway {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

template <class T>
void measure(const testing::TriangleRows<T>& rows, testing::Measured<T>& out) {
    const hn::CappedTag<T, testing::kVectorPairs> d;
    using V = hn::Vec<decltype(d)>;
    for (std::vector<T>* of : {&out.face, &out.edge, &out.lower, &out.upper, &out.feature})
        of->resize(rows.pairs);
    for (std::size_t i = 0; i < rows.pairs; i += hn::Lanes(d)) {
        const TrianglePair<V> pair(LoadTriangles(d, rows.a, rows.pairs, i),
                                   LoadTriangles(d, rows.b, rows.pairs, i));
        const V none = hn::Set(d, -hwy::HighestValue<T>());
        const TriangleBounds<V> bounds = TriangleDistance(d, pair, none);
        hn::StoreU(FaceSeparation(d, pair), d, out.face.data() + i);
        hn::StoreU(EdgeSeparation(d, pair), d, out.edge.data() + i);
        hn::StoreU(bounds.lower, d, out.lower.data() + i);
        hn::StoreU(bounds.upper, d, out.upper.data() + i);
        hn::StoreU(bounds.feature, d, out.feature.data() + i);
    }
}

void measureFloat(const testing::TriangleRows<float>& rows, testing::Measured<float>& out) {
    measure(rows, out);
}
void measureDouble(const testing::TriangleRows<double>& rows, testing::Measured<double>& out) {
    measure(rows, out);
}

}  // namespace HWY_NAMESPACE
}  // namespace clearway
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace clearway {

HWY_EXPORT(measureFloat);
HWY_EXPORT(measureDouble);

namespace testing {
namespace {

constexpr std::uint64_t kSeed = 83;

/// Rounding of a slab gap, first order, in u of the size: the products along the direction 3, their
/// difference 1, the direction's length, its root and the division 3.5.
constexpr double kGapRoundoffs = 8;

/// Rounding of a difference of two points, first order, in u of the size: corners' difference 1, edges 2,
/// their multiples 2, sums 2, a clamped share of a face 1, the length 2.5.
constexpr double kPointRoundoffs = 11;

// Sets the dispatch of this program, which is separate from the library's, to the target in use.
Measured<float> measured(const TriangleRows<float>& rows) {
    Measured<float> out;
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
    HWY_DYNAMIC_DISPATCH(measureFloat)(rows, out);
    return out;
}
Measured<double> measured(const TriangleRows<double>& rows) {
    Measured<double> out;
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
    HWY_DYNAMIC_DISPATCH(measureDouble)(rows, out);
    return out;
}

template <class T>
const std::vector<FramedPair<T>>& pairsOf() {
    static const std::vector<FramedPair<T>> pairs = framedPairs<T>(kSeed, 240);
    return pairs;
}

/// The least distance at a feature, numbered as in query/pair_query.h: between two edges, or a corner and a
/// face.
long double distanceAt(int feature, const LongTriangle& a, const LongTriangle& b) {
    const auto corner = [](const LongTriangle& t, int k) { return LongTriangle{t[k], t[k], t[k]}; };
    const auto edge = [](const LongTriangle& t, int k) {
        return LongTriangle{t[k], t[(k + 1) % 3], t[(k + 1) % 3]};
    };
    if (feature < 9) return triangleDistance(edge(a, feature / 3), edge(b, feature % 3)).distance;
    const int k = (feature - 9) / 2;
    return (feature % 2 == 1 ? triangleDistance(corner(a, k), b) : triangleDistance(a, corner(b, k)))
        .distance;
}

template <class T>
void checkBounds() {
    const std::vector<FramedPair<T>>& pairs = pairsOf<T>();
    const Measured<T> found = measured(rowsOf(pairs));
    const long double u = std::numeric_limits<T>::epsilon() / 2;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        const long double distance = pairs[i].truth.distance;
        const long double gapError = kGapRoundoffs * u * pairs[i].size;
        const long double pointError = kPointRoundoffs * u * pairs[i].size;
        BOOST_TEST_CONTEXT(pairs[i].family << ", seed " << kSeed << ", pair " << i) {
            BOOST_TEST(found.face[i] - gapError <= distance);
            BOOST_TEST(found.edge[i] - gapError <= distance);
            BOOST_TEST(found.lower[i] - gapError <= distance);
            BOOST_TEST(distance <= found.upper[i] + pointError);
            BOOST_TEST(found.feature[i] >= 0);
            BOOST_TEST(found.feature[i] < kFeatures);
            const int feature = static_cast<int>(found.feature[i]);
            BOOST_TEST(distanceAt(feature, pairs[i].a, pairs[i].b) <= found.upper[i] + pointError);
        }
    }
}

/// The pairs of a family, and how many of them got good bounds.
struct Share {
    int good = 0, all = 0;
    void add(bool isGood) {
        ++all;
        good += isGood;
    }
};

/// Pairs that are neither flat nor near nor parallel, for which the bounds must also be tight.
bool isPlain(const std::string& family) {
    return family == "random" || family == "one edge of each along x" || family == "far from the origin";
}

template <class T>
void checkPower() {
    const std::vector<FramedPair<T>>& pairs = pairsOf<T>();
    const Measured<T> found = measured(rowsOf(pairs));
    const long double u = std::numeric_limits<T>::epsilon() / 2;
    Share tight, separated;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        const long double distance = pairs[i].truth.distance, size = pairs[i].size;
        if (!isPlain(pairs[i].family) || distance < 1e-3L * size) continue;
        separated.add(std::max(found.face[i], found.edge[i]) > kGapRoundoffs * u * size);
        if (distance < 0.1L * size) continue;
        const long double both = 1e3L * u * size;
        tight.add(found.upper[i] - distance < both && distance - found.lower[i] < both);
    }
    BOOST_TEST(separated.all > 200);
    BOOST_TEST(separated.good == separated.all);
    BOOST_TEST(tight.all > 100);
    BOOST_TEST(tight.good > 0.98 * tight.all);
}

}  // namespace

BOOST_AUTO_TEST_SUITE(tri_tri_distance_test)

BOOST_DATA_TEST_CASE(float_bounds_hold_the_distance_but_for_rounding, eachTarget(), target) {
    const UsingTarget using_(target);
    checkBounds<float>();
}

BOOST_DATA_TEST_CASE(double_bounds_hold_the_distance_but_for_rounding, eachTarget(), target) {
    const UsingTarget using_(target);
    checkBounds<double>();
}

BOOST_DATA_TEST_CASE(plain_pairs_are_separated_and_their_bounds_are_tight, eachTarget(), target) {
    const UsingTarget using_(target);
    checkPower<float>();
    checkPower<double>();
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace testing
}  // namespace clearway

#endif  // HWY_ONCE
