// The library for C gives C++'s answers and C++'s words, and survives whatever it is handed.
#include "clearway/clearway.h"

#include <array>
#include <atomic>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <fstream>
#include <functional>
#include <limits>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "clearway/version.h"
#include "support/query_cases.h"
#include "support/temporary_folder.h"

BOOST_AUTO_TEST_SUITE(clearway_test)

using namespace clearway;
using namespace clearway::testing;

namespace {

using Rows = std::array<double, 16>;

Rows rowsOf(const Pose& pose) {
    Rows rows{};
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) rows[4 * row + column] = pose.rotation(row, column);
        rows[4 * row + 3] = pose.translation[row];
    }
    rows[15] = 1;
    return rows;
}

const Rows kAtOrigin = rowsOf(Pose());

struct Arrays {
    std::vector<double> vertices;
    std::vector<std::uint32_t> triangles;
};

Arrays arraysOf(const Mesh& mesh) {
    Arrays arrays;
    for (const Vector3& vertex : mesh.vertices) {
        arrays.vertices.insert(arrays.vertices.end(), {vertex.x(), vertex.y(), vertex.z()});
    }
    for (const TriangleIndices& triangle : mesh.triangles) {
        arrays.triangles.insert(arrays.triangles.end(), triangle.begin(), triangle.end());
    }
    return arrays;
}

clearway_status build(const Arrays& arrays, clearway_handle& model) {
    return clearway_build(arrays.vertices.data(), arrays.vertices.size() / 3, arrays.triangles.data(),
                          arrays.triangles.size() / 3, &model);
}

clearway_handle built(const Mesh& mesh) {
    clearway_handle model = 0;
    BOOST_TEST_REQUIRE(build(arraysOf(mesh), model) == CLEARWAY_OK, clearway_last_error());
    BOOST_TEST(model != 0u);
    return model;
}

clearway_handle newWorkspace() {
    clearway_handle workspace = 0;
    BOOST_TEST_REQUIRE(clearway_new_workspace(&workspace) == CLEARWAY_OK);
    return workspace;
}

/// Expects a failing call with a text that holds all of the words.
void expectRefusal(clearway_status status, clearway_status expected, const std::vector<std::string>& words) {
    const std::string text = clearway_last_error();
    BOOST_TEST(status == expected, text);
    for (const std::string& word : words) BOOST_TEST(text.find(word) != std::string::npos, text);
}

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
    for (int axis = 0; axis < 3; ++axis) {
        BOOST_TEST(areEqual(found.point_on_part[axis], expected.pointOnPart[axis]));
        BOOST_TEST(areEqual(found.point_on_environment[axis], expected.pointOnEnvironment[axis]));
    }
    BOOST_TEST(found.part_triangle == expected.partTriangle);
    BOOST_TEST(found.environment_triangle == expected.environmentTriangle);
}

/// Two boxes of side 2, and the pose at which their faces are 1 apart.
struct Boxes {
    Mesh mesh = box({1, 1, 1});
    Model model = Model::build(mesh);
    clearway_handle part = built(mesh), environment = built(mesh);
    Pose apart{Matrix3::Identity(), {3, 0, 0}};
    Rows rows = rowsOf(apart);
    clearway_distance_result result{};
    int flag = -1;

    ~Boxes() { clearway_free(part), clearway_free(environment); }

    clearway_status distance(const double* pose, const clearway_distance_options* options = nullptr,
                             clearway_handle workspace = 0) {
        return clearway_distance(part, environment, pose, options, workspace, &result);
    }
    clearway_status collides(const double* pose, clearway_handle workspace = 0) {
        return clearway_collides(part, environment, pose, workspace, &flag);
    }
};

}  // namespace

BOOST_AUTO_TEST_CASE(answers_are_those_of_cpp_to_the_last_digit) {
    for (const QueryCase& queryCase : queryCases()) {
        const ModelPair models = buildPair(queryCase);
        const clearway_handle part = built(queryCase.part), environment = built(queryCase.environment),
                              workspace = newWorkspace();
        Workspace scratch;  // each with a workspace that saw the same queries
        for (const Pose& pose : queryCase.poses) {
            const Rows rows = rowsOf(pose);
            for (const clearway_distance_options options :
                 {clearway_distance_options{}, clearway_distance_options{0.1, 0.01, 0},
                  clearway_distance_options{0, 0, 0.5}}) {
                DistanceOptions same;
                same.relativeError = options.relative_error;
                same.absoluteError = options.absolute_error;
                if (options.cap > 0) same.cap = options.cap;
                clearway_distance_result found{};
                BOOST_TEST_REQUIRE(clearway_distance(part, environment, rows.data(), &options, workspace,
                                                     &found) == CLEARWAY_OK);
                checkEqual(found, distance(models.part, models.environment, pose, same, scratch));
            }
            int touching = -1, near = -1;
            BOOST_TEST(clearway_collides(part, environment, rows.data(), workspace, &touching) ==
                       CLEARWAY_OK);
            BOOST_TEST(touching == int(collides(models.part, models.environment, pose, scratch)));
            BOOST_TEST(clearway_within(part, environment, rows.data(), 1, workspace, &near) == CLEARWAY_OK);
            BOOST_TEST(near == int(isWithin(models.part, models.environment, pose, 1, scratch)));
        }
        for (const clearway_handle handle : {part, environment, workspace})
            BOOST_TEST(clearway_free(handle) == CLEARWAY_OK);
    }
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
    for (double DistanceOptions::*const option :
         {&DistanceOptions::relativeError, &DistanceOptions::absoluteError, &DistanceOptions::cap}) {
        for (const double value : {-1.0, nan}) {
            DistanceOptions bad;
            bad.*option = value;
            const clearway_distance_options same = {bad.relativeError, bad.absoluteError, bad.cap};
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

/// Every function with one handle that is none, in each place that takes a handle.
void expectNoHandle(Boxes& boxes, clearway_handle none, const std::string& word) {
    const double* const rows = boxes.rows.data();
    const clearway_handle part = boxes.part;
    const auto expect = [&](clearway_status status, const std::string& name) {
        expectRefusal(status, CLEARWAY_INVALID_ARGUMENT, {name + " is " + word, "expected a "});
    };
    expect(clearway_distance(none, part, rows, nullptr, 0, &boxes.result), "part");
    expect(clearway_distance(part, none, rows, nullptr, 0, &boxes.result), "environment");
    expect(clearway_collides(none, part, rows, 0, &boxes.flag), "part");
    expect(clearway_collides(part, none, rows, 0, &boxes.flag), "environment");
    expect(clearway_within(none, part, rows, 1, 0, &boxes.flag), "part");
    expect(clearway_within(part, none, rows, 1, 0, &boxes.flag), "environment");
    expect(clearway_save(none, "never_written"), "model");
}

BOOST_AUTO_TEST_CASE(handles_that_are_stale_of_the_other_kind_or_zero_are_refused) {
    Boxes boxes;
    const clearway_handle workspace = newWorkspace(), stale = built(boxes.mesh), staleSpace = newWorkspace();
    BOOST_TEST(clearway_free(stale) == CLEARWAY_OK);
    BOOST_TEST(clearway_free(staleSpace) == CLEARWAY_OK);
    expectNoHandle(boxes, workspace, "a workspace");
    expectNoHandle(boxes, 0, "0");
    for (const clearway_handle none : {stale, staleSpace}) {
        expectNoHandle(boxes, none, std::to_string(none));
        expectRefusal(boxes.distance(boxes.rows.data(), nullptr, none), CLEARWAY_INVALID_ARGUMENT,
                      {"workspace is " + std::to_string(none)});
        expectRefusal(clearway_free(none), CLEARWAY_INVALID_ARGUMENT, {std::to_string(none), "freed"});
    }
    expectRefusal(boxes.collides(boxes.rows.data(), boxes.part), CLEARWAY_INVALID_ARGUMENT,
                  {"workspace is a model"});
    BOOST_TEST(clearway_free(0) == CLEARWAY_OK);
    BOOST_TEST(clearway_free(workspace) == CLEARWAY_OK);
}

BOOST_AUTO_TEST_CASE(ten_thousand_invented_handles_are_refused) {
    Boxes boxes;
    Random random(1);
    for (int i = 0; i < 10000; ++i) {
        // All bits, and small numbers as of a user who counts.
        const clearway_handle none = i % 2 ? random.bits() : clearway_handle(i / 2);
        if (none == boxes.part || none == boxes.environment) continue;
        BOOST_TEST_REQUIRE(clearway_distance(none, boxes.environment, boxes.rows.data(), nullptr, 0,
                                             &boxes.result) == CLEARWAY_INVALID_ARGUMENT);
        BOOST_TEST_REQUIRE(clearway_collides(boxes.part, none, boxes.rows.data(), 0, &boxes.flag) ==
                           CLEARWAY_INVALID_ARGUMENT);
        if (none == 0) continue;
        BOOST_TEST_REQUIRE(boxes.collides(boxes.rows.data(), none) == CLEARWAY_INVALID_ARGUMENT);
        BOOST_TEST_REQUIRE(clearway_free(none) == CLEARWAY_INVALID_ARGUMENT);
    }
    BOOST_TEST(boxes.distance(boxes.rows.data()) == CLEARWAY_OK);
}

BOOST_AUTO_TEST_CASE(handles_are_never_given_out_again) {
    Boxes boxes;
    std::vector<clearway_handle> given;
    for (int i = 0; i < 2000; ++i) {
        given.push_back(newWorkspace());
        if (i % 3) clearway_free(given.back());
    }
    std::vector<clearway_handle> sorted = given;
    std::sort(sorted.begin(), sorted.end());
    BOOST_TEST((std::adjacent_find(sorted.begin(), sorted.end()) == sorted.end()));
    for (std::size_t i = 0; i < given.size(); ++i) {
        BOOST_TEST(clearway_free(given[i]) == (i % 3 ? CLEARWAY_INVALID_ARGUMENT : CLEARWAY_OK));
    }
}

BOOST_AUTO_TEST_CASE(a_workspace_is_refused_to_other_threads) {
    Boxes boxes;
    const clearway_handle mine = newWorkspace();
    std::thread([&] {
        int flag = -1;
        BOOST_TEST(clearway_collides(boxes.part, boxes.environment, boxes.rows.data(), mine, &flag) ==
                   CLEARWAY_INVALID_ARGUMENT);
        BOOST_TEST(clearway_last_error() ==
                   std::string("the workspace belongs to another thread, expected one for each thread"));
        BOOST_TEST(flag == -1);
    }).join();
    BOOST_TEST(boxes.collides(boxes.rows.data(), mine) == CLEARWAY_OK);
    std::thread([&] { clearway_free(mine); }).join();  // giving up is not using
    BOOST_TEST(boxes.collides(boxes.rows.data(), mine) == CLEARWAY_INVALID_ARGUMENT);
}

BOOST_AUTO_TEST_CASE(each_thread_has_its_own_last_error) {
    std::thread([] {
        BOOST_TEST(clearway_last_error() == std::string());
        clearway_free(12345);
        BOOST_TEST(clearway_last_error() != std::string());
    }).join();
    clearway_load(nullptr, 1, nullptr);
    const std::string mine = clearway_last_error();
    std::thread([] { clearway_free(54321); }).join();
    BOOST_TEST(clearway_last_error() == mine);
    BOOST_TEST(clearway_free(0) == CLEARWAY_OK);
    BOOST_TEST(clearway_last_error() == mine);  // what succeeds leaves it
}

/// Threads query models and workspaces that another thread frees: an answer is right or refused.
BOOST_AUTO_TEST_CASE(freeing_what_other_threads_use_is_safe) {
    Random random(3);
    const Mesh mesh = randomSoup(random, 300, 5, 1);
    const Rows pose = rowsOf({Matrix3::Identity(), {14, 0, 0}});
    const clearway_handle environment = built(mesh);
    clearway_distance_result expected{};
    BOOST_TEST_REQUIRE(clearway_distance(environment, environment, pose.data(), nullptr, newWorkspace(),
                                         &expected) == CLEARWAY_OK);
    std::atomic<clearway_handle> part{built(mesh)};
    std::atomic<bool> isOver{false};
    std::atomic<int> answered{0}, wrong{0};
    std::vector<std::thread> threads;
    for (int k = 0; k < 3; ++k) {
        threads.emplace_back([&] {
            clearway_handle mine = 0;
            clearway_new_workspace(&mine);
            while (!isOver) {
                clearway_distance_result found{};
                const clearway_status status =
                    clearway_distance(part, environment, pose.data(), nullptr, mine, &found);
                if (status == CLEARWAY_OK) {
                    ++answered;
                    if (!(found.lower <= expected.upper && expected.lower <= found.upper)) ++wrong;
                } else if (status != CLEARWAY_INVALID_ARGUMENT) {
                    ++wrong;
                }
            }
            clearway_free(mine);
        });
    }
    for (int i = 0; i < 50 || answered < 100; ++i) {
        const clearway_handle old = part.exchange(built(mesh));
        BOOST_TEST(clearway_free(old) == CLEARWAY_OK);
    }
    isOver = true;
    for (std::thread& thread : threads) thread.join();
    BOOST_TEST(wrong == 0);
    clearway_free(part), clearway_free(environment);
}

BOOST_AUTO_TEST_SUITE_END()
