#include "demos/scenes/scenes.h"

#include <boost/test/data/monomorphic.hpp>
#include <boost/test/data/test_case.hpp>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <string>
#include <vector>

#include "demos/scenes/scene_checks.h"

BOOST_AUTO_TEST_SUITE(puzzle_test)

using namespace clearway;
using namespace clearway::scenes;
using namespace clearway::testing;
namespace data = boost::unit_test::data;

SceneOptions with(std::uint64_t seed, std::size_t triangles, double clearance) {
    return {seed, triangles, triangles, clearance};
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

BOOST_AUTO_TEST_SUITE_END()
