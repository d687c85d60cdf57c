// Bounds of several pairs in double never exceed the distance of their exact vertices, and come near the
// distance for well-shaped triangles; far from the origin, at any scale, on any instruction set.
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "model/model_data.h"
#include "query/pair_query.h"
#include "support/each_target.h"
#include "support/exact_distance.h"
#include "support/hard_triangles.h"
#include "support/query_cases.h"
#include "support/tree_triangles.h"
#include "support/triangle_distance.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "query/bound_pairs_test.cpp"
#include "hwy/foreach_target.h"  // must come before highway.h and the kernels

#include "hwy/highway.h"
#include "query/bound_pairs-inl.h"

HWY_BEFORE_NAMESPACE();
namespace clearway {
namespace HWY_NAMESPACE {

void boundPairs(const PairQuery& query, const Candidate* pairs, int count, double* lower) {
    alignas(64) double found[kPairsTogether];
    BoundPairs(query, pairs, count, found);
    for (int k = 0; k < count; ++k) lower[k] = found[k];
}

}  // namespace HWY_NAMESPACE
}  // namespace clearway
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace clearway {

HWY_EXPORT(boundPairs);

namespace testing {
namespace {

constexpr std::uint64_t kSeed = 103;

/// Pairs of triangles of two meshes at a pose, with their distances.
struct PairsCase {
    std::string name;
    Model part, environment;
    Pose pose;
    std::vector<Candidate> pairs;
    std::vector<double> distances;  ///< mesh units
    std::vector<double> sizes;      ///< largest coordinate of the pair from the environment's first corner
    std::vector<bool> isPlain;      ///< well shaped, and apart by more than half of their size
};

std::map<std::size_t, TriangleAt> placesOf(const FlatTree& tree) {
    std::map<std::size_t, TriangleAt> places;
    for (const TriangleAt triangle : trianglesOf(tree)) places[tree.triangleId(triangle)] = triangle;
    return places;
}

/// The least height of a triangle over its longest edge.
long double shapeOf(const LongTriangle& t) {
    const long double area = (t[1] - t[0]).cross(t[2] - t[0]).norm();
    const long double longest = std::max({(t[1] - t[0]).norm(), (t[2] - t[1]).norm(), (t[0] - t[2]).norm()});
    return longest > 0 ? area / (longest * longest) : 0;
}

/// The distance in long double, and in exact arithmetic for near pairs.
double trueDistance(const Pose& pose, const std::array<Vector3, 3>& a, const std::array<Vector3, 3>& b,
                    double largest) {
    const long double distance = triangleDistance(moved(pose, a), toLong(b)).distance;
    if (distance > 1e-12L * largest) return static_cast<double>(distance);
    return static_cast<double>(exactDistance(pose, a, b).rounded());
}

/// ids: ids of the part's and the environment's triangles.
PairsCase makePairs(const std::string& name, const Mesh& part, const Mesh& environment, const Pose& pose,
                    const std::vector<std::pair<std::size_t, std::size_t>>& ids) {
    PairsCase made{name, Model::build(part), Model::build(environment), pose, {}, {}, {}, {}};
    const auto partPlaces = placesOf(treeOf(made.part)),
               environmentPlaces = placesOf(treeOf(made.environment));
    const PairQuery query = preparePairQuery(treeOf(made.part), treeOf(made.environment), pose);
    for (const auto& [p, e] : ids) {
        const auto inPart = partPlaces.find(p), inEnvironment = environmentPlaces.find(e);
        if (inPart == partPlaces.end() || inEnvironment == environmentPlaces.end()) continue;  // removed
        const auto a = cornersOf(part, p), b = cornersOf(environment, e);
        const LongTriangle longA = moved(pose, a), longB = toLong(b);
        long double size = 0;
        for (const LongTriangle* t : {&longA, &longB}) {
            for (const LongVector& corner : *t)
                size = std::max(size, (corner - longB[0]).cwiseAbs().maxCoeff());
        }
        const double distance = trueDistance(pose, a, b, query.largestCoordinate / query.perMeshUnit);
        made.pairs.push_back({0, {inPart->second, inEnvironment->second, kNoFeature}});
        made.distances.push_back(distance);
        made.sizes.push_back(static_cast<double>(size));
        made.isPlain.push_back(distance > 0.5 * static_cast<double>(size) && shapeOf(longA) > 0.2L &&
                               shapeOf(longB) > 0.2L);
    }
    return made;
}

PairsCase makeFamily(Random& random, const TriangleFamily& family, const Pose& pose) {
    Mesh part, environment;
    std::vector<std::pair<std::size_t, std::size_t>> ids;
    for (std::size_t i = 0; i < 60; ++i) {
        const TrianglePair pair = family.make(random);
        part = joined(part, meshOf(pair.a));
        environment = joined(environment, meshOf(pair.b));
        ids.emplace_back(i, i);
    }
    return makePairs(family.name, part, environment, pose, ids);
}

PairsCase makeSoup(Random& random, const std::string& name, double offset, int exponent) {
    const double scale = std::ldexp(1.0, exponent);
    const Pose away{Matrix3::Identity(), offset * random.direction()};
    const Mesh part = scaledBy(transformed(randomSoup(random, 40, 8, 1.5), away), scale);
    const Mesh environment = scaledBy(transformed(randomSoup(random, 40, 8, 1.5), away), scale);
    // Turns the part about the place where both triangles lie.
    Pose pose = away * random.pose(8) * inverse(away);
    pose.translation *= scale;
    std::vector<std::pair<std::size_t, std::size_t>> ids;
    for (int i = 0; i < 300; ++i) ids.emplace_back(random.below(40), random.below(40));
    return makePairs(name, part, environment, pose, ids);
}

const std::vector<PairsCase>& cases() {
    static const std::vector<PairsCase> made = [] {
        std::vector<PairsCase> result;
        Random random(kSeed);
        for (const TriangleFamily& family : hardTriangleFamilies()) {
            if (family.name == "denormals") continue;  // their sizes differ too much
            result.push_back(makeFamily(random, family, Pose{}));
            result.push_back(makeFamily(random, family, random.pose(300)));
        }
        for (const double offset : {0.0, 1e3, 1e6, 1e9}) {
            for (const int exponent : {-40, 0, 40}) {
                const std::string name =
                    "soup at " + std::to_string(offset) + " times 2^" + std::to_string(exponent);
                for (int i = 0; i < 4; ++i) result.push_back(makeSoup(random, name, offset, exponent));
            }
        }
        return result;
    }();
    return made;
}

/// Bounds of all pairs, query units, taken 1 to 8 at a time.
std::vector<double> boundsOf(const PairQuery& query, const std::vector<Candidate>& pairs) {
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());  // this program's own dispatch
    std::vector<double> bounds(pairs.size());
    std::size_t count = 1;
    for (std::size_t first = 0; first < pairs.size(); first += count) {
        count = std::min(first % 8 + 1, pairs.size() - first);
        HWY_DYNAMIC_DISPATCH(boundPairs)(query, pairs.data() + first, int(count), bounds.data() + first);
    }
    return bounds;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(bound_pairs_test)

BOOST_AUTO_TEST_CASE(the_cases_hold_contact_near_and_plain_pairs) {
    int touching = 0, near = 0, plain = 0;
    for (const PairsCase& pairs : cases()) {
        for (std::size_t i = 0; i < pairs.pairs.size(); ++i) {
            touching += pairs.distances[i] == 0;
            near += pairs.distances[i] > 0 && pairs.distances[i] < 1e-6 * pairs.sizes[i];
            plain += pairs.isPlain[i];
        }
    }
    BOOST_TEST(touching > 200);
    BOOST_TEST(near > 100);
    BOOST_TEST(plain > 1000);
}

BOOST_DATA_TEST_CASE(no_bound_exceeds_the_distance_or_is_far_from_that_of_a_plain_pair, eachTarget(),
                     target) {
    const UsingTarget using_(target);
    for (const PairsCase& pairs : cases()) {
        const PairQuery query = preparePairQuery(treeOf(pairs.part), treeOf(pairs.environment), pairs.pose);
        const double M = query.largestCoordinate / query.perMeshUnit;
        const std::vector<double> bounds = boundsOf(query, pairs.pairs);
        for (std::size_t i = 0; i < bounds.size(); ++i) {
            const double bound = bounds[i] / query.perMeshUnit;
            BOOST_TEST_CONTEXT(pairs.name << ", seed " << kSeed << ", pair " << i) {
                BOOST_TEST(bounds[i] >= 0);
                BOOST_TEST(bound <= pairs.distances[i]);
                if (pairs.isPlain[i]) {
                    const double rounding = kUnitRoundoff * (32 * M + 64 * pairs.sizes[i]);
                    BOOST_TEST(pairs.distances[i] - bound <= rounding);
                }
            }
        }
    }
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace testing
}  // namespace clearway

#endif  // HWY_ONCE
