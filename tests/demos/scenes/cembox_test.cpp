#include "demos/scenes/cembox.h"

#include <boost/test/data/monomorphic.hpp>
#include <boost/test/data/test_case.hpp>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <map>
#include <ostream>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "demos/scenes/scene_checks.h"
#include "demos/scenes/scenes.h"
#include "support/full_run.h"

namespace clearway::scenes {

std::ostream& operator<<(std::ostream& out, const SceneOptions& options) {
    return out << "seed " << options.seed << ", " << options.partTriangles << " / "
               << options.environmentTriangles << ", clearance " << options.clearance;
}

}  // namespace clearway::scenes

BOOST_AUTO_TEST_SUITE(cembox_test)

using namespace clearway;
using namespace clearway::scenes;
using namespace clearway::testing;

/// From a scene that leaves out most components to one with all large ones.
constexpr SceneOptions kSmall{1, 3000, 6000, 4}, kRich{3, 5000, 80000, 0.5};

/// The scenes to test; more with CLEARWAY_FULL=1.
std::vector<SceneOptions> cases() {
    std::vector<SceneOptions> all{kSmall, kRich};
    if (!isFullRun()) return all;
    for (std::uint64_t seed = 1; seed <= 20; ++seed)
        all.push_back({seed, 3600, 80000, seed == 2 ? 8.0 : 4.0});
    for (std::uint64_t seed = 4; seed <= 10; ++seed) all.push_back({seed, 8000, 120000, 8});
    all.push_back({1, 30000, 500000, 2});
    all.push_back(kCembox);
    return all;
}

/// Each scene is made once, because most tests look at all of them.
const GeneratedScene& sceneOf(const SceneOptions& options) {
    static std::map<std::string, GeneratedScene> made;
    std::ostringstream name;
    name << options;
    const auto found = made.find(name.str());
    return found != made.end() ? found->second : made.emplace(name.str(), makeCembox2(options)).first->second;
}

std::set<std::string> namesOf(const Mesh& mesh) {
    std::set<std::string> names;
    for (const Component& component : mesh.components) names.insert(component.name);
    return names;
}

BOOST_AUTO_TEST_CASE(many_components_have_flat_faces_beside_fine_roundings) {
    const GeneratedScene& scene = sceneOf(kRich);
    BOOST_TEST(scene.part.components.size() > 60);
    BOOST_TEST(scene.environment.components.size() > 300);
    double longest = 0;
    for (std::size_t i = 0; i < scene.environment.triangles.size(); ++i) {
        const auto [a, b, c] = cornersOf(scene.environment, i);
        longest = std::max({longest, (b - a).norm(), (c - b).norm(), (a - c).norm()});
    }
    // A flat face is two triangles.
    BOOST_TEST(longest > 0.5 * boundingBox(scene.environment).sizes().minCoeff());
}

/// The bay leaves room for the envelope, so the envelope must hold the module.
BOOST_AUTO_TEST_CASE(the_module_measures_between_300_and_400_mm_and_stays_in_its_envelope) {
    for (const std::uint64_t seed : {1, 2, 3, 4, 5, 6, 7, 8}) {
        const CemboxDesign design = designCembox({seed, 0, 0, 4});
        for (const double richness : {0.2, 1.0, 3.0}) {
            const int quarter = static_cast<int>(std::ceil(richness));
            const Detail detail{quarter, 8 * quarter, 60 / richness, richness};
            const Mesh part = buildModule(design, detail, scenes::Random(seed), /*studs*/ 3).mesh();
            const double diagonal = boundingBox(part).diagonal().norm();
            BOOST_TEST(diagonal > 300);
            BOOST_TEST(diagonal < 400);
            for (const Vector3& v : part.vertices) {
                bool isHeld = false;
                for (Box box : design.envelope()) {
                    box.min().array() -= 1e-4, box.max().array() += 1e-4;  // allows for rounding to float
                    isHeld = isHeld || box.contains(v);
                }
                BOOST_REQUIRE(isHeld);
            }
        }
    }
}

BOOST_AUTO_TEST_CASE(the_problem_starts_in_the_rails_and_ends_above_them) {
    const GeneratedScene& scene = sceneOf(kRich);
    const Problem& problem = scene.problem;
    BOOST_TEST(problem.fineness.value() == 0.6);  // half of the sheets' 1.2 mm
    double railTop = 0;
    for (const Component& component : scene.environment.components) {
        if (component.name.rfind("guide_rail", 0) != 0) continue;
        for (std::uint32_t i = 0; i < component.triangleCount; ++i) {
            for (const Vector3& p : cornersOf(scene.environment, component.firstTriangle + i))
                railTop = std::max(railTop, p.z());
        }
    }
    double lowestAtStart = 1e9, lowestAtGoal = 1e9;
    for (const Vector3& v : scene.part.vertices) {
        lowestAtStart = std::min(lowestAtStart, (poseOf(problem.start) * v).z());
        lowestAtGoal = std::min(lowestAtGoal, (poseOf(problem.goal) * v).z());
    }
    BOOST_TEST(lowestAtStart < railTop - 150);
    BOOST_TEST(lowestAtGoal > railTop + 100);
}

/// The room for the module must not drive out any large component, whatever the clearance.
BOOST_DATA_TEST_CASE(what_holds_the_module_is_there_at_any_size_and_large_components_in_large_scenes, cases(),
                     scenario) {
    const std::set<std::string> names = namesOf(sceneOf(scenario).environment);
    for (const char* name :
         {"guide_rail_left", "guide_rail_right", "buffer_left", "buffer_right", "wiper_tube", "strut_brace"})
        BOOST_TEST(names.count(name) == 1, name);
    if (scenario.environmentTriangles < 80000) return;
    for (const char* name : {"carrier_plate",
                             "carrier_shelf",
                             "bulkhead_lower",
                             "bulkhead_upper",
                             "cowl_edge",
                             "inner_wing_left",
                             "inner_wing_right",
                             "strut_tower_left",
                             "strut_tower_right",
                             "engine_block",
                             "cylinder_head",
                             "valve_cover",
                             "gearbox_case",
                             "intake_plenum",
                             "exhaust_collector",
                             "belt",
                             "battery",
                             "battery_tray",
                             "air_filter_upper",
                             "air_duct",
                             "coolant_tank_upper",
                             "washer_tank_upper",
                             "brake_booster",
                             "pressure_unit",
                             "fuse_box",
                             "fan_shroud",
                             "radiator_tank_upper",
                             "harness_trunk",
                             "heater_hose_in",
                             "heater_hose_out",
                             "radiator_hose_upper",
                             "radiator_hose_lower",
                             "front_member",
                             "rear_member",
                             "rail_bracket_04",
                             "intake_runner_04",
                             "module_cable_03",
                             "bumper_beam",
                             "bumper_foam",
                             "subframe",
                             "subframe_cross",
                             "steering_rack",
                             "insulation_foam",
                             "insulation_heavy_layer",
                             "wing_brace_left",
                             "wing_brace_right",
                             "cowl_tray",
                             "wiper_motor",
                             "steering_bellows_02",
                             "crash_can_02",
                             "shaft_boot_04",
                             "grommet_06"})
        BOOST_TEST(names.count(name) == 1, name);
}

BOOST_DATA_TEST_CASE(beside_the_rails_there_is_more_room_and_above_them_more_still, cases(), scenario) {
    GeneratedScene scene = sceneOf(scenario);
    std::vector<TriangleIndices> rest;
    for (const Component& component : scene.environment.components) {
        if (component.name.rfind("guide_rail", 0) == 0 || component.name.rfind("buffer", 0) == 0) continue;
        const auto first = scene.environment.triangles.begin() + component.firstTriangle;
        rest.insert(rest.end(), first, first + component.triangleCount);
    }
    scene.environment.triangles = rest;
    scene.environment.components.clear();
    GeneratedScene inRails = scene, above = scene;
    inRails.path = {scene.path[0], scene.path[1]};
    above.path.erase(above.path.begin());
    BOOST_TEST(walkPath(inRails, 1.5 * scenario.clearance, 0, 5).proven);
    const PathClearance walk = walkPath(above, 3 * scenario.clearance, 0, 5);
    BOOST_TEST(walk.proven);
    // A crowded place, not an empty one.
    if (scenario.environmentTriangles >= 80000) BOOST_TEST(walk.least < 3 * scenario.clearance + 15);
}

BOOST_DATA_TEST_CASE(neither_the_straight_motion_nor_a_straight_pull_takes_the_module_out, cases(),
                     scenario) {
    if (scenario.environmentTriangles < 80000) return;
    const GeneratedScene& scene = sceneOf(scenario);
    const Model part = Model::build(scene.part), environment = Model::build(scene.environment);
    PartState pulled = scene.path.front();
    pulled.position.z() += 500;
    for (const PartState& end : {scene.path.back(), pulled})
        BOOST_TEST(collidingShare(part, environment, scene.path.front(), end) >= 0.25);
}

BOOST_AUTO_TEST_SUITE_END()
