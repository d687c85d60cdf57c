// Queries answer for the mesh's vertices, whether a leaf holds them in its floats, or refers to them in double, or both
// kinds stand in one tree.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "model/model_data.h"
#include "support/exact_check.h"
#include "support/random_meshes.h"
#include "tree/flat_tree.h"

namespace clearway::testing {
BOOST_AUTO_TEST_SUITE(exact_leaves_test)

constexpr std::uint64_t kSeed = 151;

Mesh ofFloats(Mesh mesh) {
    for (Vector3& vertex : mesh.vertices) vertex = vertex.cast<float>().cast<double>();
    return mesh;
}

/// Every second triangle is of floats.
Mesh ofBoth(const Mesh& mesh) {
    const Mesh floats = ofFloats(mesh);
    Mesh mixed;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const auto first = std::uint32_t(mixed.vertices.size());
        for (const std::uint32_t vertex : mesh.triangles[i])
            mixed.vertices.push_back((i % 2 == 0 ? floats : mesh).vertices[vertex]);
        mixed.triangles.push_back({first, first + 1, first + 2});
    }
    return mixed;
}

/// A scale and a place, far from the origin or not.
struct Place {
    double scale;
    Vector3 at;
};

struct Kind {
    const char* name;
    std::function<Mesh(const Mesh&)> make;
};

const Kind kKinds[] = {
    {"floats", ofFloats}, {"doubles", [](const Mesh& mesh) { return mesh; }}, {"both", ofBoth}};

/// One triangle a leaf: a leaf with a triangle of doubles is not exact.
BuildOptions small() {
    BuildOptions options;
    options.leafSize = 1;
    return options;
}

BOOST_AUTO_TEST_CASE(every_kind_of_leaf_answers_exactly_for_the_mesh) {
    Random random(kSeed);
    std::size_t exact = 0, others = 0, mixed = 0;
    for (const Place& place :
         {Place{1, {0, 0, 0}}, Place{1e-3, {0.02, -0.3, 5}}, Place{0x1p40, {0, 0x1p44, 0}}}) {
        for (const Kind& ofPart : kKinds) {
            for (const Kind& ofEnvironment : kKinds) {
                const auto placed = [&](const Mesh& mesh) {
                    return translated(scaledBy(mesh, place.scale), place.at);
                };
                const Mesh part = ofPart.make(placed(randomSoup(random, 15, 1, 0.5))),
                           environment = ofEnvironment.make(placed(randomSoup(random, 15, 1, 0.5)));
                // Turns the part about the meshes' place.
                const Pose there{Matrix3::Identity(), place.at};
                Pose turn = random.pose(random.below(2) == 0 ? 0.2 : 3);
                turn.translation *= place.scale;
                const std::string name = std::string(ofPart.name) + " and " + ofEnvironment.name +
                                         ", scale " + std::to_string(place.scale) + ", seed " +
                                         std::to_string(kSeed);
                const ExactCase exactly = exactCase(name, part, environment, there * turn * inverse(there));
                checkEveryBuild(exactly);
                const ModelPair models = buildPair(exactly, small());
                for (const Model* model : {&models.part, &models.environment}) {
                    std::size_t here = 0;
                    const std::vector<LeafReference> leaves = treeOf(*model).leaves();
                    for (const LeafReference at : leaves) here += treeOf(*model).leaf(at).isExact;
                    exact += here;
                    others += leaves.size() - here;
                    mixed += here > 0 && here < leaves.size();
                }
            }
        }
    }
    // The cases do what they are here for.
    BOOST_TEST(exact > 50u);
    BOOST_TEST(others > 50u);
    BOOST_TEST(mixed > 5u);
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::testing
