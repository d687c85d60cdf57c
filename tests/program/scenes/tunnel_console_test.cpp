#include "program/scenes/scenes.h"

#include <boost/test/data/monomorphic.hpp>
#include <boost/test/data/test_case.hpp>
#include <boost/test/unit_test.hpp>
#include <stdexcept>

#include "program/scenes/scene_checks.h"
#include "support/convex_hull.h"
#include "support/oracle.h"

using namespace clearway;
using namespace clearway::scenes;
using namespace clearway::testing;

namespace {

bool sameMesh(const Mesh& a, const Mesh& b) {
    return a.vertices == b.vertices && a.triangles == b.triangles &&
           a.components.size() == b.components.size();
}

/// The version is the row's in scenes.h.
GeneratedScene make(int version, const SceneOptions& options = kTunnelConsole) {
    return sceneNamed("tunnel-console-" + std::to_string(version)).make(options);
}

const auto kVersions = boost::unit_test::data::make({1, 2});

std::string refusal(int version, const SceneOptions& options) {
    try {
        make(version, options);
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
    return "not refused";
}

bool mentions(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

SceneOptions sized(std::size_t part, std::size_t environment, double clearance = 10, std::uint64_t seed = 1) {
    SceneOptions options;
    options.seed = seed;
    options.partTriangles = part;
    options.environmentTriangles = environment;
    options.clearance = clearance;
    return options;
}

BOOST_AUTO_TEST_SUITE(tunnel_console)  // its cases share names with other scenes' cases

BOOST_DATA_TEST_CASE(triangle_counts_are_reached_within_five_percent, kVersions, version) {
    for (const auto& [part, environment] : {std::pair<std::size_t, std::size_t>(2000, 8000),
                                            {2600, 9500},
                                            {5000, 20000},
                                            {20000, 61000},
                                            {73000, 300000}}) {
        const GeneratedScene scene = make(version, sized(part, environment));
        BOOST_TEST_INFO("asked for " << part << " and " << environment);
        BOOST_TEST(scene.part.triangles.size() <= part);
        BOOST_TEST(scene.part.triangles.size() >= 0.95 * part);
        BOOST_TEST(scene.environment.triangles.size() <= environment);
        BOOST_TEST(scene.environment.triangles.size() >= 0.95 * environment);
    }
}

BOOST_DATA_TEST_CASE(the_part_measures_900_mm, kVersions, version) {
    for (const std::uint64_t seed : {1, 2, 3, 4}) {
        const double diagonal =
            boundingBox(make(version, sized(2000, 8000, 10, seed)).part).diagonal().norm();
        BOOST_TEST(std::abs(diagonal - 900) < 10);
    }
}

BOOST_DATA_TEST_CASE(the_seed_alone_decides, kVersions, version) {
    const GeneratedScene one = make(version, sized(2000, 8000)), again = make(version, sized(2000, 8000));
    BOOST_TEST(sameMesh(one.part, again.part));
    BOOST_TEST(sameMesh(one.environment, again.environment));
    const GeneratedScene other = make(version, sized(2000, 8000, 10, 2));
    BOOST_TEST(!sameMesh(one.part, other.part));
    BOOST_TEST(!sameMesh(one.environment, other.environment));
}

BOOST_DATA_TEST_CASE(every_component_is_a_named_closed_solid,
                     kVersions*(boost::unit_test::data::make({2000, 30000, 30000, 4000}) ^
                                boost::unit_test::data::make({10, 10, 1, 25})),
                     version, triangles, clearance) {
    const GeneratedScene scene = make(version, sized(triangles, 4 * triangles, clearance));
    for (const Mesh* mesh : {&scene.part, &scene.environment}) {
        testNamedClosedSolids(*mesh);
    }
}

BOOST_DATA_TEST_CASE(coordinates_are_floats, kVersions, version) {
    const GeneratedScene scene = make(version);
    for (const Mesh* mesh : {&scene.part, &scene.environment}) {
        for (const Vector3& v : mesh->vertices) BOOST_REQUIRE((v == v.cast<float>().cast<double>()));
    }
}

BOOST_DATA_TEST_CASE(slivers_lie_beside_fine_roundings, kVersions, version) {
    const GeneratedScene scene = make(version);
    for (const Mesh* mesh : {&scene.part, &scene.environment}) {
        testSlivers(*mesh);
    }
}

BOOST_DATA_TEST_CASE(the_parts_convex_hull_has_at_least_twice_its_volume, kVersions, version) {
    const GeneratedScene scene = make(version);
    BOOST_TEST(signedVolume(convexHull(scene.part.vertices)) >= 2 * signedVolume(scene.part));
}

BOOST_DATA_TEST_CASE(the_problem_starts_inside_and_ends_outside, kVersions, version) {
    const GeneratedScene scene = make(version);
    const Problem& problem = scene.problem;
    BOOST_REQUIRE(problem.volume.has_value());
    for (const PartState& state : scene.path) BOOST_TEST(problem.volume->contains(state.position));
    BOOST_TEST((problem.start.position == scene.path.front().position));
    BOOST_TEST((problem.goal.position == scene.path.back().position));
    BOOST_TEST(problem.step.value() == 0.8);  // half of the skins' 1.6 mm

    Box tunnel;
    for (const Component& component : scene.environment.components) {
        if (component.name.rfind("tunnel_skin", 0) != 0) continue;
        for (std::uint32_t i = 0; i < component.triangleCount; ++i) {
            for (const Vector3& p : cornersOf(scene.environment, component.firstTriangle + i))
                tunnel.extend(p);
        }
    }
    Box atStart, atGoal;
    for (const Vector3& v : scene.part.vertices) {
        atStart.extend(poseOf(problem.start) * v);
        atGoal.extend(poseOf(problem.goal) * v);
    }
    BOOST_TEST(tunnel.contains(atStart));
    BOOST_TEST(!tunnel.intersects(atGoal));
}

BOOST_DATA_TEST_CASE(what_cannot_be_made_is_refused_by_name, kVersions, version) {
    BOOST_TEST(mentions(refusal(version, sized(100, 8000)), "part-triangles is 100, expected "));
    BOOST_TEST(mentions(refusal(version, sized(2000, 100)), "environment-triangles is 100, expected "));
    BOOST_TEST(mentions(refusal(version, sized(5000000, 8000)), "part-triangles is 5000000, expected "));
    for (const double clearance : {0.0, -3.0, 26.0, std::nan(""), 1e300}) {
        BOOST_TEST(mentions(refusal(version, sized(2000, 8000, clearance)), "clearance is "));
        BOOST_TEST(mentions(refusal(version, sized(2000, 8000, clearance)), ", expected 1 to 25"));
    }
    // A narrow gap needs more stations than so few triangles give.
    BOOST_TEST(mentions(refusal(version, sized(2000, 8000, 1)), "part-triangles is 2000, expected "));
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace
