// The hard cases of triangles, one test per case (see hard_cases.md): each pair alone and all pairs together
// in two meshes, on every instruction set, with every leaf split and node width, in all three queries; and in
// double alone.
#include <boost/test/unit_test.hpp>
#include <string>

#include "model/model_data.h"
#include "query/pair_query.h"
#include "query/refine.h"
#include "support/each_target.h"
#include "support/exact_check.h"
#include "support/hard_triangles.h"
#include "support/words.h"

BOOST_AUTO_TEST_SUITE(hard_triangles_test)

using namespace clearway;
using namespace clearway::testing;

constexpr std::uint64_t kSeed = 131;
constexpr int kDraws = 30;
constexpr int kTogether = 5;

/// The test's name, for example "22_needles".
std::string caseName(const TriangleFamily& family) {
    std::string name = (family.number < 10 ? "0" : "") + std::to_string(family.number) + '_' + family.name;
    const auto isPlain = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; };
    for (char& c : name) {
        if (!isPlain(c)) c = '_';
    }
    return name;
}

void checkInDouble(const ExactCase& exact, const ModelPair& models) {
    const PairQuery query = preparePairQuery(treeOf(models.part), treeOf(models.environment), exact.pose);
    const ResolvedPair pair = resolvePair(query, {});
    BOOST_TEST_CONTEXT(exact.name << ", in double") {
        BOOST_TEST(exact.truth.compare(pair.lower / query.perMeshUnit) >= 0);
        BOOST_TEST(exact.truth.compare(pair.upper / query.perMeshUnit) <= 0);
        if (pair.contact != Verdict::open) {
            BOOST_TEST((pair.contact == Verdict::yes) == exact.truth.isZero());
        }
    }
}

void checkAlone(const TrianglePair& pair, const Pose& pose, const std::string& name) {
    const ExactCase exact = exactCase(name, meshOf(pair.a), meshOf(pair.b), pose);
    for (const int width : nodeWidths()) {
        BuildOptions options;
        options.nodeWidth = width;
        const ModelPair models = buildPair(exact, options);
        checkInDouble(exact, models);
        for (const std::string& target : availableTargets()) {
            const UsingTarget using_(target);
            Workspace workspace;
            BOOST_TEST_CONTEXT(target << ", width " << width) {
                checkExactly(exact, models, workspace);
            }
        }
    }
}

void checkFamily(const TriangleFamily& family) {
    Random random(kSeed);
    Mesh part, environment;
    for (int draw = 0; draw < kDraws; ++draw) {
        const TrianglePair pair = family.make(random);
        const std::string name =
            family.name + ", seed " + std::to_string(kSeed) + ", draw " + std::to_string(draw);
        checkAlone(pair, draw % 3 == 2 ? poseFor(random, pair) : Pose{}, name);
        if (draw >= kTogether) continue;
        part = joined(part, meshOf(pair.a));
        environment = joined(environment, meshOf(pair.b));
    }
    checkEveryBuild(exactCase(family.name + " together", part, environment, Pose{}));
}

bool registerFamilies() {
    for (const TriangleFamily& family : hardTriangleFamilies()) {
        if (family.number == 0 || family.name == "denormals") continue;  // denormals: see below
        boost::unit_test::framework::current_auto_test_suite().add(boost::unit_test::make_test_case(
            [family] { checkFamily(family); }, caseName(family), __FILE__, __LINE__));
    }
    return true;
}
const bool registered = registerFamilies();

BOOST_AUTO_TEST_CASE(pairs_from_bug_reports_have_the_distance_that_they_state) {
    for (const KnownPair& known : knownTrianglePairs()) {
        checkAlone(known.pair, Pose{}, known.name);
        const ExactDistance truth = exactDistance(Pose{}, known.pair.a, known.pair.b);
        BOOST_TEST(truth.compare(known.distance * (1 - 1e-15)) >= 0, known.name);
        BOOST_TEST(truth.compare(known.distance * (1 + 1e-15)) <= 0, known.name);
    }
}

BOOST_AUTO_TEST_CASE(case_31_denormal_sizes_are_refused_by_name) {
    Random random(kSeed);
    const auto requireRefused = [](const auto& ask) {
        const std::string message = refusalBy(ask);
        BOOST_TEST(
            (holds(message, "largest coordinate") || holds(message, "the sizes of part and environment")),
            message);
    };
    for (const TriangleFamily& family : hardTriangleFamilies()) {
        if (family.name != "denormals") continue;
        for (int draw = 0; draw < 100; ++draw) {
            const TrianglePair pair = family.make(random), other = family.make(random);
            const Model small = Model::build(meshOf(pair.a)), alsoSmall = Model::build(meshOf(other.a)),
                        usual = Model::build(meshOf(pair.b));
            if (small.box().diagonal().norm() == 0) continue;  // a point may lie anywhere
            Workspace workspace;
            requireRefused([&] { collides(small, alsoSmall, Pose{}, workspace); });
            requireRefused([&] { distance(small, alsoSmall, Pose{}, {}, workspace); });
            if (usual.box().diagonal().norm() == 0) continue;
            requireRefused([&] { collides(small, usual, Pose{}, workspace); });
        }
    }
}

BOOST_AUTO_TEST_CASE(case_34_all_36_orders_of_corners_agree) {
    Random random(kSeed);
    constexpr int kOrders[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}};
    for (const TriangleFamily& family : hardTriangleFamilies()) {
        if (family.name == "denormals") continue;
        const TrianglePair pair = family.make(random);
        const ExactCase exact = exactCase(family.name, meshOf(pair.a), meshOf(pair.b), Pose{});
        for (const auto& i : kOrders) {
            for (const auto& j : kOrders) {
                ExactCase ordered = exact;
                ordered.part = meshOf({pair.a[i[0]], pair.a[i[1]], pair.a[i[2]]});
                ordered.environment = meshOf({pair.b[j[0]], pair.b[j[1]], pair.b[j[2]]});
                Workspace workspace;
                checkExactly(ordered, buildPair(ordered, BuildOptions{}), workspace);
            }
        }
    }
}

BOOST_AUTO_TEST_SUITE_END()
