#include "demos/study/claims.h"

#include <boost/test/unit_test.hpp>
#include <cmath>

namespace clearway::testing {
BOOST_AUTO_TEST_SUITE(claims_test)

using namespace study;

TreeRow tree(const std::string& scene, const std::string& general, const std::string& leaf, double seconds,
             std::uint64_t leaves) {
    TreeRow row;
    row.scene = scene;
    row.nodeWidth = 2;
    row.generalSplit = general;
    row.leafSplit = leaf;
    row.buildSeconds = 1;
    row.megabytes = 30;
    row.leaves = leaves;
    for (int i = 0; i < 20; ++i) row.distancesBlockSeconds.push_back(seconds * (1 + 0.001 * (i % 5)));
    row.collisionsBlockSeconds = row.distancesBlockSeconds;
    return row;
}

const ClaimRow& find(const std::vector<ClaimRow>& claims, const std::string& claim) {
    for (const ClaimRow& row : claims) {
        if (row.claim == claim) return row;
    }
    BOOST_FAIL("no such claim among " << claims.size());
    return claims.front();
}

BOOST_AUTO_TEST_CASE(claims_are_judged_by_the_rule) {
    const std::vector<TreeRow> trees = {
        tree("cembox", "mean", "chain", 2, 100), tree("cembox", "axis", "chain", 1, 200),
        tree("cembox", "axis", "none", 0.5, 100), tree("cembox", "axis", "edge", 1.001, 300),
        tree("cembox", "axis", "all", 3, 400)};
    const auto claims = judgeClaims(trees);
    const auto verdict = [&](const std::string& claim) { return find(claims, claim).verdict; };
    BOOST_TEST(verdict("AxisSplit answers distances faster than MeanSplit") == "holds");
    BOOST_TEST(verdict("ChainSplit answers distances faster than NoSplit") == "the opposite");
    BOOST_TEST(verdict("ChainSplit answers distances faster than EdgeSplit") == "no difference");
    BOOST_TEST(verdict("EdgeSplit answers collisions as fast as ChainSplit") == "holds");
    BOOST_TEST(verdict("ChainSplit answers collisions as fast as NoSplit") == "the first is slower");
    BOOST_TEST(verdict("AxisSplit takes longer to build than MeanSplit") == "no difference");
    BOOST_TEST(verdict("ChainSplit makes more leaves than NoSplit") == "holds");
    for (const ClaimRow& row : claims)
        BOOST_TEST(row.claim != "ChainSplit answers collisions faster than NoSplit");
    const auto inLarge = judgeClaims({tree("large-environment", "axis", "chain", 1, 200),
                                      tree("large-environment", "axis", "none", 5, 100)});
    const ClaimRow& collisions = find(inLarge, "ChainSplit answers collisions faster than NoSplit");
    BOOST_TEST(collisions.verdict == "holds");
    BOOST_TEST(collisions.thesisRatio.value() == 16223.0 / 3151.0);
    const ClaimRow& axis = find(claims, "AxisSplit answers distances faster than MeanSplit");
    BOOST_TEST(axis.median == 2);
    BOOST_TEST(axis.thesisRatio.value() == 595.0 / 205.0);
    const auto elsewhere =
        judgeClaims({tree("window", "mean", "chain", 2, 1), tree("window", "axis", "chain", 1, 1)});
    BOOST_TEST(!elsewhere.at(0).thesisRatio);
}

/// If no difference was shown, that is no proof that both are alike.
BOOST_AUTO_TEST_CASE(a_claim_about_which_poses_disagree_is_undecided) {
    std::vector<TreeRow> trees = {tree("cembox", "axis", "chain", 1, 200),
                                  tree("cembox", "axis", "edge", 1, 300)};
    for (std::size_t i = 0; i < 20; ++i) trees[1].distancesBlockSeconds[i] = i % 2 == 0 ? 0.8 : 1.25;
    trees[1].collisionsBlockSeconds = trees[1].distancesBlockSeconds;
    const auto claims = judgeClaims(trees);
    for (const char* claim : {"EdgeSplit answers collisions as fast as ChainSplit",
                              "ChainSplit answers distances faster than EdgeSplit"}) {
        BOOST_TEST(find(claims, claim).verdict == "undecided", claim);
    }
}

BOOST_AUTO_TEST_CASE(thesis_values_are_looked_up_by_scene_and_strategy) {
    const ThesisScene* tunnel = thesisSceneOf("tunnel-console-3");
    BOOST_TEST_REQUIRE(tunnel != nullptr);
    BOOST_TEST(thesisValue(*tunnel, TreeMeasure::kDistancesPerSecond, "axis", "edge").value() == 339);
    BOOST_TEST(thesisValue(*tunnel, TreeMeasure::kDistancesPerSecond, "mean", "chain").value() == 230);
    BOOST_TEST(thesisValue(*tunnel, TreeMeasure::kLeaves, "axis", "all").value() == 300401);
    BOOST_TEST(thesisValue(*tunnel, TreeMeasure::kBuildSeconds, "axis", "chain").value() == 4.05);
    BOOST_TEST(!thesisValue(*tunnel, TreeMeasure::kBuildSeconds, "axis", "none"));
    BOOST_TEST(!thesisValue(*tunnel, TreeMeasure::kDistancesPerSecond, "sah", "chain"));
    BOOST_TEST(!thesisValue(*thesisSceneOf("cembox"), TreeMeasure::kLeaves, "axis", "all"));
    BOOST_TEST(thesisSceneOf("window") == nullptr);
    // NoSplit's leaves hold all triangles of the thesis's static model, as the leaves of every other split
    // do.
    for (const auto& sizes : *tunnel->leaves) {
        double triangles = 0;
        for (std::size_t i = 0; i < sizes.size(); ++i) triangles += static_cast<double>(i + 1) * sizes[i];
        BOOST_TEST(std::abs(triangles - 300401) <= 1, "leaves hold " << triangles << " triangles");
    }
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::testing
