// Meshes, poses and handles for the tests of the library for C.
#pragma once

#include <array>
#include <boost/test/unit_test.hpp>
#include <cstdint>
#include <string>
#include <vector>

#include "clearway/clearway.h"
#include "clearway/model.h"
#include "support/random_meshes.h"

namespace clearway::testing::c {

using Rows = std::array<double, 16>;

inline Rows rowsOf(const Pose& pose) {
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

inline Arrays arraysOf(const Mesh& mesh) {
    Arrays arrays;
    for (const Vector3& vertex : mesh.vertices) {
        arrays.vertices.insert(arrays.vertices.end(), {vertex.x(), vertex.y(), vertex.z()});
    }
    for (const TriangleIndices& triangle : mesh.triangles) {
        arrays.triangles.insert(arrays.triangles.end(), triangle.begin(), triangle.end());
    }
    return arrays;
}

inline clearway_status build(const Arrays& arrays, clearway_handle& model) {
    return clearway_build(arrays.vertices.data(), arrays.vertices.size() / 3, arrays.triangles.data(),
                          arrays.triangles.size() / 3, &model);
}

inline clearway_handle built(const Mesh& mesh) {
    clearway_handle model = 0;
    BOOST_TEST_REQUIRE(build(arraysOf(mesh), model) == CLEARWAY_OK, clearway_last_error());
    BOOST_TEST(model != 0u);
    return model;
}

inline clearway_handle newWorkspace() {
    clearway_handle workspace = 0;
    BOOST_TEST_REQUIRE(clearway_new_workspace(&workspace) == CLEARWAY_OK);
    return workspace;
}

/// Expects a failing call with a text that holds all of the words.
inline void expectRefusal(clearway_status status, clearway_status expected,
                          const std::vector<std::string>& words) {
    const std::string text = clearway_last_error();
    BOOST_TEST(status == expected, text);
    for (const std::string& word : words) BOOST_TEST(text.find(word) != std::string::npos, text);
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

}  // namespace clearway::testing::c
