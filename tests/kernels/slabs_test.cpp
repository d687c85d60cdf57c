// Slabs across a direction are judged by their width over its length, never by what overflows or vanishes,
// and go through the extreme corners; on any instruction set.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <vector>

#include "kernels/framed_pairs.h"
#include "support/each_target.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/slabs_test.cpp"
#include "hwy/foreach_target.h"  // must come before highway.h and the kernels

#include "hwy/highway.h"
#include "kernels/certificate-inl.h"
#include "kernels/triangle_lanes-inl.h"

#ifndef CLEARWAY_TESTS_SLABS
#define CLEARWAY_TESTS_SLABS
namespace clearway::testing {

/// Slabs to judge.
struct Slabs {
    std::vector<float> width, lengthSquared, needSquared;  ///< a multiple of kVectorPairs
    std::vector<bool> proved;
};

}  // namespace clearway::testing
#endif

HWY_BEFORE_NAMESPACE();
namespace clearway {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

void judge(testing::Slabs& slabs) {
    const WideTag d;
    slabs.proved.clear();
    for (std::size_t i = 0; i < slabs.width.size(); i += hn::Lanes(d)) {
        AppendLanes(
            ProvesApart(d, hn::LoadU(d, slabs.width.data() + i), hn::LoadU(d, slabs.lengthSquared.data() + i),
                        hn::LoadU(d, slabs.needSquared.data() + i)),
            slabs.proved);
    }
}

/// out: rows x, y, z of the extreme corners of the first triangles, and their place along the direction.
template <bool kNearest>
void support(const testing::TriangleRows<float>& rows, const std::vector<float>& directions,
             std::vector<float>& out) {
    const WideTag d;
    using V = hn::Vec<WideTag>;
    const std::size_t pairs = rows.pairs;
    out.resize(4 * pairs);
    for (std::size_t i = 0; i < pairs; i += hn::Lanes(d)) {
        const SupportCorner<V> found =
            Support<kNearest>(LoadPoints(d, directions.data(), pairs, i), LoadTriangles(d, rows.a, pairs, i));
        hn::StoreU(found.corner.x, d, out.data() + i);
        hn::StoreU(found.corner.y, d, out.data() + pairs + i);
        hn::StoreU(found.corner.z, d, out.data() + 2 * pairs + i);
        hn::StoreU(found.along, d, out.data() + 3 * pairs + i);
    }
}

void farthest(const testing::TriangleRows<float>& rows, const std::vector<float>& directions,
              std::vector<float>& out) {
    support<false>(rows, directions, out);
}
void nearest(const testing::TriangleRows<float>& rows, const std::vector<float>& directions,
             std::vector<float>& out) {
    support<true>(rows, directions, out);
}

}  // namespace HWY_NAMESPACE
}  // namespace clearway
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace clearway {

HWY_EXPORT(judge);
HWY_EXPORT(farthest);
HWY_EXPORT(nearest);

namespace testing {
namespace {

constexpr std::uint64_t kSeed = 101;
constexpr double kU = 0x1p-24;
constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

/// Sets the program's own dispatch, which is beside the library's, to the target in use.
void useChosenTarget() {
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
}

}  // namespace

BOOST_AUTO_TEST_SUITE(slabs_test)

BOOST_DATA_TEST_CASE(slabs_are_judged_by_their_width_across_the_direction, eachTarget(), target) {
    const UsingTarget using_(target);
    Random random(kSeed);
    Slabs slabs;
    std::vector<float> apart;
    for (int i = 0; i < 64 * 1024; ++i) {
        const double length = std::ldexp(random.uniform(1, 2), random.below(50) - 30);
        apart.push_back(static_cast<float>(std::ldexp(random.uniform(1, 2), random.below(60) - 22)));
        const double ratio = 1 + random.uniform(-1, 1) * std::pow(10.0, -random.below(8));
        slabs.lengthSquared.push_back(static_cast<float>(length * length));
        slabs.width.push_back(
            static_cast<float>(apart.back() * std::sqrt(double(slabs.lengthSquared.back())) * ratio));
        slabs.needSquared.push_back(HWY_STATIC_DISPATCH(NeedSquared)(apart.back()));
    }
    useChosenTarget();
    HWY_DYNAMIC_DISPATCH(judge)(slabs);
    int proofs = 0;
    for (std::size_t i = 0; i < apart.size(); ++i) {
        const long double need = apart[i] * std::sqrt(static_cast<long double>(slabs.lengthSquared[i]));
        // Three of the roundings NeedSquared allows for are in the square of the direction's length, exact
        // here.
        proofs += slabs.proved[i];
        if (slabs.proved[i]) BOOST_TEST(slabs.width[i] >= need * (1 + kU));
        if (slabs.width[i] >= need * (1 + 8 * kU)) BOOST_TEST(slabs.proved[i]);
    }
    BOOST_TEST(proofs > 10000);
}

BOOST_DATA_TEST_CASE(slabs_that_overflow_vanish_or_are_no_numbers_prove_nothing, eachTarget(), target) {
    const UsingTarget using_(target);
    Slabs slabs;
    const auto add = [&](float width, float lengthSquared, float needSquared) {
        slabs.width.push_back(width);
        slabs.lengthSquared.push_back(lengthSquared);
        slabs.needSquared.push_back(needSquared);
    };
    const float needSquared = HWY_STATIC_DISPATCH(NeedSquared)(2e-7f);
    add(-1, 1, needSquared);  // overlapping slabs
    add(0, 0, needSquared);   // no direction
    add(1, 0, needSquared);
    add(1e-20f, 1e-23f, needSquared);  // too short
    add(1, kNaN, needSquared);
    add(kNaN, 1, needSquared);
    add(1, 1, kNaN);
    add(1e20f, 1, kInfinity);
    add(kInfinity, 1, kInfinity);
    add(1e20f, 1e38f, 1e38f);  // both squares overflow, and 1e20 over 1e19 is not 1e19
    add(kInfinity, kInfinity, needSquared);
    while (slabs.width.size() % kVectorPairs != 0) add(0, 1, needSquared);
    useChosenTarget();
    HWY_DYNAMIC_DISPATCH(judge)(slabs);
    for (std::size_t i = 0; i < slabs.proved.size(); ++i) BOOST_TEST(!slabs.proved[i], "slab " << i);
}

BOOST_DATA_TEST_CASE(supports_are_the_extreme_corners, eachTarget(), target) {
    const UsingTarget using_(target);
    const std::vector<FramedPair<float>> pairs = framedPairs<float>(kSeed, 60);
    const TriangleRows<float> rows = rowsOf(pairs);
    const std::size_t n = rows.pairs;
    Random random(kSeed);
    std::vector<float> directions(3 * n);
    for (float& x : directions) x = static_cast<float>(random.normal());
    for (const bool isNearest : {false, true}) {
        std::vector<float> found;
        useChosenTarget();
        isNearest ? HWY_DYNAMIC_DISPATCH(nearest)(rows, directions, found)
                  : HWY_DYNAMIC_DISPATCH(farthest)(rows, directions, found);
        for (std::size_t i = 0; i < pairs.size(); ++i) {
            const LongTriangle& triangle = pairs[i].a;
            const LongVector v(directions[i], directions[n + i], directions[2 * n + i]);
            const LongVector corner(found[i], found[n + i], found[2 * n + i]);
            const long double rounding = 3 * kU * v.norm() * largestNorm(triangle);
            bool isCorner = false;
            for (const LongVector& other : triangle) {
                isCorner |= other == corner;
                const long double farther = isNearest ? v.dot(corner - other) : v.dot(other - corner);
                BOOST_TEST(farther <= 2 * rounding);
            }
            BOOST_TEST(isCorner);
            BOOST_TEST(std::abs(v.dot(corner) - found[3 * n + i]) <= rounding);
        }
    }
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace testing
}  // namespace clearway

#endif  // HWY_ONCE
