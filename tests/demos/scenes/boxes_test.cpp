#include "demos/scenes/scenes.h"

#include <boost/test/unit_test.hpp>
#include <stdexcept>

#include "demos/scenes/scene_checks.h"
#include "support/convex_hull.h"
#include "support/oracle.h"

BOOST_AUTO_TEST_SUITE(boxes_test)

using namespace clearway;
using namespace clearway::scenes;
using namespace clearway::testing;

namespace {

bool sameMesh(const Mesh& a, const Mesh& b) {
    return a.vertices == b.vertices && a.triangles == b.triangles;
}

bool isRefused(const SceneOptions& options, const std::string& saying) {
    try {
        makeBoxes(options);
    } catch (const std::invalid_argument& error) {
        BOOST_TEST_INFO(error.what());
        return std::string(error.what()).find(saying) != std::string::npos;
    }
    return false;
}

/// The number of pairs of triangles that are as near as the nearest pair.
int tiesAt(const GeneratedScene& scene, const PartState& state, double nearest) {
    const MeshOracle oracle(scene.part, scene.environment);
    int ties = 0;
    for (std::size_t i = 0; i < scene.part.triangles.size(); ++i) {
        for (std::size_t j = 0; j < scene.environment.triangles.size(); ++j) {
            ties += oracle.pairDistance(poseOf(state), i, j) <= nearest * (1 + 1e-9);
        }
    }
    return ties;
}

BOOST_AUTO_TEST_CASE(triangle_counts_are_reached) {
    for (const auto& [part, environment] : {std::pair<std::size_t, std::size_t>(12, 24),
                                            {100, 700},
                                            {101, 703},
                                            {3000, 50000},
                                            {400000, 1000000}}) {
        const GeneratedScene scene = makeBoxes({1, part, environment, 2});
        BOOST_TEST(scene.part.triangles.size() <= part);
        BOOST_TEST(scene.part.triangles.size() + 3 >= part);
        BOOST_TEST(scene.environment.triangles.size() <= environment);
        BOOST_TEST(scene.environment.triangles.size() + 3 >= environment);
    }
}

BOOST_AUTO_TEST_CASE(the_seed_alone_decides) {
    const GeneratedScene one = makeBoxes(kBoxes), again = makeBoxes(kBoxes);
    BOOST_TEST(sameMesh(one.part, again.part));
    BOOST_TEST(sameMesh(one.environment, again.environment));
    SceneOptions options = kBoxes;
    options.seed = 2;
    BOOST_TEST(!sameMesh(one.part, makeBoxes(options).part));
}

BOOST_AUTO_TEST_CASE(every_box_is_a_named_closed_solid_with_float_coordinates) {
    const GeneratedScene scene = makeBoxes({5, 1000, 3000, 2});
    for (const Mesh* mesh : {&scene.part, &scene.environment}) {
        for (const Component& component : mesh->components) {
            BOOST_TEST_INFO(component.name);
            BOOST_TEST(isClosed(*mesh, component));
            BOOST_TEST(signedVolume(*mesh, component) > 0);
            BOOST_TEST(!component.name.empty());
        }
        for (const Vector3& v : mesh->vertices) BOOST_REQUIRE((v == v.cast<float>().cast<double>()));
    }
    BOOST_TEST(scene.environment.components.size() == 2);
}

/// The path is free along its whole length, and every step keeps the clearance. By the oracle, the distance
/// in the corner is the gap itself.
BOOST_AUTO_TEST_CASE(the_path_keeps_the_clearance_and_its_faces_parallel) {
    for (const double clearance : {0.01, 2.0, 20.0}) {
        const GeneratedScene scene = makeBoxes({3, 100, 700, clearance});
        for (const PartState& state : scene.path) BOOST_TEST((poseOf(state).rotation == Matrix3::Identity()));
        const PathClearance walk = walkPath(scene, 0.5 * clearance, 1.02 * clearance, 5);
        BOOST_TEST(walk.proven);
        BOOST_TEST(walk.least >= clearance);
        BOOST_TEST(walk.tightLength > 0.5 * walk.length);
        const MeshOracle oracle(scene.part, scene.environment);
        for (std::size_t i = 0; i + 1 < scene.path.size(); ++i) {
            for (const double t : {0.0, 0.3, 0.7}) {
                const PartState state = between(scene.path[i], scene.path[i + 1], t);
                const double distance = oracle.distance(poseOf(state)).distance;
                BOOST_TEST(distance >= clearance);
                if (i + 2 < scene.path.size()) BOOST_TEST(distance < 1.011 * clearance);
            }
        }
    }
}

BOOST_AUTO_TEST_CASE(many_pairs_of_triangles_are_equally_near) {
    const GeneratedScene scene = makeBoxes(kBoxes);
    const PartState state = between(scene.path[0], scene.path[1], 0.4);
    const double nearest = MeshOracle(scene.part, scene.environment).distance(poseOf(state)).distance;
    BOOST_TEST(tiesAt(scene, state, nearest) >= 50);
}

BOOST_AUTO_TEST_CASE(what_cannot_be_made_is_refused_by_name) {
    BOOST_TEST(isRefused({1, 11, 700, 2}, "part-triangles is 11, expected 12 to"));
    BOOST_TEST(isRefused({1, 100, 23, 2}, "environment-triangles is 23, expected 24 to"));
    BOOST_TEST(isRefused({1, 100, 5000000, 2}, "environment-triangles is 5000000, expected "));
    for (const double clearance : {0.0, -1.0, 20.5, std::nan("")}) {
        BOOST_TEST(isRefused({1, 100, 700, clearance}, "expected 0.01 to 20"));
    }
}

}  // namespace

BOOST_AUTO_TEST_SUITE_END()
