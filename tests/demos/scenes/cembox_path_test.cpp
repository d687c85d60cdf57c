#include <boost/test/data/monomorphic.hpp>
#include <boost/test/data/test_case.hpp>
#include <boost/test/unit_test.hpp>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "demos/scenes/scene_checks.h"
#include "demos/scenes/scenes.h"
#include "support/full_run.h"
#include "support/oracle.h"

namespace clearway::scenes {

std::ostream& operator<<(std::ostream& out, const SceneOptions& options) {
    return out << "seed " << options.seed << ", " << options.partTriangles << " / "
               << options.environmentTriangles << ", clearance " << options.clearance;
}

}  // namespace clearway::scenes

BOOST_AUTO_TEST_SUITE(cembox_path_test)

using namespace clearway;
using namespace clearway::scenes;
using namespace clearway::testing;

namespace {

/// The scenes to test; more with CLEARWAY_FULL=1.
std::vector<SceneOptions> cases() {
    if (!isFullRun()) return {{1, 3600, 80000, 4}, {3, 5000, 80000, 0.5}};
    std::vector<SceneOptions> all{{1, 3600, 80000, 4}, {2, 3600, 80000, 8}, {3, 5000, 80000, 0.5}};
    for (std::uint64_t seed = 4; seed <= 20; ++seed) all.push_back({seed, 3600, 80000, 4});
    for (std::uint64_t seed = 4; seed <= 10; ++seed) all.push_back({seed, 8000, 120000, 8});
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

bool holdsModule(const std::string& name) {
    return name.rfind("guide_rail", 0) == 0 || name.rfind("buffer", 0) == 0;
}

/// The environment without rails and buffers.
Mesh besideTheSlot(const Mesh& mesh) {
    Mesh rest;
    rest.vertices = mesh.vertices;
    for (const Component& component : mesh.components) {
        if (holdsModule(component.name)) continue;
        const auto first = mesh.triangles.begin() + component.firstTriangle;
        rest.triangles.insert(rest.triangles.end(), first, first + component.triangleCount);
    }
    return rest;
}

/// The clearance is proven along the whole way, also between the samples.
BOOST_DATA_TEST_CASE(the_constructed_path_keeps_the_clearance_and_is_tight_for_three_tenths, cases(),
                     scenario) {
    const double clearance = scenario.clearance;
    const GeneratedScene& scene = sceneOf(scenario);
    const PathClearance walk = walkPath(scene, clearance, 1.5 * clearance, 5);
    BOOST_TEST_MESSAGE(scenario << ": least " << walk.least << " mm, " << 100 * walk.tightLength / walk.length
                                << " % tight, " << walk.samples << " samples");
    BOOST_TEST(walk.proven);
    BOOST_TEST(walk.least < 1.5 * clearance);
    BOOST_TEST(walk.tightLength >= 0.3 * walk.length);
}

BOOST_DATA_TEST_CASE(beside_the_rails_there_is_more_room_and_above_them_more_still, cases(), scenario) {
    GeneratedScene scene = sceneOf(scenario);
    scene.environment = besideTheSlot(scene.environment);
    GeneratedScene inRails = scene, above = scene;
    inRails.path = {scene.path[0], scene.path[1]};
    above.path.erase(above.path.begin());
    BOOST_TEST(walkPath(inRails, 1.5 * scenario.clearance, 0, 5).proven);
    const PathClearance walk = walkPath(above, 3 * scenario.clearance, 0, 5);
    BOOST_TEST(walk.proven);
    BOOST_TEST(walk.least < 3 * scenario.clearance + 15);  // a crowded place, not an empty one
}

BOOST_AUTO_TEST_CASE(the_oracle_finds_no_less_clearance_on_the_path) {
    const SceneOptions options = cases().front();
    const GeneratedScene& scene = sceneOf(options);
    const MeshOracle oracle(scene.part, scene.environment);
    for (std::size_t i = 0; i + 1 < scene.path.size(); ++i) {
        for (const double t : {0.0, 0.5}) {
            const PartState state = between(scene.path[i], scene.path[i + 1], t);
            BOOST_TEST(oracle.distance(poseOf(state)).distance >= options.clearance);
        }
    }
    BOOST_TEST(oracle.distance(poseOf(scene.path.back())).distance >= options.clearance);
}

/// The room for the module must not drive out any large component.
BOOST_DATA_TEST_CASE(the_large_components_are_there_whatever_the_clearance, cases(), scenario) {
    std::set<std::string> names;
    for (const Component& component : sceneOf(scenario).environment.components) names.insert(component.name);
    for (const char* name : {"guide_rail_left",
                             "guide_rail_right",
                             "buffer_left",
                             "buffer_right",
                             "carrier_plate",
                             "carrier_shelf",
                             "wiper_tube",
                             "strut_brace",
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
                             "radiator_tank_upper",
                             "fan_shroud",
                             "harness_trunk",
                             "heater_hose_in",
                             "heater_hose_out",
                             "radiator_hose_upper",
                             "radiator_hose_lower",
                             "front_member",
                             "rear_member",
                             "rail_bracket_04",
                             "intake_runner_04",
                             "module_cable_03"}) {
        BOOST_TEST(names.count(name) == 1, name);
    }
}

BOOST_DATA_TEST_CASE(neither_the_straight_motion_nor_a_straight_pull_takes_the_module_out, cases(),
                     scenario) {
    const GeneratedScene& scene = sceneOf(scenario);
    const Model part = Model::build(scene.part), environment = Model::build(scene.environment);
    Workspace workspace;
    constexpr int kSamples = 200;
    int straight = 0, pulled = 0;
    for (int i = 0; i < kSamples; ++i) {
        const double t = (i + 0.5) / kSamples;
        straight +=
            collides(part, environment, poseOf(between(scene.path.front(), scene.path.back(), t)), workspace);
        PartState state = scene.path.front();
        state.position.z() += 500 * t;
        pulled += collides(part, environment, poseOf(state), workspace);
    }
    BOOST_TEST_MESSAGE(scenario << ": " << 100.0 * straight / kSamples
                                << " % of the straight motion collides");
    BOOST_TEST(straight >= kSamples / 4);
    BOOST_TEST(pulled >= kSamples / 4);
}

}  // namespace

BOOST_AUTO_TEST_SUITE_END()
