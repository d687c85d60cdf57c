#include "demos/scenes/scenes.h"

#include <boost/test/data/monomorphic.hpp>
#include <boost/test/data/test_case.hpp>
#include <boost/test/unit_test.hpp>
#include <stdexcept>
#include <vector>

#include "demos/scenes/scene_checks.h"
#include "support/convex_hull.h"
#include "support/full_run.h"
#include "support/oracle.h"

BOOST_AUTO_TEST_SUITE(puzzle_test)

using namespace clearway;
using namespace clearway::scenes;
using namespace clearway::testing;
namespace data = boost::unit_test::data;

namespace {

SceneOptions with(std::uint64_t seed, std::size_t triangles, double clearance) {
    return {seed, triangles, triangles, clearance};
}

bool same(const Mesh& a, const Mesh& b) {
    return a.vertices == b.vertices && a.triangles == b.triangles;
}

/// Makes this version of the puzzle.
GeneratedScene make(int version, const SceneOptions& options) {
    return sceneNamed("puzzle-" + std::to_string(version)).make(options);
}

const auto kVersions = data::make({1, 2});

/// The bar's triangles between two shares of them. The triangles stand in the order of the bar's length.
Mesh stretch(const Mesh& bar, double from, double to) {
    Mesh some;
    some.vertices = bar.vertices;
    const auto at = [&](double share) {
        return bar.triangles.begin() +
               static_cast<std::ptrdiff_t>(share * static_cast<double>(bar.triangles.size()));
    };
    some.triangles.assign(at(from), at(to));
    return some;
}

std::string refusal(int version, const SceneOptions& options) {
    try {
        make(version, options);
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
    return "not refused";
}

bool begins(const std::string& text, const std::string& with) {
    return text.rfind(with, 0) == 0;
}

BOOST_DATA_TEST_CASE(triangle_counts_are_reached_within_five_percent,
                     kVersions* data::make<std::size_t>({800, 1000, 2000, 2777, 10000, 200000}), version,
                     triangles) {
    const GeneratedScene scene = make(version, with(1, triangles, 2));
    for (const Mesh* mesh : {&scene.part, &scene.environment}) {
        BOOST_TEST(mesh->triangles.size() <= triangles);
        BOOST_TEST(mesh->triangles.size() >= 0.95 * triangles);
    }
}

BOOST_DATA_TEST_CASE(the_seed_alone_decides, kVersions, version) {
    const GeneratedScene one = make(version, kPuzzle), again = make(version, kPuzzle),
                         other = make(version, with(2, 2000, 2));
    BOOST_TEST(same(one.part, again.part));
    BOOST_TEST(same(one.environment, again.environment));
    BOOST_TEST(!same(one.part, other.part));
    BOOST_TEST(!same(one.environment, other.environment));
}

BOOST_DATA_TEST_CASE(both_bars_are_closed_solids_with_float_coordinates, kVersions* data::xrange(1, 9),
                     version, seed) {
    const GeneratedScene scene = make(version, with(seed, 2000, 2));
    for (const Mesh* mesh : {&scene.part, &scene.environment}) {
        BOOST_REQUIRE(mesh->components.size() == 1);
        BOOST_TEST(!mesh->components[0].name.empty());
        BOOST_TEST(isClosed(*mesh, mesh->components[0]));
        BOOST_TEST(signedVolume(*mesh) > 0);
        for (const Vector3& v : mesh->vertices) BOOST_REQUIRE((v == v.cast<float>().cast<double>()));
    }
}

BOOST_DATA_TEST_CASE(in_version_2_the_gap_of_a_loop_is_open_and_narrower_than_a_bar,
                     data::xrange(1, 9) * data::make({0.1, 2.0, 10.0}), seed, clearance) {
    const GeneratedScene scene = make(2, with(seed, 4000, clearance));
    Workspace workspace;
    for (const Mesh* bar : {&scene.part, &scene.environment}) {
        // Loops have more than half of the triangles. The triangles of both ends come last.
        const Model beginning = Model::build(stretch(*bar, 0, 0.1)),
                    rest = Model::build(stretch(*bar, 0.4, 0.98));
        const double gap = distance(beginning, rest, {}, {}, workspace).distance;
        BOOST_TEST(gap >= 3);
        BOOST_TEST(gap < 5);
    }
}

/// The clearance is proven along the whole way, also between the samples. Most of the way leads through the
/// eye.
BOOST_DATA_TEST_CASE(the_constructed_path_keeps_the_clearance_and_is_tight_for_most_of_it, kVersions,
                     version) {
    std::vector<SceneOptions> all{kPuzzle, with(3, 2000, 0.5), with(4, 2000, 10), with(9, 900, 4)};
    if (isFullRun()) {
        all.insert(all.end(), {with(2, 2000, 2), with(5, 2000, 5), with(6, 2000, 2), with(7, 8000, 0.5),
                               with(8, 20000, 0.3), with(10, 2000, 2)});
    }
    for (const SceneOptions& options : all) {
        const GeneratedScene scene = make(version, options);
        const double tight = 1.5 * options.clearance;
        const PathClearance walk = walkPath(scene, options.clearance, tight, 2);
        BOOST_TEST_CONTEXT("seed " << options.seed << ", clearance " << options.clearance << ": least "
                                   << walk.least << " mm, " << 100 * walk.tightLength / walk.length
                                   << " % tight") {
            BOOST_TEST(walk.proven);
            BOOST_TEST(walk.tightLength >= 0.5 * walk.length);
            BOOST_TEST(walk.least < 1.3 * options.clearance);
        }
    }
}

BOOST_DATA_TEST_CASE(the_oracle_finds_no_less_clearance_on_the_path, kVersions, version) {
    const GeneratedScene scene = make(version, kPuzzle);
    const MeshOracle oracle(scene.part, scene.environment);
    for (const PartState& state : scene.path)
        BOOST_TEST(oracle.distance(poseOf(state)).distance >= kPuzzle.clearance);
}

/// Straight pulls in many directions collide. The only free way that was built leads through the eye.
BOOST_DATA_TEST_CASE(no_straight_motion_frees_the_part, kVersions* data::xrange(1, 6), version, seed) {
    const GeneratedScene scene = make(version, with(seed, 2000, 2));
    const Model part = Model::build(scene.part), environment = Model::build(scene.environment);
    Workspace workspace;
    for (double height = -0.99; height < 1; height += 0.11) {
        for (double turn = 0; turn < 2 * M_PI; turn += 0.2) {
            const double level = std::sqrt(1 - height * height);
            const Vector3 direction(level * std::cos(turn), level * std::sin(turn), height);
            bool collided = false;
            for (double length = 2; length < 250 && !collided; length += 4) {
                PartState state = scene.problem.start;
                state.position += length * direction;
                collided = collides(part, environment, poseOf(state), workspace);
            }
            BOOST_TEST(collided);
        }
    }
}

BOOST_DATA_TEST_CASE(the_goal_is_free_of_the_other_bar, kVersions, version) {
    for (const std::uint64_t seed : {1, 2, 3, 4, 5}) {
        const GeneratedScene scene = make(version, with(seed, 2000, 2));
        Box atGoal;
        for (const Vector3& v : scene.part.vertices) atGoal.extend(poseOf(scene.problem.goal) * v);
        BOOST_TEST(!atGoal.intersects(boundingBox(scene.environment)));
        BOOST_REQUIRE(scene.problem.volume.has_value());
        for (const PartState& state : scene.path) BOOST_TEST(scene.problem.volume->contains(state.position));
    }
}

BOOST_DATA_TEST_CASE(what_cannot_be_made_is_refused_by_name, kVersions, version) {
    SceneOptions few = kPuzzle, many = kPuzzle;
    few.partTriangles = 100;
    many.environmentTriangles = 4000001;
    BOOST_TEST(begins(refusal(version, few), "part-triangles is 100, expected "));
    BOOST_TEST(begins(refusal(version, many), "environment-triangles is 4000001, expected "));
    for (const double clearance : {0.0, -1.0, 10.5, std::nan(""), 1e300}) {
        BOOST_TEST(begins(refusal(version, with(1, 2000, clearance)), "clearance is "));
    }
}

}  // namespace

BOOST_AUTO_TEST_SUITE_END()
