#include "clearway/problem.h"
#include "program/cli/run_program.h"
#include "support/random_meshes.h"
#include "support/window_scene.h"

namespace clearway::testing {

BOOST_AUTO_TEST_SUITE(outside_test)

namespace {

/// The window's plate, to be brought beyond the wall. The file states no bounds.
struct OutsideFolder : TemporaryFolder {
    OutsideFolder() {
        saveMesh(window.partMesh, file("plate.obj"));
        saveMesh(window.wallMesh, file("wall.obj"));
        Problem problem = window.problem;
        problem.robot = file("plate.obj");
        problem.world = file("wall.obj");
        problem.asOmplApp = false;
        problem.outside = Outside{sideNamed("+x")};
        writeProblem(problem, file("bounded.cfg"));
        problem.volume.reset();
        problem.start = {{20, 0, 0}, {1, 0, 0, 0}};  // flat within the window, half way
        writeProblem(problem, file("out.cfg"));
    }
    WindowScene window = windowScene();
};

BOOST_AUTO_TEST_CASE(a_part_is_planned_checked_drawn_and_reported_on_its_way_outside) {
    const OutsideFolder folder;
    const Outcome planned =
        runIn(folder, "plan out.cfg --path out.path --iterations 200000 --report out.html");
    BOOST_TEST(planned.code == 0, planned.err);
    BOOST_TEST(planned.err == "");
    const auto path = readPath(folder.file("out.path"), Space::kSe3);
    double least = 1e9;
    for (const Vector3& vertex : folder.window.partMesh.vertices)
        least = std::min(least, (poseOf(path.back()) * vertex).x());
    BOOST_TEST(least > 2);  // where the wall ends
    BOOST_TEST(readText(folder.file("out.html")).find("</html>") != std::string::npos);

    const Outcome checked = runIn(folder, "check out.cfg out.path");
    BOOST_TEST(checked.code == 0, checked.err);
    BOOST_TEST(checked.err == "");  // no warning about the goal
    const Outcome drawn = runIn(folder, "render out.cfg --out out.png --size 64x64 --samples 1");
    BOOST_TEST(drawn.code == 0, drawn.err);
    BOOST_TEST(row(drawn, "pose at 0").find("clearance ") == 0);
    BOOST_TEST(drawn.out.find("pose at 1") == std::string::npos);  // the goal has no pose
    BOOST_TEST(runIn(folder, "render out.cfg out.path --out out.png --size 64x64 --samples 1").code == 0);
    const Outcome benched =
        runIn(folder, "bench out.cfg --planner RRTConnect --runs 2 --time 5 --log out.log");
    BOOST_TEST(benched.code == 0, benched.err);
    BOOST_TEST(benched.out.find("2 of 2 runs solved") != std::string::npos, benched.out);
}

BOOST_AUTO_TEST_CASE(info_says_where_outside_is_and_why_the_bounds_are_larger) {
    const OutsideFolder folder;
    const Outcome outcome = runIn(folder, "info out.cfg");
    BOOST_TEST(outcome.code == 0, outcome.err);
    BOOST_TEST(row(outcome, "goal") == "outside, beyond +x of the environment's box");
    const std::string bounds = row(outcome, "bounds");
    BOOST_TEST(bounds.find("grown to hold the start and the part outside") != std::string::npos, bounds);
}

BOOST_AUTO_TEST_CASE(a_path_that_ends_inside_is_no_solution) {
    const OutsideFolder folder;
    const PartState start = folder.window.problem.start;
    writePath({start, start}, Space::kSe3, folder.file("in.path"));
    const Outcome outcome = runIn(folder, "check bounded.cfg in.path");
    BOOST_TEST(outcome.code == 1);
    BOOST_TEST(row(outcome, "ends") ==
               "where the part's box overlaps the environment's by 92 along +x, expected a goal outside");
    BOOST_TEST(outcome.err == "");
}

BOOST_AUTO_TEST_CASE(bounds_without_room_and_contradictions_are_refused_in_one_line) {
    const OutsideFolder folder;
    Problem problem = readProblem(folder.file("bounded.cfg"));
    problem.volume->max().x() = 6;  // 7 is needed for the plate on its flattest side
    writeProblem(problem, folder.file("tight.cfg"));
    requireRefused(folder, "plan tight.cfg --path out.path",
                   {"tight.cfg: the bounds leave no room for the part outside", "volume.max.x above 7"});
    folder.write("up.cfg", readText(folder.file("out.cfg")) + "outside = up\n");
    requireRefused(folder, "plan up.cfg --path out.path", {"up.cfg:", "outside is given again"});
    folder.write("posed.cfg", "[problem]\ngoal.x = 3\n" + readText(folder.file("out.cfg")).substr(10));
    requireRefused(
        folder, "plan posed.cfg --path out.path",
        {"posed.cfg:2: [problem] goal.x is '3', expected no such key together with [clearway] goal"});
}

}  // namespace
BOOST_AUTO_TEST_SUITE_END()

}  // namespace clearway::testing
