#include <zip.h>

#include <boost/test/unit_test.hpp>
#include <fstream>
#include <stdexcept>
#include <utility>

#include "clearway/mesh.h"
#include "mesh/mesh_files.h"
#include "support/temporary_folder.h"

namespace clearway {
BOOST_AUTO_TEST_SUITE(three_mf_test)

using namespace testing;

using Parts = std::vector<std::pair<std::string, std::string>>;

const std::string kShared = "http://schemas.microsoft.com/3dmanufacturing/";
const std::string kItem = "<item objectid=\"1\"/>";

std::string writeArchive(const TemporaryFolder& folder, const Parts& parts, int method = ZIP_CM_DEFLATE) {
    const std::string file = folder.file("part.3mf");
    zip_t* const archive = zip_open(file.c_str(), ZIP_CREATE | ZIP_TRUNCATE, nullptr);
    BOOST_REQUIRE(archive);
    for (const auto& [name, text] : parts) {
        zip_source_t* const source = zip_source_buffer(archive, text.data(), text.size(), 0);
        const zip_int64_t index = zip_file_add(archive, name.c_str(), source, ZIP_FL_OVERWRITE);
        BOOST_REQUIRE(index >= 0);
        BOOST_REQUIRE(zip_set_file_compression(archive, static_cast<zip_uint64_t>(index), method, 0) == 0);
    }
    BOOST_REQUIRE(zip_close(archive) == 0);
    return file;
}

std::string relationships(const std::string& target) {
    return "<Relationships "
           "xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\"><Relationship Target=\"" +
           target + "\" Id=\"r\" Type=\"" + kShared + "2013/01/3dmodel\"/></Relationships>";
}

std::string model(const std::string& resources, const std::string& items,
                  const std::string& attributes = "") {
    return "<?xml version=\"1.0\"?><model xmlns=\"" + kShared + "core/2015/02\" xmlns:p=\"" + kShared +
           "production/2015/06\" xmlns:s=\"" + kShared + "slice/2015/07\" xmlns:b=\"" + kShared +
           "beamlattice/2017/02\" " + attributes + "><resources>" + resources + "</resources><build>" +
           items + "</build></model>";
}

/// more: elements behind the triangles.
std::string meshText(const std::string& more = "") {
    const Mesh mesh = tetrahedron();
    std::string text = "<mesh><vertices>";
    for (const Vector3& v : mesh.vertices) {
        text += "<vertex x=\"" + std::to_string(v.x()) + "\" y=\"" + std::to_string(v.y()) + "\" z=\"" +
                std::to_string(v.z()) + "\"/>";
    }
    text += "</vertices><triangles>";
    for (const TriangleIndices& t : mesh.triangles) {
        text += "<triangle v1=\"" + std::to_string(t[0]) + "\" v2=\"" + std::to_string(t[1]) + "\" v3=\"" +
                std::to_string(t[2]) + "\"/>";
    }
    return text + "</triangles>" + more + "</mesh>";
}

std::string object(const std::string& id, const std::string& content, const std::string& attributes = "") {
    return "<object id=\"" + id + "\" " + attributes + ">" + content + "</object>";
}

Mesh load(const Parts& parts) {
    const TemporaryFolder folder;
    return loadMesh(writeArchive(folder, parts));
}

Mesh load(const std::string& text) {
    return load({{"_rels/.rels", relationships("/3D/a.model")}, {"3D/a.model", text}});
}

void requireRefused(const Parts& parts, const std::string& words) {
    requireRefusedBy<std::runtime_error>([&] { load(parts); }, {words});
}

void requireRefused(const std::string& text, const std::string& reason) {
    requireRefused({{"_rels/.rels", relationships("/3D/a.model")}, {"3D/a.model", text}}, reason);
}

BOOST_AUTO_TEST_CASE(items_and_components_place_objects_by_row_vectors) {
    const Mesh mesh =
        load(model(object("1", meshText(), "name=\"left bracket\"") +
                       object("2",
                              "<components><component objectid=\"1\" transform=\"0 1 0 -1 0 0 0 0 1 5 6 "
                              "7\"/></components>"),
                   "<item objectid=\"1\"/><item objectid=\"2\" transform=\"2 0 0 0 2 0 0 0 2 0 0 100\"/>",
                   "unit=\"inch\""));
    BOOST_REQUIRE(mesh.triangles.size() == 8u);
    BOOST_TEST(mesh.vertices.size() == 8u);
    requireTetrahedron(mesh, 0, unchanged);
    requireTetrahedron(mesh, 4, [](const Vector3& v) {
        return Vector3(2 * (5 - v.y()), 2 * (v.x() + 6), 2 * (v.z() + 7) + 100);
    });
    BOOST_TEST(mesh.components[0].name == "left bracket");
    BOOST_TEST(mesh.components[1].name == "left bracket#2");
    BOOST_TEST(mesh.origin.unitMetres == 0.0254);
    BOOST_TEST(mesh.origin.upAxis == 'z');
}

BOOST_AUTO_TEST_CASE(a_mirrored_object_keeps_its_front_outside) {
    const Mesh mesh =
        load(model(object("1", meshText()), "<item objectid=\"1\" transform=\"-1 0 0 0 1 0 0 0 1 0 0 0\"/>"));
    requireTetrahedron(
        mesh, 0, [](const Vector3& v) { return Vector3(-v.x(), v.y(), v.z()); }, true);
    BOOST_TEST(mesh.origin.unitMetres == 0.001);
}

BOOST_AUTO_TEST_CASE(objects_of_other_parts_are_read) {
    const Parts parts = {
        {"_rels/.rels", relationships("/3D/My%20Model.model")},
        {"3D/my model.model",
         model(object("2",
                      "<components><component objectid=\"1\" p:path=\"/3D/Objects/A.model\"/></components>") +
                   object("1", meshText(), "name=\"here\""),
               "<item objectid=\"1\"/><item objectid=\"2\" partnumber=\"P-7\"/>",
               "requiredextensions=\"p\"")},
        {"3D/Objects/a.model", model(object("1", meshText()), "")}};
    const Mesh mesh = load(parts);
    BOOST_REQUIRE(mesh.triangles.size() == 8u);
    BOOST_TEST(mesh.components[0].name == "here");
    BOOST_TEST(mesh.components[1].name == "P-7");
    requireRefused({parts[0], parts[1]}, "part '/3D/Objects/A.model' is not in the archive");
    requireRefused({parts[0], parts[1], {parts[2].first, model(object("9", meshText()), "")}},
                   "component 0 of object '2' of '/3D/My%20Model.model' refers to object '1' of "
                   "'/3D/Objects/A.model', which is not there");
    requireRefused(
        {parts[0], parts[1], {parts[2].first, model(object("1", meshText()), "", "unit=\"foot\"")}},
        "the unit of part '/3D/Objects/A.model' is 'foot', expected 'millimeter'");
}

BOOST_AUTO_TEST_CASE(any_prefix_may_stand_for_the_namespace_of_the_core) {
    std::string text = model(object("1", meshText()), kItem);
    for (std::size_t at = text.find("<model"); at != std::string::npos; at = text.find('<', at + 1)) {
        text.insert(at + (text[at + 1] == '/' ? 2 : 1), "c:");
    }
    BOOST_TEST(load(replaced(text, "xmlns=", "xmlns:c=")).triangles.size() == 4u);
}

BOOST_AUTO_TEST_CASE(an_archive_without_relationships_has_one_model) {
    const std::string text = model(object("1", meshText()), kItem);
    BOOST_TEST(load({{"3D/a.model", text}}).triangles.size() == 4u);
    requireRefused({{"a.model", text}, {"b.model", text}}, "the archive starts at 2 3D models, expected one");
    requireRefused({{"a.txt", text}}, "the archive starts at 0 3D models, expected one");
}

BOOST_AUTO_TEST_CASE(what_is_left_out_or_unusual_is_noted) {
    const Mesh mesh = load(model(object("1", meshText(), "type=\"support\"") + object("2", meshText()),
                                 "<item objectid=\"1\" printable=\"0\"/>"));
    BOOST_TEST_REQUIRE(mesh.origin.notes.size() == 3u);
    BOOST_TEST(holds(mesh.origin.notes[0], "1 object left out"));
    BOOST_TEST(holds(mesh.origin.notes[1], "1 object", "not printable"));
    BOOST_TEST(holds(mesh.origin.notes[2], "1 object", "'support'"));
}

BOOST_AUTO_TEST_CASE(material_of_extensions_is_refused_by_name) {
    const std::string beams =
        "<b:beamlattice radius=\"1\"><b:beams><b:beam v1=\"0\" v2=\"1\"/></b:beams></b:beamlattice>";
    requireRefused(model(object("1", meshText()), kItem, "requiredextensions=\"p b\""),
                   "requires the extension 'b', 'beamlattice/2017/02', which is not read");
    requireRefused(model(object("1", meshText()), kItem, "requiredextensions=\"q\""),
                   "'q', a prefix that is not bound");
    requireRefused(model(object("1", meshText(beams)), kItem),
                   "holds <b:beamlattice> of 'beamlattice/2017/02'");
    requireRefused(model(object("1", "<b:shape/>"), kItem), "object '1' of '/3D/a.model' holds <b:shape>");
    requireRefused(model(object("1", meshText(), "s:slicestackid=\"5\" s:meshresolution=\"lowres\""), kItem),
                   "has a meshresolution of 'lowres'");
    requireRefused(model(object("1", "<mesh><vertices/><triangles/></mesh>", "s:slicestackid=\"5\""), kItem),
                   "has slices, which are not read, and no triangle");
}

BOOST_AUTO_TEST_CASE(damaged_meshes_are_refused_by_number) {
    const std::string text = model(object("1", meshText()), kItem);
    requireRefused(replaced(text, "v2=\"3\"", "v2=\"4\""),
                   "triangle 1 of object '1' of '/3D/a.model' refers to vertex 4 of 4");
    requireRefused(replaced(text, "v2=\"3\"", "v2=\"-1\""),
                   "v2 of triangle 1 of object '1' of '/3D/a.model' is '-1'");
    requireRefused(replaced(text, "v2=\"3\"", ""),
                   "v2 of triangle 1 of object '1' of '/3D/a.model' is missing");
    requireRefused(replaced(text, "y=\"0.125", "y=\"0,125"),
                   "y of vertex 1 of object '1' of '/3D/a.model' is '0,125000', expected a number");
    requireRefused(replaced(text, "<vertex ", "<point "), "is <point>, expected <vertex>");
    requireRefused(text.substr(0, text.size() - 20), "is not sound XML");
    requireRefused(
        model(object("1", meshText()), "<item objectid=\"1\" transform=\"1 0 0 0 1 0 0 0 1 0 0\"/>"),
        "the transform of item 0 of the build has 11 numbers, expected 12");
    requireRefused(
        model(object("1", meshText()), "<item objectid=\"1\" transform=\"1 0 0 0 1 0 0 0 1 0 0 x\"/>"),
        "number 11 of the transform of item 0 of the build is 'x', expected a number");
}

BOOST_AUTO_TEST_CASE(references_that_place_nothing_or_too_much_are_refused) {
    const auto component = [](const std::string& id) { return "<component objectid=\"" + id + "\"/>"; };
    requireRefused(model(object("1", meshText()), ""), "its build has no item");
    requireRefused(model(object("1", meshText()), "<item objectid=\"2\"/>"),
                   "item 0 of the build refers to object '2'");
    requireRefused(model(object("1", meshText()) + object("1", meshText()), kItem),
                   "id 1 of '/3D/a.model' names two objects");
    requireRefused(model(object("1", "<components>" + component("2") + "</components>") +
                             object("2", "<components>" + component("1") + "</components>"),
                         kItem),
                   "object '1' of '/3D/a.model' contains itself");
    std::string nested = object("40", meshText());
    for (int id = 1; id < 40; ++id) {
        const std::string inner = component(std::to_string(id + 1));
        nested += object(std::to_string(id), "<components>" + inner + inner + "</components>");
    }
    requireRefused(replaced(model(nested, kItem), meshText(), "<mesh/>"),
                   "it places more than 1000000 nodes");
}

BOOST_AUTO_TEST_CASE(a_damaged_archive_is_refused) {
    const TemporaryFolder folder;
    const std::string text = model(object("1", meshText()), kItem);
    const std::string bytes = readText(writeArchive(folder, {{"a.model", text}}, ZIP_CM_STORE));
    const auto refused = [&](const std::string& changed, const std::string& words) {
        testing::requireRefused("b.3mf", changed, words);
    };
    refused(bytes.substr(0, bytes.size() - 30), "not a whole zip archive");
    refused(replaced(bytes, "<vertex x=\"0", "<vertex x=\"8"), "part 'a.model' is damaged: CRC error");
    // The size that the archive's directory states, 22 bytes before the name in it.
    std::string bomb = bytes;
    const std::size_t size = bytes.rfind("a.model") - 22;
    bomb.replace(size, 4, "\xF0\xFF\xFF\x7F");
    refused(bomb, "part 'a.model' states 2147483632 bytes");
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway
