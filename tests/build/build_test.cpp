#include "build/build.h"
#include "build/flatten.h"

#include <algorithm>
#include <boost/test/data/monomorphic.hpp>
#include <boost/test/data/test_case.hpp>
#include <boost/test/unit_test.hpp>
#include <cstring>

#include "build/check_tree.h"
#include "build/sample_meshes.h"
#include "build/top_down.h"
#include "support/each_target.h"
#include "support/full_run.h"

namespace clearway::testing {
BOOST_AUTO_TEST_SUITE(build_test)

namespace data = boost::unit_test::data;

const std::vector<int> kLeafSizes = isFullRun() ? std::vector<int>{1, 2, 4, 8, 16} : std::vector<int>{1, 16};

FlatTree build(const CleanMesh& mesh, const BuildOptions& options) {
    return buildTree(mesh, options);
}

const auto eachGeneralSplit = data::make(generalSplitNames());
const auto eachFit = data::make(fitNames());
const auto eachLeafSplit = data::make(leafSplitNames());
const auto eachLeafSize = data::make(kLeafSizes);
const auto eachNodeWidth = data::make(nodeWidths());

BOOST_DATA_TEST_CASE(every_volume_holds_what_is_below_it_and_every_triangle_comes_once,
                     eachGeneralSplit* eachLeafSplit* eachLeafSize* eachNodeWidth, general, leaf, leafSize,
                     width) {
    const BuildOptions options{general, leaf, leafSize, width};
    for (const auto& triangles :
         {soup(isFullRun() ? 700 : 300, 11), bentSheet(40, 9), transformed(soup(90, 12), 1e-3, {5, -7, 1})}) {
        const CleanMesh mesh = cleanMeshOf(triangles);
        const FlatTree tree = build(mesh, options);
        checkTree(tree, mesh);
        for (const LeafReference at : tree.leaves()) {
            const int most = leaf == "all" ? 1 : leaf == "cost" ? std::min(leafSize, 4) : leafSize;
            BOOST_REQUIRE(tree.leaf(at).triangleCount <= static_cast<unsigned>(most));
        }
    }
}

BOOST_DATA_TEST_CASE(degenerate_meshes_build, eachGeneralSplit* eachLeafSplit* eachFit* eachNodeWidth,
                     general, leaf, fit, width) {
    for (const SampleMesh& sample : degenerateMeshes()) {
        BOOST_TEST_CONTEXT(sample.name) {
            for (const int leafSize : {1, 4}) {
                checkTree(build(sample.mesh, {general, leaf, leafSize, width, fit}), sample.mesh);
            }
        }
    }
}

template <class Values>
bool sameBytes(const Values& a, const Values& b) {
    return a.size() == b.size() &&
           (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(a[0])) == 0);
}

void checkSameTree(const FlatTree& first, const FlatTree& second) {
    BOOST_TEST(sameBytes(first.nodes<2>(), second.nodes<2>()));
    BOOST_TEST(sameBytes(first.nodes<8>(), second.nodes<8>()));
    BOOST_TEST(sameBytes(first.leafBlocks, second.leafBlocks));
    BOOST_TEST(sameBytes(first.vertices, second.vertices));
}

BOOST_DATA_TEST_CASE(building_again_gives_the_same_tree, eachGeneralSplit* eachLeafSplit* eachNodeWidth,
                     general, leaf, width) {
    const CleanMesh mesh = cleanMeshOf(soup(500, 21));
    const BuildOptions options{general, leaf, 4, width};
    checkSameTree(build(mesh, options), build(mesh, options));
}

BOOST_DATA_TEST_CASE(the_tree_does_not_depend_on_the_number_of_threads, eachGeneralSplit* eachFit, general,
                     fit) {
    const CleanMesh mesh = cleanMeshOf(bentSheet(300, 60));  // enough for many tasks
    BOOST_TEST_REQUIRE(mesh.triangles.size() > 4 * kTaskTriangles);
    for (const char* leaf : {"none", "cost"}) {
        const FlatTree alone = build(mesh, {general, leaf, 4, 8, fit, 1});
        for (const int threads : isFullRun() ? std::vector<int>{2, 3, 0} : std::vector<int>{3}) {
            BOOST_TEST_CONTEXT(leaf << ", " << threads << " threads") {
                checkSameTree(alone, build(mesh, {general, leaf, 4, 8, fit, threads}));
            }
        }
    }
}

BOOST_DATA_TEST_CASE(the_tree_does_not_depend_on_the_instruction_set, eachGeneralSplit* eachFit, general,
                     fit) {
    for (const CleanMesh& mesh : {cleanMeshOf(bentSheet(60, 40)), cleanMeshOf(soup(900, 23))}) {
        for (const char* leaf : {"none", "cost"}) {
            const FlatTree best = build(mesh, {general, leaf, 4, 8, fit, 1});
            for (const std::string& target : availableTargets()) {
                const UsingTarget thatTarget(target);
                BOOST_TEST_CONTEXT(target) {
                    checkSameTree(best, build(mesh, {general, leaf, 4, 8, fit, 1}));
                }
            }
        }
    }
}

/// Depth of the binary tree, in nodes.
int depthOf(const BinaryTree& tree) {
    std::vector<int> depths(tree.nodes.size(), 1);
    int deepest = 1;
    for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
        deepest = std::max(deepest, depths[i]);
        if (tree.nodes[i].isLeaf()) continue;
        depths[tree.nodes[i].left] = depths[tree.nodes[i].right] = depths[i] + 1;
    }
    return deepest;
}

BOOST_DATA_TEST_CASE(no_input_makes_a_tree_that_is_too_deep, eachGeneralSplit, general) {
    // Each triangle lies four times as far out as the one before: a plane through the mean cuts off one or
    // two at a time.
    std::vector<Corners> triangles;
    for (int i = -250; i < 250; ++i) {
        const double size = std::ldexp(1.0, 2 * i);
        triangles.push_back({size * Vector3(1, 0, 0), size * Vector3(1.1, 0, 0), size * Vector3(1, 0.1, 0)});
    }
    const CleanMesh mesh = cleanMeshOf(triangles);
    const BinaryTree tree = buildBinaryTree(mesh, {general, "none", 1, 8});
    if (general == "mean") BOOST_TEST(depthOf(tree) > kDeepestSplit);  // the input does what it is here for
    BOOST_TEST(depthOf(tree) <= kDeepestSplit + 1 + 9);                // the root, then halves of at most 500
    checkTree(flatten(tree, mesh, 8), mesh);
}

BOOST_AUTO_TEST_CASE(one_triangle_is_a_root_volume_over_one_leaf) {
    const CleanMesh mesh = cleanMeshOf({{Vector3::UnitX(), Vector3::UnitY(), Vector3::UnitZ()}});
    const FlatTree tree = build(mesh, {});
    BOOST_TEST(tree.nodes<8>().size() == 1u);
    BOOST_TEST(tree.nodes<8>()[0].child[0] == ~0);
    BOOST_TEST(tree.triangleId({0, 0}) == 7u);
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::testing
