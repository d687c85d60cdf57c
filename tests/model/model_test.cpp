// The properties that a model reports, and the meshes that are refused.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>

#include "clearway/model.h"
#include "model/model_data.h"
#include "support/each_target.h"
#include "support/random_meshes.h"
#include "support/words.h"

BOOST_AUTO_TEST_SUITE(model_test)

using namespace clearway;
using namespace clearway::testing;

void checkRefused(const Mesh& mesh, const BuildOptions& options, const std::vector<std::string>& words) {
    requireRefusedBy([&] { Model::build(mesh, options); }, words);
}

BOOST_AUTO_TEST_CASE(a_model_tells_its_box_radius_and_components) {
    Mesh mesh = translated(box({1, 2, 3}, 2), {10, 0, 0});
    mesh.vertices.push_back({1000, 1000, 1000});  // no triangle's
    const auto count = static_cast<std::uint32_t>(mesh.triangles.size());
    mesh.components = {{"left", 0, 5}, {"right", 5, count - 5}};
    mesh.origin.scale = 2.5;
    const Model model = Model::build(mesh);
    BOOST_TEST((model.box().min() == Vector3(9, -2, -3)));
    BOOST_TEST((model.box().max() == Vector3(11, 2, 3)));
    const double radius = std::sqrt(121.0 + 4 + 9);
    BOOST_TEST(model.radiusAboutOrigin() >= radius * (1 - 1e-15));
    BOOST_TEST(model.radiusAboutOrigin() <= radius * (1 + 1e-12));
    BOOST_TEST_REQUIRE(model.components().size() == 2u);
    BOOST_TEST(model.components()[1].name == "right");
    BOOST_TEST(model.origin().scale == 2.5);
    BOOST_TEST(Model::build(box({1, 1, 1})).components().size() == 1u);
}

BOOST_AUTO_TEST_CASE(copies_share_an_id_and_builds_do_not) {
    const Mesh mesh = box({1, 2, 3});
    const Model first = Model::build(mesh), second = Model::build(mesh);
    const Model copy = first;
    BOOST_TEST(copy.id() == first.id());
    BOOST_TEST(&treeOf(copy) == &treeOf(first));
    BOOST_TEST(first.id() != second.id());
}

BOOST_DATA_TEST_CASE(the_report_tells_what_was_built, eachBuild(), build) {
    const Mesh once = torus(10, 3, 8);
    const Mesh mesh = joined(once, once);
    const Model model = Model::build(mesh, build);
    const BuildReport& report = model.report();
    BOOST_TEST(report.options.generalSplit == build.generalSplit);
    BOOST_TEST(report.options.leafSplit == build.leafSplit);
    BOOST_TEST(report.triangles == once.triangles.size());
    BOOST_TEST(report.clean.duplicateTriangles == once.triangles.size());
    BOOST_TEST(report.seconds >= 0.0);
    BOOST_TEST(report.tree.bytes > 0u);
    std::size_t leaves = 0, triangles = 0;
    for (std::size_t k = 0; k < report.tree.leavesBySize.size(); ++k) {
        leaves += report.tree.leavesBySize[k];
        triangles += k * report.tree.leavesBySize[k];
        if (k > static_cast<std::size_t>(build.leafSize)) BOOST_TEST(report.tree.leavesBySize[k] == 0u);
    }
    BOOST_TEST(leaves == report.tree.leaves);
    BOOST_TEST(triangles == report.triangles);
}

BOOST_AUTO_TEST_CASE(a_mesh_that_is_none_is_refused_by_what_is_wrong_with_it) {
    const Mesh good = box({1, 2, 3});
    checkRefused(Mesh{}, {}, {"triangle"});
    for (const double wrong :
         {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
        Mesh mesh = good;
        mesh.vertices[mesh.triangles[7][1]].y() = wrong;
        std::size_t first = 0;  // the first triangle that uses the vertex
        while (mesh.triangles[first][0] != mesh.triangles[7][1] &&
               mesh.triangles[first][1] != mesh.triangles[7][1] &&
               mesh.triangles[first][2] != mesh.triangles[7][1]) {
            ++first;
        }
        checkRefused(mesh, {}, {"triangle " + std::to_string(first), "finite"});
    }
    Mesh unusedWrong = good;
    unusedWrong.vertices.push_back(Vector3::Constant(std::numeric_limits<double>::quiet_NaN()));
    BOOST_TEST(Model::build(unusedWrong).report().clean.unusedVertices == 1u);
    Mesh outOfRange = good;
    outOfRange.triangles[3][2] = 9999;
    checkRefused(outOfRange, {}, {"triangle 3", "9999"});
    Mesh uncovered = good;
    uncovered.components = {{"only some", 0, 4}};
    checkRefused(uncovered, {}, {"component"});
}

BOOST_AUTO_TEST_CASE(wrong_options_are_refused_with_the_known_ones) {
    const Mesh mesh = box({1, 2, 3});
    BuildOptions options;
    options.generalSplit = "middle";
    checkRefused(mesh, options, {"middle", "mean", "axis"});
    options = {};
    options.leafSplit = "ring";
    checkRefused(mesh, options, {"ring", "none", "chain", "edge", "all", "cost"});
    for (const int size : {0, -1, 17}) {
        options = {};
        options.leafSize = size;
        checkRefused(mesh, options, {"leafSize", std::to_string(size), "16"});
    }
    options = {};
    options.nodeWidth = 4;
    checkRefused(mesh, options, {"nodeWidth", "4", "8"});
}

BOOST_AUTO_TEST_SUITE_END()
