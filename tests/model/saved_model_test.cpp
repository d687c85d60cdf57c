#include <sys/stat.h>

#include <boost/test/unit_test.hpp>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "clearway/model.h"
#include "clearway/query.h"
#include "core/hash.h"
#include "model/model_data.h"
#include "support/random_meshes.h"
#include "support/temporary_folder.h"
#include "support/words.h"
#include "tree/flat_tree.h"

namespace clearway {
BOOST_AUTO_TEST_SUITE(saved_model_test)

using testing::Random;

std::string contentOf(const std::string& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

void write(const std::string& file, const std::string& content) {
    std::ofstream(file, std::ios::binary) << content;
}

/// Writes the content with the hash that fits it.
void writeHashed(const std::string& file, std::string content) {
    constexpr std::size_t kKey = 24, kHash = 40, kPayload = 48;
    Hash hash;
    hash.add(content.data() + kKey, 8);
    hash.add(content.data() + kPayload, content.size() - kPayload);
    const std::uint64_t value = hash.value();
    std::memcpy(content.data() + kHash, &value, sizeof value);
    write(file, content);
}

struct Fixture {
    Random random{3};
    testing::TemporaryFolder folder;
    Mesh part = testing::torus(3, 1, 8);
    Mesh environment = testing::randomTerrain(random, 10, 20, 1);
    std::string file = folder.file("model.clearway");
};

BOOST_FIXTURE_TEST_CASE(a_loaded_model_answers_as_the_saved_one, Fixture) {
    environment.components = {{"left", 0, 50},
                              {"right", 50, std::uint32_t(environment.triangles.size()) - 50}};
    environment.origin.notes = {"turned"};
    for (const int width : nodeWidths()) {
        BuildOptions options;
        options.nodeWidth = width;
        const Model moving = Model::build(part, options), built = Model::build(environment, options);
        built.save(file);
        const Model loaded = Model::load(file);
        BOOST_TEST(loaded.key() == built.key());
        BOOST_TEST(loaded.id() != built.id());
        BOOST_TEST(loaded.report().tree.bytes == built.report().tree.bytes);
        BOOST_TEST(loaded.report().tree.leavesBySize == built.report().tree.leavesBySize);
        BOOST_TEST(loaded.report().triangles == built.report().triangles);
        BOOST_TEST(loaded.components()[1].name == "right");
        BOOST_TEST(loaded.origin().notes == environment.origin.notes);
        Workspace a, b;
        for (int i = 0; i < 50; ++i) {
            const Pose X = random.pose(6);
            const DistanceResult first = distance(moving, built, X, {}, a),
                                 second = distance(moving, loaded, X, {}, b);
            BOOST_TEST(first.lower == second.lower);
            BOOST_TEST(first.upper == second.upper);
            BOOST_TEST(first.witness->environmentTriangle == second.witness->environmentTriangle);
            BOOST_TEST(first.counters.volumeTests == second.counters.volumeTests);
        }
    }
}

BOOST_FIXTURE_TEST_CASE(saving_twice_gives_the_same_bytes, Fixture) {
    const Model model = Model::build(part);
    model.save(file);
    const std::string first = contentOf(file);
    Model::load(file).save(file);
    BOOST_TEST((contentOf(file) == first));
}

BOOST_FIXTURE_TEST_CASE(a_cut_damaged_or_foreign_file_is_refused_by_name, Fixture) {
    Model::build(testing::box({1, 1, 1})).save(file);
    const std::string whole = contentOf(file);
    const auto requireRefused = [&](const std::string& content) {
        write(file, content);
        testing::requireRefusedBy<std::runtime_error>([&] { Model::load(file); }, {file + ": "});
    };
    for (std::size_t length = 0; length < whole.size(); length += 7) requireRefused(whole.substr(0, length));
    for (std::size_t at = 0; at < whole.size(); at += 3) {
        std::string damaged = whole;
        damaged[at] = char(damaged[at] ^ (1 << (at % 8)));
        requireRefused(damaged);
    }
    requireRefused(whole + "x");
    requireRefused("solid ascii stl\nendsolid\n");
    BOOST_CHECK_THROW(Model::load(folder.file("missing.clearway")), std::runtime_error);
    BOOST_CHECK_THROW(Model::load(folder.path()), std::runtime_error);
    const std::string pipe = folder.file("pipe");  // reading it would wait for a writer
    BOOST_TEST_REQUIRE(mkfifo(pipe.c_str(), 0600) == 0);
    BOOST_CHECK_THROW(Model::load(pipe), std::runtime_error);
}

BOOST_FIXTURE_TEST_CASE(a_model_of_another_format_is_refused_by_its_version, Fixture) {
    Model::build(part).save(file);
    std::string content = contentOf(file);
    content[8] = 5;  // the version, lowest byte first
    write(file, content);
    testing::requireRefusedBy<std::runtime_error>(
        [&] { Model::load(file); },
        {file + ": has format version 5, expected a model saved by this version of clearway"});
}

BOOST_FIXTURE_TEST_CASE(nodes_that_are_no_tree_are_refused_on_loading, Fixture) {
    // Each node has the next one as both children: a query would meet the last one 2^n times.
    BuildOptions options;
    options.nodeWidth = 2;
    const Model model = Model::build(environment, options);
    model.save(file);
    auto nodes = treeOf(model).nodes<2>();
    std::string content = contentOf(file);
    const std::size_t bytes = nodes.size() * sizeof nodes[0];
    const std::size_t at = content.find({reinterpret_cast<const char*>(nodes.data()), bytes});
    for (std::size_t n = 1; n + 1 < nodes.size(); ++n)
        nodes[n].child[0] = nodes[n].child[1] = std::int32_t(n + 1);
    content.replace(at, bytes, reinterpret_cast<const char*>(nodes.data()), bytes);
    writeHashed(file, content);
    testing::requireRefusedBy<std::runtime_error>(
        [&] { Model::load(file); },
        {file + ": node 1 shares a child, expected a model saved by this version of clearway"});
}

BOOST_FIXTURE_TEST_CASE(a_model_without_some_of_its_triangles_is_refused_on_loading, Fixture) {
    const std::string name = "whole mesh";
    const auto count = std::uint32_t(part.triangles.size());
    part.components = {{name, 0, count}};
    Model::build(part).save(file);
    std::string content = contentOf(file);
    ++content[content.rfind(name) + name.size() + sizeof count];  // the component's number of triangles
    writeHashed(file, content);
    BOOST_CHECK_EXCEPTION(Model::load(file), std::runtime_error, [&](const std::runtime_error& error) {
        BOOST_TEST(error.what() == file + ": its leaves hold " + std::to_string(count) +
                                       " triangles and leave out 0 of " + std::to_string(count + 1) +
                                       ", expected a model saved by this version of clearway");
        return true;
    });
}

BOOST_FIXTURE_TEST_CASE(leaves_of_floats_and_of_doubles_are_saved, Fixture) {
    Mesh floats = environment;
    for (Vector3& vertex : floats.vertices) vertex = vertex.cast<float>().cast<double>();
    Mesh both = floats;
    both.vertices[5].x() = environment.vertices[5].x();
    for (const Mesh& mesh : {floats, environment, both}) {
        const Model built = Model::build(mesh);
        built.save(file);
        const Model loaded = Model::load(file);
        const std::vector<LeafReference> leaves = treeOf(loaded).leaves();
        BOOST_TEST((leaves == treeOf(built).leaves()));
        for (const LeafReference leaf : leaves) {
            for (std::uint32_t i = 0; i < treeOf(loaded).leaf(leaf).triangleCount; ++i) {
                BOOST_REQUIRE((treeOf(loaded).corners({leaf, i}) == treeOf(built).corners({leaf, i})));
                BOOST_REQUIRE(treeOf(loaded).triangleId({leaf, i}) == treeOf(built).triangleId({leaf, i}));
            }
        }
    }
}

BOOST_FIXTURE_TEST_CASE(the_key_tells_meshes_and_options_apart, Fixture) {
    const std::uint64_t key = modelKey(part, {});
    BOOST_TEST(key == modelKey(part, {}));
    BuildOptions options;
    options.leafSplit = "chain";
    BOOST_TEST(key != modelKey(part, options));
    options = {};
    options.threads = 1;  // makes the same tree
    BOOST_TEST(key == modelKey(part, options));
    Mesh moved = part;
    moved.vertices.back().z() += 1e-9;
    BOOST_TEST(key != modelKey(moved, {}));
    std::swap(moved = part, part);
    std::swap(moved.triangles[0], moved.triangles[1]);
    BOOST_TEST(key != modelKey(moved, {}));
}

BOOST_FIXTURE_TEST_CASE(the_cache_builds_once_and_replaces_what_is_damaged, Fixture) {
    const std::string cache = folder.file("cache");
    BOOST_TEST(!buildCached(part, {}, cache).isLoaded);
    const CachedModel second = buildCached(part, {}, cache);
    BOOST_TEST(second.isLoaded);
    BOOST_TEST(second.warning == "");
    BOOST_TEST(!buildCached(environment, {}, cache).isLoaded);

    for (const auto& entry : std::filesystem::directory_iterator(cache))
        write(entry.path().string(), "clearway");
    const CachedModel anew = buildCached(part, {}, cache);
    BOOST_TEST(!anew.isLoaded);
    BOOST_TEST(anew.warning.find("built again") != std::string::npos);
    BOOST_TEST(buildCached(part, {}, cache).isLoaded);
}

BOOST_FIXTURE_TEST_CASE(a_cache_that_cannot_be_used_is_a_warning_beside_the_model, Fixture) {
    write(file, "no folder");
    const std::string loop = folder.file("loop");
    std::filesystem::create_directory_symlink(loop, loop);
    for (const std::string& cache : {file, file + "/below", loop, std::string("/proc")}) {
        const CachedModel built = buildCached(part, {}, cache);
        BOOST_TEST(built.model.report().triangles == part.triangles.size());
        BOOST_TEST((!built.isLoaded && !built.isKept));
        BOOST_TEST(built.warning.find("'" + cache) != std::string::npos, built.warning);
        BOOST_TEST(built.warning.find("; built models are not kept") != std::string::npos, built.warning);
    }
    BOOST_TEST(contentOf(file) == "no folder");
}

BOOST_FIXTURE_TEST_CASE(a_cached_file_with_other_components_is_built_again, Fixture) {
    // Callers index arrays by a component's and a triangle's number.
    part.components = {{"left", 0, 5}, {"right", 5, std::uint32_t(part.triangles.size()) - 5}};
    const std::string cache = folder.file("cache");
    buildCached(part, {}, cache);
    const std::string kept = std::filesystem::directory_iterator(cache)->path().string();
    std::string content = contentOf(kept);
    content.replace(content.rfind("right"), 5, "wrong");
    writeHashed(kept, content);
    const CachedModel anew = buildCached(part, {}, cache);
    BOOST_TEST(!anew.isLoaded);
    BOOST_TEST(anew.warning.find("from another mesh") != std::string::npos, anew.warning);
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway
