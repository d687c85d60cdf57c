// The program from two meshes to a path, and its facts as JSON.
#include <filesystem>
#include <set>

#include "clearway/obstacle_groups.h"
#include "clearway/problem.h"
#include "program/cli/run_program.h"
#include "support/random_meshes.h"

namespace clearway::testing {
BOOST_AUTO_TEST_SUITE(init_test)

Mesh named(const Mesh& mesh, const std::string& name, const Vector3& place) {
    return testing::named(translated(mesh, place), name);
}

/// A block beside a plate that hides its way out on one side, and a floor.
struct MeshFolder : TemporaryFolder {
    MeshFolder() {
        saveMesh(named(box({1, 1, 1}), "block", {20, 0, 1.5}), file("block.obj"));
        saveMesh(
            joined(named(box({3, 3, 1}), "floor", {20, 0, -1}), named(box({0.5, 3, 3}), "plate", {22, 0, 2})),
            file("rest.obj"));
        saveMesh(named(box({3, 3, 1}), "seat", {20, 0, -0.5}), file("seat.obj"));
    }
};

BOOST_AUTO_TEST_CASE(init_writes_a_problem_that_plan_solves) {
    const MeshFolder folder;
    const auto made = factsOf(folder, "init block.obj rest.obj --out p.cfg");
    BOOST_TEST(made["part"]["triangles"] == 12);
    BOOST_TEST(made["part"]["closed"] == true);
    BOOST_TEST(made["clearance_at_start"].get<double>() == 0.5, boost::test_tools::tolerance(1e-6));
    const Problem problem = readProblem(folder.file("p.cfg"));
    BOOST_TEST(problem.meshes.isReadingStated);
    BOOST_TEST(!problem.meshes.asOmplApp);
    BOOST_TEST(problem.outside.has_value());
    BOOST_TEST(problem.volume.has_value());
    const Outcome planned = runIn(folder, "plan p.cfg --path o.path --quick --iterations 5000");
    BOOST_TEST(planned.code == 0, planned.err);
    BOOST_TEST(planned.err == "");
    const auto seat = factsOf(folder, "init block.obj rest.obj seat.obj --out seat.cfg");
    BOOST_TEST(seat["touched_at_start"].dump() == R"(["seat"])");
    BOOST_TEST(holds(readText(folder.file("seat.cfg")), "# contact.start = seat"));
    BOOST_TEST(runIn(folder, "init block.obj --out p.cfg").code == 2);
    requireRefused(folder, "init block.obj rest.obj --out p.txt", {"ends in .cfg"});
}

BOOST_AUTO_TEST_CASE(init_sends_a_part_that_starts_outside_to_the_far_side) {
    const MeshFolder folder;
    saveMesh(named(box({1, 1, 1}), "block", {5, 0, 2}), folder.file("left.obj"));
    saveMesh(named(box({1, 1, 1}), "block", {20, 0.5, 90}), folder.file("above.obj"));
    runIn(folder, "init left.obj rest.obj --out left.cfg");
    BOOST_TEST(runIn(folder, "plan left.cfg --path o.path --quick --iterations 5000").code == 0);
    BOOST_TEST(readPath(folder.file("o.path"), Space::kSe3).back().position.x() > 15);
    const Outcome above = runIn(folder, "init above.obj rest.obj --out above.cfg");
    BOOST_TEST(holds(row(above, "goal"), "outside on -z", "starts outside on +z"), above.out);
}

BOOST_AUTO_TEST_CASE(the_deflection_of_the_files_is_shown_beside_every_clearance) {
    const MeshFolder folder;
    Mesh block = named(box({1, 1, 1}), "block", {20, 0, 1.5});
    block.components[0].deflection = 0.02;
    saveMesh(block, folder.file("block.3mf"));
    Mesh floor = named(box({3, 3, 1}), "floor", {20, 0, -1});
    floor.components[0].deflection = 0.05;
    saveMesh(floor, folder.file("floor.3mf"));
    const std::string says = "0.05; certified for these triangles; the surfaces may be up to 2 x 0.05 closer";
    const Outcome made = runIn(folder, "init block.3mf floor.3mf --out p.cfg");
    BOOST_TEST(row(made, "deflection") == says);
    BOOST_TEST(readProblem(folder.file("p.cfg")).deflection == 0.05);
    BOOST_TEST(row(runIn(folder, "info p.cfg"), "deflection") == says);
    BOOST_TEST(row(runIn(folder, "plan p.cfg --path o.path --quick --iterations 5000"), "deflection") ==
               says);
    BOOST_TEST(row(runIn(folder, "check p.cfg o.path"), "deflection") == says);
    BOOST_TEST(factsOf(folder, "check p.cfg o.path")["deflection"] == 0.05);
    folder.write("poses", "0 0 0 0 0 0 1\n");
    const std::string query = "query --part block.3mf --environment floor.3mf --poses poses --query distance";
    BOOST_TEST(row(runIn(folder, query), "deflection") == says);
    const Outcome mesh = runIn(folder, "info block.3mf");
    BOOST_TEST(row(mesh, "deflection stated") == "0.02", mesh.out);
}

BOOST_AUTO_TEST_CASE(a_step_file_is_refused_with_the_command_that_makes_a_mesh) {
    const MeshFolder folder;
    folder.write("part.step", "ISO-10303-21;\nHEADER;\nFILE_SCHEMA(('AUTOMOTIVE_DESIGN'));\nENDSEC;\n");
    requireRefused(folder, "info part.step", {"clearway-cad 'part.step' --out 'part.3mf'"});
    // Here clearway-cad is neither beside the program nor on the PATH.
    std::filesystem::create_directory(folder.file("bin"));
    std::filesystem::copy_file(kProgram, folder.file("bin/clearway"));
    requireRefused(folder, "init part.step rest.obj --out p.cfg",
                   {"'part.step'", "neither in " + folder.file("bin"), "PATH", "Debian package",
                    "clearway-cad 'part.step' --out 'part.3mf'"},
                   "PATH= " + folder.file("bin/clearway"));
}

BOOST_AUTO_TEST_CASE(a_mesh_is_no_problem_and_a_problem_no_mesh) {
    const MeshFolder folder;
    saveMesh(named(box({1, 1, 1}), "block", {20, 0, 1.5}), folder.file("block.3mf"));
    folder.write("part.step", "ISO-10303-21;\n");
    folder.write("path", "0 0 0 0 0 0 1\n");
    for (const std::string words : {"plan block.3mf --path o.path", "check block.obj path",
                                    "render block.obj --out o.png", "bench block.3mf --log o.log"})
        requireRefused(folder, words, {"'block.", "is a mesh file", "problem file (.cfg)", "clearway init"});
    requireRefused(folder, "plan part.step --path o.path", {"is a CAD or scene file", "clearway init"});
    std::filesystem::copy_file(folder.file("block.3mf"), folder.file("block"));
    requireRefused(folder, "plan block --path o.path", {"'block'", "it is no text", "clearway init"});
    runIn(folder, "init block.obj rest.obj --out p.cfg");
    const std::string query = "query --part p.cfg --environment rest.obj --poses path --query distance";
    for (const std::string& words : {std::string("init p.cfg --part lid --out q.cfg"), query})
        requireRefused(folder, words, {"'p.cfg'", "it is a problem file", "expected a mesh file"});
    requireRefused(folder, "check p.cfg block.3mf", {"'block.3mf'", "it is no text", "path"});
}

/// Lines of choice stand in comments: each counts once its "# " is taken out.
BOOST_AUTO_TEST_CASE(lines_of_choice_that_init_writes_can_be_switched_on) {
    const MeshFolder folder;
    runIn(folder, "init block.obj rest.obj seat.obj --out p.cfg");
    std::string text = readText(folder.file("p.cfg"));
    for (const std::string key : {"unit", "outside", "contact.start"}) {
        const std::size_t at = text.find("# " + key + " = ");
        BOOST_TEST_REQUIRE(at != std::string::npos, key);
        text.erase(at, 2);
    }
    folder.write("p.cfg", text);
    const Problem problem = readProblem(folder.file("p.cfg"));
    BOOST_TEST(problem.unit == "mm");
    BOOST_TEST(problem.rules.startContact.has_value());
}

BOOST_AUTO_TEST_CASE(init_keeps_an_old_problem_and_writes_no_name_that_cannot_be_read_back) {
    const MeshFolder folder;
    folder.write("p.cfg", "mine");
    BOOST_TEST(runIn(folder, "init block.obj rest.obj --out p.cfg").code == 0);
    BOOST_TEST(readText(folder.file("p.cfg.old")) == "mine");
    std::filesystem::copy_file(folder.file("block.obj"), folder.file("a #1.obj"));
    for (const char* words :
         {"init \"a #1.obj\" rest.obj --out q.cfg", "init block.obj \"a #1.obj\" --out q.cfg"})
        requireRefused(folder, words, {"'a #1.obj'", "without #"});
    BOOST_TEST(!std::filesystem::exists(folder.file("q.cfg")));
}

BOOST_AUTO_TEST_CASE(what_may_mislead_about_the_start_is_said) {
    const MeshFolder folder;
    saveMesh(named(box({9, 9, 9}), "rock", {20, 0, 1.5}), folder.file("rock.obj"));
    const Outcome inside = runIn(folder, "init block.obj rock.obj --out r.cfg");
    BOOST_TEST(holds(inside.err, "inside 'rock'", "solid = rock"), inside.err);
    BOOST_TEST(holds(runIn(folder, "info r.cfg").err, "inside 'rock'"));
    saveMesh(named(box({0.2, 0.2, 0.2}), "gear", {20, 0, 1.5}), folder.file("gear.obj"));
    // The block stands on the seat, too.
    const Outcome around = runIn(folder, "init block.obj seat.obj gear.obj --out g.cfg");
    BOOST_TEST(holds(around.err, "'gear' is inside the part", "ignore = gear"), around.err);
    BOOST_TEST(holds(runIn(folder, "info g.cfg").err, "at the start 'gear' is inside the part"));
    folder.write("g.cfg", readText(folder.file("g.cfg")) + "ignore = gear\n");
    BOOST_TEST(!holds(runIn(folder, "info g.cfg").err, "inside"));
    saveMesh(named(box({1e3, 1e3, 1e3}), "metres", {0, 0, 0}), folder.file("large.obj"));
    const Outcome units = runIn(folder, "init large.obj rest.obj --out u.cfg");
    BOOST_TEST(holds(units.err, "one unit?"), units.err);
    BOOST_TEST(runIn(folder, "init block.obj rest.obj --out p.cfg").err == "");
}

BOOST_AUTO_TEST_CASE(a_mesh_without_area_is_named) {
    const MeshFolder folder;
    folder.write("flat.obj", "o line\nv 0 0 9\nv 1 0 9\nv 3 0 9\nf 1 2 3\no dot\nv 5 5 9\nf 4 4 4\n");
    const Outcome made = runIn(folder, "init block.obj rest.obj flat.obj --out p.cfg");
    BOOST_TEST(made.code == 0, made.err);
    BOOST_TEST(holds(made.err, "flat.obj: zero area", "'line', 'dot'"), made.err);
    folder.write("dot.obj", "o dot\nv 5 5 9\nf 1 1 1\n");
    const std::string alone = runIn(folder, "init block.obj dot.obj --out q.cfg").err;
    BOOST_TEST(holds(alone, "dot.obj: zero area: "), alone);
    BOOST_TEST(!holds(alone, "in one unit?"), alone);  // there is no size to compare
}

BOOST_AUTO_TEST_CASE(init_and_plan_give_the_same_advice_about_parts_that_touch_at_the_start) {
    const MeshFolder folder;
    const Outcome made = runIn(folder, "init block.obj rest.obj seat.obj --out p.cfg");
    const std::string refused = runIn(folder, "plan p.cfg --path o.path").err;
    const std::size_t begin = refused.find("; if the parts are assembled so, write in [clearway] ");
    BOOST_TEST_REQUIRE(begin != std::string::npos, refused);
    const std::string advice = refused.substr(begin, refused.find('\n') - begin), told = row(made, "start");
    BOOST_TEST_REQUIRE(told.size() > advice.size(), told);
    BOOST_TEST(told.substr(told.size() - advice.size()) == advice);
    const std::string text = readText(folder.file("p.cfg"));
    for (const std::string key : {"contact.start", "ignore", "overlap"}) {
        BOOST_TEST(holds(advice, key + " = "), advice);
        BOOST_TEST(holds(text, "# " + key + " = "), text);
    }
}

BOOST_AUTO_TEST_CASE(facts_are_json_with_the_names_of_the_rows) {
    const MeshFolder folder;
    runIn(folder, "init block.obj rest.obj --out p.cfg");
    const auto facts = factsOf(folder, "plan p.cfg --path o.path --quick --iterations 5000");
    BOOST_TEST(facts["found"].get<bool>());
    BOOST_TEST(facts["audit"]["verdict"].get<std::string>() == "valid");
    BOOST_TEST(facts["path"]["states"].get<std::size_t>() ==
               readPath(folder.file("o.path"), Space::kSe3).size());
    const Outcome printed = runIn(folder, "plan p.cfg --path - --quick --iterations 5000 --json f.json");
    BOOST_TEST(printed.out == readText(folder.file("o.path")));
    const auto audit = factsOf(folder, "check p.cfg o.path");
    BOOST_TEST(audit["valid_share"].get<double>() == 1);
    BOOST_TEST(audit["audit"]["segments"].size() == facts["path"]["states"].get<std::size_t>() - 1);
    requireRefused(folder, "check p.cfg o.path --json - --csv -", {"is -", "too, expected a file"});
    requireRefused(folder, "plan p.cfg --path o.path --report -", {"--report is '-'", "the name of a file"});
}

BOOST_AUTO_TEST_CASE(the_room_that_a_part_takes_is_written) {
    const MeshFolder folder;
    runIn(folder, "init block.obj rest.obj --out p.cfg");
    runIn(folder, "plan p.cfg --path o.path --quick --iterations 5000");
    const Outcome swept = runIn(folder, "check p.cfg o.path --swept room.stl --swept-tolerance 0.5");
    BOOST_TEST(swept.code == 0, swept.err);
    BOOST_TEST(boundingBox(loadMesh(folder.file("room.stl"))).contains(Vector3(20, 0, 1.5)));
    // The block turns by 0.1 about z, 20 from it; the longer way round would sweep a ring.
    folder.write("turn.path", "0 0 9 0 0 0 1\n0 0 9 0 0 -0.0499791692706783 -0.998750260394966\n");
    BOOST_TEST(
        runIn(folder, "check p.cfg turn.path --any-ends --swept turn.stl --swept-tolerance 0.5").code == 0);
    BOOST_TEST(boundingBox(loadMesh(folder.file("turn.stl"))).min().x() > 15);
    folder.write("mm.cfg", readText(folder.file("p.cfg")) + "unit = mm\n");
    const Outcome inMetres = runIn(folder, "check mm.cfg o.path --swept room.glb --swept-tolerance 0.5");
    BOOST_TEST(holds(row(inMetres, "swept"), "in metres"), inMetres.out);
    const Box box = boundingBox(loadMesh(folder.file("room.glb")));
    BOOST_TEST(box.contains(Vector3(0.020, 0.0015, 0)));  // y is up in .glb files
    BOOST_TEST(box.sizes().maxCoeff() < 0.1);
    BOOST_TEST(runIn(folder, "check p.cfg o.path --swept room.txt").code == 2);
    BOOST_TEST(runIn(folder, "check p.cfg o.path --swept-tolerance 1").code == 2);
}

BOOST_AUTO_TEST_CASE(lengths_carry_the_unit_that_the_problem_states) {
    const MeshFolder folder;
    runIn(folder, "init block.obj rest.obj --out p.cfg");
    const std::string text = readText(folder.file("p.cfg"));
    const auto write = [&](const std::string& unit) {
        folder.write("u.cfg", text + "unit = " + unit + "\n");
    };
    write("mm");
    const Outcome planned =
        runIn(folder, "plan u.cfg --path o.path --quick --iterations 5000 --export o.glb --json f.json");
    BOOST_TEST(planned.code == 0, planned.err);
    for (const char* label : {"length", "margin", "floor", "  on the part", "  pose of the part"})
        BOOST_TEST(holds(row(planned, label), " mm"), label);
    BOOST_TEST(holds(row(planned, "export"), "in metres"));
    BOOST_TEST(jsonIn(folder, "f.json")["unit"] == "mm");
    const Outcome checked = runIn(folder, "check u.cfg o.path --brief --csv o.csv");
    BOOST_TEST(!holds(checked.out, "segment  verdict"));
    for (const char* label : {"least clearance", "  on the obstacle"})
        BOOST_TEST(row(checked, label) == row(planned, label));
    BOOST_TEST(holds(readText(folder.file("o.csv")), ",block,"));
    BOOST_TEST(!holds(runIn(folder, "check p.cfg o.path").out, " mm"));
    write("yards");
    requireRefused(folder, "plan u.cfg --path o.path", {"unit is 'yards'", "um, mm, cm, m, km, in, ft"});
}

BOOST_AUTO_TEST_CASE(facts_of_other_subcommands_are_json_too) {
    const MeshFolder folder;
    runIn(folder, "init block.obj rest.obj --out p.cfg");
    const auto problem = factsOf(folder, "info p.cfg");
    BOOST_TEST(problem["at_start"]["valid"].get<bool>());
    BOOST_TEST(problem["at_start"]["pair"]["part"]["mesh"] == "block");
    BOOST_TEST(problem["goal"] == "outside");
    BOOST_TEST(problem["unit"].is_null());
    BOOST_TEST(problem["environment"]["triangles"] == 24);
    const auto drawn = factsOf(folder, "render p.cfg --out p.png --size 32x24 --samples 1");
    BOOST_TEST(drawn["poses"][0]["valid"].get<bool>());
    BOOST_TEST(drawn["picture"] == "p.png");
    const auto scene =
        factsOf(folder, "puzzle --out s --no-preview --part-triangles 500 --environment-triangles 500", 0,
                kSceneProgram);
    BOOST_TEST(scene["least_clearance"].get<double>() > 0);
    const auto bench = factsOf(folder, "bench p.cfg --runs 1 --time 5 --planner RRTConnect --log b.log");
    BOOST_TEST(bench["planners"][0]["runs"].size() == 1u);
}

BOOST_AUTO_TEST_CASE(pages_for_readers_and_shells_are_printed) {
    const TemporaryFolder folder;
    BOOST_TEST(holds(runIn(folder, "help formats").out, "qx qy qz qw"));
    BOOST_TEST(holds(runIn(folder, "plan --list-options").out, "--seed\n"));
    BOOST_TEST(holds(runIn(folder, "check --man").out, ".TH CLEARWAY-CHECK 1"));
    BOOST_TEST(holds(runIn(folder, "--man").out, ".TH CLEARWAY 1", "\n.B clearway plan\n"));
    BOOST_TEST(holds(runIn(folder, "--completion").out, "complete",
                     "-F _clearway clearway clearway-cad clearway-scene"));
}

/// The obstacles of a problem, by their names.
std::set<std::string> obstacleNames(const Problem& problem) {
    std::set<std::string> names;
    for (const Mesh& world : loadWorlds(problem)) {
        for (const Component& component : world.components) {
            if (component.triangleCount > 0) names.insert(component.name);
        }
    }
    return names;
}

BOOST_AUTO_TEST_CASE(one_part_of_an_assembly_moves_and_every_other_one_stands_still) {
    const TemporaryFolder folder;
    const Mesh block = named(box({1, 1, 1}), "block", {20, 0, 1.5}),
               pin = named(box({0.2, 0.2, 0.2}), "pin", {20, 0, 3}),
               floor = named(box({3, 3, 1}), "floor", {20, 0, -1}),
               plate = named(box({0.5, 3, 3}), "plate", {22, 0, 2});
    saveMesh(assembled({block, floor, plate, pin}), folder.file("all.glb"));
    const auto made = factsOf(folder, "init all.glb --part block --out p.cfg");
    BOOST_TEST(made["part"]["triangles"] == 12);
    BOOST_TEST(made["environment"]["triangles"] == 36);
    BOOST_TEST(made["clearance_at_start"].get<double>() == 0.3, boost::test_tools::tolerance(1e-6));
    const Problem problem = readProblem(folder.file("p.cfg"));
    BOOST_TEST(problem.meshes.partNames == std::vector<std::string>({"block"}),
               boost::test_tools::per_element());
    BOOST_TEST(loadPart(problem).components.size() == 1u);
    BOOST_TEST(obstacleNames(problem) == std::set<std::string>({"floor", "pin", "plate"}),
               boost::test_tools::per_element());
    BOOST_TEST(runIn(folder, "plan p.cfg --path p.path --time 20").code == 0);
    const Outcome checked = runIn(folder, "check p.cfg p.path --json p.json --report p.html");
    BOOST_TEST(checked.code == 0);
    BOOST_TEST(holds(row(checked, "part"), "'block' of all.glb, 12 triangles"), checked.out);
    BOOST_TEST(jsonIn(folder, "p.json")["obstacles"][0]["names"].dump() == R"(["floor","plate","pin"])");
    BOOST_TEST(factsOf(folder, "info p.cfg")["environment"]["components"].size() == 3u);
    const std::string page = readText(folder.file("p.html")), opening = "type=\"application/json\">";
    BOOST_TEST(holds(page, "'block' of all.glb, 12 triangles"));
    const std::size_t begin = page.find(opening) + opening.size();
    const auto shown = nlohmann::json::parse(page.substr(begin, page.find("</script>", begin) - begin));
    BOOST_TEST(shown["environment"]["objects"].size() == 3u);

    factsOf(folder, "init all.glb --part block --part pin --out two.cfg");
    const Problem two = readProblem(folder.file("two.cfg"));
    BOOST_TEST(loadPart(two).components.size() == 2u);
    BOOST_TEST(obstacleNames(two) == std::set<std::string>({"floor", "plate"}),
               boost::test_tools::per_element());
    writeProblem(two, folder.file("again.cfg"));
    BOOST_TEST((readProblem(folder.file("again.cfg")).meshes.partNames == two.meshes.partNames));

    std::filesystem::create_directory(folder.file("parts"));
    for (const Mesh& mesh : {block, floor, plate})
        saveMesh(mesh, folder.file("parts/" + mesh.components[0].name + ".stl"));
    factsOf(folder, "init parts --part block --out folder.cfg");
    const Problem files = readProblem(folder.file("folder.cfg"));
    BOOST_TEST(files.meshes.partNames.empty());
    BOOST_TEST(std::filesystem::path(files.meshes.robot).filename() == "block.stl");
    BOOST_TEST(worldFiles(files).size() == 2u);
    BOOST_TEST(holds(runIn(folder, "init parts --part 'pl*' --out moves.cfg").out, "moves:", "'plate'"));
    folder.write("parts/hinge.step", "ISO-10303-21;");
    requireRefused(folder, "init parts --part block --out q.cfg",
                   {"'hinge.step'", "not read", "clearway-cad"});
    std::filesystem::remove(folder.file("parts/hinge.step"));

    requireRefused(folder, "init all.glb --out q.cfg", {"no ENVIRONMENT", "--part"});
    requireRefused(folder, "init all.glb --part lid --out q.cfg", {"'lid'", "block"});
    requireRefused(folder, "init all.glb --part block,pin --out q.cfg", {"for several parts repeat --part"});
    requireRefused(folder, "init all.glb --part Block --out q.cfg", {"did you mean 'block'?"});
    requireRefused(folder, "init parts/block.stl --part block --out q.cfg", {"names all parts"});
    requireRefused(folder, "init parts --part '*' --out q.cfg", {"names all parts"});

    factsOf(folder, "init parts --part 'pl*' --part block --out of_files.cfg");
    const Problem ofFiles = readProblem(folder.file("of_files.cfg"));
    BOOST_TEST(loadPart(ofFiles).components.size() == 2u);
    BOOST_TEST(loadPart(ofFiles).triangles.size() == 24u);
    BOOST_TEST(obstacleNames(ofFiles) == std::set<std::string>({"floor"}), boost::test_tools::per_element());
    // Rules call obstacles by their names in the whole folder, also when one file is left.
    Problem ignoring = ofFiles;
    ignoring.rules.ignored = {"floor"};
    BOOST_TEST(obstaclesOf(ignoring, loadWorlds(ignoring)).groups.empty());
    std::filesystem::create_directory(folder.file("two"));
    saveMesh(assembled({named(box({1, 1, 1}), "f", {90, 0, 0}), named(box({1, 1, 1}), "g", {95, 0, 0})}),
             folder.file("two/f.obj"));
    saveMesh(named(box({0.5, 0.5, 0.5}), "h", {95, 0, 0}), folder.file("two/h.obj"));
    factsOf(folder, "init two --part h --out two_files.cfg");
    Problem twoFiles = readProblem(folder.file("two_files.cfg"));
    twoFiles.meshes.partNames = {"h"};
    twoFiles.meshes.furtherWorlds.push_back(twoFiles.meshes.robot);
    twoFiles.rules.ignored = {"f/g"};
    const ObstacleGroups left = obstaclesOf(twoFiles, loadWorlds(twoFiles));
    BOOST_TEST(left.ignored == std::vector<std::string>{"f/g"}, boost::test_tools::per_element());
    BOOST_TEST_REQUIRE(left.groups.size() == 1u);
    BOOST_TEST(left.groups[0].mesh.triangles.size() == 12u);
}

/// A problem in memory that names parts but not their file among the environment's would lose the other parts without a word.
BOOST_AUTO_TEST_CASE(the_rest_of_an_assembly_is_never_lost) {
    const TemporaryFolder folder;
    saveMesh(assembled(
                 {named(box({1, 1, 1}), "block", {20, 0, 1.5}), named(box({3, 3, 1}), "floor", {20, 0, -1})}),
             folder.file("all.glb"));
    saveMesh(named(box({1, 1, 1}), "other", {30, 0, 0}), folder.file("other.obj"));
    const std::string start =
        "start.x = 0\nstart.y = 0\nstart.z = 0\nstart.axis.x = 0\nstart.axis.y = 0\nstart.axis.z = "
        "1\nstart.theta = 0\n";
    const auto read = [&](const std::string& world, const std::string& more) {
        return readProblem(folder.write("p.cfg", "[problem]\nrobot = all.glb\n" + world + start +
                                                     "[clearway]\ngoal = outside\npart = block\n" + more));
    };
    Problem problem = read("world = other.obj\n", "reading = stored\n");
    BOOST_TEST(obstacleNames(problem) == std::set<std::string>({"floor", "other"}),
               boost::test_tools::per_element());
    BOOST_TEST(obstacleNames(read("", "reading = stored\n")) == std::set<std::string>({"floor"}),
               boost::test_tools::per_element());
    BOOST_TEST(
        obstacleNames(read("world = ./all.glb\n", "reading = stored\n")) == std::set<std::string>({"floor"}),
        boost::test_tools::per_element());
    BOOST_CHECK_THROW(read("", "reading = omplapp\n"), std::invalid_argument);
    BOOST_CHECK_THROW(read("", "reading = stored\nworld.scale = 2\n"), std::invalid_argument);
    problem.meshes.world = folder.file("other.obj");
    problem.meshes.furtherWorlds.clear();
    BOOST_CHECK_THROW(loadWorlds(problem), std::invalid_argument);
    problem.meshes.partNames = {"bolt"};
    BOOST_CHECK_THROW(loadPart(problem), std::invalid_argument);
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::testing
