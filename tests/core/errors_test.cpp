// Errors of callers and files are caught as clearway's own type, by its base, and as the standard type.
#include "clearway/errors.h"

#include <boost/test/unit_test.hpp>
#include <filesystem>
#include <functional>
#include <limits>

#include "clearway/build_options.h"
#include "clearway/model.h"
#include "clearway/obstacle_groups.h"
#include "clearway/problem.h"
#include "clearway/query.h"
#include "clearway/scene.h"
#include "clearway/shrink.h"
#include "clearway/sweep.h"
#include "clearway/swept_volume.h"
#include "clearway/targets.h"
#include "support/random_meshes.h"
#include "support/temporary_folder.h"

namespace clearway {
BOOST_AUTO_TEST_SUITE(errors_test)

struct Call {
    const char* what;
    std::function<void()> call;
};

template <class Type, class Standard>
void expectType(const std::vector<Call>& calls) {
    for (const auto& [what, call] : calls) {
        BOOST_TEST_CONTEXT(what) {
            BOOST_CHECK_EXCEPTION(call(), Error, [](const Error& error) {
                const auto* standard = dynamic_cast<const Standard*>(&error);
                return dynamic_cast<const Type*>(&error) && standard && *error.what() != '\0' &&
                       std::string(error.what()) == standard->what();
            });
            BOOST_CHECK_THROW(call(), Type);
            BOOST_CHECK_THROW(call(), Standard);
            BOOST_CHECK_THROW(call(), std::exception);  // it would not be caught if it were one twice
        }
    }
}

const testing::TemporaryFolder& folder() {
    static const testing::TemporaryFolder made;
    return made;
}

BOOST_AUTO_TEST_CASE(a_wrong_argument_is_an_argument_error) {
    testing::Random random(1);
    const Mesh mesh = testing::randomSoup(random, 10, 1, 1);
    const Model model = Model::build(mesh);
    Pose skewed;
    skewed.rotation(0, 0) = 2;
    BuildOptions noLeaves;
    noLeaves.leafSize = 0;
    BuildOptions noFit;
    noFit.fit = "tight";
    LoadOptions noScale;
    noScale.scale = std::numeric_limits<double>::quiet_NaN();
    SweptVolumeOptions within;
    within.tolerance = 0.1;
    Workspace workspace;
    const std::string stl = folder().file("soup.stl");
    saveMesh(mesh, stl);
    expectType<ArgumentError, std::invalid_argument>({
        {"a quaternion of length 0", [] { toPose(Eigen::Quaterniond(0, 0, 0, 0), Vector3::Zero()); }},
        {"a pose that is no rotation", [&] { distance(model, model, skewed); }},
        {"a negative distance", [&] { isWithin(model, model, Pose(), -1); }},
        {"a motion without pieces", [&] { sweep(model, model, MotionPieces(), {}, workspace); }},
        {"a mesh without triangles", [] { Model::build(Mesh()); }},
        {"leaves of no triangles", [&] { Model::build(mesh, noLeaves); }},
        {"an unknown fit", [&] { Model::build(mesh, noFit); }},
        {"an unknown instruction set", [] { useTarget("avx9"); }},
        {"a scale that is no number", [&] { loadMesh(stl, noScale); }},
        {"an ending of no format", [&] { saveMesh(mesh, folder().file("soup.doc")); }},
        {"a negative margin", [&] { Obstacle(model, -1); }},
        {"a negative margin of a group", [&] { groupObstacles({mesh}, -1, {}); }},
        {"a surface that is not closed", [&] { shrink(mesh, {0.1}); }},
        {"a swept volume without motions", [&] { sweptVolume(mesh, {}, within); }},
    });
}

BOOST_AUTO_TEST_CASE(a_wrong_value_in_a_problem_or_path_file_is_an_argument_error) {
    const std::string problem = folder().write("wrong.cfg", "[problem]\nrobot\n");
    const std::string path = folder().write("wrong.path", "1 2 three 0 0 0 1\n");
    expectType<ArgumentError, std::invalid_argument>({
        {"a line without a value", [&] { readProblem(problem); }},
        {"a word for a number", [&] { readPath(path, Space::kSe3); }},
    });
}

BOOST_AUTO_TEST_CASE(a_file_that_cannot_be_used_is_a_file_error) {
    testing::Random random(1);
    const Model model = Model::build(testing::randomSoup(random, 10, 1, 1));
    const std::string missing = folder().file("missing"), text = folder().write("text.stl", "no mesh");
    const std::string beneath = text + "/x";
    Problem circular;
    circular.meshes.robot = circular.meshes.world = folder().file("circle.stl");
    std::filesystem::create_symlink(circular.meshes.robot, circular.meshes.robot);
    expectType<FileError, std::runtime_error>({
        {"a missing mesh", [&] { loadMesh(missing + ".stl"); }},
        {"a text as a mesh", [&] { loadMesh(text); }},
        {"a missing model", [&] { Model::load(missing); }},
        {"a text as a model", [&] { Model::load(text); }},
        {"a model beneath a file", [&] { model.save(beneath); }},
        {"a missing problem", [&] { readProblem(missing); }},
        {"a folder as a path", [&] { readPath(folder().path(), Space::kSe3); }},
        {"a mesh whose name leads in a circle",
         [&] { writeProblem(circular, folder().file("circular.cfg")); }},
        {"a path beneath a file", [&] { writePath({}, Space::kSe3, beneath); }},
    });
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway
