#include "program/report/obstacle_clearances.h"

#include <boost/test/unit_test.hpp>

#include "mesh/components.h"
#include "support/random_meshes.h"
#include "support/window_scene.h"

namespace clearway::testing {
BOOST_AUTO_TEST_SUITE(obstacle_clearances_test)

using namespace report;

/// A straight path through the window.
struct StraightPath {
    WindowScene window = windowScene();
    std::vector<ReportFrame> frames;

    explicit StraightPath(double shift = 0) {
        std::vector<PartState> path = {window.problem.start, window.problem.goal};
        for (PartState& state : path) {
            state.rotation.setIdentity();  // flat, to fit through the window
            state.position.y() += shift;
        }
        frames = framesAlong(PathLine(path, 1), SceneClearance(window.scene), 30);
    }
    std::vector<ObstacleClearance> clearances(std::size_t most) const {
        return obstacleClearances(window.scene, window.wallMesh, frames, most);
    }
};

BOOST_AUTO_TEST_CASE(the_least_clearance_to_each_obstacle_is_that_of_its_distances_at_the_frames) {
    StraightPath way;
    way.window.scene.obstacles[0].margin = 2;
    const auto clearances = way.clearances(99);
    BOOST_TEST_REQUIRE(clearances.size() == 4u);
    for (std::size_t i = 0; i < 4; ++i) {
        const Model model = Model::build(meshOfComponents(way.window.wallMesh, {i}));
        Workspace workspace;
        std::vector<double> lowers;
        for (const ReportFrame& frame : way.frames)
            lowers.push_back(
                distance(way.window.scene.part, model, frame.X_environmentPart, {}, workspace).lower - 2);
        const double least = *std::min_element(lowers.begin(), lowers.end());
        BOOST_TEST(clearances[i].isMeasured);
        BOOST_TEST((clearances[i].trouble == WhyInvalid::Kind::kValid));
        BOOST_TEST(clearances[i].margin == 2);
        BOOST_TEST(clearances[i].lower == least, boost::test_tools::tolerance(1e-9));
        BOOST_TEST(lowers[clearances[i].frame] == least, boost::test_tools::tolerance(1e-9));
    }
}

BOOST_AUTO_TEST_CASE(an_obstacle_in_the_way_is_told_from_the_others) {
    const auto clearances = StraightPath(20).clearances(99);  // runs into the wall on the right
    for (std::size_t i = 0; i < 4; ++i)
        BOOST_TEST(((clearances[i].trouble == WhyInvalid::Kind::kCollides) == (i == 3)));
    BOOST_TEST(clearances[3].lower <= 0);
}

BOOST_AUTO_TEST_CASE(what_is_not_measured_has_the_bound_of_its_box) {
    const StraightPath way(8);
    const auto all = way.clearances(99), few = way.clearances(1);
    std::size_t measured = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        measured += few[i].isMeasured;
        BOOST_TEST(few[i].isInScene);
        BOOST_TEST(few[i].lower <= all[i].lower * (1 + 1e-12));
    }
    BOOST_TEST(measured == 1u);
    BOOST_TEST(few[3].isMeasured);
}

BOOST_AUTO_TEST_CASE(obstacles_that_the_scene_ignores_are_told) {
    StraightPath way;
    const Mesh some = meshOfComponents(way.window.wallMesh, {0, 1});
    way.window.scene.obstacles = {{Model::build(some)}};
    const auto clearances = way.clearances(99);
    for (std::size_t i = 0; i < 4; ++i) BOOST_TEST(clearances[i].isInScene == (i < 2));
}

BOOST_AUTO_TEST_CASE(inside_a_solid_there_is_no_clearance) {
    StraightPath way;
    const Mesh shell =
        transformed(boxMesh(Box(Vector3(-200, -200, -200), Vector3(200, 200, 200)), "shell"), {});
    Scene& scene = way.window.scene;
    scene.partSolids = makeSolids(way.window.partMesh).solids;
    scene.obstacles.push_back(Model::build(shell));
    scene.obstacles.back().solids = makeSolids(shell).solids;
    const auto clearances = obstacleClearances(scene, shell, way.frames, 99);
    BOOST_TEST_REQUIRE(clearances.size() == 1u);
    BOOST_TEST((clearances[0].trouble == WhyInvalid::Kind::kInSolid));
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::testing
