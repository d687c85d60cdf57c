#include <boost/test/unit_test.hpp>
#include <cmath>
#include <map>
#include <stdexcept>

#include "demos/scenes/roof_slot.h"
#include "demos/scenes/scene_checks.h"
#include "demos/scenes/scenes.h"
#include "mesh/components.h"
#include "support/full_run.h"

BOOST_AUTO_TEST_SUITE(large_environment2_test)

using namespace clearway;
using namespace clearway::scenes;
using namespace clearway::testing;

constexpr SceneOptions kSmall{1, 4000, 12000, 10};

/// The small scene, made once.
const GeneratedScene& smallScene() {
    static const GeneratedScene scene = makeLargeEnvironment2(kSmall);
    return scene;
}

Mesh named(const Mesh& mesh, const std::string& name) {
    for (std::size_t i = 0; i < mesh.components.size(); ++i) {
        if (mesh.components[i].name == name) return meshOfComponents(mesh, {i});
    }
    throw std::runtime_error("no component '" + name + "'");
}

/// The pairs of components that touch, each as "a x b".
std::vector<std::string> touchingComponents(const Mesh& mesh) {
    std::vector<Model> models;
    for (std::size_t i = 0; i < mesh.components.size(); ++i)
        models.push_back(Model::build(meshOfComponents(mesh, {i})));
    Workspace workspace;
    std::vector<std::string> touching;
    for (std::size_t i = 0; i < models.size(); ++i) {
        for (std::size_t k = i + 1; k < models.size(); ++k) {
            if (!models[i].box().intersects(models[k].box())) continue;
            if (!collides(models[i], models[k], {}, workspace)) continue;
            touching.push_back(mesh.components[i].name + " x " + mesh.components[k].name);
        }
    }
    return touching;
}

/// The mean number of volume tests of exact distances at poses evenly along the path. Each search begins with
/// the pair that the previous one found.
double meanVolumeTests(const GeneratedScene& scene) {
    const Model part = Model::build(scene.part), environment = Model::build(scene.environment);
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

BOOST_AUTO_TEST_CASE(the_part_has_the_size_that_clearances_are_stated_for) {
    const Vector3 sizes = boundingBox(smallScene().part).sizes();
    BOOST_TEST(std::abs(sizes.x() - 880) < 10);
    BOOST_TEST(std::abs(sizes.y() - 880) < 10);
}

BOOST_AUTO_TEST_CASE(both_sheets_of_the_tray_are_as_near_to_those_that_face_them) {
    const GeneratedScene& scene = smallScene();
    const auto model = [](const Mesh& mesh, const std::string& name) {
        return Model::build(named(mesh, name));
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
    for (std::size_t i = 0; i < scene.environment.components.size(); ++i) {
        const Mesh sheet = meshOfComponents(scene.environment, {i});
        sheets.emplace(sheet.components[0].name, Model::build(sheet));
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
    PartState pulled = scene.path.front();
    pulled.position.x() += 1500;
    for (const PartState& end : {scene.path.back(), pulled})
        BOOST_TEST(collidingShare(part, environment, scene.path.front(), end) >= 0.2);
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

BOOST_AUTO_TEST_SUITE_END()
