#include "clearway/animation.h"

#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <assimp/Importer.hpp>
#include <boost/property_tree/json_parser.hpp>
#include <boost/test/unit_test.hpp>
#include <cstring>
#include <sstream>

#include "problem/path_line.h"
#include "support/temporary_folder.h"
#include "support/window_scene.h"
#include "support/words.h"

namespace clearway::testing {
BOOST_AUTO_TEST_SUITE(animation_test)

using Json = boost::property_tree::ptree;

const Json& at(const Json& list, std::size_t i) {
    BOOST_TEST_REQUIRE(i < list.size());
    return std::next(list.begin(), static_cast<std::ptrdiff_t>(i))->second;
}

/// A .glb file taken apart as the specification says.
struct Glb {
    Json json;
    std::string binary;

    explicit Glb(const std::string& bytes) {
        const auto word = [&](std::size_t place) {
            std::uint32_t value;
            std::memcpy(&value, bytes.data() + place, 4);
            return value;
        };
        BOOST_TEST_REQUIRE(bytes.substr(0, 4) == "glTF");
        BOOST_TEST(word(4) == 2u);
        BOOST_TEST(word(8) == bytes.size());
        const std::size_t length = word(12);
        BOOST_TEST(length % 4 == 0u);
        BOOST_TEST(bytes.substr(16, 4) == "JSON");
        std::istringstream text(bytes.substr(20, length));
        boost::property_tree::read_json(text, json);
        BOOST_TEST(bytes.substr(24 + length, 4) == std::string("BIN\0", 4));
        BOOST_TEST(word(20 + length) == bytes.size() - length - 28);
        binary = bytes.substr(28 + length);
        BOOST_TEST(at(json.get_child("buffers"), 0).get<std::size_t>("byteLength") == binary.size());
    }

    /// The rows of an accessor, each of this many numbers.
    template <class Number>
    std::vector<std::vector<Number>> rows(std::size_t accessor, std::size_t width) const {
        const Json& described = at(json.get_child("accessors"), accessor);
        const Json& view = at(json.get_child("bufferViews"), described.get<std::size_t>("bufferView"));
        const auto offset = view.get<std::size_t>("byteOffset");
        const auto count = described.get<std::size_t>("count");
        BOOST_TEST_REQUIRE(view.get<std::size_t>("byteLength") == count * width * sizeof(Number));
        BOOST_TEST_REQUIRE(offset + count * width * sizeof(Number) <= binary.size());
        BOOST_TEST(offset % 4 == 0u);
        std::vector<std::vector<Number>> values(count, std::vector<Number>(width));
        for (std::size_t i = 0; i < count; ++i)
            std::memcpy(values[i].data(), binary.data() + offset + i * width * sizeof(Number),
                        width * sizeof(Number));
        return values;
    }
};

/// A path with a quarter turn, a state twice, and quaternions of either sign.
std::vector<PartState> turningPath() {
    const double s = std::sqrt(0.5);
    return {{{-60, 0, 0}, {1, 0, 0, 0}},
            {{0, 5, 0}, {-s, 0, 0, -s}},
            {{0, 5, 0}, {-s, 0, 0, -s}},
            {{60, 0, 10}, {s, 0, s, 0}}};
}

struct Exported {
    TemporaryFolder folder;
    WindowScene window = windowScene();
    std::vector<PartState> path = turningPath();
    std::string file = folder.file("motion.glb");
    Exported() { saveAnimation(window.wallMesh, {{window.partMesh, path}}, 1, file); }
};

BOOST_AUTO_TEST_CASE(the_animation_goes_through_the_states_at_an_even_pace) {
    const Exported exported;
    const Glb glb(readText(exported.file));
    const Json& animation = at(glb.json.get_child("animations"), 0);
    const Json& samplers = animation.get_child("samplers");
    const auto accessor = [&](std::size_t i, const char* end) {
        return at(samplers, i).get<std::size_t>(end);
    };
    const auto times = glb.rows<float>(accessor(0, "input"), 1);
    const auto positions = glb.rows<float>(accessor(0, "output"), 3);
    const auto rotations = glb.rows<float>(accessor(1, "output"), 4);
    BOOST_TEST(accessor(1, "input") == accessor(0, "input"));
    BOOST_TEST_REQUIRE(times.size() == 3u);  // the state that stands twice has one time
    BOOST_TEST_REQUIRE(positions.size() == 3u);
    BOOST_TEST_REQUIRE(rotations.size() == 3u);
    const PathLine line(exported.path, Model::build(exported.window.partMesh).radiusAboutOrigin());
    for (std::size_t i = 0; i < 3; ++i) {
        const PartState state = line.at(times[i][0] / 12);
        const Eigen::Quaterniond q(rotations[i][3], rotations[i][0], rotations[i][1], rotations[i][2]);
        BOOST_TEST(q.angularDistance(Eigen::Quaterniond(state.rotation)) < 1e-4);
        BOOST_TEST((Vector3(positions[i][0], positions[i][1], positions[i][2]) - state.position).norm() <
                   1e-3);
        if (i == 0) continue;
        BOOST_TEST(times[i][0] > times[i - 1][0]);
        double dot = 0;
        for (int k = 0; k < 4; ++k) dot += rotations[i][k] * rotations[i - 1][k];
        BOOST_TEST(dot > 0);  // a viewer that ignores the sign would go the longer way
    }
    BOOST_TEST(times[0][0] == 0);
    BOOST_TEST(times[2][0] == static_cast<float>(12));
    const Json& bounds = at(glb.json.get_child("accessors"), accessor(0, "input"));
    BOOST_TEST(at(bounds.get_child("max"), 0).get_value<float>() == times[2][0]);
    BOOST_TEST(at(bounds.get_child("min"), 0).get_value<float>() == 0);
}

BOOST_AUTO_TEST_CASE(the_channels_move_the_node_that_holds_the_part) {
    const Exported exported;
    const Glb glb(readText(exported.file));
    const Json& nodes = glb.json.get_child("nodes");
    const Json& channels = at(glb.json.get_child("animations"), 0).get_child("channels");
    BOOST_TEST_REQUIRE(channels.size() == 2u);
    BOOST_TEST(at(channels, 0).get<std::string>("target.path") == "translation");
    BOOST_TEST(at(channels, 1).get<std::string>("target.path") == "rotation");
    BOOST_TEST(at(channels, 0).get<int>("sampler") == 0);
    BOOST_TEST(at(channels, 1).get<int>("sampler") == 1);
    for (std::size_t i = 0; i < 2; ++i) {
        const Json& node = at(nodes, at(channels, i).get<std::size_t>("target.node"));
        const Json& child = at(nodes, at(node.get_child("children"), 0).get_value<std::size_t>());
        BOOST_TEST(child.get<std::string>("name") == "plate");
    }
    const Json& root =
        at(nodes, at(at(glb.json.get_child("scenes"), 0).get_child("nodes"), 0).get_value<std::size_t>());
    BOOST_TEST(root.get_child("children").size() == 5u);  // four pieces of the wall, and the part
}

BOOST_AUTO_TEST_CASE(meshes_keep_their_coordinates_and_triangles) {
    const Exported exported;
    const Glb glb(readText(exported.file));
    std::size_t triangles = 0;
    for (const auto& [key, mesh] : glb.json.get_child("meshes")) {
        const Json& primitive = at(mesh.get_child("primitives"), 0);
        const auto vertices = glb.rows<float>(primitive.get<std::size_t>("attributes.POSITION"), 3);
        for (const auto& index : glb.rows<std::uint32_t>(primitive.get<std::size_t>("indices"), 1))
            BOOST_TEST_REQUIRE(index[0] < vertices.size());
        triangles += at(glb.json.get_child("accessors"), primitive.get<std::size_t>("indices"))
                         .get<std::size_t>("count") /
                     3;
        BOOST_TEST(primitive.get<std::size_t>("material") < glb.json.get_child("materials").size());
    }
    BOOST_TEST(triangles ==
               exported.window.partMesh.triangles.size() + exported.window.wallMesh.triangles.size());
}

BOOST_AUTO_TEST_CASE(another_reader_finds_the_scene_upright_and_the_part_moving) {
    const Exported exported;
    Assimp::Importer importer;
    const aiScene* scene = importer.ReadFile(exported.file, aiProcess_ValidateDataStructure);
    BOOST_TEST_REQUIRE(scene != nullptr, importer.GetErrorString());
    BOOST_TEST_REQUIRE(scene->mNumAnimations == 1u);
    BOOST_TEST_REQUIRE(scene->mAnimations[0]->mNumChannels == 1u);
    const aiNodeAnim& channel = *scene->mAnimations[0]->mChannels[0];
    BOOST_TEST(channel.mNumPositionKeys == 3u);
    BOOST_TEST(channel.mNumRotationKeys == 3u);
    const aiNode* node = scene->mRootNode->FindNode(channel.mNodeName);
    BOOST_TEST_REQUIRE(node != nullptr);
    BOOST_TEST(node->mTransformation.a4 == -60);  // the path's beginning, for readers without animations
    // z, up here, becomes y, up in glTF, without any rounding.
    const aiVector3D turned = aiMatrix3x3(node->mParent->mTransformation) * aiVector3D(1, 2, 3);
    BOOST_TEST((turned == aiVector3D(1, 3, -2)));
}

BOOST_AUTO_TEST_CASE(with_a_known_unit_the_scene_is_in_metres) {
    const Exported exported;
    saveAnimation(exported.window.wallMesh, {{exported.window.partMesh, exported.path}}, 0.001,
                  exported.file);
    Assimp::Importer importer;
    const aiScene* scene = importer.ReadFile(exported.file, aiProcess_ValidateDataStructure);
    BOOST_TEST_REQUIRE(scene != nullptr, importer.GetErrorString());
    const aiNode* node = scene->mRootNode->FindNode("moving part");
    BOOST_TEST_REQUIRE(node != nullptr);
    BOOST_TEST(node->mTransformation.a4 == -60);
    const aiVector3D placed = node->mParent->mTransformation * aiVector3D(1000, 2000, 3000);
    BOOST_TEST((placed - aiVector3D(1, 3, -2)).Length() < 1e-6f);
}

BOOST_AUTO_TEST_CASE(a_single_state_is_a_motion_that_rests) {
    Exported exported;
    saveAnimation(exported.window.wallMesh, {{exported.window.partMesh, {exported.path[1]}}}, 1,
                  exported.file);
    const Glb glb(readText(exported.file));
    BOOST_TEST(
        glb.rows<float>(
               at(at(glb.json.get_child("animations"), 0).get_child("samplers"), 0).get<std::size_t>("input"),
               1)
            .size() == 1u);
}

BOOST_AUTO_TEST_CASE(parts_move_one_after_the_other_and_disappear) {
    Exported exported;
    MovingPart first{exported.window.partMesh, exported.path, 1, 3, true, "first"}, second = first;
    second.name = "second";
    second.begin = 3;
    second.end = 4;
    second.disappearsAtEnd = false;
    saveAnimation({}, {first, second}, 1, exported.file);
    Assimp::Importer importer;
    const aiScene* scene = importer.ReadFile(exported.file, aiProcess_ValidateDataStructure);
    BOOST_TEST_REQUIRE(scene != nullptr, importer.GetErrorString());
    BOOST_TEST_REQUIRE(scene->mNumAnimations == 1u);
    BOOST_TEST_REQUIRE(scene->mAnimations[0]->mNumChannels == 2u);
    const auto channelOf = [&](const std::string& name) -> const aiNodeAnim& {
        const aiNodeAnim* const* channels = scene->mAnimations[0]->mChannels;
        return *channels[channels[0]->mNodeName.C_Str() == name ? 0 : 1];
    };
    const aiNodeAnim &a = channelOf("first"), &b = channelOf("second");
    BOOST_TEST(a.mNodeName.C_Str() == std::string("first"));
    BOOST_TEST(b.mNodeName.C_Str() == std::string("second"));
    const auto seconds = [](const aiVectorKey& key) {
        return key.mTime / 1000;
    };  // assimp's are milliseconds
    BOOST_TEST(seconds(a.mPositionKeys[0]) == 1);
    BOOST_TEST(seconds(a.mPositionKeys[a.mNumPositionKeys - 1]) == 3);
    BOOST_TEST(seconds(b.mPositionKeys[0]) == 3);
    BOOST_TEST(seconds(b.mPositionKeys[b.mNumPositionKeys - 1]) == 4);
    BOOST_TEST_REQUIRE(a.mNumScalingKeys == 2u);
    BOOST_TEST(seconds(a.mScalingKeys[1]) == 3);
    BOOST_TEST((a.mScalingKeys[1].mValue == aiVector3D(0, 0, 0)));
    BOOST_TEST(scene->mNumMaterials >= 2u);
}

BOOST_AUTO_TEST_CASE(times_and_scenes_that_mean_nothing_are_refused) {
    const Exported exported;
    const auto refused = [&](const MovingPart& part, std::vector<std::string> words) {
        requireRefusedBy([&] { saveAnimation({}, {part}, 1, exported.file); }, words);
    };
    refused({exported.window.partMesh, {}}, {"no state"});
    refused({exported.window.partMesh, exported.path, 2, 2}, {"from 2 to 2 s", "begin < end"});
    refused({exported.window.partMesh, exported.path, -1, 2}, {"from -1"});
    refused({Mesh(), exported.path}, {"0 triangles"});
    requireRefusedBy([&] { saveAnimation({}, {}, 1, exported.file); }, {"0 triangles"});
    requireRefusedBy([&] { saveAnimation(exported.window.wallMesh, {}, 0, exported.file); },
                     {"metresPerUnit is 0"});
}

BOOST_AUTO_TEST_CASE(other_endings_are_refused) {
    const Exported exported;
    for (const char* name : {"motion.gltf", "motion", "motion.fbx"}) {
        const std::string file = exported.folder.file(name);
        requireRefusedBy(
            [&] {
                saveAnimation(exported.window.wallMesh, {{exported.window.partMesh, exported.path}}, 1, file);
            },
            {file, "expected .glb"});
    }
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::testing
