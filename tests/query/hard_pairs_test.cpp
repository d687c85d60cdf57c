// Triangle pairs that other libraries answer wrongly, each as two meshes of one triangle, against rational
// arithmetic.
#define BOOST_TEST_MODULE query_hard_pairs
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "support/each_target.h"
#include "support/hard_triangles.h"
#include "support/query_cases.h"

using namespace clearway;
using namespace clearway::testing;

namespace {

constexpr std::uint64_t kSeed = 41;

struct PairCase {
    QueryCase queryCase;
    ModelPair models[2];  // of node width 2 and 8
};

PairCase makePairCase(const std::string& name, const TrianglePair& pair, const Pose& pose) {
    QueryCase queryCase = makeCase(name, meshOf(pair.a), meshOf(pair.b), {pose});
    queryCase.answers[0].distance = queryCase.oracle->pairDistance(pose, 0, 0);
    BuildOptions narrow, wide;
    narrow.nodeWidth = 2;
    return {queryCase, {buildPair(queryCase, narrow), buildPair(queryCase, wide)}};
}

// Every family, as drawn and moved by a pose.
const std::vector<PairCase>& pairCases() {
    static const std::vector<PairCase> cases = [] {
        std::vector<PairCase> result;
        Random random(kSeed);
        for (const TriangleFamily& family : hardTriangleFamilies()) {
            if (family.name == "denormals") continue;  // of sizes too far apart; see below
            for (int i = 0; i < 24; ++i) {
                const TrianglePair pair = family.make(random);
                const Pose pose = i % 3 == 2 ? poseFor(random, pair) : Pose{};
                const std::string name =
                    family.name + ", seed " + std::to_string(kSeed) + ", draw " + std::to_string(i);
                result.push_back(makePairCase(name, pair, pose));
            }
        }
        return result;
    }();
    return cases;
}

// Beside the accuracy promised relative to the scene there is rounding of the coordinates themselves.
double accuracyOf(const QueryCase& queryCase) {
    return std::max(kAccuracy * queryCase.oracle->sceneSize(),
                    64 * kUnitRoundoff * largestCoordinate(queryCase, queryCase.poses[0]));
}

}  // namespace

BOOST_DATA_TEST_CASE(pairs_from_bug_reports_are_answered_rightly, eachTarget() * eachWidth(), target, width) {
    const UsingTarget using_(target);
    for (const KnownPair& known : knownTrianglePairs()) {
        const PairCase pairCase = makePairCase(known.name, known.pair, Pose{});
        const ModelPair& models = pairCase.models[width == 2 ? 0 : 1];
        Workspace workspace;
        const DistanceResult result = distance(models.part, models.environment, Pose{}, {}, workspace);
        BOOST_TEST_CONTEXT(known.name) {
            BOOST_TEST(std::abs(result.distance - known.distance) <= accuracyOf(pairCase.queryCase));
            BOOST_TEST(result.lower <= known.distance * (1 + 1e-15));
            if (known.distance > 1e-9)
                BOOST_TEST(!collides(models.part, models.environment, Pose{}, workspace));
        }
    }
}

BOOST_DATA_TEST_CASE(hard_pairs_have_their_exact_distance, eachTarget() * eachWidth(), target, width) {
    const UsingTarget using_(target);
    Workspace workspace;
    for (const PairCase& pairCase : pairCases()) {
        const QueryCase& queryCase = pairCase.queryCase;
        const ModelPair& models = pairCase.models[width == 2 ? 0 : 1];
        const Pose& pose = queryCase.poses[0];
        const double truth = queryCase.answers[0].distance;
        const double accuracy = accuracyOf(queryCase);
        const DistanceResult result = distance(models.part, models.environment, pose, {}, workspace);
        BOOST_TEST_CONTEXT(queryCase.name << ", distance " << truth) {
            BOOST_TEST(result.lower <= truth);
            if (!result.collides()) BOOST_TEST(truth <= result.upper);
            BOOST_TEST(std::abs(result.distance - truth) <= accuracy);
            BOOST_TEST(result.upper - result.lower <= 2 * accuracy);
            BOOST_TEST(result.partTriangle == 0);
            BOOST_TEST(result.environmentTriangle == 0);
        }
    }
}

BOOST_DATA_TEST_CASE(verdicts_on_hard_pairs_agree_and_miss_no_contact, eachTarget() * eachWidth(), target,
                     width) {
    const UsingTarget using_(target);
    Workspace workspace;
    int contacts = 0;
    for (const PairCase& pairCase : pairCases()) {
        const QueryCase& queryCase = pairCase.queryCase;
        const ModelPair& models = pairCase.models[width == 2 ? 0 : 1];
        const Pose& pose = queryCase.poses[0];
        const double truth = queryCase.answers[0].distance;
        const bool touching = collides(models.part, models.environment, pose, workspace);
        contacts += touching;
        BOOST_TEST_CONTEXT(queryCase.name << ", distance " << truth) {
            BOOST_TEST(isWithin(models.part, models.environment, pose, 0, workspace) == touching);
            BOOST_TEST(distance(models.part, models.environment, pose, {}, workspace).collides() == touching);
            BOOST_TEST((truth == 0) == touching);
        }
    }
    BOOST_TEST(contacts > 80);
}

BOOST_DATA_TEST_CASE(sizes_too_far_apart_are_refused_by_name, eachTarget() * eachWidth(), target, width) {
    const UsingTarget using_(target);
    Random random(kSeed);
    const Mesh mesh = randomSoup(random, 5, 1, 1);
    for (const int exponent : {-1020, -80, -40, 40, 80, 900}) {
        const QueryCase queryCase =
            makeCase("sizes", scaledBy(mesh, std::ldexp(1.0, exponent)), mesh, {Pose{}});
        BuildOptions options;
        options.nodeWidth = width;
        const ModelPair models = buildPair(queryCase, options);
        Workspace workspace;
        BOOST_TEST_CONTEXT("part 2^" << exponent << " times as large") {
            if (std::abs(exponent) < 60) {
                checkDistance(distance(models.part, models.environment, Pose{}, {}, workspace), queryCase,
                              Pose{}, queryCase.answers[0]);
                continue;
            }
            BOOST_CHECK_EXCEPTION(collides(models.part, models.environment, Pose{}, workspace),
                                  std::invalid_argument, [](const std::invalid_argument& error) {
                                      return std::string(error.what()).find("expected 2^-60 to 2^60") !=
                                             std::string::npos;
                                  });
        }
    }
}
