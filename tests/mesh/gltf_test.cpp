#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <stdexcept>

#include "clearway/mesh.h"
#include "mesh/mesh_files.h"
#include "support/convex_hull.h"
#include "support/temporary_folder.h"

namespace clearway {
BOOST_AUTO_TEST_SUITE(gltf_test)

using namespace testing;

template <typename Value>
std::string packed(const std::vector<Value>& values) {
    std::string bytes;
    for (const Value& value : values) bytes += bytesOf(value);
    return bytes;
}

const std::vector<float> kCorners = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
const std::vector<std::uint8_t> kFaces = {0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3};  // of a tetrahedron

/// JSON whose strings stand in single quotes.
std::string json(std::string text) {
    std::replace(text.begin(), text.end(), '\'', '"');
    return text;
}

/// A .gltf that is put together list by list. Accessors 0 and 1 are a tetrahedron's corners and indices.
struct Gltf {
    std::string accessors, views, bytes, more;
    std::string nodes = "{'mesh':0,'name':'n'}";
    std::string primitives = "{'attributes':{'POSITION':0},'indices':1}";
    std::string ofMesh;  ///< further fields

    Gltf() {
        add("VEC3", 5126, 4, packed(kCorners));
        add("SCALAR", 5121, 12, packed(kFaces));
    }

    /// fields: further fields of the accessor.
    void add(const char* type, int componentType, int count, const std::string& data,
             const std::string& fields = "", const std::string& ofView = "") {
        addAccessor("{'type':'" + std::string(type) + "','componentType':" + std::to_string(componentType) +
                    ",'count':" + std::to_string(count) +
                    ",'bufferView':" + std::to_string(addView(data, ofView)) + fields + "}");
    }

    /// Shows the accessor's positions by the tetrahedron's indices.
    void show(int accessor) {
        primitives = "{'attributes':{'POSITION':" + std::to_string(accessor) + "},'indices':1}";
    }

    void addAccessor(const std::string& json) { accessors += (accessors.empty() ? "" : ",") + json; }

    int addView(const std::string& data, const std::string& fields = "") {
        views += (views.empty() ? "" : ",") + ("{'buffer':0,'byteOffset':" + std::to_string(bytes.size())) +
                 ",'byteLength':" + std::to_string(data.size()) + fields + "}";
        bytes += data;
        return viewCount++;
    }

    std::string text(const std::string& uri) const {
        return json("{'asset':{'version':'2.0'},'nodes':[" + nodes + "],'meshes':[{'primitives':[" +
                    primitives + "]" + ofMesh + "}],'accessors':[" + accessors + "],'bufferViews':[" + views +
                    "],'buffers':[{'byteLength':" + std::to_string(bytes.size()) +
                    (uri.empty() ? "" : ",'uri':'" + uri + "'") + "}]" + more + "}");
    }

    std::string text() const { return text("data:application/octet-stream;base64," + base64(bytes)); }

    int viewCount = 0;
};

Mesh load(const std::string& text, const char* name = "part.gltf") {
    return loadMesh(TemporaryFolder().write(name, text));
}

Mesh load(const Gltf& gltf) {
    return load(gltf.text());
}

void requireRefusal(const std::string& text, const std::string& words, const char* name = "part.gltf") {
    requireRefused(name, text, words);
}

void requireBox(const Mesh& mesh, const Vector3& least, const Vector3& most) {
    const Box box = boundingBox(mesh);
    BOOST_TEST((box.min() - least).norm() < 1e-12, "from " << box.min().transpose());
    BOOST_TEST((box.max() - most).norm() < 1e-12, "to " << box.max().transpose());
}

std::string glb(const std::string& json, const std::string& binary, std::uint32_t cut = 0) {
    const auto word = [](std::size_t value) { return bytesOf(static_cast<std::uint32_t>(value)); };
    const std::string text = json + std::string((4 - json.size() % 4) % 4, ' ');
    const std::string chunks =
        word(text.size()) + "JSON" + text + word(binary.size()) + std::string("BIN\0", 4) + binary;
    return "glTF" + word(2) + word(12 + chunks.size()) + chunks.substr(0, chunks.size() - cut);
}

BOOST_AUTO_TEST_CASE(coordinates_are_the_floats_of_the_file) {
    Gltf gltf;
    gltf.add("VEC3", 5126, 4, packed<float>({-0.f, 0.1f, 1e-40f, 3e38f, 7, 0, 0, 1, 0, 0, 0, 1}));
    gltf.show(2);
    for (const Mesh& mesh :
         {load(gltf), load(glb(gltf.text(""), gltf.bytes), "part.glb"), load("\xEF\xBB\xBF" + gltf.text())}) {
        BOOST_REQUIRE(mesh.vertices.size() == 4u);
        BOOST_TEST(std::signbit(mesh.vertices[0].x()));
        BOOST_TEST((mesh.vertices[0] == Vector3(0, double(0.1f), double(1e-40f))));
        BOOST_TEST(mesh.vertices[1].x() == double(3e38f));
        BOOST_TEST(mesh.origin.unitMetres == 1);
        BOOST_TEST(mesh.origin.upAxis == 'y');
    }
}

BOOST_AUTO_TEST_CASE(indices_are_never_scaled) {
    Gltf gltf;
    gltf.add("SCALAR", 5121, 12, packed(kFaces), ",'normalized':true");
    gltf.primitives = "{'attributes':{'POSITION':0},'indices':2}";
    BOOST_TEST(signedVolume(load(gltf)) == signedVolume(load(Gltf())));
}

BOOST_AUTO_TEST_CASE(quantized_positions_are_scaled_exactly) {
    Gltf gltf;
    gltf.add("VEC3", 5120, 4, packed<std::int8_t>({-128, 0, 0, 0, 127, 0, 0, 0, 0, 127, 0, 0, 64, 0, 0, 0}),
             ",'normalized':true", ",'byteStride':4");
    gltf.show(2);
    gltf.more = ",'extensionsRequired':['KHR_mesh_quantization','KHR_materials_unlit']";
    const Mesh mesh = load(gltf);
    BOOST_TEST(mesh.vertices[0].x() == -1);
    BOOST_TEST(mesh.vertices[3].x() == 64. / 127);
}

BOOST_AUTO_TEST_CASE(sparse_accessors_replace_rows) {
    Gltf gltf;
    const int at = gltf.addView(packed<std::uint16_t>({1, 3})),
              values = gltf.addView(packed<float>({5, 0, 0, 0, 0, 6}));
    const std::string sparse =
        "'sparse':{'count':2,'indices':{'componentType':5123,'bufferView':" + std::to_string(at) +
        "},'values':{'bufferView':" + std::to_string(values) + "}}}";
    gltf.addAccessor("{'type':'VEC3','componentType':5126,'count':4,'bufferView':0," + sparse);
    gltf.addAccessor("{'type':'VEC3','componentType':5126,'count':4," + sparse);  // over zeros
    gltf.show(2);
    requireBox(load(gltf), {0, 0, 0}, {5, 1, 6});
    gltf.show(3);
    requireBox(load(gltf), {0, 0, 0}, {5, 0, 6});
    gltf.addAccessor("{'type':'VEC3','componentType':5126,'count':4000000000}");
    gltf.show(4);
    requireRefusal(gltf.text(), "accessor 4 has 4000000000 elements without data");
}

BOOST_AUTO_TEST_CASE(strips_fans_and_plain_triangles_keep_their_fronts) {
    Gltf gltf;
    gltf.primitives =
        "{'attributes':{'POSITION':0},'mode':5},{'attributes':{'POSITION':0},'mode':6},"
        "{'attributes':{'POSITION':0},'mode':0},{'attributes':{'POSITION':0},'mode':1},"
        "{'attributes':{'POSITION':0},'mode':2},{'attributes':{'POSITION':0},'mode':3}";
    const Mesh mesh = load(gltf);
    const std::vector<TriangleIndices> expected = {{0, 1, 2}, {1, 3, 2}, {1, 2, 0}, {2, 3, 0}};
    BOOST_TEST((mesh.triangles == expected));
    BOOST_TEST(mesh.vertices.size() == 4u);  // shared by the primitives
    BOOST_TEST(mesh.components.size() == 1u);
    BOOST_TEST(mesh.origin.ignoredFaces == 4u + 2u + 4u + 3u);
    gltf.primitives = "{'attributes':{'POSITION':0}}";
    requireRefusal(gltf.text(), "primitive 0 of mesh 0 has 4 corners, expected three");
    gltf.primitives = "{'attributes':{'POSITION':0},'mode':7}";
    requireRefusal(gltf.text(), "has mode 7, expected 0 to 6");
}

BOOST_AUTO_TEST_CASE(long_lists_are_read_whole) {
    for (const int mode : {4, 5, 6}) {
        Gltf gltf;
        std::vector<float> corners;
        for (int i = 0; i < 6000; ++i) corners.insert(corners.end(), {float(i), float(i % 2), 0});
        gltf.add("VEC3", 5126, 6000, packed(corners));
        gltf.primitives = "{'attributes':{'POSITION':2},'mode':" + std::to_string(mode) + "}";
        const Mesh mesh = load(gltf);
        BOOST_REQUIRE(mesh.triangles.size() == (mode == 4 ? 2000u : 5998u));
        for (std::uint32_t i = 0; mode == 5 && i < 5998; ++i) {
            const TriangleIndices expected{i, i % 2 == 0 ? i + 1 : i + 2, i % 2 == 0 ? i + 2 : i + 1};
            BOOST_REQUIRE((mesh.triangles[i] == expected));
        }
        BOOST_TEST((mesh.triangles.back()[0] == (mode == 4 ? 5997u : mode == 5 ? 5997u : 5998u)));
        // A primitive that uses a few of the vertices adds only these.
        gltf.show(2);
        BOOST_TEST(load(gltf).vertices.size() == 4u);
    }
}

BOOST_AUTO_TEST_CASE(nodes_place_their_meshes_and_keep_fronts_outside) {
    Gltf gltf;
    gltf.nodes =
        "{'name':'root','children':[1,2],'scale':[-2,2,2]},{'name':'a','mesh':0,'translation':[1,0,0]},"
        "{'name':'b','mesh':0,'matrix':[0,1,0,0,-1,0,0,0,0,0,1,0,0,0,5,1]},{'mesh':0}";
    gltf.more = ",'scenes':[{'nodes':[3]},{'nodes':[0]}],'scene':1";
    const Mesh mesh = load(gltf);
    BOOST_REQUIRE(mesh.components.size() == 2u);
    BOOST_TEST(mesh.components[0].name == "a");
    BOOST_TEST(mesh.components[1].name == "b");
    requireBox(mesh, {-4, 0, 0}, {2, 2, 12});
    BOOST_TEST(std::fabs(signedVolume(mesh) - 2 * 8. / 6) < 1e-12);
    BOOST_TEST(mesh.origin.notes.size() == 2u);  // another scene, and a node that is not in this one
    gltf.more = ",'scenes':[{'nodes':[0]},{'nodes':[3]}]";  // the first one, where none is stated
    BOOST_TEST(load(gltf).components.size() == 2u);
}

BOOST_AUTO_TEST_CASE(each_instance_is_a_component) {
    Gltf gltf;
    gltf.add("VEC3", 5126, 2, packed<float>({0, 0, 0, 7, 0, 0}));
    gltf.add("VEC4", 5122, 2, packed<std::int16_t>({0, 0, 0, 32767, 0, 0, 32767, 0}), ",'normalized':true");
    const auto nodeOf = [](const std::string& attributes) {
        return "{'mesh':0,'name':'n','extensions':{'EXT_mesh_gpu_instancing':{'attributes':{" + attributes +
               "}}}}";
    };
    gltf.nodes = nodeOf("'TRANSLATION':2,'ROTATION':3");
    gltf.more = ",'extensionsRequired':['EXT_mesh_gpu_instancing']";
    const Mesh mesh = load(gltf);
    BOOST_REQUIRE(mesh.components.size() == 2u);
    BOOST_TEST(mesh.components[1].name == "n#2");
    requireBox(mesh, {0, -1, 0}, {7, 1, 1});
    gltf.nodes = nodeOf("'TRANSLATION':2,'SCALE':0");
    requireRefusal(gltf.text(), "have 2 and 4 rows, expected equal counts");
}

BOOST_AUTO_TEST_CASE(morph_targets_move_vertices_by_their_weights) {
    Gltf gltf;
    gltf.add("VEC3", 5126, 4, packed<float>({10, 0, 0, 10, 0, 0, 10, 0, 0, 10, 0, 0}));
    gltf.primitives = "{'attributes':{'POSITION':0},'indices':1,'targets':[{'POSITION':2},{'NORMAL':0}]}";
    gltf.ofMesh = ",'weights':[0.5,1]";
    requireBox(load(gltf), {5, 0, 0}, {6, 1, 1});
    gltf.nodes = "{'mesh':0,'weights':[1,0]}";
    requireBox(load(gltf), {10, 0, 0}, {11, 1, 1});
    gltf.nodes = "{'mesh':0,'weights':[1]}";
    requireRefusal(gltf.text(), "has 2 morph targets, its mesh or node has 1 weights");
}

BOOST_AUTO_TEST_CASE(skins_place_vertices_by_their_joints) {
    Gltf gltf;
    gltf.add("VEC4", 5121, 4, packed<std::uint8_t>({0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0}));
    gltf.add("VEC4", 5126, 4, packed<float>({.5, .5, 0, 0, .5, .5, 0, 0, .5, .5, 0, 0, .5, .5, 0, 0}));
    gltf.add("MAT4", 5126, 2, packed<float>({1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 3, 1,  //
                                             1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 3, 1}));
    gltf.primitives = "{'attributes':{'POSITION':0,'JOINTS_0':2,'WEIGHTS_0':3},'indices':1}";
    gltf.nodes =
        "{'mesh':0,'skin':0,'translation':[0,77,0]},{'translation':[10,0,0]},{'translation':[20,0,0]}";
    gltf.more = ",'skins':[{'joints':[1,2],'inverseBindMatrices':4}]";
    requireBox(load(gltf), {15, 0, 3}, {16, 1, 4});
    gltf.more = ",'skins':[{'joints':[1]}]";
    requireRefusal(gltf.text(), "vertex 0 of primitive 0 of mesh 0 has joint 1 with weight 0.5");
    gltf.show(0);
    requireRefusal(gltf.text(), "lack JOINTS_0, which skin 0 needs");
}

BOOST_AUTO_TEST_CASE(what_would_be_read_wrong_is_refused_by_name) {
    const auto changed = [](const std::string& from, const std::string& to) {
        std::string text = Gltf().text();
        return text.replace(text.find(json(from)), from.size(), json(to));
    };
    const std::string cases[][3] = {
        {"'POSITION':0", "'POSITION':9", "refers to accessor 9, the file has 2 accessors"},
        {"'count':4", "'count':5", "accessor 0 has 5 elements, bufferView 0 has room for 4"},
        {"'count':4", "'count':3", "index 3 at position 5 of accessor 1, it has 3 vertices"},
        {"'count':4", "'count':'4'", "accessor 0 has count '4', expected a whole number"},
        {"'byteLength':48", "'byteLength':480", "bufferView 0 covers bytes 0 to 480 of a buffer of 60"},
        {"'byteLength':60", "'byteLength':61", "buffer 0 declares 61 bytes, its data have 60"},
        {"base64,AAAA", "base64,*AAA", "has '*' at position 0 of its base64 data"},
        {"'version':'2.0'", "'version':'1.0'", "it is glTF '1.0'"},
        {"'nodes'", "'extensionsRequired':['X_bends'],'nodes'", "requires the extension 'X_bends'"},
        {"{'mesh':0", "{'rotation':[0,0,0,2],'mesh':0", "quaternion has length 2"},
        {"{'mesh':0", "{'matrix':[1],'mesh':0", "has 1 numbers as matrix, expected 16"},
        {"{'mesh':0", "{'children':[1]},{'children':[0],'mesh':0", "is below itself"},
        {"{'mesh':0", "{'children':[2]},{'children':[2]},{'mesh':0", "is a child of node 0 and of node 1"},
        {"{'mesh':0", "{'children':[7],'mesh':0", "refers to node 7, the file has 1 nodes"},
        {"'type':'VEC3'", "'type':'VEC2'", "accessor 0 has type 'VEC2', expected VEC3"},
        {"]}]", "]", "its JSON is malformed"}};
    for (const auto& [from, to, words] : cases) requireRefusal(changed(from, to), words);
}

BOOST_AUTO_TEST_CASE(compressed_primitives_are_refused_unless_their_data_are_there) {
    Gltf gltf;
    const std::string draco = ",'extensions':{'KHR_draco_mesh_compression':{'bufferView':0}}}";
    gltf.primitives = "{'attributes':{'POSITION':0},'indices':1" + draco;
    requireBox(load(gltf), {0, 0, 0}, {1, 1, 1});
    gltf.addAccessor("{'type':'VEC3','componentType':5126,'count':4}");
    gltf.primitives = "{'attributes':{'POSITION':2},'indices':1" + draco;
    requireRefusal(gltf.text(), "only in an extension, which is not read: KHR_draco_mesh_compression");
}

BOOST_AUTO_TEST_CASE(buffers_may_be_files_in_the_folder) {
    const TemporaryFolder folder;
    const Gltf gltf;
    const std::string file = folder.write("part.gltf", gltf.text("a%20b.bin"));
    requireRefusal(gltf.text("a%20b.bin"), "buffer 0 is in 'a%20b.bin', there is no file");
    folder.write("a b.bin", gltf.bytes);
    requireBox(loadMesh(file), {0, 0, 0}, {1, 1, 1});
    folder.write("a b.bin", gltf.bytes.substr(1));
    BOOST_CHECK_THROW(loadMesh(file), std::runtime_error);
}

BOOST_AUTO_TEST_CASE(cut_binary_files_are_refused) {
    const Gltf gltf;
    const std::string whole = glb(gltf.text(""), gltf.bytes);
    for (std::size_t size = 4; size < whole.size(); ++size) {
        BOOST_CHECK_THROW(load(whole.substr(0, size), "part.glb"), std::runtime_error);
    }
    requireRefusal(glb(gltf.text(""), gltf.bytes, 1), "its header declares", "part.glb");
    requireRefusal(glb(gltf.text(""), gltf.bytes.substr(4)), "declares 60 bytes, its data have 56",
                   "part.glb");
    requireBox(load(whole + "more", "part.glb"), {0, 0, 0}, {1, 1, 1});
}

BOOST_AUTO_TEST_CASE(deep_hierarchies_are_read) {
    Gltf gltf;
    gltf.nodes.clear();
    for (int i = 1; i < 50000; ++i) {
        gltf.nodes += "{'translation':[1,0,0],'children':[" + std::to_string(i) + "]},";
    }
    gltf.nodes += "{'mesh':0}";
    requireBox(load(gltf), {49999, 0, 0}, {50000, 1, 1});
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway
