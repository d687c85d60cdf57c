// A problem whose obstacles count by name, from the .cfg to the audited path.
#include "program/cli/window_folder.h"
#include "support/invalid_words.h"
#include "support/random_meshes.h"

namespace clearway::testing {
BOOST_AUTO_TEST_SUITE(obstacles_test)

/// The plate rests on a block before the wall with the window. The goal is a block behind the wall.
struct AssemblyFolder : WindowProblemFolder {
    AssemblyFolder() {
        Mesh blocks =
            joined(translated(box({20, 20, 5}), {-60, 0, -10}), translated(box({20, 20, 5}), {60, 0, -10}));
        blocks.components = {{"tray", 0, 12}, {"shelf", 12, 12}};
        saveMesh(blocks, file("blocks.obj"));
        problem.start.rotation = problem.goal.rotation = Eigen::Quaterniond::Identity();
        problem.meshes.furtherWorlds = {file("blocks.obj")};
        problem.rules.startContact = ContactRule{{"tray"}, 6};
        problem.rules.goalContact = ContactRule{{"blocks/shelf"}, 6};
        problem.rules.margins = {{"wall", 0.5}};
        problem.rules.isAllSolid = true;
        write();
    }
    void write() const { writeProblem(problem, file("a.cfg")); }

    Problem& problem = window.problem;
};

constexpr const char* kPlan = "plan a.cfg --path out.path --iterations 100000";

BOOST_AUTO_TEST_CASE(a_part_is_planned_from_one_contact_to_the_other_and_the_path_checked) {
    const AssemblyFolder folder;
    BOOST_TEST(runIn(folder, kPlan).code == 0);
    const Outcome checked = runIn(folder, "check a.cfg out.path --json facts.json");
    BOOST_TEST(checked.code == 0, checked.out);
    BOOST_TEST(holds(row(checked, "start contact"), "used in segment 1 from t = 0 to "), checked.out);
    BOOST_TEST(holds(row(checked, "goal contact"), "used in segment "), checked.out);
    int seen = 0;
    const auto facts = jsonIn(folder, "facts.json");
    for (const auto& obstacle : facts["obstacles"]) {
        const bool isTray = obstacle["names"][0] == "blocks/tray", isWall = obstacle["names"].size() == 4;
        seen += isTray || isWall;
        BOOST_TEST(obstacle["margin"] == (isWall ? 0.5 : 0.0));
        BOOST_TEST(obstacle["solid"] == true);
        BOOST_TEST(obstacle["ignored_near_start"] == isTray);
    }
    BOOST_TEST(seen == 2);
}

BOOST_AUTO_TEST_CASE(without_its_contact_the_start_touches_by_name_and_triangle) {
    AssemblyFolder folder;
    folder.problem.rules.startContact.reset();
    folder.write();
    requireRefused(folder, kPlan,
                   {"start is " + beginningOf(WhyInvalid::Kind::kCollides), "'plate'", "'blocks/tray'"});
    folder.problem.rules.ignored = {"tray"};
    folder.write();
    BOOST_TEST(runIn(folder, kPlan).code == 0);
}

BOOST_AUTO_TEST_CASE(the_cure_of_a_start_in_contact_names_all_that_is_touched) {
    AssemblyFolder folder;
    folder.problem.rules.goalContact.reset();
    folder.problem.goal = folder.problem.start;
    const Mesh flag = translated(box({1, 1, 30}), folder.problem.start.position);
    saveMesh(flag, folder.file("flag.obj"));
    folder.problem.meshes.furtherWorlds.push_back(folder.file("flag.obj"));
    folder.write();
    const std::string err = runIn(folder, kPlan).err;
    BOOST_TEST(holds(err, "contact.start = tray, flag, ", "in place of the contact.start"), err);
    folder.problem.rules.startContact.reset();
    folder.write();
    BOOST_TEST(holds(runIn(folder, kPlan).err, "contact.start = blocks/tray, flag, "));
}

BOOST_AUTO_TEST_CASE(a_triangle_is_named_by_its_place_in_its_own_file) {
    AssemblyFolder folder;
    folder.problem.rules.goalContact.reset();
    folder.write();
    const auto touched = factsOf(folder, "info a.cfg")["at_goal"]["pair"]["environment"];
    BOOST_TEST(touched["triangle"] >= 12);  // the shelf's triangles are 12 to 23 of blocks.obj
    BOOST_TEST(touched["triangle"] < 24);
    BOOST_TEST(touched["mesh"] == "blocks/shelf");
    requireRefused(folder, kPlan, {"triangle " + touched["triangle"].dump(), "'blocks/shelf'"});
}

BOOST_AUTO_TEST_CASE(a_part_inside_a_solid_is_told_so) {
    AssemblyFolder folder;
    saveMesh(translated(box({60, 60, 60}), {-60, 0, 0}), folder.file("block.obj"));
    folder.problem.meshes.world = folder.file("block.obj");
    folder.problem.meshes.furtherWorlds.clear();
    folder.problem.rules = {};
    folder.write();
    BOOST_TEST(runIn(folder, std::string(kPlan) + " --time 0.1").code == 2);  // both, expected one of them
    BOOST_TEST(runIn(folder, "plan a.cfg --path out.path --time 0.2").code == 1);
    folder.problem.rules.isAllSolid = true;
    folder.write();
    requireRefused(folder, kPlan, {"start is " + beginningOf(WhyInvalid::Kind::kInSolid), "'plate'"});
    const auto start = factsOf(folder, "info a.cfg")["at_start"];
    BOOST_TEST(start["kind"] == nameOf(WhyInvalid::Kind::kInSolid));
    BOOST_TEST(start["why_not"].get<std::string>().find("'plate'") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(info_tells_how_obstacles_count) {
    AssemblyFolder folder;
    folder.problem.rules.ignored = {"wall/left"};
    folder.write();
    const auto facts = factsOf(folder, "info a.cfg");
    int shelves = 0;
    for (const auto& obstacle : facts["obstacles"]) shelves += obstacle["ignored_near_goal"] == true;
    BOOST_TEST(shelves == 1);
    const Outcome outcome = runIn(folder, "info a.cfg");
    BOOST_TEST(holds(outcome.out, "'blocks/shelf': 12 triangles, margin 0, solid, ignored near the goal"));
    BOOST_TEST(row(outcome, "ignored") == "'wall/left'");
}

BOOST_AUTO_TEST_CASE(what_is_ignored_is_not_shown) {
    AssemblyFolder folder;
    folder.problem.rules = {};
    folder.problem.rules.ignored = {"wall"};
    folder.write();
    writePath({folder.problem.start, folder.problem.goal}, Space::kSe3, folder.file("in.path"));
    runIn(folder, "check a.cfg in.path --report page.html --export motion.glb");
    BOOST_TEST(holds(readText(folder.file("page.html")), "drawn with all of its 24 triangles"));
    std::string names;
    for (const Component& component : loadMesh(folder.file("motion.glb")).components)
        names += component.name + " ";
    BOOST_TEST(names == "blocks/tray blocks/shelf plate ");

    const std::string render = "render a.cfg in.path --size 160x90 --samples 1 --out ";
    BOOST_TEST(runIn(folder, render + "ignored.png").code == 0);
    folder.problem.meshes.world = folder.file("blocks.obj");
    folder.problem.meshes.furtherWorlds.clear();
    folder.problem.rules = {};
    folder.write();
    BOOST_TEST(runIn(folder, render + "absent.png").code == 0);
    BOOST_TEST((readText(folder.file("ignored.png")) == readText(folder.file("absent.png"))));
}

BOOST_AUTO_TEST_CASE(where_all_is_ignored_no_clearance_is_told) {
    AssemblyFolder folder;
    folder.problem.rules = {};
    folder.problem.rules.ignored = {"wall", "blocks"};
    folder.write();
    writePath({folder.problem.start, folder.problem.goal}, Space::kSe3, folder.file("in.path"));
    const auto drawn = factsOf(folder, "render a.cfg in.path --size 160x90 --samples 1 --out a.png");
    BOOST_TEST(drawn["poses"][0]["valid"] == true);
    BOOST_TEST(drawn["poses"][0]["clearance"].is_null());
    BOOST_TEST(runIn(folder, "check a.cfg in.path --report page.html").code == 0);
    BOOST_TEST(holds(readText(folder.file("page.html")), "\"clearance\":null,\"isFree\":true"));
}

BOOST_AUTO_TEST_CASE(names_that_are_none_are_refused_with_those_there_are) {
    AssemblyFolder folder;
    folder.problem.rules.ignored = {"roof"};
    folder.write();
    for (const char* command : {kPlan, "info a.cfg"})
        requireRefused(folder, command, {"a.cfg", "ignore", "'roof'", "'wall/below'", "'blocks/shelf'"});
    folder.problem.rules.ignored.clear();
    folder.problem.meshes.furtherWorlds.push_back(folder.file("none.obj"));
    folder.write();
    requireRefused(folder, kPlan, {"none.obj"});
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::testing
