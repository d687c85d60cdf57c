// The program clearway-cad: files that OpenCASCADE writes come back with their names, places and volumes, and damaged ones in one line.
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <fstream>

#include "cad/cad_file.h"
#include "cad/solids.h"
#include "clearway/problem.h"
#include "mesh/clean.h"
#include "mesh/components.h"
#include "mesh/topology.h"
#include "program/cli/run_program.h"

namespace clearway::testing {
BOOST_AUTO_TEST_SUITE(cad_test)

const std::string kCad = CLEARWAY_CAD_PROGRAM;

double volumeOf(const Mesh& mesh) {
    double six = 0;
    for (const TriangleIndices& t : mesh.triangles)
        six += mesh.vertices[t[0]].dot(mesh.vertices[t[1]].cross(mesh.vertices[t[2]]));
    return six / 6;
}

bool isClosed(const Mesh& mesh) {
    return checkEdges(clean(mesh).triangles).isClosed();
}

/// Checks that the mesh is closed, faces outwards, and encloses the shape's volume within the deflection.
void requireSameSolid(const Mesh& mesh, const TopoDS_Shape& shape) {
    BOOST_TEST(isClosed(mesh));
    const double room = 2 * deflectionOf(mesh) * exactArea(shape);
    BOOST_TEST(std::abs(volumeOf(mesh) - exactVolume(shape)) <= room, volumeOf(mesh)
                                                                          << " for " << exactVolume(shape));
}

Mesh converted(const TemporaryFolder& folder, const std::string& file, const std::string& options = "") {
    const Outcome outcome = runIn(folder, file + " --out out.3mf " + options, kCad);
    BOOST_TEST_REQUIRE(outcome.code == 0, outcome.err);
    BOOST_TEST(outcome.err == "");
    return loadMesh(folder.file("out.3mf"));
}

gp_Trsf moved(double x, double y, double z) {
    gp_Trsf result;
    result.SetTranslation(gp_Vec(x, y, z));
    return result;
}

BOOST_AUTO_TEST_CASE(solids_come_back_closed_with_name_volume_unit_and_deflection) {
    std::vector<NamedSolid> solids = curvedSolids();
    solids.push_back({"Gehäuse <1>", boxSolid(1, 2, 3)});
    for (const NamedSolid& solid : solids) {
        for (const std::string file : {"a.step", "a.igs"}) {
            BOOST_TEST_CONTEXT(solid.name << " in " << file) {
                const TemporaryFolder folder;
                const bool isStep = file == "a.step";
                if (isStep) {
                    writeStep(folder.file(file), solid);
                } else {
                    writeIges(folder.file(file), solid, true);
                }
                const Mesh mesh = converted(folder, file);
                BOOST_TEST(mesh.components.size() == 1u);
                if (isStep) BOOST_TEST(mesh.components[0].name == solid.name);
                BOOST_TEST(mesh.origin.unitMetres == 1e-3);
                const double diagonal = boundingBox(mesh).diagonal().norm();
                BOOST_TEST(mesh.origin.deflection >= 0.99e-3 * diagonal);
                BOOST_TEST(mesh.origin.deflection <= 1.5e-3 * diagonal);
                requireSameSolid(mesh, solid.shape);
                BOOST_TEST(converted(folder, file, "--deflection 0.5").origin.deflection == 0.5);
            }
        }
    }
}

BOOST_AUTO_TEST_CASE(faces_of_an_iges_file_without_solids_are_sewn) {
    const TemporaryFolder folder;
    const NamedSolid solid = {"block", boxSolid(30, 20, 10)};
    writeIges(folder.file("a.iges"), solid, false);
    const Mesh mesh = converted(folder, "a.iges");
    BOOST_TEST(mesh.components.size() == 1u);
    requireSameSolid(mesh, solid.shape);
}

BOOST_AUTO_TEST_CASE(instances_of_an_assembly_stand_in_their_places) {
    const TemporaryFolder folder;
    const NamedSolid block = {"block", cutBlock()}, ball = {"ball", BRepPrimAPI_MakeSphere(4).Shape()};
    gp_Trsf turned;
    turned.SetRotation(gp_Ax1(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1)), M_PI / 2);
    turned.SetTranslationPart(gp_Vec(100, 0, 0));
    gp_Trsf mirror;
    mirror.SetMirror(gp_Ax2(gp_Pnt(0, 0, 0), gp_Dir(1, 0, 0)));
    const NamedSolid mirrored = {"mirrored", BRepBuilderAPI_Transform(block.shape, mirror, true).Shape()};
    writeStep(folder.file("a.stp"), "machine",
              {{block, TopLoc_Location(moved(0, 0, 50))},
               {block, TopLoc_Location(turned)},
               {ball, TopLoc_Location(moved(0, 200, 0))},
               {mirrored, TopLoc_Location(moved(0, 0, -50))}});
    const Mesh mesh = converted(folder, "a.stp");
    std::vector<std::string> names;
    for (const Component& component : mesh.components) names.push_back(component.name);
    const std::vector<std::string> expected = {"block", "block#2", "ball", "mirrored"};
    BOOST_TEST_REQUIRE(names == expected, boost::test_tools::per_element());
    const Box boxes[] = {
        Box(Vector3(0, 0, 50), Vector3(30, 20, 70)), Box(Vector3(80, 0, 0), Vector3(100, 30, 20)),
        Box(Vector3(-4, 196, -4), Vector3(4, 204, 4)), Box(Vector3(-30, 0, -50), Vector3(0, 20, -30))};
    for (std::size_t i = 0; i < expected.size(); ++i) {
        BOOST_TEST_CONTEXT(expected[i]) {
            const Mesh part = meshOfComponents(mesh, {i});
            requireSameSolid(part, i == 2 ? ball.shape : block.shape);
            BOOST_TEST((boundingBox(part).min() - boxes[i].min()).norm() < 0.1);
            BOOST_TEST((boundingBox(part).max() - boxes[i].max()).norm() < 0.1);
        }
    }
}

BOOST_AUTO_TEST_CASE(a_place_that_mirrors_turns_no_solid_inside_out) {
    cad::CadFile file;
    file.parts.push_back({"block", cutBlock(), gp_Trsf()});
    file.parts[0].X_filePart.SetMirror(gp_Ax2(gp_Pnt(0, 0, 0), gp_Dir(0, 1, 0)));
    const Mesh mesh = cad::tessellate(file, std::nullopt, "");
    requireSameSolid(mesh, file.parts[0].shape);
    BOOST_TEST(boundingBox(mesh).min().y() == -20, boost::test_tools::tolerance(1e-9));
}

BOOST_AUTO_TEST_CASE(damaged_files_end_in_one_line) {
    const TemporaryFolder folder;
    writeStep(folder.file("whole.step"), {"block", cutBlock()});
    const std::string whole = readText(folder.file("whole.step"));
    const std::size_t data = whole.find("DATA;") + 5;
    folder.write("empty.step", "");
    folder.write("garbage.step", std::string(5000, '\xA7') + whole);
    folder.write("text.step", "no STEP file\n");
    folder.write("bare.step", whole.substr(0, data) + "\nENDSEC;\nEND-ISO-10303-21;\n");
    folder.write("mesh.stl", "solid\n");
    for (const double share : {0.2, 0.5, 0.9, 0.99})
        folder.write("cut.step", whole.substr(0, static_cast<std::size_t>(share * double(whole.size())))),
            requireRefused(folder, "cut.step --out o.3mf", {"'cut.step'"}, kCad);
    std::string edgeless = whole;
    edgeless.insert(edgeless.find("EDGE_CURVE"), "X");
    folder.write("edgeless.step", edgeless);
    std::string faceless = whole;
    const std::size_t face = faceless.find("ADVANCED_FACE");
    const std::size_t id = faceless.rfind('#', face);
    faceless.erase(id, faceless.find(';', face) + 1 - id);
    folder.write("faceless.step", faceless);
    for (const std::string file : {"empty", "garbage", "text", "bare", "missing", "faceless", "edgeless"})
        requireRefused(folder, file + ".step --out o.3mf", {"'" + file + ".step'"}, kCad);
    folder.write("garbage.igs", std::string(5000, 'x'));
    requireRefused(folder, "garbage.igs --out o.3mf", {"'garbage.igs'"}, kCad);
    requireRefused(folder, "mesh.stl --out o.3mf", {"ends in .step"}, kCad);
    requireRefused(folder, "whole.step --out o.stl", {"ends in .3mf"}, kCad);
    requireRefused(folder, "whole.step --out no/o.3mf", {"no"}, kCad);
    requireRefused(folder, "whole.step --out o.3mf --deflection 0", {"--deflection"}, kCad);
}

/// OpenCASCADE would not end with some of these numbers.
BOOST_AUTO_TEST_CASE(lengths_that_no_part_has_are_refused) {
    const TemporaryFolder folder;
    writeStep(folder.file("whole.step"), {"block 1.E308", cutBlock()});
    std::string whole = readText(folder.file("whole.step"));
    whole.insert(whole.find("DATA;") + 5, "/* it's no length: 1.E308 */");  // nor is the block's name one
    folder.write("whole.step", whole);
    converted(folder, "whole.step");
    for (const std::string entity : {"CARTESIAN_POINT", "VECTOR", "CYLINDRICAL_SURFACE"}) {
        const std::size_t at = whole.find('.', whole.find(" " + entity + "(") + entity.size()),
                          begin = whole.find_last_not_of("0123456789", at - 1) + 1,
                          end = whole.find_first_of(",)", at);
        for (const std::string number : {"1.E308", "1.5E+0308", "2.e100"}) {
            folder.write("large.step", std::string(whole).replace(begin, end - begin, number));
            requireRefused(folder, "large.step --out o.3mf", {"'large.step'", "'" + number + "'", "1e100"},
                           kCad);
        }
    }
    writeStep(folder.file("far.step"), {"rod", boxSolid(1e10, 1, 1)});
    requireRefused(folder, "far.step --out o.3mf", {"'far.step'", "'rod'", "1e+10 mm", "1e+09 mm"}, kCad);
    writeIges(folder.file("far.igs"), {"rod", boxSolid(1e10, 1, 1)}, true);
    requireRefused(folder, "far.igs --out o.3mf", {"'far.igs'", "1e+10 mm"}, kCad);
    writeStep(folder.file("long.step"), {"rod", boxSolid(1e8, 1, 1)});
    BOOST_TEST(boundingBox(converted(folder, "long.step")).max().x() == 1e8);
}

BOOST_AUTO_TEST_CASE(init_calls_the_program_and_goes_on_with_what_it_made) {
    const TemporaryFolder folder;
    writeStep(folder.file("a.step"), "machine",
              {{{"block", cutBlock()}, TopLoc_Location()},
               {{"ball", BRepPrimAPI_MakeSphere(4).Shape()}, TopLoc_Location(moved(0, 0, 40))}});
    for (const bool isOther : {false, true, false}) {  // another file is kept, the same one is not
        if (isOther) folder.write("a.3mf", "of another program");
        const Outcome made = runIn(folder, "init a.step --part ball --out p.cfg");
        BOOST_TEST_REQUIRE(made.code == 0, made.err);
        BOOST_TEST(holds(row(made, "made"), "a.3mf of a.step"), made.out);
        BOOST_TEST(holds(row(made, "made"), "a.3mf.old") == isOther, made.out);
        const Problem problem = readProblem(folder.file("p.cfg"));
        BOOST_TEST(problem.unit == "mm");
        BOOST_TEST(problem.deflection > 0.03);
        BOOST_TEST(problem.deflection < 0.06);
    }
    const Outcome planned = runIn(folder, "plan p.cfg --path o.path --quick --iterations 5000");
    BOOST_TEST(planned.code == 0, planned.err);
    folder.write("bad.step", "no STEP file\n");
    requireRefused(folder, "init bad.step a.3mf --out q.cfg", {"clearway-cad fails", "'bad.step'"});
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::testing
