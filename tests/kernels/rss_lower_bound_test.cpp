// No lower bound between two volumes exceeds the distance of the triangles in them, on any instruction set.
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <vector>

#include "model/model_data.h"
#include "query/pair_query.h"
#include "query/queries.h"
#include "support/each_target.h"
#include "support/query_cases.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/rss_lower_bound_test.cpp"
#include "hwy/foreach_target.h"  // must come before highway.h and the kernels

#include "hwy/highway.h"
#include "query/traverse-inl.h"

HWY_BEFORE_NAMESPACE();
namespace clearway {
namespace HWY_NAMESPACE {

/// Lower bounds, in mesh units, from every volume of `carried` to the children of every node of `tree`:
/// bounds[(volume * nodes + node) * kWidth + lane], where a volume is node * kWidth + lane.
template <int kWidth>
void allBounds(const FlatTree& carried, const FlatTree& tree, const Carry& carry, double toMeshUnit,
               std::vector<double>& bounds) {
    const std::size_t volumes = carried.nodes<kWidth>().size() * kWidth;
    const std::size_t nodes = tree.nodes<kWidth>().size();
    for (std::size_t volume = 0; volume < volumes; ++volume) {
        const Volume<kWidth> one(carried, static_cast<VolumeReference>(volume));
        for (std::size_t node = 0; node < nodes; ++node) {
            alignas(64) float found[kWidth];
            std::fill(found, found + kWidth, std::numeric_limits<float>::infinity());
            RssLowerBounds(CarryVolume(carry, one.node, one.lane), tree.nodes<kWidth>()[node], carry.slack,
                           carry.toQueryUnit, hwy::HighestValue<float>(), found);
            for (const float bound : found) bounds.push_back(bound * toMeshUnit);
        }
    }
}

void allBounds2(const FlatTree& carried, const FlatTree& tree, const Carry& carry, double toMeshUnit,
                std::vector<double>& bounds) {
    allBounds<2>(carried, tree, carry, toMeshUnit, bounds);
}

void allBounds8(const FlatTree& carried, const FlatTree& tree, const Carry& carry, double toMeshUnit,
                std::vector<double>& bounds) {
    allBounds<8>(carried, tree, carry, toMeshUnit, bounds);
}

}  // namespace HWY_NAMESPACE
}  // namespace clearway
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace clearway {

HWY_EXPORT(allBounds2);
HWY_EXPORT(allBounds8);

namespace testing {
namespace {

// Sets the dispatch of this program, which is separate from the library's, to the target in use.
std::vector<double> boundsOf(const FlatTree& carried, const FlatTree& tree, const Carry& carry,
                             double toMeshUnit) {
    std::vector<double> bounds;
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
    if (tree.nodeWidth == 2) {
        HWY_DYNAMIC_DISPATCH(allBounds2)(carried, tree, carry, toMeshUnit, bounds);
    } else {
        HWY_DYNAMIC_DISPATCH(allBounds8)(carried, tree, carry, toMeshUnit, bounds);
    }
    return bounds;
}

template <int kWidth>
void addIds(const FlatTree& tree, std::int32_t child, std::vector<std::uint32_t>& ids) {
    if (child == kNoChild) return;
    if (child < 0) {
        const Leaf leaf = tree.leaf(LeafReference(~child));
        for (std::uint32_t i = 0; i < leaf.triangleCount; ++i) ids.push_back(tree.triangleId({leaf.at, i}));
        return;
    }
    for (const std::int32_t grandchild : tree.nodes<kWidth>()[child].child) {
        addIds<kWidth>(tree, grandchild, ids);
    }
}

// The ids of the triangles in each volume; none for an unused lane.
template <int kWidth>
std::vector<std::vector<std::uint32_t>> idsOfVolumes(const FlatTree& tree) {
    std::vector<std::vector<std::uint32_t>> result;
    const std::size_t nodes = tree.nodes<kWidth>().size();
    for (std::size_t node = 0; node < nodes; ++node) {
        for (const std::int32_t child : tree.nodes<kWidth>()[node].child) {
            addIds<kWidth>(tree, child, result.emplace_back());
        }
    }
    return result;
}

std::vector<std::vector<std::uint32_t>> idsOfVolumes(const FlatTree& tree) {
    return withNodeWidth(tree.nodeWidth, [&](auto width) { return idsOfVolumes<width>(tree); });
}

// Distances of all pairs of triangles, by their ids, one row for each triangle of the part.
std::vector<std::vector<double>> pairDistances(const QueryCase& queryCase, const Pose& pose) {
    std::vector<std::vector<double>> distances;
    for (std::size_t p = 0; p < queryCase.part.triangles.size(); ++p) {
        distances.emplace_back();
        for (std::size_t e = 0; e < queryCase.environment.triangles.size(); ++e) {
            distances.back().push_back(queryCase.oracle->pairDistance(pose, p, e));
        }
    }
    return distances;
}

struct Tightness {
    long pairs = 0;
    long above = 0;  // bounds above the distance: must stay 0
    long half = 0;   // bounds above half of a distance that exceeds the volumes' sizes
    long farApart = 0;
    long unused = 0;  // unused lanes with a bound other than infinity
};

// Compares the bounds with the distances of the volumes' triangles. distanceOf(i, j): distance of the
// triangles with id i in carried and id j in tree.
template <class DistanceOf>
void compare(const std::vector<double>& bounds, const FlatTree& carried, const FlatTree& tree,
             const DistanceOf& distanceOf, Tightness& tightness) {
    const auto ofCarried = idsOfVolumes(carried), ofTree = idsOfVolumes(tree);
    for (std::size_t i = 0; i < ofCarried.size(); ++i) {
        if (ofCarried[i].empty()) continue;
        for (std::size_t j = 0; j < ofTree.size(); ++j) {
            const double bound = bounds[i * ofTree.size() + j];
            double distance = std::numeric_limits<double>::infinity(), farthest = 0;
            for (const std::uint32_t a : ofCarried[i]) {
                for (const std::uint32_t b : ofTree[j]) {
                    distance = std::min(distance, distanceOf(a, b));
                    farthest = std::max(farthest, distanceOf(a, b));
                }
            }
            if (ofTree[j].empty()) {
                tightness.unused += bound != distance;
                continue;
            }
            ++tightness.pairs;
            tightness.above += !(bound <= distance);
            if (distance > 0.5 * farthest) {
                ++tightness.farApart;
                tightness.half += bound > 0.5 * distance;
            }
        }
    }
}

void compareBothWays(const QueryCase& queryCase, int width, Tightness& tightness) {
    BuildOptions options;
    options.nodeWidth = width;
    options.leafSize = 1;  // down to volumes around one triangle, whose bounds are tight
    const ModelPair models = buildPair(queryCase, options);
    const FlatTree &part = treeOf(models.part), &environment = treeOf(models.environment);
    for (const Pose& pose : queryCase.poses) {
        const PairQuery query = preparePairQuery(part, environment, pose);
        const double toMeshUnit = 1 / query.perMeshUnit;
        const auto distances = pairDistances(queryCase, pose);
        compare(
            boundsOf(part, environment, query.partToEnvironment, toMeshUnit), part, environment,
            [&](std::uint32_t a, std::uint32_t b) { return distances[a][b]; }, tightness);
        compare(
            boundsOf(environment, part, query.environmentToPart, toMeshUnit), environment, part,
            [&](std::uint32_t a, std::uint32_t b) { return distances[b][a]; }, tightness);
    }
}

QueryCase smallCase(Random& random, const Mesh& part, const Mesh& environment) {
    std::vector<Pose> poses;
    for (const double reach : {5.0, 40.0}) poses.push_back(random.pose(reach));
    // Nearly equal axes, where formulas for rectangle distances lose their digits.
    for (const double angle : {0.0, 1e-9, 1e-6, 1e-3}) {
        poses.push_back({Eigen::AngleAxisd(angle, random.direction()).toRotationMatrix(), random.inBox(20)});
    }
    poses.push_back({random.rotation(), {1e5, -3e4, 2e4}});
    return makeCase("small", part, environment, poses);
}

}  // namespace

BOOST_AUTO_TEST_SUITE(rss_lower_bound_test)

BOOST_DATA_TEST_CASE(lower_bound_never_exceeds_true_distance, eachTarget() * eachWidth(), target, width) {
    const UsingTarget using_(target);
    Random random(71);
    const std::vector<QueryCase> cases = {
        smallCase(random, randomSoup(random, 40, 10, 4), randomSoup(random, 40, 10, 4)),
        smallCase(random, torus(6, 2, 4), box({10, 6, 0.5}, 2)),
        smallCase(random, box({3, 4, 5}, 1), plateWithHole(30, 1, 6, 6)),
        smallCase(random, scaledBy(torus(6, 2, 4), 0x1p-12), randomTerrain(random, 4, 30, 0)),
        smallCase(random, randomSoup(random, 9, 0, 0), randomSoup(random, 30, 10, 1e-9))};  // nearly points
    Tightness tightness;
    for (const QueryCase& queryCase : cases) compareBothWays(queryCase, width, tightness);
    BOOST_TEST(tightness.pairs > 10000);
    BOOST_TEST(tightness.above == 0);
    BOOST_TEST(tightness.unused == 0);
    BOOST_TEST(tightness.half > 0.9 * static_cast<double>(tightness.farApart));
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace testing
}  // namespace clearway

#endif  // HWY_ONCE
