// A problem whose obstacles count by name, from the .cfg to the audited path.
#include "clearway/problem.h"
#include "program/cli/run_program.h"
#include "support/random_meshes.h"
#include "support/window_scene.h"

namespace clearway::testing {

BOOST_AUTO_TEST_SUITE(obstacles_test)

namespace {

/// The plate rests on a block before the wall with the window. The goal is a block behind the wall.
struct AssemblyFolder : TemporaryFolder {
    AssemblyFolder() {
        const WindowScene window = windowScene();
        saveMesh(window.partMesh, file("plate.obj"));
        saveMesh(window.wallMesh, file("wall.obj"));
        Mesh blocks = joined(transformed(box({20, 20, 5}), {Matrix3::Identity(), {-60, 0, -10}}),
                             transformed(box({20, 20, 5}), {Matrix3::Identity(), {60, 0, -10}}));
        blocks.components = {{"tray", 0, 12}, {"shelf", 12, 12}};
        saveMesh(blocks, file("blocks.obj"));
        problem = window.problem;
        problem.start.rotation = problem.goal.rotation = Eigen::Quaterniond::Identity();
        problem.robot = file("plate.obj");
        problem.world = file("wall.obj");
        problem.furtherWorlds = {file("blocks.obj")};
        problem.asOmplApp = false;
        problem.rules.startContact = ContactRule{{"tray"}, 6};
        problem.rules.goalContact = ContactRule{{"blocks/shelf"}, 6};
        problem.rules.margins = {{"wall", 0.5}};
        problem.rules.isAllSolid = true;
        writeProblem(problem, file("a.cfg"));
    }
    void write(const Problem& changed) const { writeProblem(changed, file("a.cfg")); }

    Problem problem;
};

constexpr const char* kPlan = "plan a.cfg --path out.path --iterations 100000";

BOOST_AUTO_TEST_CASE(a_part_is_planned_from_one_contact_to_the_other_and_the_path_checked) {
    const AssemblyFolder folder;
    const Outcome planned = runIn(folder, kPlan);
    BOOST_TEST(planned.code == 0, planned.err + planned.out);
    BOOST_TEST(planned.err == "");
    BOOST_TEST(planned.out.find("'blocks/tray': 12 triangles, margin 0, solid, ignored near the start") !=
               std::string::npos);
    BOOST_TEST(planned.out.find("'wall/below', 'wall/above', 'wall/left', 'wall/right': ") !=
               std::string::npos);
    BOOST_TEST(planned.out.find("margin 0.5, solid") != std::string::npos);
    BOOST_TEST(row(planned, "contact at start") == "6");
    const Outcome checked = runIn(folder, "check a.cfg out.path");
    BOOST_TEST(checked.code == 0, checked.out);
    BOOST_TEST(row(checked, "start contact").find("used in segment 1 from t = 0 to ") == 0u, checked.out);
    BOOST_TEST(row(checked, "goal contact").find("used in segment ") == 0u);
}

BOOST_AUTO_TEST_CASE(without_its_contact_the_start_touches_by_name_and_triangle) {
    AssemblyFolder folder;
    folder.problem.rules.startContact.reset();
    folder.write(folder.problem);
    requireRefused(folder, kPlan,
                   {"start is in collision: triangle", "'plate'", "'blocks/tray'", "touching"});
    folder.problem.rules.ignored = {"tray"};
    folder.write(folder.problem);
    BOOST_TEST(runIn(folder, kPlan).code == 0);
}

BOOST_AUTO_TEST_CASE(the_cure_of_a_start_in_contact_names_all_that_is_touched) {
    AssemblyFolder folder;
    folder.problem.rules.goalContact.reset();
    folder.problem.goal = folder.problem.start;
    const Mesh flag = transformed(box({1, 1, 30}), {Matrix3::Identity(), folder.problem.start.position});
    saveMesh(flag, folder.file("flag.obj"));
    folder.problem.furtherWorlds.push_back(folder.file("flag.obj"));
    folder.write(folder.problem);
    const std::string& err = runIn(folder, kPlan).err;
    BOOST_TEST(err.find("contact.start = tray, flag, ") != std::string::npos, err);
    BOOST_TEST(err.find("in place of the contact.start that is there") != std::string::npos, err);
    folder.problem.rules.startContact.reset();
    folder.write(folder.problem);
    BOOST_TEST(runIn(folder, kPlan).err.find("contact.start = blocks/tray, flag, ") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(a_triangle_is_named_by_its_place_in_its_own_file) {
    AssemblyFolder folder;
    folder.problem.rules.goalContact.reset();
    folder.write(folder.problem);
    const Outcome outcome = runIn(folder, kPlan);
    BOOST_TEST(outcome.code == 2);
    const std::string words = "and triangle ";
    const std::size_t place = outcome.err.find(words);
    BOOST_REQUIRE(place != std::string::npos);
    const int triangle = std::stoi(outcome.err.substr(place + words.size()));
    BOOST_TEST(triangle >= 12);  // the shelf's triangles are 12 to 23 of blocks.obj
    BOOST_TEST(triangle < 24);
    BOOST_TEST(outcome.err.find("'blocks/shelf'") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(a_part_inside_a_solid_is_told_so) {
    AssemblyFolder folder;
    saveMesh(transformed(box({60, 60, 60}), {Matrix3::Identity(), {-60, 0, 0}}), folder.file("block.obj"));
    folder.problem.world = folder.file("block.obj");
    folder.problem.furtherWorlds.clear();
    folder.problem.rules = {};
    folder.write(folder.problem);
    BOOST_TEST(runIn(folder, std::string(kPlan) + " --time 0.1").code == 2);  // both, expected one of them
    BOOST_TEST(runIn(folder, "plan a.cfg --path out.path --time 0.2").code == 1);
    folder.problem.rules.isAllSolid = true;
    folder.write(folder.problem);
    requireRefused(folder, kPlan, {"start is in collision: the part's mesh 'plate' is inside the solid '"});
}

BOOST_AUTO_TEST_CASE(info_tells_how_obstacles_count) {
    AssemblyFolder folder;
    folder.problem.rules.ignored = {"wall/left"};
    folder.write(folder.problem);
    const Outcome outcome = runIn(folder, "info a.cfg");
    BOOST_TEST(outcome.code == 0, outcome.err);
    BOOST_TEST(outcome.out.find("'blocks/shelf': 12 triangles, margin 0, solid, ignored near the goal") !=
               std::string::npos);
    BOOST_TEST(row(outcome, "ignored") == "'wall/left'");
    BOOST_TEST(row(outcome, "contact at goal") == "6");
}

BOOST_AUTO_TEST_CASE(what_is_ignored_is_not_shown) {
    AssemblyFolder folder;
    folder.problem.rules = {};
    folder.problem.rules.ignored = {"wall"};
    folder.write(folder.problem);
    writePath({folder.problem.start, folder.problem.goal}, Space::kSe3, folder.file("in.path"));
    runIn(folder, "check a.cfg in.path --report page.html --export motion.glb");
    BOOST_TEST(
        readText(folder.file("page.html")).find("The environment is drawn with all of its 24 triangles") !=
        std::string::npos);
    std::string names;
    for (const Component& component : loadMesh(folder.file("motion.glb")).components)
        names += component.name + " ";
    BOOST_TEST(names == "blocks/tray blocks/shelf plate ");

    const std::string render = "render a.cfg in.path --size 160x90 --samples 1 --out ";
    BOOST_TEST(runIn(folder, render + "ignored.png").code == 0);
    folder.problem.world = folder.file("blocks.obj");
    folder.problem.furtherWorlds.clear();
    folder.problem.rules = {};
    folder.write(folder.problem);
    BOOST_TEST(runIn(folder, render + "absent.png").code == 0);
    BOOST_TEST((readText(folder.file("ignored.png")) == readText(folder.file("absent.png"))));
}

BOOST_AUTO_TEST_CASE(where_all_is_ignored_no_clearance_is_told) {
    AssemblyFolder folder;
    folder.problem.rules = {};
    folder.problem.rules.ignored = {"wall", "blocks"};
    folder.write(folder.problem);
    writePath({folder.problem.start, folder.problem.goal}, Space::kSe3, folder.file("in.path"));
    const Outcome drawn = runIn(folder, "render a.cfg in.path --size 160x90 --samples 1 --out a.png");
    BOOST_TEST(drawn.code == 0, drawn.err);
    BOOST_TEST(row(drawn, "pose at 0") == "nothing to keep clear of");
    BOOST_TEST(runIn(folder, "check a.cfg in.path --report page.html").code == 0);
    BOOST_TEST(readText(folder.file("page.html")).find("\"clearance\":null,\"isFree\":true") !=
               std::string::npos);
}

BOOST_AUTO_TEST_CASE(names_that_are_none_are_refused_with_those_there_are) {
    AssemblyFolder folder;
    folder.problem.rules.ignored = {"roof"};
    folder.write(folder.problem);
    for (const char* command : {kPlan, "info a.cfg"}) {
        requireRefused(
            folder, command,
            {"a.cfg: [clearway] ignore names 'roof', which is no obstacle, expected one of "
             "'wall/below', 'wall/above', 'wall/left', 'wall/right', 'blocks/tray', 'blocks/shelf'"});
    }
    folder.problem.rules.ignored.clear();
    folder.problem.furtherWorlds.push_back(folder.file("none.obj"));
    folder.write(folder.problem);
    requireRefused(folder, kPlan, {"none.obj"});
}

}  // namespace
BOOST_AUTO_TEST_SUITE_END()

}  // namespace clearway::testing
