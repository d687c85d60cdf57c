#include "program/scenes/scenes.h"

#include <boost/test/data/monomorphic.hpp>
#include <boost/test/data/test_case.hpp>
#include <boost/test/unit_test.hpp>
#include <cstdlib>
#include <stdexcept>

#include "program/scenes/component_checks.h"
#include "program/scenes/scene_checks.h"
#include "support/convex_hull.h"
#include "support/oracle.h"

using namespace clearway;
using namespace clearway::scenes;
using namespace clearway::testing;
namespace data = boost::unit_test::data;

namespace {

constexpr SceneOptions kSmall{1, 5000, 40000, 4};

/// Made once.
const GeneratedScene& smallScene() {
    static const GeneratedScene scene = makeLargeEnvironment(kSmall);
    return scene;
}

bool isFull() {
    const char* full = std::getenv("CLEARWAY_FULL");
    return full != nullptr && std::string(full) == "1";
}

bool same(const Mesh& a, const Mesh& b) {
    return a.vertices == b.vertices && a.triangles == b.triangles;
}

std::string refusal(const SceneOptions& options) {
    try {
        makeLargeEnvironment(options);
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
    return "not refused";
}

bool begins(const std::string& text, const std::string& with) {
    return text.rfind(with, 0) == 0;
}

BOOST_AUTO_TEST_SUITE(large_environment)  // its cases share names with other scenes' cases

BOOST_AUTO_TEST_CASE(triangle_counts_are_reached_within_five_percent) {
    for (const auto& [part, environment] : {std::pair<std::size_t, std::size_t>(4000, 32000),
                                            {5000, 40000},
                                            {11111, 99999},
                                            {30000, 300000},
                                            {100000, 1700000},
                                            {150000, 1700000}}) {
        const GeneratedScene scene = makeLargeEnvironment({1, part, environment, 4});
        BOOST_TEST_CONTEXT("asked for " << part << " and " << environment) {
            BOOST_TEST(scene.part.triangles.size() <= part);
            BOOST_TEST(scene.part.triangles.size() >= 0.95 * part);
            BOOST_TEST(scene.environment.triangles.size() <= environment);
            BOOST_TEST(scene.environment.triangles.size() >= 0.95 * environment);
        }
    }
}

BOOST_AUTO_TEST_CASE(the_car_and_the_carrier_have_their_sizes) {
    const Vector3 car = boundingBox(smallScene().environment).sizes(),
                  carrier = boundingBox(smallScene().part).sizes();
    BOOST_TEST((car - Vector3(3900, 1600, 1300)).cwiseAbs().maxCoeff() < 50);
    BOOST_TEST((carrier - Vector3(355, 1080, 550)).cwiseAbs().maxCoeff() < 10);
}

BOOST_AUTO_TEST_CASE(the_seed_alone_decides) {
    const GeneratedScene again = makeLargeEnvironment(kSmall),
                         other = makeLargeEnvironment({2, 5000, 40000, 4});
    BOOST_TEST(same(smallScene().part, again.part));
    BOOST_TEST(same(smallScene().environment, again.environment));
    BOOST_TEST(!same(smallScene().part, other.part));
    BOOST_TEST(!same(smallScene().environment, other.environment));
}

BOOST_DATA_TEST_CASE(every_component_is_a_named_closed_solid, data::make({4000, 30000}), triangles) {
    const GeneratedScene scene =
        makeLargeEnvironment({3, static_cast<std::size_t>(triangles), 8u * triangles, 4});
    for (const Mesh* mesh : {&scene.part, &scene.environment}) {
        testNamedClosedSolids(*mesh);
        for (const Vector3& v : mesh->vertices) BOOST_REQUIRE((v == v.cast<float>().cast<double>()));
    }
}

/// Coarser, layers a few millimetres apart would meet at their chords.
BOOST_AUTO_TEST_CASE(no_two_components_touch_when_the_sheets_are_fine) {
    const SceneOptions options = isFull() ? kLargeEnvironment : SceneOptions{3, 40000, 600000, 12};
    const GeneratedScene scene = makeLargeEnvironment(options);
    BOOST_TEST(touchingComponents(scene.part) == std::vector<std::string>{},
               boost::test_tools::per_element());
    BOOST_TEST(touchingComponents(scene.environment) == std::vector<std::string>{},
               boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(sheets_follow_each_other_a_few_millimetres_apart) {
    const GeneratedScene scene = makeLargeEnvironment({1, 20000, 600000, 4});
    std::map<std::string, Model> sheets;
    for (const Component& component : scene.environment.components) {
        sheets.emplace(component.name, Model::build(only(scene.environment, component), buildPreset("fast")));
    }
    Workspace workspace;
    for (const auto& [one, other] : {std::pair("floor_pan", "damping_mat_2_right"),
                                     {"damping_mat_2_right", "underlay_2_right"},
                                     {"dash_panel", "dash_insulation_cabin"},
                                     {"b_pillar_reinforcement_left", "b_pillar_patch_left"},
                                     {"bodyside_outer_left", "b_pillar_reinforcement_left"},
                                     {"roof_skin", "roof_damping_2"},
                                     {"wheel_house_front_right", "wheel_house_liner_front_right"}}) {
        const double apart = distance(sheets.at(one), sheets.at(other), {}, {}, workspace).distance;
        BOOST_TEST_CONTEXT(one << " and " << other) {
            BOOST_TEST(apart > 0);
            BOOST_TEST(apart < 6);
        }
    }
}

BOOST_AUTO_TEST_CASE(slivers_lie_beside_fine_roundings) {
    for (const Mesh* mesh : {&smallScene().part, &smallScene().environment}) {
        testSlivers(*mesh);
    }
}

/// Proven along the whole way, in between the samples too.
BOOST_AUTO_TEST_CASE(the_constructed_path_keeps_the_clearance_and_ends_tight) {
    std::vector<SceneOptions> cases{kSmall, {2, 5000, 40000, 1}, {3, 4000, 32000, 12}, {4, 10000, 90000, 6}};
    if (isFull()) {
        for (std::uint64_t seed = 5; seed <= 12; ++seed) cases.push_back({seed, 10000, 80000, 1.0 * seed});
        cases.push_back(kLargeEnvironment);
    }
    for (const SceneOptions& options : cases) {
        const double tight = 1.25 * options.clearance;
        const PathClearance walk = walkPath(makeLargeEnvironment(options), options.clearance, tight, 20);
        BOOST_TEST_CONTEXT("seed " << options.seed << ", clearance " << options.clearance << ": least "
                                   << walk.least << " mm, tight for " << walk.tightLength << " of "
                                   << walk.length << " mm, " << walk.samples << " samples") {
            BOOST_TEST(walk.proven);
            BOOST_TEST(walk.least < tight);
            BOOST_TEST(walk.tightLength >= 80);
        }
    }
}

BOOST_AUTO_TEST_CASE(the_oracle_finds_no_less_clearance_on_the_path) {
    const GeneratedScene& scene = smallScene();
    const MeshOracle oracle(scene.part, scene.environment);
    for (std::size_t i = 0; i + 1 < scene.path.size(); ++i) {
        for (const double t : {0.0, 0.5}) {
            const PartState state = between(scene.path[i], scene.path[i + 1], t);
            BOOST_TEST(oracle.distance(poseOf(state)).distance >= kSmall.clearance);
        }
    }
    BOOST_TEST(oracle.distance(poseOf(scene.path.back())).distance >= kSmall.clearance);
}

BOOST_AUTO_TEST_CASE(the_straight_motion_to_the_goal_collides) {
    const GeneratedScene& scene = smallScene();
    const Model part = Model::build(scene.part), environment = Model::build(scene.environment);
    Workspace workspace;
    int collisions = 0;
    for (int i = 0; i < 100; ++i) {
        const PartState state = between(scene.path.front(), scene.path.back(), (i + 0.5) / 100);
        collisions += collides(part, environment, poseOf(state), workspace);
    }
    BOOST_TEST(collisions >= 20);
}

BOOST_AUTO_TEST_CASE(the_problem_leads_from_outside_to_the_place) {
    const GeneratedScene& scene = smallScene();
    BOOST_REQUIRE(scene.problem.volume.has_value());
    for (const PartState& state : scene.path) BOOST_TEST(scene.problem.volume->contains(state.position));
    BOOST_TEST((scene.problem.start.position == scene.path.front().position));
    BOOST_TEST((scene.problem.goal.position == scene.path.back().position));
    Box atStart, atGoal;
    for (const Vector3& v : scene.part.vertices) {
        atStart.extend(poseOf(scene.problem.start) * v);
        atGoal.extend(poseOf(scene.problem.goal) * v);
    }
    const Box car = boundingBox(scene.environment);
    BOOST_TEST(!car.intersects(atStart));
    BOOST_TEST(car.contains(atGoal));
}

BOOST_AUTO_TEST_CASE(what_cannot_be_made_is_refused_by_name) {
    BOOST_TEST(begins(refusal({1, 100, 80000, 4}), "part-triangles is 100, expected "));
    BOOST_TEST(begins(refusal({1, 10000, 100, 4}), "environment-triangles is 100, expected "));
    BOOST_TEST(begins(refusal({1, 10000, 4000001, 4}), "environment-triangles is 4000001, expected "));
    for (const double clearance : {0.0, -3.0, 12.5, std::nan(""), 1e300}) {
        BOOST_TEST(begins(refusal({1, 10000, 80000, clearance}), "clearance is "));
    }
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace
