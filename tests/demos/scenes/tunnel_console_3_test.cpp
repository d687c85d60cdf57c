// The tunnel console at full size. The checks that it is no toy are in tunnel_console_3_toy_test.cpp.
#include <boost/test/data/monomorphic.hpp>
#include <boost/test/data/test_case.hpp>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "demos/scenes/scene_checks.h"
#include "demos/scenes/scenes.h"
#include "support/full_run.h"

BOOST_AUTO_TEST_SUITE(tunnel_console_3_test)

using namespace clearway;
using namespace clearway::scenes;
using namespace clearway::testing;

/// The scene at full size, made once for each clearance.
const GeneratedScene& fullSize(double clearance) {
    static std::map<double, GeneratedScene> made;
    SceneOptions options = kTunnelConsole3;
    options.clearance = clearance;
    if (made.count(clearance) == 0) made.emplace(clearance, makeTunnelConsole3(options));
    return made.at(clearance);
}

/// Clearances of the full size, of which 10 mm is only tried with CLEARWAY_FULL=1.
const auto kClearances =
    boost::unit_test::data::make(isFullRun() ? std::vector<double>{10, 2} : std::vector<double>{2});

bool isWithin(std::size_t count, std::size_t wanted, double share) {
    return count <= wanted && static_cast<double>(count) >= (1 - share) * static_cast<double>(wanted);
}

/// True when the part's convex hull has at least twice its volume.
bool isHollow(const Mesh& part) {
    std::vector<Vector3> some;  // some vertices: their hull lies within the hull of all
    for (std::size_t i = 0; i < part.vertices.size(); i += part.vertices.size() / 400)
        some.push_back(part.vertices[i]);
    return signedVolume(convexHull(some)) >= 2 * signedVolume(part);
}

std::string stem(const std::string& name) {
    const std::size_t end = name.find_last_not_of("0123456789");
    return end + 1 < name.size() && name[end] == '_' ? name.substr(0, end) : name;
}

BOOST_DATA_TEST_CASE(it_has_the_triangles_and_the_components_of_a_real_one, kClearances, clearance) {
    const GeneratedScene& scene = fullSize(clearance);
    BOOST_TEST(isWithin(scene.part.triangles.size(), 73425, 0.005));
    BOOST_TEST(isWithin(scene.environment.triangles.size(), 300401, 0.005));
    std::set<std::string> kinds;
    for (const Mesh* mesh : {&scene.part, &scene.environment}) {
        testNamedClosedSolids(*mesh);
        testSlivers(*mesh);
        for (const Component& component : mesh->components) kinds.insert(stem(component.name));
    }
    BOOST_TEST(scene.part.components.size() >= 60);
    BOOST_TEST(scene.environment.components.size() >= 150);
    BOOST_TEST(kinds.size() >= 50);
    BOOST_TEST(isHollow(scene.part));
    BOOST_TEST(std::abs(boundingBox(scene.part).diagonal().norm() - 900) < 10);
}

bool begins(const std::string& text, const std::string& with) {
    return text.rfind(with, 0) == 0;
}

BOOST_DATA_TEST_CASE(the_problem_starts_inside_and_ends_outside, kClearances, clearance) {
    const GeneratedScene& scene = fullSize(clearance);
    const Problem& problem = scene.problem;
    BOOST_TEST(problem.fineness.value() == 0.8);  // half of the skins' 1.6 mm
    Box tunnel, atStart, atGoal;
    for (const Component& component : scene.environment.components) {
        if (!begins(component.name, "tunnel_skin")) continue;
        for (std::uint32_t i = 0; i < component.triangleCount; ++i) {
            for (const Vector3& p : cornersOf(scene.environment, component.firstTriangle + i))
                tunnel.extend(p);
        }
    }
    for (const Vector3& v : scene.part.vertices) {
        atStart.extend(poseOf(problem.start) * v);
        atGoal.extend(poseOf(problem.goal) * v);
    }
    BOOST_TEST(tunnel.contains(atStart));
    BOOST_TEST(!tunnel.intersects(atGoal));
}

/// The path except for its last motion leads from the assembled pose to where the part has left the tunnel.
BOOST_AUTO_TEST_CASE(the_sheets_keep_farther_off_than_the_parts_at_the_gap) {
    const GeneratedScene scene = makeTunnelConsole3({1, 28000, 120000, 10});
    Mesh sheets;
    sheets.vertices = scene.environment.vertices;
    for (const Component& component : scene.environment.components) {
        if (!begins(component.name, "floor_pan") && !begins(component.name, "tunnel_")) continue;
        const auto first = scene.environment.triangles.begin() + component.firstTriangle;
        sheets.triangles.insert(sheets.triangles.end(), first, first + component.triangleCount);
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
    BOOST_TEST_MESSAGE("sheets at least " << least << " mm off");
    BOOST_TEST(least >= 2 * 10);
}

BOOST_AUTO_TEST_SUITE_END()
