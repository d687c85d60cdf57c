#include "program/report/frames.h"

#include <boost/test/unit_test.hpp>

#include "clearway/planning/check_path.h"
#include "support/random_meshes.h"
#include "support/window_scene.h"

namespace clearway::testing {
BOOST_AUTO_TEST_SUITE(frames_test)

using namespace report;

/// A straight path through the window.
struct Way {
    WindowScene window = windowScene();
    std::vector<PartState> path{window.problem.start, window.problem.start, window.problem.goal};
    Way() {
        for (PartState& state : path) state.rotation.setIdentity();  // flat, to fit through the window
        path[1].position.x() = 10;
        window.problem.start = path[0];
        window.problem.goal = path[2];
    }
    PathLine line() const { return {path, window.scene.part.radiusAboutOrigin()}; }
};

BOOST_AUTO_TEST_CASE(every_state_of_the_path_is_a_frame_and_frames_are_in_order) {
    const Way way;
    const PathLine line = way.line();
    const auto frames = framesAlong(line, SceneClearance(way.window.scene), 20);
    BOOST_TEST(frames.size() >= 20u);
    BOOST_TEST(frames.size() <= 23u);
    std::size_t states = 0;
    for (std::size_t i = 0; i < frames.size(); ++i) {
        if (i > 0) BOOST_TEST(frames[i].share > frames[i - 1].share);
        for (const PartState& state : way.path)
            states += frames[i].X_environmentPart.translation == state.position;
    }
    BOOST_TEST(states == 3u);
}

BOOST_AUTO_TEST_CASE(a_part_that_turns_while_it_goes_far_is_shown_at_every_few_degrees) {
    Way way;
    way.path.resize(1);
    for (int i = 1; i <= 9; ++i) {  // three turns, in the last thousandth of the way
        PartState state = way.path[0];
        state.position.x() -= 1e6;
        state.rotation = Eigen::AngleAxisd(i * 2 * M_PI / 3, Vector3::UnitZ());
        way.path.push_back(state);
    }
    way.path[1].rotation = way.path[0].rotation;
    const auto frames = framesAlong(way.line(), SceneClearance(way.window.scene), 20);
    double most = 0;
    for (std::size_t i = 1; i < frames.size(); ++i) {
        const Eigen::AngleAxisd turn(frames[i - 1].X_environmentPart.rotation.transpose() *
                                     frames[i].X_environmentPart.rotation);
        most = std::max(most, turn.angle());
    }
    BOOST_TEST(most < 6.1 * M_PI / 180);
    BOOST_TEST(frames.size() < 250u);
}

BOOST_AUTO_TEST_CASE(where_a_path_is_tightest_and_where_it_collides_are_frames) {
    Way way;
    const SceneClearance clearance(way.window.scene);
    const auto leastOf = [&](const std::vector<ReportFrame>& frames) {
        double least = std::numeric_limits<double>::infinity();
        for (const ReportFrame& frame : frames) least = std::min(least, frame.clearance.lower);
        return least;
    };
    way.path.erase(way.path.begin() + 1);  // no state within the wall
    auto audit = planning::checkPath(way.window.problem, way.window.scene, way.path).audit;
    BOOST_TEST_REQUIRE(audit.isValid());
    const auto fits = framesAlong(way.line(), clearance, 2, tightPlaces(way.line(), audit, 9));
    BOOST_TEST(fits.size() == 3u);
    BOOST_TEST(leastOf(fits) <= audit.upperClearance + 1e-9);
    BOOST_TEST(leastOf(framesAlong(way.line(), clearance, 2)) > 2 * audit.upperClearance);

    for (PartState& state : way.path) state.rotation = Eigen::AngleAxisd(1.5, Vector3::UnitX());
    audit = planning::checkPath(way.window.problem, way.window.scene, way.path).audit;
    BOOST_TEST_REQUIRE(!audit.isValid());
    BOOST_TEST(leastOf(framesAlong(way.line(), clearance, 2, tightPlaces(way.line(), audit, 9))) <= 0);
    BOOST_TEST(tightPlaces(way.line(), audit, 0).size() == 1u);
    BOOST_TEST(tightPlaces(way.line(), {}, 9).empty());
}

BOOST_AUTO_TEST_CASE(a_frame_knows_the_clearance_and_the_pair_of_its_pose) {
    const Way way;
    const auto frames = framesAlong(way.line(), SceneClearance(way.window.scene), 20);
    Workspace workspace;
    for (const ReportFrame& frame : frames) {
        const DistanceResult d = distance(way.window.scene.part, way.window.scene.obstacles[0].model,
                                          frame.X_environmentPart, {}, workspace);
        BOOST_TEST(frame.clearance.lower == d.lower, boost::test_tools::tolerance(1e-9));
        BOOST_TEST((frame.clearance.nearest.witness->pointOnPart -
                    frame.clearance.nearest.witness->pointOnEnvironment)
                           .norm() == d.upper,
                   boost::test_tools::tolerance(1e-9));
        BOOST_TEST(frame.partMesh == "plate");
        BOOST_TEST(!frame.environmentMesh.empty());
    }
}

BOOST_AUTO_TEST_CASE(what_is_certified_of_a_stretch_is_never_more_than_the_clearance_in_it) {
    const Way way;
    const auto audit = planning::checkPath(way.window.problem, way.window.scene, way.path).audit;
    BOOST_TEST_REQUIRE(audit.isValid());
    constexpr std::size_t kCount = 50;
    const auto certified = certifiedStretches(way.line(), audit, kCount);
    BOOST_TEST_REQUIRE(certified.size() == kCount);
    for (const ReportFrame& frame : framesAlong(way.line(), SceneClearance(way.window.scene), 777)) {
        const auto stretch =
            std::min<std::size_t>(kCount - 1, static_cast<std::size_t>(frame.share * kCount));
        BOOST_TEST(certified[stretch] > 0);
        BOOST_TEST(certified[stretch] <= frame.clearance.upper);
    }
    BOOST_TEST(certifiedStretches(way.line(), {}, kCount).empty());
}

BOOST_AUTO_TEST_CASE(a_pose_out_of_the_environments_reach_is_a_frame_of_which_nothing_is_known) {
    const Way way;
    const Mesh far = translated(way.window.wallMesh, {1000, 0, 0});
    const Box positions(Vector3(-70, -80, -80), Vector3(20, 80, 80));
    const Model near = Model::build(joined(way.window.wallMesh, far), {}, QueryRange{positions, 50, 30});
    const Scene scene(way.window.scene.part, near);
    std::size_t unknown = 0;
    for (const ReportFrame& frame : framesAlong(way.line(), SceneClearance(scene), 20)) {
        BOOST_TEST(frame.isInRange == (frame.X_environmentPart.translation.x() <= 20));
        unknown += !frame.isInRange;
    }
    BOOST_TEST(unknown > 3u);
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::testing
