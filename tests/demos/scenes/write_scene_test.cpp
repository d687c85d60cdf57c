#include <boost/test/unit_test.hpp>
#include <filesystem>
#include <stdexcept>

#include "demos/scenes/scene_checks.h"
#include "demos/scenes/scenes.h"
#include "support/temporary_folder.h"
#include "support/words.h"

BOOST_AUTO_TEST_SUITE(write_scene_test)

using namespace clearway;
using namespace clearway::scenes;
using namespace clearway::testing;

GeneratedScene readScene(const std::string& problemFile, const std::string& pathFile) {
    GeneratedScene scene;
    scene.problem = readProblem(problemFile);
    scene.part = loadPart(scene.problem);
    scene.environment = loadEnvironment(scene.problem);
    scene.path = readPath(pathFile, scene.problem.space);
    return scene;
}

std::vector<std::string> names(const Mesh& mesh) {
    std::vector<std::string> all;
    for (const Component& component : mesh.components) all.push_back(component.name);
    std::sort(all.begin(), all.end());
    return all;
}

const std::string kData = std::string(CLEARWAY_DATA_DIR) + "/tunnel-console-small/";

BOOST_AUTO_TEST_CASE(written_files_read_back_as_the_scene) {
    const TemporaryFolder folder;
    const GeneratedScene made = makeTunnelConsole3({1, 15000, 50000, 10});
    const SceneFiles files = writeScene(made, folder.file("new/sub"));
    const GeneratedScene read = readScene(files.problem, files.path);
    BOOST_TEST(read.problem.warnings.empty());
    BOOST_TEST(read.problem.meshes.asOmplApp);
    BOOST_TEST(read.problem.fineness.value() == made.problem.fineness.value());
    BOOST_TEST(read.part.triangles.size() == made.part.triangles.size());
    BOOST_TEST(read.environment.triangles.size() == made.environment.triangles.size());
    BOOST_TEST(names(read.part) == names(made.part), boost::test_tools::per_element());
    BOOST_TEST(names(read.environment) == names(made.environment), boost::test_tools::per_element());
    BOOST_REQUIRE(read.path.size() == made.path.size());

    // The part's surface is where the scene was made, and the reader hardly moved it.
    BOOST_TEST(read.part.origin.shift.norm() < 1e-3);
    for (std::size_t i = 0; i < made.path.size(); ++i) {
        Box madeBox, readBox;
        for (const Vector3& v : made.part.vertices) madeBox.extend(poseOf(made.path[i]) * v);
        for (const Vector3& v : read.part.vertices) readBox.extend(poseOf(read.path[i]) * v);
        BOOST_TEST((madeBox.min() - readBox.min()).norm() < 2e-3);
        BOOST_TEST((madeBox.max() - readBox.max()).norm() < 2e-3);
    }
    BOOST_TEST((boundsOf(read.problem, boundingBox(read.environment), boundingBox(read.part))
                    .contains(read.problem.start.position)));
    BOOST_TEST(walkPath(read, 10, 15, 5).proven);
}

BOOST_AUTO_TEST_CASE(the_small_scene_in_data_keeps_its_promises) {
    const GeneratedScene kept = readScene(kData + "tunnel-console.cfg", kData + "tunnel-console.path");
    BOOST_TEST(kept.part.triangles.size() >= 1900);
    BOOST_TEST(kept.part.triangles.size() <= 2100);
    BOOST_TEST(kept.environment.triangles.size() >= 7600);
    BOOST_TEST(kept.environment.triangles.size() <= 8400);
    const PathClearance walk = walkPath(kept, 10, 15, 5);
    BOOST_TEST(walk.proven);
    BOOST_TEST(walk.tightLength >= 0.3 * walk.length);
    std::uintmax_t bytes = 0;
    for (const auto& entry : std::filesystem::directory_iterator(kData)) bytes += entry.file_size();
    BOOST_TEST(bytes < 2000000);
}

BOOST_AUTO_TEST_CASE(nothing_is_written_when_one_of_the_files_cannot_be) {
    const TemporaryFolder folder;
    const GeneratedScene scene = makeBoxes(kBoxes);
    std::filesystem::create_directory(folder.file(scene.name + ".path"));
    BOOST_CHECK_THROW(writeScene(scene, folder.path()), std::runtime_error);
    BOOST_TEST(folder.names() == std::vector<std::string>{scene.name + ".path"});
}

BOOST_AUTO_TEST_SUITE_END()
