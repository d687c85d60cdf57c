#include "program/cli/assembly.h"

#include <filesystem>
#include <nlohmann/json.hpp>

#include "clearway/obstacle_groups.h"
#include "program/cli/run_program.h"
#include "support/assembled_problems.h"
#include "support/random_meshes.h"

namespace clearway::testing {
BOOST_AUTO_TEST_SUITE(assembly_test)

using cli::PartPair;

Mesh box(const std::string& name, const Vector3& low, const Vector3& high) {
    return boxMesh(Box(low, high), name);
}

/// A base; a lid that lies on it; a bolt pressed into it by 0.5; a pin 0.25 beside it; one far away; a core inside of it.
std::vector<Mesh> parts() {
    return {box("base", {0, 0, 0}, {10, 10, 4}),          box("lid", {0, 0, 4}, {10, 10, 5}),
            box("bolt", {9.5, 2, 1}, {12, 3, 2}),         box("pin", {-1, 5, 1}, {-0.25, 6, 2}),
            box("far", {100, 100, 100}, {101, 101, 101}), box("core", {4, 4, 1}, {6, 6, 3})};
}

BOOST_AUTO_TEST_CASE(pairs_are_overlaps_contacts_and_gaps_in_this_order) {
    const std::vector<PartPair> pairs = cli::pairsOf(assembled(parts()), 0.3);
    BOOST_TEST_REQUIRE(pairs.size() == 4u);
    const auto is = [&](std::size_t i, PartPair::Kind kind, const char* a, const char* b) {
        BOOST_TEST((pairs[i].kind == kind), i);
        BOOST_TEST(pairs[i].a == a);
        BOOST_TEST(pairs[i].b == b);
    };
    is(0, PartPair::Kind::kOverlap, "base", "core");  // 1 below the faces of the base
    BOOST_TEST(std::abs(pairs[0].depth->upper - 2) < 0.03);
    BOOST_TEST(std::abs(pairs[0].escape->upper - 3) < 0.01);
    is(1, PartPair::Kind::kOverlap, "base", "bolt");
    BOOST_TEST(pairs[1].depth->lower <= 0.5);
    BOOST_TEST(pairs[1].depth->upper >= 0.5);
    BOOST_TEST(pairs[1].depth->upper < 0.51);
    BOOST_TEST(pairs[1].escapeDirection == "+x");
    BOOST_TEST(pairs[1].escape->upper >= 0.5);
    BOOST_TEST(pairs[1].escape->upper < 0.501);
    is(2, PartPair::Kind::kContact, "base", "lid");
    BOOST_TEST(pairs[2].touchingTriangles >= 4u);
    BOOST_TEST((pairs[2].at - Vector3(5, 5, 4)).norm() < 5);
    BOOST_TEST(pairs[2].at.z() == 4);
    is(3, PartPair::Kind::kGap, "base", "pin");
    BOOST_TEST(pairs[3].lower <= 0.25);
    BOOST_TEST(pairs[3].upper >= 0.25);
    BOOST_TEST(pairs[3].at.x() == -0.125);
    BOOST_TEST(cli::pairsOf(assembled(parts()), 0.2).size() == 3u);
}

/// Surfaces of copies lie nowhere deep in each other, and a piece of a part may be inside of another one whose box does not hold the part's.
BOOST_AUTO_TEST_CASE(copies_and_pieces_inside_are_overlaps_and_a_block_in_a_corner_is_not) {
    const auto copies =
        cli::pairsOf(assembled({box("a", {0, 0, 0}, {10, 10, 10}), box("copy", {0, 0, 0}, {10, 10, 10})}), 0);
    BOOST_TEST_REQUIRE(copies.size() == 1u);
    BOOST_TEST((copies[0].kind == PartPair::Kind::kOverlap));
    BOOST_TEST(copies[0].doCoincide);
    BOOST_TEST(std::abs(copies[0].escape->upper - 10) < 0.01);

    const Mesh pieces =
        named(joined(box("b", {4, 4, 4}, {6, 6, 6}), box("c", {50, 50, 50}, {60, 60, 60})), "pieces");
    const auto inside = cli::pairsOf(assembled({box("a", {0, 0, 0}, {10, 10, 10}), pieces}), 0.1);
    BOOST_TEST_REQUIRE(inside.size() == 1u);
    BOOST_TEST((inside[0].kind == PartPair::Kind::kOverlap));
    BOOST_TEST(std::abs(inside[0].depth->upper - 5) < 1.1);

    const auto corner =
        cli::pairsOf(assembled({box("floor", {0, 0, 0}, {9, 9, 1}), box("wall", {0, 0, 1}, {1, 9, 9}),
                                box("block", {1, 1, 1}, {4, 4, 4})}),
                     0);
    BOOST_TEST(corner.size() == 3u);
    for (const PartPair& pair : corner)
        BOOST_TEST((pair.kind == PartPair::Kind::kContact), pair.a << " " << pair.b);
}

Mesh withoutLastTriangle(Mesh mesh) {
    mesh.triangles.pop_back();
    --mesh.components[0].triangleCount;
    return mesh;
}

Mesh sheet(const std::string& name, const Vector3& corner, const Vector3& u, const Vector3& v) {
    Mesh mesh;
    mesh.vertices = {corner, corner + u, corner + u + v, corner + v};
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    mesh.components = {{name, 0, 2}};
    return mesh;
}

PartPair pairOf(const Mesh& a, const Mesh& b) {
    const auto pairs = cli::pairsOf(assembled({a, b}), 0);
    BOOST_TEST_REQUIRE(pairs.size() == 1u);
    return pairs[0];
}

BOOST_AUTO_TEST_CASE(
    open_parts_that_touch_are_in_contact_and_those_that_cross_overlap_with_an_unknown_depth) {
    const Mesh lower = withoutLastTriangle(box("a", {0, 0, 0}, {1, 1, 1})),
               flat = sheet("flat", {0, 0, 0}, {9, 0, 0}, {0, 9, 0});
    const PartPair touching[] = {pairOf(lower, withoutLastTriangle(box("b", {0, 0, 1}, {1, 1, 2}))),
                                 pairOf(flat, sheet("T", {4, 1, 0}, {0, 3, 0}, {0, 0, 7})),
                                 pairOf(flat, sheet("copy", {1, 1, 0}, {3, 0, 0}, {0, 3, 0}))};
    for (const PartPair& pair : touching) {
        BOOST_TEST((pair.kind == PartPair::Kind::kContact), pair.b);
        BOOST_TEST(!pair.depth);
    }
    const PartPair crossing[] = {pairOf(lower, withoutLastTriangle(box("b", {0.5, 0.5, 0.5}, {2, 2, 2}))),
                                 pairOf(flat, sheet("X", {4, 1, -1}, {0, 3, 0}, {0, 0, 7}))};
    for (const PartPair& pair : crossing) {
        BOOST_TEST((pair.kind == PartPair::Kind::kOverlap), pair.b);
        BOOST_TEST(!pair.depth);
        BOOST_TEST(!pair.doCoincide);
    }
    BOOST_TEST(crossing[1].escapeDirection == "+z");
    BOOST_TEST(std::abs(crossing[1].escape->upper - 1) < 0.01);
    BOOST_TEST(crossing[1].at.x() == 4);
    BOOST_TEST(std::abs(crossing[1].at.z()) < 1e-9);
}

/// Nothing of thin plates lies deep in each other.
BOOST_AUTO_TEST_CASE(thin_plates_that_cross_overlap_and_those_that_stand_on_each_other_are_in_contact) {
    const Mesh flat = box("flat", {-50, -50, -0.01}, {50, 50, 0.01});
    const PartPair crossing = pairOf(flat, box("upright", {-0.01, -50, -50}, {0.01, 50, 50}));
    BOOST_TEST((crossing.kind == PartPair::Kind::kOverlap));
    BOOST_TEST(crossing.depth->lower <= 0.01);
    BOOST_TEST(std::abs(crossing.escape->upper - 50.01) < 0.01);
    for (const double sunk : {0.0, 0.005, 0.02})
        BOOST_TEST((pairOf(flat, box("on it", {-0.01, -50, 0.01 - sunk}, {0.01, 50, 50})).kind ==
                    PartPair::Kind::kContact),
                   sunk);
}

BOOST_AUTO_TEST_CASE(info_tells_the_pairs_of_a_folder_and_of_a_file) {
    const TemporaryFolder folder;
    std::filesystem::create_directory(folder.file("parts"));
    for (const Mesh& mesh : parts()) saveMesh(mesh, folder.file("parts/" + mesh.components[0].name + ".stl"));
    folder.write("parts/notes.txt", "no mesh");
    const Outcome found =
        runIn(folder, "info parts --near 0.3 --csv pairs.csv --json pairs.json --picture pairs.png");
    BOOST_TEST_REQUIRE(found.code == 0, found.err);
    BOOST_TEST(holds(row(found, "assembly"), "6 parts"), found.out);
    BOOST_TEST(holds(row(found, "contact"), "base", "lid"), found.out);
    BOOST_TEST(holds(row(found, "gap"), "0.25"), found.out);
    const auto json = nlohmann::json::parse(readText(folder.file("pairs.json")));
    BOOST_TEST_REQUIRE(json["pairs"].size() == 4u);
    BOOST_TEST(json["pairs"][1]["escape"]["direction"] == "+x");
    BOOST_TEST(readText(folder.file("pairs.png")).substr(1, 3) == "PNG");
    const std::string csv = readText(folder.file("pairs.csv"));
    BOOST_TEST(std::count(csv.begin(), csv.end(), '\n') == 5);

    BOOST_TEST(json["open_parts"].empty());

    std::vector<Mesh> opened = parts();
    opened[4].triangles.pop_back();
    --opened[4].components[0].triangleCount;
    saveMesh(assembled(opened), folder.file("all.glb"));
    const Outcome file = runIn(folder, "info all.glb --pairs");
    BOOST_TEST(
        holds(row(file, "overlap"), "'base' and 'core'", "; pushed through 'base', 'core' is out of it 3"),
        file.out);
    BOOST_TEST(!holds(file.out, "gap:"), file.out);
    BOOST_TEST(row(file, "open parts") == "1 of 6: 'far'");
    BOOST_TEST(!holds(runIn(folder, "info all.glb").out, "contact:"));

    std::filesystem::create_directory(folder.file("empty"));
    requireRefused(folder, "info empty", {"'empty' holds no mesh file", ".stl"});
    requireRefused(folder, "info parts --scale 2", {"--scale", "'parts'"});
    requireRefused(folder, "info parts --near -1", {"--near is '-1'"});
}

BOOST_AUTO_TEST_CASE(the_pump_in_data_is_as_it_is_made_and_its_parts_touch_as_described) {
    const Mesh made = pumpAssembly(), kept = loadMesh(CLEARWAY_DATA_DIR "/pump/pump.3mf");
    BOOST_TEST(kept.origin.unitMetres == 1e-3);
    BOOST_TEST_REQUIRE(kept.components.size() == 12u);
    for (std::size_t i = 0; i < 12; ++i) BOOST_TEST(kept.components[i].name == made.components[i].name);
    BOOST_TEST_REQUIRE(kept.triangles.size() == made.triangles.size());
    double farthest = 0;  // sines may differ by their last digits
    for (std::size_t i = 0; i < made.triangles.size(); ++i) {
        for (int k = 0; k < 3; ++k)
            farthest = std::max(
                farthest, (kept.vertices[kept.triangles[i][k]] - made.vertices[made.triangles[i][k]]).norm());
    }
    BOOST_TEST(farthest < 1e-4);
    std::size_t contacts = 0;
    for (const PartPair& pair : cli::pairsOf(kept, 0.1)) {
        BOOST_TEST((pair.kind != PartPair::Kind::kOverlap), pair.a << " and " << pair.b);
        contacts += pair.kind == PartPair::Kind::kContact;
    }
    BOOST_TEST(contacts == 3u);  // post, hub and pot stand on the base
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::testing
