// Between parallel faces hundreds of pairs of triangles are equally close. The interval stays narrow and
// holds the distance, for every leaf size and leaf split, on any instruction set.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "support/each_target.h"
#include "support/query_cases.h"

BOOST_AUTO_TEST_SUITE(ties_test)

using namespace clearway;
using namespace clearway::testing;

constexpr std::uint64_t kSeed = 109;

/// Boxes of 4 x 3 x 2 and 6 x 5 x 2, face to face, straight and turned, near the origin and away from it.
const std::vector<QueryCase>& boxesAtGaps() {
    static const std::vector<QueryCase> made = [] {
        std::vector<QueryCase> cases;
        Random random(kSeed);
        const Mesh part = box({2, 1.5, 1}, 4), environment = box({3, 2.5, 1}, 6);
        std::vector<Pose> straight;
        for (int power = 1; power <= 9; ++power) {
            const double gap = std::pow(10.0, -power);
            straight.push_back({Matrix3::Identity(), {0.25, -0.5, 2 + gap}});
        }
        cases.push_back(makeCase("straight", part, environment, straight));
        // The turned environment's corners are rounded, so that faces are parallel only up to rounding.
        for (const double away : {0.0, 1e3}) {
            const Pose place{random.rotation(), away * random.direction()};
            std::vector<Pose> turned;
            for (const Pose& pose : straight) turned.push_back(place * pose);
            cases.push_back(makeCase(away == 0 ? "turned" : "turned and away", part,
                                     transformed(environment, place), turned));
        }
        return cases;
    }();
    return made;
}

// The models, built once for all instruction sets.
const ModelPair& modelsOf(const QueryCase& queryCase, const BuildChoice& build) {
    static std::map<std::string, ModelPair> built;
    std::ostringstream key;
    key << queryCase.name << ' ' << build;
    const auto found = built.find(key.str());
    return found != built.end() ? found->second
                                : built.emplace(key.str(), buildPair(queryCase, build)).first->second;
}

void checkTies(const QueryCase& queryCase, const BuildChoice& build) {
    const ModelPair& models = modelsOf(queryCase, build);
    Workspace workspace;
    for (std::size_t i = 0; i < queryCase.poses.size(); ++i) {
        const Pose& pose = queryCase.poses[i];
        BOOST_TEST_CONTEXT(queryCase.name << ", seed " << kSeed << ", pose " << i << ", " << build) {
            for (const bool warm : {false, true}) {
                if (!warm) workspace.forgetWarmStart();
                const DistanceResult result = distance(models.part, models.environment, pose, {}, workspace);
                checkDistance(result, queryCase, pose, queryCase.answers[i]);
                BOOST_TEST(!result.collides());
            }
            const double truth = queryCase.answers[i].distance;
            const double rounding = kUnitRoundoff * largestCoordinate(queryCase, pose);  // of the oracle
            BOOST_TEST(!collides(models.part, models.environment, pose, workspace));
            BOOST_TEST(isWithin(models.part, models.environment, pose, truth + rounding, workspace));
            BOOST_TEST(!isWithin(models.part, models.environment, pose, truth - rounding, workspace));
        }
    }
}

std::vector<BuildChoice> everyLeaf() {
    std::vector<BuildChoice> builds;
    for (const int width : nodeWidths()) {
        for (const std::string& leaf : leafSplitNames()) {
            for (const int size : {1, 3, 4, 5, 8, 16}) {
                builds.push_back(buildChoice("sah", leaf, size, width));
            }
        }
    }
    return builds;
}

BOOST_AUTO_TEST_CASE(gaps_are_those_asked_for) {
    for (const QueryCase& queryCase : boxesAtGaps()) {
        for (std::size_t i = 0; i < queryCase.poses.size(); ++i) {
            const double gap = std::pow(10.0, -double(i + 1));
            BOOST_TEST(std::abs(queryCase.answers[i].distance - gap) <=
                       16 * kUnitRoundoff * largestCoordinate(queryCase, queryCase.poses[i]));
        }
    }
}

BOOST_DATA_TEST_CASE(many_pairs_are_resolved_in_double, eachTarget(), target) {
    const UsingTarget using_(target);
    for (const QueryCase& queryCase : boxesAtGaps()) {
        const ModelPair& models = modelsOf(queryCase, buildChoice("sah", "none", 4, 8));
        for (std::size_t i = 0; i < queryCase.poses.size(); ++i) {
            Workspace workspace;
            distance(models.part, models.environment, queryCase.poses[i], {}, workspace);
            BOOST_TEST(workspace.counters().refinedPairs > 64u, queryCase.name << ", pose " << i);
        }
    }
}

BOOST_DATA_TEST_CASE(parallel_faces_keep_a_narrow_interval_about_their_gap, eachTarget(), target) {
    const UsingTarget using_(target);
    for (const BuildChoice& build : everyLeaf()) {
        for (const QueryCase& queryCase : boxesAtGaps()) checkTies(queryCase, build);
    }
}

BOOST_AUTO_TEST_SUITE_END()
