#include "build/leaf_order.h"

#include <boost/test/unit_test.hpp>
#include <numeric>
#include <set>

#include "build/sample_meshes.h"

namespace clearway::testing {
BOOST_AUTO_TEST_SUITE(leaf_order_test)

using Point = std::array<double, 3>;

BOOST_AUTO_TEST_CASE(each_run_has_its_vertices_and_a_short_one_has_each_once) {
    constexpr std::uint64_t kSeed = 95;
    BOOST_TEST_CONTEXT("seed " << kSeed) {
        Random random(kSeed);
        const CleanMesh mesh = cleanMeshOf(bentSheet(20, 9));
        std::vector<std::uint32_t> order(mesh.triangles.size());
        std::iota(order.begin(), order.end(), 0u);
        for (std::size_t i = order.size(); i-- > 1;) std::swap(order[i], order[random.below(int(i) + 1)]);
        const LeafOrder leafOrder(mesh, order);
        PointArrays points;
        for (int round = 0; round < 500; ++round) {
            const int first = random.below(int(order.size()));
            const int count = 1 + random.below(int(order.size()) - first);
            std::set<Point> expected;
            std::set<std::uint32_t> vertices;
            for (int i = first; i < first + count; ++i) {
                for (int k = 0; k < 3; ++k) {
                    const std::uint32_t vertex = mesh.triangles[order[i]][k];
                    const Vector3& p = mesh.vertices[vertex];
                    BOOST_REQUIRE(leafOrder.vertex(leafOrder.triangles()[i][k]) == p);
                    if (vertices.insert(vertex).second) expected.insert({p.x(), p.y(), p.z()});
                }
            }
            const std::size_t found =
                leafOrder.gatherVertices(std::uint32_t(first), std::uint32_t(count), points);
            std::multiset<Point> gathered;
            for (std::size_t i = 0; i < found; ++i)
                gathered.insert({points[0].data()[i], points[1].data()[i], points[2].data()[i]});
            BOOST_REQUIRE((std::set<Point>(gathered.begin(), gathered.end()) == expected));
            if (count <= 8) BOOST_REQUIRE(gathered.size() == expected.size());
        }
    }
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::testing
