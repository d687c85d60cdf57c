// Promises that all families of scenes keep; what one family promises beside them is in its own test.
#include <boost/test/data/monomorphic.hpp>
#include <boost/test/data/test_case.hpp>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "demos/scenes/scene_checks.h"
#include "demos/scenes/scenes.h"
#include "support/full_run.h"
#include "support/words.h"

BOOST_AUTO_TEST_SUITE(families_test)

using namespace clearway;
using namespace clearway::scenes;
using namespace clearway::testing;
namespace data = boost::unit_test::data;

using Counts = std::pair<std::size_t, std::size_t>;

struct Family {
    const char* name;
    std::vector<Counts> counts, largeCounts;  ///< triangles of part and environment to ask for
    std::vector<SceneOptions> scenes, furtherScenes;
    double widest;          ///< largest clearance that it takes, mm
    double tightShare = 0;  ///< least share of the path within 1.5 times the clearance; 0: not walked here
    double step = 5;        ///< longest step of the walk, mm
    bool hasSlivers = false;
    bool isPartFixed = false;  ///< the seed changes the environment alone
};

std::ostream& operator<<(std::ostream& out, const Family& family) {
    return out << family.name;
}

/// The form with CLEARWAY_FULL=1 alone tries largeCounts and furtherScenes.
std::vector<Family> families() {
    const std::vector<Counts> puzzles{{800, 800}, {1000, 1000}, {2000, 2000}, {2777, 2777}, {10000, 10000}};
    const std::vector<Counts> largePuzzles{{200000, 200000}};
    const std::vector<SceneOptions> puzzleScenes{
        kPuzzle, {3, 2000, 2000, 0.5}, {4, 2000, 2000, 10}, {9, 900, 900, 4}};
    const std::vector<SceneOptions> furtherPuzzles{{2, 2000, 2000, 2},     {5, 2000, 2000, 5},
                                                   {6, 2000, 2000, 2},     {7, 8000, 8000, 0.5},
                                                   {8, 20000, 20000, 0.3}, {10, 2000, 2000, 2}};
    std::vector<SceneOptions> cars{{3, 30000, 200000, 4}};
    for (const double clearance : {1.0, 2.0, 4.0, 8.0, 12.0}) {
        cars.push_back({3, 4000, 12000, clearance});
        cars.push_back({4, 20000, 150000, clearance});
    }
    std::vector<SceneOptions> bays{{1, 30000, 500000, 2}, kCembox};
    for (std::uint64_t seed = 1; seed <= 20; ++seed) bays.push_back({seed, 3600, 80000, seed == 2 ? 8. : 4.});
    for (std::uint64_t seed = 3; seed <= 8; ++seed) bays.push_back({seed, 8000, 90000, 1.0 * seed});
    for (std::uint64_t seed = 4; seed <= 10; ++seed) bays.push_back({seed, 8000, 120000, 8});
    return {{"tunnel-console-3",
             {{20000, 80000}},
             {{150000, 600000}},
             {{2, 28000, 120000, 25}, {5, 28000, 120000, 1}},
             {{3, 28000, 120000, 10}, {4, 28000, 120000, 2}},
             25,
             0.3,
             5,
             true},
            {"cembox-2",
             {{2500, 5000}, {3000, 20000}, {9000, 60000}},
             {{11000, 130000}, {30000, 500000}, {60000, 300000}},
             {{1, 3000, 6000, 4}, {3, 5000, 80000, 0.5}},
             bays,
             8,
             0.3,
             5,
             true},
            {"large-environment-2",
             {{3700, 10000}, {5000, 50000}, {11111, 99999}},
             {{150000, 700000}},
             {{1, 4000, 12000, 10}, {2, 3700, 10000, 2}},
             cars,
             12,
             0.3,
             20,
             true},
            {"puzzle-1", puzzles, largePuzzles, puzzleScenes, furtherPuzzles, 10, 0.5, 2},
            {"puzzle-2", puzzles, largePuzzles, puzzleScenes, furtherPuzzles, 10, 0.5, 2},
            {"boxes-1",
             {{12, 24}, {100, 700}, {101, 703}, {3000, 50000}},
             {{400000, 1000000}},
             {kBoxes, {5, 1000, 3000, 2}},
             {},
             20},
            {"peg-in-hole-1",
             {{2000, 2000}, {3400, 3400}, {18000, 18000}},
             {},
             {kPegInHole},
             {},
             10,
             0,
             5,
             false,
             true},
            {"apartment-1",
             {{3000, 8000}, {5100, 13600}, {27000, 72000}},
             {},
             {kApartment},
             {},
             70,
             0,
             5,
             false,
             true}};
}

std::vector<SceneOptions> scenesOf(const Family& family) {
    std::vector<SceneOptions> all = family.scenes;
    if (isFullRun()) all.insert(all.end(), family.furtherScenes.begin(), family.furtherScenes.end());
    return all;
}

GeneratedScene make(const Family& family, const SceneOptions& options) {
    return sceneNamed(family.name).make(options);
}

bool isSame(const Mesh& a, const Mesh& b) {
    return a.vertices == b.vertices && a.triangles == b.triangles;
}

BOOST_DATA_TEST_CASE(triangle_counts_are_reached_within_five_percent, data::make(families()), family) {
    std::vector<Counts> all = family.counts;
    if (isFullRun()) all.insert(all.end(), family.largeCounts.begin(), family.largeCounts.end());
    for (const auto& [part, environment] : all) {
        const GeneratedScene scene = make(family, {3, part, environment, family.scenes.front().clearance});
        BOOST_TEST_CONTEXT("asked for " << part << " and " << environment) {
            BOOST_TEST(scene.part.triangles.size() <= part);
            BOOST_TEST(scene.part.triangles.size() >= 0.95 * part);
            BOOST_TEST(scene.environment.triangles.size() <= environment);
            BOOST_TEST(scene.environment.triangles.size() >= 0.95 * environment);
        }
    }
}

BOOST_DATA_TEST_CASE(the_seed_alone_decides, data::make(families()), family) {
    SceneOptions options = family.scenes.front();
    const GeneratedScene one = make(family, options), again = make(family, options);
    options.seed += 1;
    const GeneratedScene other = make(family, options);
    BOOST_TEST(isSame(one.part, again.part));
    BOOST_TEST(isSame(one.environment, again.environment));
    BOOST_TEST(isSame(one.part, other.part) == family.isPartFixed);
    BOOST_TEST(!isSame(one.environment, other.environment));
}

/// The clearance of the path is proven along the whole way, also between the samples.
BOOST_DATA_TEST_CASE(components_are_named_closed_solids_of_floats_and_the_path_keeps_the_clearance_tightly,
                     data::make(families()), family) {
    for (const SceneOptions& options : scenesOf(family)) {
        const GeneratedScene scene = make(family, options);
        BOOST_TEST_CONTEXT("seed " << options.seed << ", " << options.partTriangles << " and "
                                   << options.environmentTriangles << ", clearance " << options.clearance) {
            for (const Mesh* mesh : {&scene.part, &scene.environment}) {
                testNamedClosedSolids(*mesh);
                if (family.hasSlivers) testSlivers(*mesh);
                for (const Vector3& v : mesh->vertices) BOOST_REQUIRE((v == v.cast<float>().cast<double>()));
            }
            BOOST_REQUIRE(scene.problem.volume.has_value());
            for (const PartState& state : scene.path)
                BOOST_TEST(scene.problem.volume->contains(state.position));
            BOOST_TEST((scene.problem.start.position == scene.path.front().position));
            BOOST_TEST((scene.problem.goal.position == scene.path.back().position));
            if (family.tightShare == 0) continue;
            const PathClearance walk =
                walkPath(scene, options.clearance, 1.5 * options.clearance, family.step);
            BOOST_TEST_MESSAGE(family.name << ": least " << walk.least << " mm, "
                                           << 100 * walk.tightLength / walk.length << " % tight, "
                                           << walk.samples << " samples");
            BOOST_TEST(walk.proven);
            BOOST_TEST(walk.tightLength >= family.tightShare * walk.length);
        }
    }
}

BOOST_DATA_TEST_CASE(what_cannot_be_made_is_refused_by_name, data::make(families()), family) {
    const SceneOptions good = family.scenes.front();
    const auto refused = [&](const SceneOptions& options, const std::string& what) {
        requireRefusedBy([&] { make(family, options); }, {what, "expected "});
    };
    refused({1, 10, good.environmentTriangles, good.clearance}, "part-triangles is 10,");
    refused({1, good.partTriangles, 10, good.clearance}, "environment-triangles is 10,");
    refused({1, 5000000, good.environmentTriangles, good.clearance}, "part-triangles is 5000000,");
    refused({1, good.partTriangles, 5000000, good.clearance}, "environment-triangles is 5000000,");
    for (const double clearance : {0.0, -3.0, 1.05 * family.widest, std::nan(""), 1e300})
        refused({1, good.partTriangles, good.environmentTriangles, clearance}, "clearance is ");
}

BOOST_AUTO_TEST_SUITE_END()
