// No lower bound between two volumes exceeds their distance, which long double computes from the stored
// rectangles: nearly parallel, crossing, coplanar, without width and far away, on any instruction set.
#include <algorithm>
#include <array>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include "kernels/stored_volumes.h"
#include "query/pair_query.h"
#include "query/queries.h"
#include "support/each_target.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/stored_volumes_test.cpp"
#include "hwy/foreach_target.h"  // must come before highway.h and the kernels

#include "hwy/highway.h"
#include "query/traverse-inl.h"

HWY_BEFORE_NAMESPACE();
namespace clearway {
namespace HWY_NAMESPACE {

/// Bounds from lane 0 of the carried node to all lanes of the other node; returns the near lanes.
std::uint32_t boundsToLanes2(const WideNode<2>& carried, const WideNode<2>& node, const Carry& carry,
                             float dropFrom, float* bounds) {
    return RssLowerBounds(CarryVolume(carry, carried, 0), node, carry.slack, carry.toQueryUnit, dropFrom,
                          bounds)
        .lanes;
}
std::uint32_t boundsToLanes8(const WideNode<8>& carried, const WideNode<8>& node, const Carry& carry,
                             float dropFrom, float* bounds) {
    return RssLowerBounds(CarryVolume(carry, carried, 0), node, carry.slack, carry.toQueryUnit, dropFrom,
                          bounds)
        .lanes;
}

}  // namespace HWY_NAMESPACE
}  // namespace clearway
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace clearway {

HWY_EXPORT(boundsToLanes2);
HWY_EXPORT(boundsToLanes8);

namespace testing {
namespace {

constexpr std::uint64_t kSeed = 97;

FlatTree emptyTree(const Frame& frame) {
    FlatTree tree;
    tree.origin = frame.origin;
    tree.unitExponent = frame.unitExponent;
    tree.unit = std::ldexp(1.0, frame.unitExponent);
    tree.radius = 1;
    tree.box.extend(frame.origin);
    return tree;
}

const std::vector<VolumeCase>& cases() {
    static const std::vector<VolumeCase> made = makeVolumeCases(kSeed);
    return made;
}

template <int kWidth>
void setLane(WideNode<kWidth>& node, int lane, const StoredRss& rss) {
    for (int k = 0; k < 3; ++k) {
        node.centre[k][lane] = rss.centre[k];
        node.axis0[k][lane] = rss.axis0[k];
        node.axis1[k][lane] = rss.axis1[k];
    }
    node.halfLength0[lane] = rss.halfLength0;
    node.halfLength1[lane] = rss.halfLength1;
    node.radius[lane] = rss.radius;
    node.size[lane] = rss.longest();
    node.child[lane] = ~lane;
}

struct FoundBound {
    bool near;
    float bound;  ///< query units
};

template <int kWidth, class Function>
std::vector<FoundBound> boundsBy(const Function& boundsToLanes, const StoredRss& one,
                                 const std::vector<StoredRss>& lanes, const Carry& carry, float dropFrom) {
    std::vector<FoundBound> found;
    for (std::size_t first = 0; first < lanes.size(); first += kWidth) {
        WideNode<kWidth> carried{}, node{};
        setLane(carried, 0, one);
        for (int lane = 0; lane < kWidth; ++lane) setLane(node, lane, lanes[first + std::size_t(lane)]);
        alignas(64) float bounds[kWidth];
        const std::uint32_t near = boundsToLanes(carried, node, carry, dropFrom, bounds);
        for (int lane = 0; lane < kWidth; ++lane) found.push_back({(near >> lane & 1) != 0, bounds[lane]});
    }
    return found;
}

std::vector<FoundBound> boundsOfWidth(int width, const StoredRss& one, const std::vector<StoredRss>& lanes,
                                      const Carry& carry, float dropFrom) {
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());  // this program's own dispatch
    return width == 2 ? boundsBy<2>(HWY_DYNAMIC_DISPATCH(boundsToLanes2), one, lanes, carry, dropFrom)
                      : boundsBy<8>(HWY_DYNAMIC_DISPATCH(boundsToLanes8), one, lanes, carry, dropFrom);
}

PairQuery queryOf(const VolumeCase& volumes) {
    static FlatTree part, environment;  // static, because the query points at them
    part = emptyTree(volumes.partFrame);
    environment = emptyTree(volumes.environmentFrame);
    return preparePairQuery(part, environment, volumes.pose);
}

/// Bounds from the part's volume, carried, to the children; then from each child, carried, to a node that
/// holds the part's volume. Mesh units.
std::vector<std::array<long double, 2>> boundsBothWays(const VolumeCase& volumes, const PairQuery& query,
                                                       int width) {
    const long double unit = std::ldexp(1.0L, query.unitExponent);
    const float all = std::numeric_limits<float>::max();
    std::vector<std::array<long double, 2>> bounds;
    const auto there = boundsOfWidth(width, volumes.part, volumes.children, query.partToEnvironment, all);
    const std::vector<StoredRss> alone(8, volumes.part);
    for (std::size_t lane = 0; lane < there.size(); ++lane) {
        const auto back = boundsOfWidth(width, volumes.children[lane], alone, query.environmentToPart, all);
        bounds.push_back({there[lane].bound * unit, back[0].bound * unit});
    }
    return bounds;
}

/// |t| + both trees' radii, mesh units: the length that kVolumeSlack is a multiple of.
long double rangeOf(const VolumeCase& volumes) {
    const Vector3 between = volumes.pose * volumes.partFrame.origin - volumes.environmentFrame.origin;
    return between.norm() + std::ldexp(1.0, volumes.partFrame.unitExponent) +
           std::ldexp(1.0, volumes.environmentFrame.unitExponent);
}

}  // namespace

BOOST_AUTO_TEST_SUITE(stored_volumes_test)

BOOST_AUTO_TEST_CASE(the_cases_hold_volumes_apart_and_overlapping) {
    int apart = 0, overlapping = 0, close = 0;
    for (const VolumeCase& volumes : cases()) {
        for (std::size_t lane = 0; lane < 8; ++lane) {
            const long double distance = volumes.distances[lane], size = sizeOf(volumes, lane);
            ++(distance <= 0 ? overlapping : distance < 1e-3L * size ? close : apart);
        }
    }
    BOOST_TEST(apart > 10000);
    BOOST_TEST(overlapping > 2000);
    BOOST_TEST(close > 1000);
}

BOOST_DATA_TEST_CASE(no_bound_exceeds_the_distance_of_the_volumes_as_stored, eachTarget() * eachWidth(),
                     target, width) {
    const UsingTarget using_(target);
    for (std::size_t i = 0; i < cases().size(); ++i) {
        const VolumeCase& volumes = cases()[i];
        const auto bounds = boundsBothWays(volumes, queryOf(volumes), width);
        for (std::size_t lane = 0; lane < 8; ++lane) {
            for (const long double bound : bounds[lane]) {
                BOOST_TEST(bound <= volumes.distances[lane],
                           volumes.kind << ", seed " << kSeed << ", case " << i << ", lane " << lane);
            }
        }
    }
}

BOOST_DATA_TEST_CASE(rounding_takes_less_than_a_quarter_of_its_slack, eachTarget() * eachWidth(), target,
                     width) {
    const UsingTarget using_(target);
    std::map<std::string, long double> worst;  // in u32 of the reach, by kind
    for (const VolumeCase& volumes : cases()) {
        if (volumes.kind == "far from the origin") continue;  // most of the slack there is the offset's
        PairQuery query = queryOf(volumes);
        query.partToEnvironment.slack = query.environmentToPart.slack = 0;
        const auto bounds = boundsBothWays(volumes, query, width);
        long double& most = worst[volumes.kind];
        for (std::size_t lane = 0; lane < 8; ++lane) {
            for (const long double bound : bounds[lane]) {
                most = std::max(most,
                                (bound - volumes.distances[lane]) / (kUnitRoundoffFloat * rangeOf(volumes)));
            }
        }
    }
    for (const auto& [kind, most] : worst) {
        BOOST_TEST_MESSAGE(kind << ", seed " << kSeed << ": " << most << " of " << kVolumeSlack << " u");
        BOOST_TEST(most <= 0.25L * kVolumeSlack, kind << ", seed " << kSeed);
    }
}

BOOST_DATA_TEST_CASE(what_is_not_near_is_at_least_as_far_as_asked, eachTarget() * eachWidth(), target,
                     width) {
    const UsingTarget using_(target);
    int dropped = 0;
    for (std::size_t i = 0; i < cases().size(); ++i) {
        const VolumeCase& volumes = cases()[i];
        const PairQuery query = queryOf(volumes);
        for (const long double distance : volumes.distances) {
            const float dropFrom = nextFloatAbove(static_cast<double>(distance) * query.perMeshUnit);
            const auto found =
                boundsOfWidth(width, volumes.part, volumes.children, query.partToEnvironment, dropFrom);
            for (std::size_t lane = 0; lane < found.size(); ++lane) {
                if (found[lane].near) {
                    BOOST_TEST(found[lane].bound < dropFrom);
                    continue;
                }
                ++dropped;
                BOOST_TEST(volumes.distances[lane] * query.perMeshUnit >= dropFrom,
                           volumes.kind << ", seed " << kSeed << ", case " << i << ", lane " << lane);
            }
        }
    }
    BOOST_TEST(dropped > 50000);
}

BOOST_DATA_TEST_CASE(bounds_of_volumes_apart_are_of_use, eachTarget() * eachWidth(), target, width) {
    const UsingTarget using_(target);
    // The narrow node's bound is the rectangles' distance up to rounding, the wide node's bound a share of
    // that distance.
    const long double share = width == 2 ? 0.99L : 0.5L;
    int apart = 0, useful = 0;
    for (const VolumeCase& volumes : cases()) {
        if (volumes.kind == "far from the origin") continue;  // the slack there is wide
        const auto bounds = boundsBothWays(volumes, queryOf(volumes), width);
        for (std::size_t lane = 0; lane < 8; ++lane) {
            if (volumes.distances[lane] <= sizeOf(volumes, lane)) continue;
            for (const long double bound : bounds[lane]) {
                ++apart;
                useful += bound >= share * volumes.distances[lane];
            }
        }
    }
    BOOST_TEST(apart > 5000);
    BOOST_TEST(useful > 0.99 * apart);
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace testing
}  // namespace clearway

#endif  // HWY_ONCE
