#include <boost/test/unit_test.hpp>

#include "clearway/problem.h"
#include "support/temporary_folder.h"

namespace clearway::testing {
BOOST_AUTO_TEST_SUITE(load_scene_test)

/// A box between two others, one of which is ignored.
Problem betweenBoxes(const TemporaryFolder& folder) {
    saveMesh(boxMesh(Box(Vector3(-1, -1, -1), Vector3(1, 1, 1)), "part"), folder.file("part.obj"));
    saveMesh(boxMesh(Box(Vector3(10, 0, 0), Vector3(11, 1, 1)), "right"), folder.file("right.obj"));
    saveMesh(boxMesh(Box(Vector3(-11, 0, 0), Vector3(-10, 1, 1)), "left"), folder.file("left.obj"));
    return readProblem(folder.write(
        "boxes.cfg",
        "[problem]\nrobot = part.obj\nworld = right.obj, left.obj\nstart.x = "
        "0\nstart.y = 0\nstart.theta = 0\n"
        "goal.x = 5\ngoal.y = 5\ngoal.theta = 0\n[clearway]\nignore = left\nreading = stored\n"));
}

BOOST_AUTO_TEST_CASE(a_caller_may_replace_reading_building_and_the_reach) {
    const TemporaryFolder folder;
    std::vector<std::string> readFiles;
    std::vector<bool> builtWithRange;
    Box environmentBox;
    SceneLoading loading;
    loading.read = [&](const std::string& file, const LoadOptions& options) {
        readFiles.push_back(file.substr(file.rfind('/') + 1));
        return loadMesh(file, options);
    };
    loading.build = [&](const Mesh& mesh, const BuildOptions& options,
                        const std::optional<QueryRange>& range) {
        builtWithRange.push_back(range.has_value());
        return Model::build(mesh, options, range);
    };
    loading.range = [&](const Model& part, const Box& box) {
        BOOST_TEST(part.components()[0].name == "part");
        environmentBox = box;
        return QueryRange{Box(Vector3(0, 0, 0), Vector3(5, 5, 0)), part.radiusAboutOrigin(), 1};
    };
    BuildOptions options;
    options.leafSize = 2;
    const Scene scene = loadScene(betweenBoxes(folder), options, loading).scene;
    BOOST_TEST(readFiles == std::vector<std::string>({"part.obj", "right.obj", "left.obj"}),
               boost::test_tools::per_element());
    BOOST_TEST(builtWithRange == std::vector<bool>({false, true}), boost::test_tools::per_element());
    BOOST_TEST(environmentBox.min().x() == -11);  // the ignored box counts
    BOOST_TEST(environmentBox.max().x() == 11);
    BOOST_TEST_REQUIRE(scene.obstacles.size() == 1u);
    BOOST_TEST(scene.obstacles[0].model.range()->cap == 1);
    BOOST_TEST(scene.obstacles[0].model.report().options.leafSize == 2);
}

BOOST_AUTO_TEST_CASE(by_default_the_whole_environment_is_built) {
    const TemporaryFolder folder;
    const Scene scene = loadScene(betweenBoxes(folder)).scene;
    BOOST_TEST(!scene.obstacles[0].model.range());
    BOOST_TEST(scene.obstacles[0].model.report().triangles == 12u);
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::testing
