#include <boost/test/data/monomorphic.hpp>
#include <boost/test/data/test_case.hpp>
#include <boost/test/unit_test.hpp>
#include <cstdlib>
#include <map>
#include <set>
#include <vector>

#include "program/scenes/scene_checks.h"
#include "program/scenes/scenes.h"
#include "support/oracle.h"

using namespace clearway;
using namespace clearway::scenes;
using namespace clearway::testing;

namespace {

struct Case {
    SceneOptions options;
    const char* scene = "tunnel-console-1";

    GeneratedScene make() const { return sceneNamed(scene).make(options); }
};

std::ostream& operator<<(std::ostream& out, const Case& c) {
    return out << c.scene << ", seed " << c.options.seed << ", " << c.options.partTriangles << " / "
               << c.options.environmentTriangles << ", clearance " << c.options.clearance;
}

Mesh only(const Mesh& mesh, const Component& component) {
    Mesh alone;
    alone.vertices = mesh.vertices;
    const auto first = mesh.triangles.begin() + component.firstTriangle;
    alone.triangles.assign(first, first + component.triangleCount);
    return alone;
}

/// Each case for both versions.
std::vector<Case> ofBoth(std::vector<Case> all) {
    const std::size_t count = all.size();
    for (std::size_t i = 0; i < count; ++i) all.push_back({all[i].options, "tunnel-console-2"});
    return all;
}

/// More of them with CLEARWAY_FULL=1.
std::vector<Case> cases() {
    std::vector<Case> all{// seed, part, environment, clearance
                          {{1, 2000, 8000, 10}},
                          {{2, 2000, 8000, 10}},
                          {{5, 3000, 13000, 4}},
                          {{7, 2000, 8000, 25}}};
    const char* full = std::getenv("CLEARWAY_FULL");
    if (full == nullptr || std::string(full) != "1") return ofBoth(all);
    for (std::uint64_t seed = 3; seed <= 20; ++seed) all.push_back({{seed, 2000, 8000, 10}});
    all.push_back({{4, 9000, 30000, 10}});
    all.push_back({{5, 3000, 14000, 3}});
    all.push_back({{6, 5000, 20000, 1.5}});
    all.push_back({{7, 73000, 300000, 10}});
    return ofBoth(all);
}

BOOST_AUTO_TEST_SUITE(tunnel_console_path)  // its cases share names with other scenes' cases

/// Proven along the whole way, in between the samples too.
BOOST_DATA_TEST_CASE(the_constructed_path_keeps_the_clearance_and_is_tight_for_three_tenths, cases(),
                     scenario) {
    const double clearance = scenario.options.clearance;
    const GeneratedScene scene = scenario.make();
    const PathClearance walk = walkPath(scene, clearance, 1.5 * clearance, 5);
    BOOST_TEST_MESSAGE(scenario << ": least " << walk.least << " mm, " << 100 * walk.tightLength / walk.length
                                << " % tight, " << walk.samples << " samples");
    BOOST_TEST(walk.proven);
    BOOST_TEST(walk.tightLength >= 0.3 * walk.length);
}

BOOST_DATA_TEST_CASE(the_oracle_finds_no_less_clearance_on_the_path, ofBoth({{{1, 2000, 8000, 10}}}),
                     scenario) {
    const GeneratedScene scene = scenario.make();
    const MeshOracle oracle(scene.part, scene.environment);
    for (std::size_t i = 0; i + 1 < scene.path.size(); ++i) {
        for (const double t : {0.0, 0.5}) {
            const PartState state = between(scene.path[i], scene.path[i + 1], t);
            BOOST_TEST(oracle.distance(poseOf(state)).distance >= 10);
        }
    }
    BOOST_TEST(oracle.distance(poseOf(scene.path.back())).distance >= 10);
}

/// From the assembled pose to where the part has left: the path's last motion but one.
BOOST_DATA_TEST_CASE(in_version_2_the_sheets_keep_farther_off_than_what_is_near, cases(), scenario) {
    if (std::string(scenario.scene) != "tunnel-console-2") return;
    const GeneratedScene scene = scenario.make();
    Mesh sheets;
    sheets.vertices = scene.environment.vertices;
    for (const Component& component : scene.environment.components) {
        if (component.name.rfind("floor_pan", 0) != 0 && component.name.rfind("tunnel_", 0) != 0) continue;
        const Mesh sheet = only(scene.environment, component);
        sheets.triangles.insert(sheets.triangles.end(), sheet.triangles.begin(), sheet.triangles.end());
    }
    const Model part = Model::build(scene.part), far = Model::build(sheets);
    Workspace workspace;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i + 2 < scene.path.size(); ++i) {
        for (const double t : {0.0, 0.5}) {
            const Pose pose = poseOf(between(scene.path[i], scene.path[i + 1], t));
            least = std::min(least, distance(part, far, pose, {}, workspace).lower);
        }
    }
    BOOST_TEST_MESSAGE(scenario << ": sheets at least " << least << " mm off");
    BOOST_TEST(least >= 2 * scenario.options.clearance);
}

BOOST_DATA_TEST_CASE(the_straight_motion_collides_over_half_its_length_with_three_components, cases(),
                     scenario) {
    const GeneratedScene scene = scenario.make();
    const Model part = Model::build(scene.part), environment = Model::build(scene.environment);
    std::map<std::string, Model> components;  // on their own, so that none hides behind another
    for (const Component& component : scene.environment.components) {
        components.emplace(component.name, Model::build(only(scene.environment, component)));
    }
    Workspace workspace;
    constexpr int kSamples = 200;
    int collisions = 0;
    std::set<std::string> hit;
    for (int i = 0; i < kSamples; ++i) {
        const Pose pose = poseOf(between(scene.path.front(), scene.path.back(), (i + 0.5) / kSamples));
        if (!collides(part, environment, pose, workspace)) continue;
        ++collisions;
        for (const auto& [name, model] : components) {
            if (hit.count(name) == 0 && collides(part, model, pose, workspace)) hit.insert(name);
        }
    }
    BOOST_TEST_MESSAGE(scenario << ": " << 100.0 * collisions / kSamples << " % with " << hit.size());
    BOOST_TEST(collisions >= kSamples / 2);
    BOOST_TEST(hit.size() >= 3);
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace
