// The library for C gives C++'s answers and C++'s words, and survives whatever it is handed.
#include "clearway/clearway.h"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "c/c_models.h"
#include "clearway/query.h"
#include "clearway/version.h"
#include "support/random_meshes.h"
#include "support/temporary_folder.h"

BOOST_AUTO_TEST_SUITE(clearway_test)

using namespace clearway;
using namespace clearway::testing;
using namespace clearway::testing::c;

/// Expects that the call fails with the text with which the C++ function throws an Exception.
template <class Exception>
void expectWordsOfCpp(clearway_status status, const std::function<void()>& inCpp) {
    std::string words;
    try {
        inCpp();
    } catch (const Exception& error) {
        words = error.what();
    }
    BOOST_TEST(!words.empty());
    BOOST_TEST(clearway_last_error() == words);
    const bool isArgument = std::is_same_v<Exception, std::invalid_argument>;
    BOOST_TEST(status == (isArgument ? CLEARWAY_INVALID_ARGUMENT : CLEARWAY_FILE_ERROR));
}

bool areEqual(double a, double b) {
    return a == b || (std::isnan(a) && std::isnan(b));
}

void checkEqual(const clearway_distance_result& found, const DistanceResult& expected) {
    BOOST_TEST(found.lower == expected.lower);
    BOOST_TEST(found.upper == expected.upper);
    BOOST_TEST(found.distance == expected.distance);
    if (!expected.witness) {
        BOOST_TEST(std::isnan(found.point_on_part[0]));
        BOOST_TEST(std::isnan(found.point_on_environment[0]));
        BOOST_TEST(found.part_triangle == -1);
        BOOST_TEST(found.environment_triangle == -1);
        return;
    }
    for (int axis = 0; axis < 3; ++axis) {
        BOOST_TEST(areEqual(found.point_on_part[axis], expected.witness->pointOnPart[axis]));
        BOOST_TEST(areEqual(found.point_on_environment[axis], expected.witness->pointOnEnvironment[axis]));
    }
    BOOST_TEST(found.part_triangle == expected.witness->partTriangle);
    BOOST_TEST(found.environment_triangle == expected.witness->environmentTriangle);
}

BOOST_AUTO_TEST_CASE(answers_are_those_of_cpp_to_the_last_digit) {
    int contacts = 0, apart = 0;
    Random random(1);
    for (const MeshPair& pair : meshPairs(1)) {
        const Model cppPart = Model::build(pair.part), cppEnvironment = Model::build(pair.environment);
        const clearway_handle part = built(pair.part), environment = built(pair.environment),
                              workspace = newWorkspace();
        Workspace scratch;  // each with a workspace that saw the same queries
        for (int i = 0; i < 20; ++i) {
            const Pose pose = random.pose(cppEnvironment.box().diagonal().norm() / 2);
            const Rows rows = rowsOf(pose);
            for (const clearway_distance_options options :
                 {clearway_distance_options{}, clearway_distance_options{0.1, 0.01, 0},
                  clearway_distance_options{0, 0, 0.5}, clearway_distance_options{0, 0, HUGE_VAL}}) {
                DistanceOptions same;
                same.relativeError = options.relative_error;
                same.absoluteError = options.absolute_error;
                if (options.cap > 0) same.cap = options.cap;
                clearway_distance_result found{};
                BOOST_TEST_REQUIRE(clearway_distance(part, environment, rows.data(), &options, workspace,
                                                     &found) == CLEARWAY_OK);
                checkEqual(found, distance(cppPart, cppEnvironment, pose, same, scratch));
            }
            int touching = -1, near = -1;
            BOOST_TEST(clearway_collides(part, environment, rows.data(), workspace, &touching) ==
                       CLEARWAY_OK);
            ++(touching == 1 ? contacts : apart);
            BOOST_TEST(touching == int(collides(cppPart, cppEnvironment, pose, scratch)));
            BOOST_TEST(clearway_within(part, environment, rows.data(), 1, workspace, &near) == CLEARWAY_OK);
            BOOST_TEST(near == int(isWithin(cppPart, cppEnvironment, pose, 1, scratch)));
        }
        for (const clearway_handle handle : {part, environment, workspace})
            BOOST_TEST(clearway_free(handle) == CLEARWAY_OK);
    }
    BOOST_TEST(contacts > 10);
    BOOST_TEST(apart > 10);
}

BOOST_AUTO_TEST_CASE(without_a_workspace_and_without_options_queries_answer_too) {
    Boxes boxes;
    BOOST_TEST(boxes.distance(boxes.rows.data()) == CLEARWAY_OK);
    BOOST_TEST(boxes.result.lower <= 1);
    BOOST_TEST(boxes.result.upper >= 1);
    BOOST_TEST(boxes.result.distance == 1, boost::test_tools::tolerance(1e-15));
    BOOST_TEST(boxes.result.point_on_part[0] == 2);
    BOOST_TEST(boxes.result.point_on_environment[0] == 1);
    BOOST_TEST(boxes.collides(boxes.rows.data()) == CLEARWAY_OK);
    BOOST_TEST(boxes.flag == 0);
    BOOST_TEST(boxes.collides(kAtOrigin.data()) == CLEARWAY_OK);
    BOOST_TEST(boxes.flag == 1);
    BOOST_TEST(clearway_version() == std::string(CLEARWAY_VERSION));
}

BOOST_AUTO_TEST_CASE(a_model_owns_its_data_and_is_saved_and_loaded) {
    Boxes boxes;
    Arrays arrays = arraysOf(boxes.mesh);
    clearway_handle model = 0, again = 0;
    BOOST_TEST(build(arrays, model) == CLEARWAY_OK);
    arrays.vertices.assign(arrays.vertices.size(), 1e30);
    arrays.triangles.assign(arrays.triangles.size(), 0);

    const TemporaryFolder folder;
    const std::string saved = folder.file("box.clearway"), mesh = folder.file("box.stl");
    saveMesh(boxes.mesh, mesh);
    BOOST_TEST(clearway_save(model, saved.c_str()) == CLEARWAY_OK);
    BOOST_TEST(clearway_free(model) == CLEARWAY_OK);
    for (const auto& [file, scale] : {std::pair(saved, 1.0), std::pair(mesh, 1.0), std::pair(mesh, 0.5)}) {
        BOOST_TEST_REQUIRE(clearway_load(file.c_str(), scale, &again) == CLEARWAY_OK, clearway_last_error());
        clearway_distance_result result{};
        BOOST_TEST(clearway_distance(again, boxes.environment, boxes.rows.data(), nullptr, 0, &result) ==
                   CLEARWAY_OK);
        BOOST_TEST(result.distance == 2 - scale);
        BOOST_TEST(clearway_free(again) == CLEARWAY_OK);
    }
    expectRefusal(clearway_load(saved.c_str(), 2, &again), CLEARWAY_INVALID_ARGUMENT,
                  {"scale is 2", "expected 1"});
}

BOOST_AUTO_TEST_CASE(bad_input_is_refused_in_the_words_of_cpp) {
    Boxes boxes;
    const TemporaryFolder folder;
    const double nan = std::numeric_limits<double>::quiet_NaN();
    clearway_handle model = 77;
    Mesh notFinite = boxes.mesh, outOfRange = boxes.mesh, empty;
    notFinite.vertices[3].y() = nan;
    outOfRange.triangles[5][1] = std::uint32_t(outOfRange.vertices.size());
    for (const Mesh& mesh : {notFinite, outOfRange, empty}) {
        expectWordsOfCpp<std::invalid_argument>(build(arraysOf(mesh), model), [&] { Model::build(mesh); });
    }
    const std::string missing = folder.file("missing.stl"), text = folder.write("text.obj", "no mesh\n"),
                      damaged = folder.write("damaged.clearway", "clearway, but not for long");
    for (const std::string& file : {missing, text}) {
        expectWordsOfCpp<std::runtime_error>(clearway_load(file.c_str(), 1, &model), [&] { loadMesh(file); });
    }
    expectWordsOfCpp<std::runtime_error>(clearway_load(damaged.c_str(), 1, &model),
                                         [&] { Model::load(damaged); });
    const std::string nowhere = folder.file("no/such/folder");
    expectWordsOfCpp<std::runtime_error>(clearway_save(boxes.part, nowhere.c_str()),
                                         [&] { boxes.model.save(nowhere); });
    for (const double scale : {0.0, -1.0, nan}) {
        LoadOptions options;
        options.scale = scale;
        expectWordsOfCpp<std::invalid_argument>(clearway_load(missing.c_str(), scale, &model),
                                                [&] { loadMesh(missing, options); });
    }
    BOOST_TEST(model == 77u);  // what fails leaves its result as it was

    std::vector<Pose> poses(4, boxes.apart);
    poses[0].rotation(0, 0) = 1.1;
    poses[1].rotation(2, 2) = -1;
    poses[2].rotation(1, 0) = nan;
    poses[3].translation.z() = std::numeric_limits<double>::infinity();
    boxes.result.lower = -5;
    for (const Pose& pose : poses) {
        const Rows rows = rowsOf(pose);
        const auto inCpp = [&] { distance(boxes.model, boxes.model, pose); };
        expectWordsOfCpp<std::invalid_argument>(boxes.distance(rows.data()), inCpp);
        expectWordsOfCpp<std::invalid_argument>(boxes.collides(rows.data()), inCpp);
        expectWordsOfCpp<std::invalid_argument>(
            clearway_within(boxes.part, boxes.environment, rows.data(), 1, 0, &boxes.flag), inCpp);
    }
    for (double clearway_distance_options::*const option :
         {&clearway_distance_options::relative_error, &clearway_distance_options::absolute_error,
          &clearway_distance_options::cap}) {
        for (const double value : {-1.0, nan}) {
            clearway_distance_options same = {0, 0, HUGE_VAL};
            same.*option = value;
            const DistanceOptions bad{same.relative_error, same.absolute_error, same.cap};
            expectWordsOfCpp<std::invalid_argument>(boxes.distance(boxes.rows.data(), &same), [&] {
                distance(boxes.model, boxes.model, boxes.apart, bad);
            });
        }
    }
    for (const double d : {-1.0, nan}) {
        expectWordsOfCpp<std::invalid_argument>(
            clearway_within(boxes.part, boxes.environment, boxes.rows.data(), d, 0, &boxes.flag),
            [&] { isWithin(boxes.model, boxes.model, boxes.apart, d); });
    }
    BOOST_TEST(boxes.result.lower == -5);
    BOOST_TEST(boxes.flag == -1);
}

BOOST_AUTO_TEST_CASE(a_pose_whose_columns_come_first_is_refused) {
    Boxes boxes;
    Rows byColumns{};
    for (int row = 0; row < 4; ++row) {
        for (int column = 0; column < 4; ++column) byColumns[4 * column + row] = boxes.rows[4 * row + column];
    }
    expectRefusal(boxes.distance(byColumns.data()), CLEARWAY_INVALID_ARGUMENT,
                  {"the last row of pose is 3 0 0 1", "expected 0 0 0 1"});
    byColumns = boxes.rows;
    byColumns[15] = std::numeric_limits<double>::quiet_NaN();
    expectRefusal(boxes.collides(byColumns.data()), CLEARWAY_INVALID_ARGUMENT, {"nan"});
}

BOOST_AUTO_TEST_CASE(null_pointers_are_refused_by_name) {
    Boxes boxes;
    const Arrays arrays = arraysOf(boxes.mesh);
    const double* const vertices = arrays.vertices.data();
    const std::uint32_t* const triangles = arrays.triangles.data();
    const double* const rows = boxes.rows.data();
    const clearway_handle part = boxes.part;
    clearway_handle model = 0;
    const auto expectNull = [](clearway_status status, const std::string& name) {
        expectRefusal(status, CLEARWAY_INVALID_ARGUMENT, {name + " is a null pointer, expected "});
    };
    expectNull(clearway_load(nullptr, 1, &model), "file");
    expectNull(clearway_load("x.stl", 1, nullptr), "model");
    expectNull(clearway_build(nullptr, 8, triangles, 12, &model), "vertices");
    expectNull(clearway_build(vertices, 8, nullptr, 12, &model), "triangles");
    expectNull(clearway_build(vertices, 8, triangles, 12, nullptr), "model");
    expectNull(clearway_save(part, nullptr), "file");
    expectNull(clearway_new_workspace(nullptr), "workspace");
    expectNull(clearway_distance(part, part, nullptr, nullptr, 0, &boxes.result), "pose");
    expectNull(clearway_distance(part, part, rows, nullptr, 0, nullptr), "result");
    expectNull(clearway_collides(part, part, nullptr, 0, &boxes.flag), "pose");
    expectNull(clearway_collides(part, part, rows, 0, nullptr), "collides");
    expectNull(clearway_within(part, part, nullptr, 1, 0, &boxes.flag), "pose");
    expectNull(clearway_within(part, part, rows, 1, 0, nullptr), "within");
}

BOOST_AUTO_TEST_CASE(counts_beyond_any_memory_are_refused_before_anything_is_read) {
    const double vertex[3] = {};
    const std::uint32_t triangle[3] = {};
    clearway_handle model = 0;
    const std::size_t many = std::numeric_limits<std::size_t>::max();
    BOOST_TEST(clearway_build(vertex, many, triangle, 1, &model) == CLEARWAY_OUT_OF_MEMORY);
    BOOST_TEST(clearway_build(vertex, 1, triangle, many / 2, &model) == CLEARWAY_OUT_OF_MEMORY);
    BOOST_TEST(clearway_last_error() == std::string("out of memory"));
}

BOOST_AUTO_TEST_SUITE_END()
