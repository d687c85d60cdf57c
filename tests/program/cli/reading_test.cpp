// The program says how meshes were read: checked or not, units, polygons that are left out, equal names.
#include <assimp/scene.h>

#include <assimp/Exporter.hpp>
#include <assimp/Importer.hpp>

#include "clearway/problem.h"
#include "program/cli/run_program.h"
#include "support/random_meshes.h"

namespace clearway::testing {
BOOST_AUTO_TEST_SUITE(reading_test)

Mesh body(const Vector3& half, const Vector3& place) {
    return named(translated(box(half), place), "Body");
}

/// A block above a floor; both are called Body.
struct BodyFolder : TemporaryFolder {
    BodyFolder() {
        save("block", ".obj", body({1, 1, 1}, {0, 0, 2}));
        save("floor", ".obj", body({3, 3, 1}, {0, 0, -1}));
    }
    void save(const std::string& name, const std::string& ending, const Mesh& mesh) {
        saveMesh(mesh, file(name + ending));
    }
};

BOOST_AUTO_TEST_CASE(every_verdict_says_that_assimp_alone_read_a_mesh) {
    const BodyFolder folder;
    saveMesh(body({1, 1, 1}, {0, -5, 8}), folder.file("high.obj"));  // above the floor when turned, too
    Assimp::Importer importer;
    BOOST_TEST_REQUIRE(importer.ReadFile(folder.file("high.obj"), 0));
    Assimp::Exporter exporter;
    BOOST_TEST_REQUIRE(exporter.Export(importer.GetScene(), "3ds", folder.file("block.3ds")) ==
                       aiReturn_SUCCESS);
    const std::string words = "not checked: 3DS is read by assimp alone",
                      scope = "for the triangles that assimp delivered";

    BOOST_TEST(holds(runIn(folder, "info block.3ds").out, words, "by assimp: x' = "));
    BOOST_TEST(factsOf(folder, "info block.3ds")["mesh"]["reading"] == "unchecked");
    const Outcome made = runIn(folder, "init block.3ds floor.obj --out p.cfg --json facts.json");
    BOOST_TEST(holds(made.err, words), made.err);
    BOOST_TEST(holds(readText(folder.file("p.cfg")), "but for what assimp turns"));
    BOOST_TEST(jsonIn(folder, "facts.json")["part"]["reading"] == "unchecked");
    const Outcome planned =
        runIn(folder, "plan p.cfg --path o.path --quick --iterations 5000 --json facts.json");
    BOOST_TEST(planned.code == 0, planned.err);
    BOOST_TEST(holds(planned.err, words), planned.err);
    BOOST_TEST(holds(row(planned, "audit"), "certified " + scope), planned.out);
    const Outcome checked = runIn(folder, "check p.cfg o.path --report page.html --json facts.json");
    BOOST_TEST(checked.code == 0, checked.err);
    BOOST_TEST(holds(checked.err, words), checked.err);
    BOOST_TEST(holds(row(checked, "audit"), "certified " + scope), checked.out);
    BOOST_TEST(jsonIn(folder, "facts.json")["part"]["reading"] == "unchecked");
    BOOST_TEST(jsonIn(folder, "facts.json")["obstacles"][0]["reading"] == "checked");
    BOOST_TEST(holds(readText(folder.file("page.html")), words, scope));
}

BOOST_AUTO_TEST_CASE(a_checked_mesh_needs_no_words_and_equal_names_are_told_apart) {
    const BodyFolder folder;
    BOOST_TEST(runIn(folder, "init block.obj floor.obj --out p.cfg").code == 0);
    const Outcome planned = runIn(folder, "plan p.cfg --path o.path --quick --iterations 5000");
    BOOST_TEST(planned.err == "");
    BOOST_TEST(row(planned, "audit") == "valid along the whole path, certified");
    BOOST_TEST(holds(planned.out, "block.obj/Body", "floor.obj/Body"), planned.out);
}

BOOST_AUTO_TEST_CASE(init_writes_the_unit_that_all_files_state) {
    const BodyFolder folder;
    saveMesh(body({1, 1, 1}, {0, 0, 2}), folder.file("block.glb"));
    saveMesh(body({3, 3, 1}, {0, 0, -1}), folder.file("floor.glb"));
    BOOST_TEST(runIn(folder, "init block.glb floor.glb --out p.cfg").code == 0);
    BOOST_TEST(readProblem(folder.file("p.cfg")).unit == "m");
    BOOST_TEST(runIn(folder, "init block.glb floor.obj --out q.cfg").code == 0);
    BOOST_TEST(readProblem(folder.file("q.cfg")).unit == "");
    BOOST_TEST(factsOf(folder, "info block.glb")["mesh"]["unit_stated"] == "m");
}

BOOST_AUTO_TEST_CASE(polygons_that_are_left_out_or_bent_are_warned_of) {
    const BodyFolder folder;
    folder.write("odd.obj", readText(folder.file("floor.obj")) +
                                "v 10 0 0\nv 11 1 0\nv 11 0 0\nv 10 1 0\nf -4 -3 -2 -1\nv 20 0 0\nv 21 0 "
                                "0\nv 21 1 0.2\nv 20 1 0\nf -4 -3 -2 -1\n");
    BOOST_TEST(runIn(folder, "init block.obj odd.obj --out p.cfg").code == 0);
    const Outcome planned = runIn(folder, "plan p.cfg --path o.path --quick --iterations 5000");
    const Outcome checked = runIn(folder, "check p.cfg o.path");
    for (const Outcome& outcome : {planned, checked})
        BOOST_TEST(holds(outcome.err, "1 face left out, whose outline crosses itself", "1 face not flat"),
                   outcome.err);
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::testing
