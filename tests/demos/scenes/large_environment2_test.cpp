#include <boost/test/unit_test.hpp>
#include <cmath>
#include <cstdlib>
#include <map>
#include <stdexcept>

#include "demos/scenes/component_checks.h"
#include "demos/scenes/roof_slot.h"
#include "demos/scenes/scene_checks.h"
#include "demos/scenes/scenes.h"
#include "support/full_run.h"
#include "support/oracle.h"

BOOST_AUTO_TEST_SUITE(large_environment2_test)

using namespace clearway;
using namespace clearway::scenes;
using namespace clearway::testing;

namespace {

constexpr SceneOptions kSmall{1, 4000, 12000, 10};

/// The small scene, made once.
const GeneratedScene& smallScene() {
    static const GeneratedScene scene = makeLargeEnvironment2(kSmall);
    return scene;
}

std::string refusal(const SceneOptions& options) {
    try {
        makeLargeEnvironment2(options);
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
    return "not refused";
}

bool begins(const std::string& text, const std::string& with) {
    return text.rfind(with, 0) == 0;
}

const Component& named(const Mesh& mesh, const std::string& name) {
    for (const Component& component : mesh.components) {
        if (component.name == name) return component;
    }
    throw std::runtime_error("no component '" + name + "'");
}

/// The mean number of volume tests of exact distances at poses evenly along the path. Each search begins with
/// the pair that the previous one found.
double meanVolumeTests(const GeneratedScene& scene) {
    const Model part = Model::build(scene.part, buildPreset("fast")),
                environment = Model::build(scene.environment, buildPreset("fast"));
    Workspace workspace;
    constexpr int kPoses = 60;
    double tests = 0;
    for (int i = 0; i < kPoses; ++i) {
        const double at = (i + 0.5) / kPoses * static_cast<double>(scene.path.size() - 1);
        const auto leg = static_cast<std::size_t>(at);
        const PartState state = between(scene.path[leg], scene.path[leg + 1], at - static_cast<double>(leg));
        tests += static_cast<double>(
            distance(part, environment, poseOf(state), {}, workspace).counters.volumeTests);
    }
    return tests / kPoses;
}

BOOST_AUTO_TEST_CASE(triangle_counts_are_reached_within_five_percent) {
    for (const auto& [part, environment] : {std::pair<std::size_t, std::size_t>(3700, 10000),
                                            {5000, 50000},
                                            {11111, 99999},
                                            {150000, 700000}}) {
        const GeneratedScene scene = makeLargeEnvironment2({1, part, environment, 10});
        BOOST_TEST_CONTEXT("asked for " << part << " and " << environment) {
            BOOST_TEST(scene.part.triangles.size() <= part);
            BOOST_TEST(scene.part.triangles.size() >= 0.95 * part);
            BOOST_TEST(scene.environment.triangles.size() <= environment);
            BOOST_TEST(scene.environment.triangles.size() >= 0.95 * environment);
        }
    }
}

BOOST_AUTO_TEST_CASE(every_component_is_a_named_closed_solid) {
    for (const SceneOptions& options : {kSmall, SceneOptions{3, 30000, 200000, 4}}) {
        const GeneratedScene scene = makeLargeEnvironment2(options);
        for (const Mesh* mesh : {&scene.part, &scene.environment}) {
            testNamedClosedSolids(*mesh);
            testSlivers(*mesh);
            for (const Vector3& v : mesh->vertices) BOOST_REQUIRE((v == v.cast<float>().cast<double>()));
        }
    }
}

BOOST_AUTO_TEST_CASE(the_part_has_the_size_that_clearances_are_stated_for) {
    const Vector3 sizes = boundingBox(smallScene().part).sizes();
    BOOST_TEST(std::abs(sizes.x() - 880) < 10);
    BOOST_TEST(std::abs(sizes.y() - 880) < 10);
}

BOOST_AUTO_TEST_CASE(the_seed_alone_decides) {
    const GeneratedScene again = makeLargeEnvironment2(kSmall);
    BOOST_TEST((smallScene().part.vertices == again.part.vertices));
    BOOST_TEST((smallScene().environment.vertices == again.environment.vertices));
    const GeneratedScene other = makeLargeEnvironment2({2, 4000, 12000, 10});
    BOOST_TEST((smallScene().part.vertices != other.part.vertices));
    BOOST_TEST((smallScene().environment.vertices != other.environment.vertices));
}

/// The clearance is proven along the whole way, also between the samples, at any fineness, although facing
/// sheets are cut into different triangles.
BOOST_AUTO_TEST_CASE(the_constructed_path_keeps_the_clearance_and_is_tight_for_three_tenths) {
    std::vector<SceneOptions> cases{kSmall, {2, 3700, 10000, 2}};
    if (isFullRun()) {
        for (const double clearance : {1.0, 2.0, 4.0, 8.0, 12.0}) {
            cases.push_back({3, 4000, 12000, clearance});
            cases.push_back({4, 20000, 150000, clearance});
        }
    }
    for (const SceneOptions& options : cases) {
        const double tight = 1.5 * options.clearance;
        const PathClearance walk = walkPath(makeLargeEnvironment2(options), options.clearance, tight, 20);
        BOOST_TEST_CONTEXT("seed " << options.seed << ", clearance " << options.clearance << ": least "
                                   << walk.least << " mm, tight for " << walk.tightLength << " of "
                                   << walk.length << " mm, " << walk.samples << " samples") {
            BOOST_TEST(walk.proven);
            BOOST_TEST(walk.tightLength >= 0.3 * walk.length);
        }
    }
}

BOOST_AUTO_TEST_CASE(both_sheets_of_the_tray_are_as_near_to_those_that_face_them) {
    const GeneratedScene& scene = smallScene();
    const auto model = [](const Mesh& mesh, const std::string& name) {
        return Model::build(only(mesh, named(mesh, name)), buildPreset("fast"));
    };
    Workspace workspace;
    const Pose start = poseOf(scene.path.front());
    const double above = distance(model(scene.part, "upper_sheet"),
                                  model(scene.environment, "roof_inner_sheet"), start, {}, workspace)
                             .distance,
                 below = distance(model(scene.part, "lower_sheet"),
                                  model(scene.environment, "lining_carrier"), start, {}, workspace)
                             .distance;
    BOOST_TEST(above >= kSmall.clearance);
    BOOST_TEST(below >= kSmall.clearance);
    BOOST_TEST(above <= 1.5 * kSmall.clearance);
    BOOST_TEST(below <= 1.5 * kSmall.clearance);
}

/// Only screws touch other components. With CLEARWAY_FULL=1 the whole car is at full size: at coarser sizes,
/// layers a few millimetres apart meet at their chords.
BOOST_AUTO_TEST_CASE(no_two_components_but_bolts_touch_when_the_sheets_are_fine) {
    const GeneratedScene scene = makeLargeEnvironment2({3, 60000, isFullRun() ? 1700000u : 100000u, 10});
    std::vector<std::string> pairs = touchingComponents(scene.part);
    if (isFullRun()) {
        for (const std::string& pair : touchingComponents(scene.environment)) pairs.push_back(pair);
    }
    for (const std::string& pair : pairs) {
        if (pair.find("bolt") == std::string::npos) BOOST_ERROR(pair);
    }
}

BOOST_AUTO_TEST_CASE(sheets_follow_each_other_a_few_millimetres_apart) {
    const GeneratedScene scene = makeLargeEnvironment2({1, 20000, 600000, 4});
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

BOOST_AUTO_TEST_CASE(straight_motions_out_of_the_slot_collide) {
    const GeneratedScene& scene = smallScene();
    const Model part = Model::build(scene.part), environment = Model::build(scene.environment);
    Workspace workspace;
    int toGoal = 0, back = 0;
    for (int i = 0; i < 100; ++i) {
        const double t = (i + 0.5) / 100;
        toGoal +=
            collides(part, environment, poseOf(between(scene.path.front(), scene.path.back(), t)), workspace);
        PartState pulled = scene.path.front();
        pulled.position.x() += 1500 * t;
        back += collides(part, environment, poseOf(pulled), workspace);
    }
    BOOST_TEST(toGoal >= 20);
    BOOST_TEST(back >= 20);
}

/// Sheets that follow each other let a search prune little.
BOOST_AUTO_TEST_CASE(it_takes_more_volume_tests_a_query_than_the_other_families) {
    const double own = meanVolumeTests(makeLargeEnvironment2({1, 15000, 120000, 10}));
    for (const char* name : {"tunnel-console-3", "cembox-2"}) {
        const NamedScene& scene = sceneNamed(name);
        SceneOptions options = scene.defaults;
        options.partTriangles = 15000;
        options.environmentTriangles = 120000;
        const double other = meanVolumeTests(scene.make(options));
        BOOST_TEST_CONTEXT(name << ": " << other << " tests, " << own << " here") {
            BOOST_TEST(own > 2 * other);
        }
    }
}

BOOST_AUTO_TEST_CASE(the_oracle_finds_no_less_clearance_on_the_path) {
    const GeneratedScene& scene = smallScene();
    const MeshOracle oracle(scene.part, scene.environment);
    for (std::size_t i = 0; i + 1 < scene.path.size(); i += isFullRun() ? 4 : 12) {
        for (const double t : {0.0, 0.5}) {
            const PartState state = between(scene.path[i], scene.path[i + 1], t);
            BOOST_TEST(oracle.distance(poseOf(state)).distance >= kSmall.clearance);
        }
    }
    BOOST_TEST(oracle.distance(poseOf(scene.path.back())).distance >= kSmall.clearance);
}

BOOST_AUTO_TEST_CASE(what_cannot_be_made_is_refused_by_name) {
    BOOST_TEST(begins(refusal({1, 100, 80000, 4}), "part-triangles is 100, expected "));
    BOOST_TEST(begins(refusal({1, 10000, 100, 4}), "environment-triangles is 100, expected "));
    BOOST_TEST(begins(refusal({1, 10000, 4000001, 4}), "environment-triangles is 4000001, expected "));
    for (const double clearance : {0.0, -3.0, 12.5, std::nan(""), 1e300}) {
        BOOST_TEST(begins(refusal({1, 10000, 80000, clearance}), "clearance is "));
    }
}

}  // namespace

BOOST_AUTO_TEST_SUITE_END()
