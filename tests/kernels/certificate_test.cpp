// A direction proves no more than is true, whatever the direction and on any instruction set, and finds most
// pairs that are clearly apart.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "kernels/framed_pairs.h"
#include "support/each_target.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/certificate_test.cpp"
#include "hwy/foreach_target.h"  // must come before highway.h and the kernels

#include "hwy/highway.h"
#include "kernels/certificate-inl.h"
#include "kernels/triangle_lanes-inl.h"

#ifndef CLEARWAY_TESTS_WALKS
#define CLEARWAY_TESTS_WALKS
namespace clearway::testing {

/// Walks to make, and which of them proved their pair apart.
struct Walks {
    TriangleRows<float> rows;
    std::vector<float> start;  ///< coordinate c of pair i at c * rows.pairs + i
    std::vector<float> needSquared;
    std::vector<bool> proved;
};

}  // namespace clearway::testing
#endif

HWY_BEFORE_NAMESPACE();
namespace clearway {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

template <int kSteps>
void walk(testing::Walks& walks) {
    const WideTag d;
    const std::size_t pairs = walks.rows.pairs;
    walks.proved.clear();
    for (std::size_t i = 0; i < pairs; i += hn::Lanes(d)) {
        AppendLanes(WalkProvesApart<kSteps>(d, LoadTriangles(d, walks.rows.a, pairs, i),
                                            LoadTriangles(d, walks.rows.b, pairs, i),
                                            LoadPoints(d, walks.start.data(), pairs, i),
                                            hn::LoadU(d, walks.needSquared.data() + i)),
                    walks.proved);
    }
}

void walk0(testing::Walks& walks) {
    walk<0>(walks);
}
void walk1(testing::Walks& walks) {
    walk<1>(walks);
}
void walk3(testing::Walks& walks) {
    walk<3>(walks);
}

}  // namespace HWY_NAMESPACE
}  // namespace clearway
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace clearway {

HWY_EXPORT(walk0);
HWY_EXPORT(walk1);
HWY_EXPORT(walk3);

namespace testing {
namespace {

constexpr std::uint64_t kSeed = 89;
constexpr double kU = 0x1p-24;
constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

/// Rounding of a slab's width over |direction|, first order, in u of the pair's size: either end 3, the
/// difference 1. What the squares round by is in NeedSquared.
constexpr double kWidthRoundoffs = 4;

/// Sets the program's own dispatch, which is beside the library's, to the target in use.
void useChosenTarget() {
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
}

void makeWalks(Walks& walks, int steps) {
    useChosenTarget();
    if (steps == 0) return HWY_DYNAMIC_DISPATCH(walk0)(walks);
    if (steps == 1) return HWY_DYNAMIC_DISPATCH(walk1)(walks);
    HWY_DYNAMIC_DISPATCH(walk3)(walks);
}

const std::vector<FramedPair<float>>& pairs() {
    static const std::vector<FramedPair<float>> made = framedPairs<float>(kSeed, 300);
    return made;
}

enum class Start { cornerToCorner, between, random, zero, notANumber };

LongVector startOf(Start start, const FramedPair<float>& pair, Random& random) {
    switch (start) {
        case Start::cornerToCorner:
            return pair.b[0] - pair.a[0];
        case Start::between:  // the direction that proves best
            return pair.truth.pointOnB - pair.truth.pointOnA;
        case Start::random:
            return (random.direction() * std::pow(10.0, random.uniform(-6, 1))).cast<long double>();
        case Start::zero:
            return LongVector::Zero();
        case Start::notANumber:
            break;
    }
    return LongVector(kNaN, 0, 1);
}

/// One walk a pair, for the distance that `apartOf` names.
template <class ApartOf>
Walks walksFrom(Start start, const ApartOf& apartOf) {
    Random random(kSeed);
    Walks walks;
    walks.rows = rowsOf(pairs());
    walks.start.resize(3 * walks.rows.pairs);
    for (std::size_t i = 0; i < walks.rows.pairs; ++i) {
        const FramedPair<float>& pair = pairs()[i < pairs().size() ? i : 0];
        const LongVector from = startOf(start, pair, random);
        for (std::size_t c = 0; c < 3; ++c) {
            walks.start[c * walks.rows.pairs + i] = static_cast<float>(from[Eigen::Index(c)]);
        }
        walks.needSquared.push_back(HWY_STATIC_DISPATCH(NeedSquared)(apartOf(pair)));
    }
    return walks;
}

/// A share of the distance, above the 1e-7 that NeedSquared asks for.
float shareOf(const FramedPair<float>& pair, double share) {
    return std::max(static_cast<float>(static_cast<double>(pair.truth.distance) * share), 2e-7f);
}

}  // namespace

BOOST_AUTO_TEST_SUITE(certificate_test)

BOOST_DATA_TEST_CASE(what_a_walk_proves_is_true_but_for_the_width_of_slabs, eachTarget(), target) {
    const UsingTarget using_(target);
    long proofs = 0;
    for (const double share : {0.3, 0.99, 1 - 1e-6, 1.0, 1 + 1e-6, 1 + 1e-5, 1.001, 1.5}) {
        const auto apartOf = [&](const FramedPair<float>& pair) { return shareOf(pair, share); };
        for (const Start start : {Start::cornerToCorner, Start::between, Start::random}) {
            Walks walks = walksFrom(start, apartOf);
            for (const int steps : {0, 1, 3}) {
                makeWalks(walks, steps);
                for (std::size_t i = 0; i < pairs().size(); ++i) {
                    if (!walks.proved[i]) continue;
                    const FramedPair<float>& pair = pairs()[i];
                    ++proofs;
                    BOOST_TEST(apartOf(pair) - kWidthRoundoffs * kU * pair.size <= pair.truth.distance,
                               pair.family << ", seed " << kSeed << ", pair " << i << ", share " << share);
                }
            }
        }
    }
    BOOST_TEST(proofs > 10000);
}

BOOST_DATA_TEST_CASE(directions_of_no_length_and_no_number_prove_nothing, eachTarget(), target) {
    const UsingTarget using_(target);
    for (const Start start : {Start::zero, Start::notANumber}) {
        Walks walks = walksFrom(start, [](const FramedPair<float>&) { return 2e-7f; });
        for (const int steps : {0, 1, 3}) {
            makeWalks(walks, steps);
            for (const bool proved : walks.proved) BOOST_TEST(!proved);
        }
    }
}

BOOST_DATA_TEST_CASE(triangles_of_no_number_are_not_proved_apart, eachTarget(), target) {
    const UsingTarget using_(target);
    Walks walks = walksFrom(Start::cornerToCorner, [](const FramedPair<float>&) { return 2e-7f; });
    for (float& x : walks.rows.a) x = kNaN;
    for (const int steps : {0, 1, 3}) {
        makeWalks(walks, steps);
        for (const bool proved : walks.proved) BOOST_TEST(!proved);
    }
}

BOOST_DATA_TEST_CASE(pairs_clearly_apart_are_proved_within_few_steps, eachTarget(), target) {
    const UsingTarget using_(target);
    const auto apartOf = [](const FramedPair<float>& pair) { return shareOf(pair, 0.5); };
    Walks walks = walksFrom(Start::cornerToCorner, apartOf);
    double shares[4] = {};
    for (const int steps : {0, 1, 3}) {
        makeWalks(walks, steps);
        int all = 0, proved = 0;
        for (std::size_t i = 0; i < pairs().size(); ++i) {
            if (pairs()[i].truth.distance < 0.25L * pairs()[i].size) continue;
            ++all;
            proved += walks.proved[i];
        }
        BOOST_TEST(all > 200);
        shares[steps] = static_cast<double>(proved) / all;
    }
    BOOST_TEST(shares[1] >= 0.9);
    BOOST_TEST(shares[3] >= 0.99);
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace testing
}  // namespace clearway

#endif  // HWY_ONCE
