// LeafPairs hands over each near pair of leaves exactly once, with bounds that hold its distance, for any numbers
// of leaves and triangles, on any instruction set.
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "model/model_data.h"
#include "query/pair_query.h"
#include "query/refine.h"
#include "support/each_target.h"
#include "support/hard_triangles.h"
#include "support/query_cases.h"
#include "support/tree_triangles.h"

#ifndef CLEARWAY_TESTS_TAKEN
#define CLEARWAY_TESTS_TAKEN
namespace clearway::testing {

struct TakenPair {
    float lower, upper;
    TrianglesAt triangles;
};

}  // namespace clearway::testing
#endif

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "query/leaf_pairs_test.cpp"
#include "hwy/foreach_target.h"  // must come before highway.h and the kernels

#include "hwy/highway.h"
#include "query/leaf_pairs-inl.h"

HWY_BEFORE_NAMESPACE();
namespace clearway {
namespace HWY_NAMESPACE {

/// A visitor that records all pairs it is given.
class Recorder {
  public:
    Recorder(float dropFrom, std::vector<testing::TakenPair>& taken) : dropFrom_(dropFrom), taken_(taken) {}
    static constexpr bool kPairsMayWait = true;
    float dropFrom() const { return dropFrom_; }
    bool done() const { return false; }

    template <class D, class V>
    HWY_INLINE TriangleBounds<V> bounds(D d, const TrianglePair<V>& pair, V lower) const {
        return TriangleDistance(d, pair, lower);
    }
    void take(float lower, float upper, const TrianglesAt& triangles) {
        taken_.push_back({lower, upper, triangles});
    }

  private:
    float dropFrom_;
    std::vector<testing::TakenPair>& taken_;
};

/// Visits all pairs of leaves.
void visitLeaves(const PairQuery& query, float dropFrom, std::vector<testing::TakenPair>& taken) {
    LeafPairs pairs;
    WaitingPairs waiting;
    Recorder recorder(dropFrom, taken);
    for (const LeafReference a : query.part->leaves()) {
        for (const LeafReference b : query.environment->leaves()) {
            const Leaf part = query.part->leaf(a), environment = query.environment->leaf(b);
            pairs.meet(query, part, environment, -hwy::HighestValue<float>(), dropFrom);
            pairs.visit(waiting, recorder);
        }
    }
    if (waiting.count > 0) waiting.take(recorder);
}

}  // namespace HWY_NAMESPACE
}  // namespace clearway
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace clearway {

HWY_EXPORT(visitLeaves);

namespace testing {
namespace {

constexpr std::uint64_t kSeed = 107;

/// Two meshes at a pose, most of them of one leaf each.
struct LeafCase {
    std::string name;
    Model part, environment;
    Pose pose;
    std::vector<std::vector<long double>> distances;  ///< of the triangles in the trees' order, query units
};

LeafCase makeLeaves(const std::string& name, const Mesh& part, const Mesh& environment, const Pose& pose,
                    int leafSize = 16) {
    BuildOptions options;
    options.leafSplit = "none";
    options.leafSize = leafSize;
    LeafCase leaves{name, Model::build(part, options), Model::build(environment, options), pose, {}};
    const FlatTree &a = treeOf(leaves.part), &b = treeOf(leaves.environment);
    const double perMeshUnit = preparePairQuery(a, b, pose).perMeshUnit;
    const MeshOracle oracle(part, environment);
    for (const TriangleAt p : trianglesOf(a)) {
        leaves.distances.emplace_back();
        for (const TriangleAt e : trianglesOf(b)) {
            leaves.distances.back().push_back(oracle.pairDistance(pose, a.triangleId(p), b.triangleId(e)) *
                                              perMeshUnit);
        }
    }
    return leaves;
}

/// Two leaves with the given numbers of triangles, apart by a small share of their size up to many times it.
LeafCase makeSoups(Random& random, int partTriangles, int environmentTriangles) {
    const double away = std::pow(10.0, random.uniform(-1, 4)), size = std::pow(10.0, random.uniform(-2, 0));
    const Mesh part =
        scaledBy(randomSoup(random, partTriangles, 1, size), std::ldexp(1.0, random.below(20) - 10));
    const Mesh environment = randomSoup(random, environmentTriangles, 1, size);
    const std::string name = std::to_string(partTriangles) + " and " + std::to_string(environmentTriangles) +
                             " triangles, away " + std::to_string(away);
    return makeLeaves(name, part, environment, {random.rotation(), away * random.direction()});
}

/// Trees of several leaves of at most leafSize triangles, near each other.
LeafCase makeSeveralLeaves(Random& random, int leafSize) {
    const Mesh part = randomSoup(random, 12 + random.below(8), 1, 0.5),
               environment = randomSoup(random, 12 + random.below(8), 1, 0.5);
    return makeLeaves("leaves of " + std::to_string(leafSize), part, environment,
                      {random.rotation(), random.inBox(2)}, leafSize);
}

/// Leaves near each other, turned so that the rotation's rows are as far from the axes as possible: there
/// rounding adds up most.
LeafCase makeUnfavourable(Random& random) {
    const Mesh part = randomSoup(random, 16, 0.3, 1), environment = randomSoup(random, 16, 0.3, 1);
    const Matrix3 mirror = Matrix3::Constant(2.0 / 3) - Matrix3::Identity();  // a half turn about (1, 1, 1)
    const Matrix3 turn =
        Eigen::AngleAxisd(random.uniform(0, 0.02), random.direction()).toRotationMatrix() * mirror;
    return makeLeaves("unfavourable", part, environment, {turn, random.inBox(0.5)});
}

/// Both leaves so far from the origin that composing the offset between them rounds by more than all float
/// operations.
LeafCase makeFar(Random& random) {
    const double away = std::ldexp(1.0, 36 + random.below(12));
    const Pose place{Matrix3::Identity(), away * random.direction()};
    const Mesh part = transformed(randomSoup(random, 5, 2, 1), place);
    const Mesh environment = transformed(randomSoup(random, 5, 2, 1), place);
    return makeLeaves("far", part, environment, place * random.pose(2) * inverse(place));
}

LeafCase makeFamily(Random& random, const TriangleFamily& family, const Pose& pose) {
    Mesh part, environment;
    const int triangles = 1 + random.below(16);
    for (int i = 0; i < triangles; ++i) {
        const TrianglePair pair = family.make(random);
        part = joined(part, meshOf(pair.a));
        environment = joined(environment, meshOf(pair.b));
    }
    return makeLeaves(family.name, part, environment, pose);
}

const std::vector<LeafCase>& cases() {
    static const std::vector<LeafCase> made = [] {
        std::vector<LeafCase> result;
        Random random(kSeed);
        for (int n = 1; n <= 16; ++n) {
            for (int m = 1; m <= 16; ++m) {
                for (int i = 0; i < 2; ++i) result.push_back(makeSoups(random, n, m));
            }
        }
        for (int i = 0; i < 60; ++i) result.push_back(makeSeveralLeaves(random, 1 + i % 6));
        for (int i = 0; i < 60; ++i) {
            result.push_back(makeUnfavourable(random));
            result.push_back(makeFar(random));
        }
        for (const TriangleFamily& family : hardTriangleFamilies()) {
            if (family.name == "denormals") continue;  // their sizes differ too much
            for (int i = 0; i < 6; ++i) {
                result.push_back(makeFamily(random, family, i % 2 == 0 ? Pose{} : random.pose(100)));
            }
        }
        return result;
    }();
    return made;
}

/// The recorded pairs of all pairs of leaves; [part triangle][environment triangle].
std::vector<std::vector<std::vector<TakenPair>>> takenOf(const LeafCase& leaves, const PairQuery& query,
                                                         float dropFrom) {
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());  // this program's own dispatch
    std::vector<TakenPair> taken;
    HWY_DYNAMIC_DISPATCH(visitLeaves)(query, dropFrom, taken);
    const FlatTree &part = treeOf(leaves.part), &environment = treeOf(leaves.environment);
    const std::vector<TriangleAt> ofPart = trianglesOf(part), ofEnvironment = trianglesOf(environment);
    const auto positionIn = [](const std::vector<TriangleAt>& all, TriangleAt triangle) {
        return std::size_t(std::find(all.begin(), all.end(), triangle) - all.begin());
    };
    std::vector<std::vector<std::vector<TakenPair>>> byPair(leaves.distances.size());
    for (auto& row : byPair) row.resize(leaves.distances[0].size());
    for (const TakenPair& pair : taken) {
        byPair.at(positionIn(ofPart, pair.triangles.part))
            .at(positionIn(ofEnvironment, pair.triangles.environment))
            .push_back(pair);
    }
    return byPair;
}

/// The reach of two trees of one leaf each: both radii and the offset between the centres, as LeafPairs adds
/// them up.
long double rangeOf(const LeafCase& leaves, const PairQuery& query) {
    const Leaf a = treeOf(leaves.part).leaf(0), b = treeOf(leaves.environment).leaf(0);
    const Vector3 between = leaves.pose * Vector3(a.centre.data()) - Vector3(b.centre.data());
    return a.radius * query.partLeafToQuery + b.radius * query.environmentLeafToQuery +
           between.lpNorm<1>() * query.perMeshUnit;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(leaf_pairs_test)

BOOST_AUTO_TEST_CASE(the_cases_hold_leaves_of_1_to_16_triangles) {
    std::vector<int> leaves(17);
    for (const LeafCase& pair : cases()) {
        const FlatTree& tree = treeOf(pair.part);
        for (const LeafReference at : tree.leaves()) ++leaves.at(tree.leaf(at).triangleCount);
    }
    for (int n = 1; n <= 16; ++n) BOOST_TEST(leaves[std::size_t(n)] >= 32, n << " triangles");
}

BOOST_DATA_TEST_CASE(every_near_pair_is_taken_once_with_bounds_that_hold_its_distance, eachTarget(), target) {
    const UsingTarget using_(target);
    Random random(kSeed);
    for (const LeafCase& leaves : cases()) {
        const PairQuery query =
            preparePairQuery(treeOf(leaves.part), treeOf(leaves.environment), leaves.pose);
        const std::size_t rows = leaves.distances.size(), columns = leaves.distances[0].size();
        for (int draw = 0; draw < 6; ++draw) {
            // Just above one of the distances, so that one rounding too many would drop its pair.
            const long double distance =
                leaves
                    .distances[std::size_t(random.below(int(rows)))][std::size_t(random.below(int(columns)))];
            const float dropFrom = draw == 0 ? std::numeric_limits<float>::max()
                                             : std::max(nextFloatAbove(double(distance)), kLeastProved);
            const auto taken = takenOf(leaves, query, dropFrom);
            BOOST_TEST_CONTEXT(leaves.name << ", seed " << kSeed << ", drops from " << dropFrom) {
                for (std::size_t i = 0; i < rows; ++i) {
                    for (std::size_t j = 0; j < columns; ++j) {
                        BOOST_TEST(taken[i][j].size() <= 1u);
                        if (leaves.distances[i][j] < dropFrom) BOOST_TEST(taken[i][j].size() == 1u);
                        for (const TakenPair& pair : taken[i][j]) {
                            BOOST_TEST(pair.lower <= leaves.distances[i][j]);
                            BOOST_TEST(leaves.distances[i][j] <= pair.upper);
                            BOOST_TEST(pair.triangles.feature >= 0);
                            BOOST_TEST(pair.triangles.feature < kFeatures);
                        }
                    }
                }
            }
        }
    }
}

BOOST_DATA_TEST_CASE(rounding_takes_less_than_half_of_its_slack, eachTarget(), target) {
    const UsingTarget using_(target);
    long double worstGap = 0, worstDistance = 0;  // in u32 of the leaves' reach
    for (const LeafCase& leaves : cases()) {
        const PairQuery query =
            preparePairQuery(treeOf(leaves.part), treeOf(leaves.environment), leaves.pose);
        if (treeOf(leaves.part).leaves().size() != 1 || treeOf(leaves.environment).leaves().size() != 1)
            continue;
        const long double reach = rangeOf(leaves, query), u = kUnitRoundoffFloat;
        const long double slack = kTriangleSlack * u * reach + query.offsetSlack;
        if (query.offsetSlack > 0.01L * slack) continue;  // far from the origin: the offset's slack
        const auto taken = takenOf(leaves, query, std::numeric_limits<float>::max());
        for (std::size_t i = 0; i < taken.size(); ++i) {
            for (std::size_t j = 0; j < taken[i].size(); ++j) {
                for (const TakenPair& pair : taken[i][j]) {
                    const long double distance = leaves.distances[i][j];
                    worstGap = std::max(worstGap, (pair.lower + slack - distance) / (u * reach));
                    worstDistance = std::max(worstDistance, (distance - (pair.upper - slack)) / (u * reach));
                }
            }
        }
    }
    BOOST_TEST_MESSAGE("gaps " << worstGap << ", distances " << worstDistance << " of " << kTriangleSlack
                               << " u, seed " << kSeed);
    BOOST_TEST(worstGap <= 0.5L * kTriangleSlack);
    BOOST_TEST(worstDistance <= 0.5L * kTriangleSlack);
}

BOOST_DATA_TEST_CASE(most_pairs_that_are_not_near_are_left_out, eachTarget(), target) {
    const UsingTarget using_(target);
    long beyond = 0, leftOut = 0;
    for (const LeafCase& leaves : cases()) {
        const PairQuery query =
            preparePairQuery(treeOf(leaves.part), treeOf(leaves.environment), leaves.pose);
        long double least = std::numeric_limits<long double>::max();
        for (const auto& row : leaves.distances) {
            for (const long double distance : row) least = std::min(least, distance);
        }
        const float dropFrom = std::max(nextFloatAbove(double(least)), kLeastProved);
        const auto taken = takenOf(leaves, query, dropFrom);
        for (std::size_t i = 0; i < taken.size(); ++i) {
            for (std::size_t j = 0; j < taken[i].size(); ++j) {
                if (leaves.distances[i][j] < 1.1L * dropFrom) continue;
                ++beyond;
                leftOut += taken[i][j].empty();
            }
        }
    }
    BOOST_TEST(beyond > 10000);
    BOOST_TEST(leftOut > 0.95 * double(beyond));
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace testing
}  // namespace clearway

#endif  // HWY_ONCE
