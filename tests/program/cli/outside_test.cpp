#include "program/cli/window_folder.h"

namespace clearway::testing {
BOOST_AUTO_TEST_SUITE(outside_test)

/// The window's plate, to be brought beyond the wall. The file out.cfg states no bounds.
struct OutsideFolder : WindowProblemFolder {
    OutsideFolder() {
        Problem problem = window.problem;
        problem.outside = Outside{sideNamed("+x")};
        rewrite(problem, "bounded.cfg");
        problem.volume.reset();
        problem.start = {{20, 0, 0}, {1, 0, 0, 0}};  // flat within the window, half way
        rewrite(problem, "out.cfg");
    }
};

BOOST_AUTO_TEST_CASE(a_part_is_planned_checked_drawn_and_reported_on_its_way_outside) {
    const OutsideFolder folder;
    const Outcome planned =
        runIn(folder, "plan out.cfg --path out.path --iterations 200000 --report out.html");
    BOOST_TEST(planned.code == 0, planned.err);
    const auto path = readPath(folder.file("out.path"), Space::kSe3);
    double least = 1e9;
    for (const Vector3& vertex : folder.window.partMesh.vertices)
        least = std::min(least, (poseOf(path.back()) * vertex).x());
    BOOST_TEST(least > 2);  // where the wall ends
    BOOST_TEST(holds(readText(folder.file("out.html")), "</html>"));

    const Outcome checked = runIn(folder, "check out.cfg out.path");
    BOOST_TEST(checked.code == 0, checked.err);
    BOOST_TEST(checked.err == "");  // no warning about the goal
    const auto drawn = factsOf(folder, "render out.cfg --out out.png --size 64x64 --samples 1");
    BOOST_TEST(drawn["poses"].size() == 1u);  // the goal has no pose
    BOOST_TEST(runIn(folder, "render out.cfg out.path --out out.png --size 64x64 --samples 1").code == 0);
    const auto benched =
        factsOf(folder, "bench out.cfg --planner RRTConnect --runs 2 --time 5 --log out.log");
    for (const auto& run : benched["planners"][0]["runs"]) BOOST_TEST(run["solved"] == true);
    BOOST_TEST(holds(row(runIn(folder, "info out.cfg"), "bounds"), "grown to hold the start"));
}

BOOST_AUTO_TEST_CASE(a_path_that_ends_inside_is_no_solution) {
    const OutsideFolder folder;
    const PartState start = folder.window.problem.start;
    writePath({start, start}, Space::kSe3, folder.file("in.path"));
    const Outcome outcome = runIn(folder, "check bounded.cfg in.path");
    BOOST_TEST(outcome.code == 1);
    BOOST_TEST(holds(row(outcome, "ends"), "by 92 along +x", "expected a goal outside"), outcome.out);
}

BOOST_AUTO_TEST_CASE(bounds_without_room_and_contradictions_are_refused_in_one_line) {
    const OutsideFolder folder;
    Problem problem = readProblem(folder.file("bounded.cfg"));
    problem.volume->max().x() = 6;  // 7 is needed for the plate on its flattest side
    folder.rewrite(problem, "tight.cfg");
    requireRefused(folder, "plan tight.cfg --path out.path",
                   {"tight.cfg", "no room for the part outside", "volume.max.x above 7"});
    folder.write("up.cfg", readText(folder.file("out.cfg")) + "outside = up\n");
    requireRefused(folder, "plan up.cfg --path out.path", {"up.cfg:", "outside is given again"});
    folder.write("posed.cfg", "[problem]\ngoal.x = 3\n" + readText(folder.file("out.cfg")).substr(10));
    requireRefused(folder, "plan posed.cfg --path out.path",
                   {"posed.cfg:2", "goal.x is '3'", "expected no such key", "[clearway] goal"});
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::testing
