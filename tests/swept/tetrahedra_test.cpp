#include "swept/tetrahedra.h"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <map>

#include "mesh/topology.h"
#include "support/random_meshes.h"
#include "support/winding.h"
#include "swept/cut_surface.h"

namespace clearway::testing {
BOOST_AUTO_TEST_SUITE(tetrahedra_test)

double volumeOf(const Tetrahedra& tetrahedra, const Tetrahedron& t) {
    const auto& v = tetrahedra.vertices();
    const Vector3& base = v[t.corners[0]];
    return std::abs((v[t.corners[1]] - base).cross(v[t.corners[2]] - base).dot(v[t.corners[3]] - base)) / 6;
}

double volumeOf(const Tetrahedra& tetrahedra) {
    double sum = 0;
    for (const Tetrahedron& t : tetrahedra.all()) sum += volumeOf(tetrahedra, t);
    return sum;
}

/// Bisects those around a point, the smaller the nearer, without care for neighbours.
void refineAround(Tetrahedra& tetrahedra, const Vector3& point, double least) {
    for (std::size_t i = 0; i < tetrahedra.all().size(); ++i) {
        for (;;) {
            const auto& c = tetrahedra.all()[i].corners;
            const auto& v = tetrahedra.vertices();
            const double size = (v[c[0]] - v[c[3]]).norm();
            if (size < least || size < 0.5 * (v[c[0]] - point).norm()) break;
            tetrahedra.bisect(i);
        }
    }
}

BOOST_AUTO_TEST_CASE(bisection_always_halves_the_one_longest_edge) {
    Tetrahedra tetrahedra(Box(Vector3(-1, -2, -3), Vector3(4, 5, 6)));
    Random random(1);
    for (int n = 0; n < 3000; ++n) {
        const std::size_t i = static_cast<std::size_t>(random.below(int(tetrahedra.all().size())));
        const Tetrahedron t = tetrahedra.all()[i];
        const auto& v = tetrahedra.vertices();
        const double halved = (v[t.corners[t.tag]] - v[t.corners[0]]).norm();
        for (int j = 0; j < 4; ++j) {
            for (int k = j + 1; k < 4; ++k) {
                const bool isHalved = j == 0 && k == t.tag;
                const double length = (v[t.corners[j]] - v[t.corners[k]]).norm();
                if (!isHalved) BOOST_REQUIRE(length < halved * (1 - 1e-3));
            }
        }
        tetrahedra.bisect(i);
    }
}

Tetrahedra refinedTetrahedra() {
    Tetrahedra tetrahedra(Box(Vector3(-1, -2, -3), Vector3(4, 5, 6)));
    refineAround(tetrahedra, {0.3, 0.4, 0.5}, 0.05);
    refineAround(tetrahedra, {2.3, -1.4, 2.5}, 0.1);
    return tetrahedra;
}

BOOST_AUTO_TEST_CASE(tetrahedra_fill_the_box_and_agree_about_the_pieces_of_their_surfaces) {
    const Tetrahedra tetrahedra = refinedTetrahedra();
    const auto& v = tetrahedra.vertices();
    Box all;
    for (const Vector3& vertex : v) all.extend(vertex);
    BOOST_TEST(volumeOf(tetrahedra) == all.volume(), boost::test_tools::tolerance(1e-12));
    std::map<TriangleIndices, int> pieces;  // from the least vertex on, counter-clockwise
    std::size_t withOthers = 0;
    for (const Tetrahedron& t : tetrahedra.all()) {
        withOthers += !tetrahedra.verticesOn(t).empty();
        BOOST_REQUIRE(tetrahedra.hasWholeEdges(t) == tetrahedra.verticesOn(t).empty());
        tetrahedra.eachPiece(t, [&](TriangleIndices piece) {
            std::rotate(piece.begin(), std::min_element(piece.begin(), piece.end()), piece.end());
            BOOST_REQUIRE(++pieces[piece] == 1);
        });
    }
    BOOST_TEST(withOthers > 1000u);
    std::size_t lone = 0;
    for (const auto& [piece, count] : pieces) {
        if (pieces.count({piece[0], piece[2], piece[1]}) == 1) continue;  // a neighbour's
        ++lone;
        bool isBorder = false;
        for (int axis = 0; axis < 3; ++axis) {
            for (const double end : {all.min()[axis], all.max()[axis]}) {
                isBorder = isBorder ||
                           (v[piece[0]][axis] == end && v[piece[1]][axis] == end && v[piece[2]][axis] == end);
            }
        }
        BOOST_REQUIRE(isBorder);
    }
    BOOST_TEST(lone > 0u);
}

BOOST_AUTO_TEST_CASE(the_surface_through_tetrahedra_of_many_sizes_is_closed_and_separates_their_vertices) {
    const Tetrahedra tetrahedra = refinedTetrahedra();
    Random random(5);
    std::vector<double> ball, noise;
    for (const Vector3& v : tetrahedra.vertices()) {
        ball.push_back(2 - (v - Vector3(1, 1, 1)).norm());
        const bool isBorder = (v - Vector3(1.5, 1.5, 1.5)).cwiseAbs().maxCoeff() > 4;
        noise.push_back(isBorder ? -1 : random.uniform(-1, 1));
    }
    for (const std::vector<double>& heights : {ball, noise}) {
        const CutSurface cut = cutSurface(tetrahedra, heights);
        const EdgeReport edges = checkEdges(cut.mesh.triangles);
        BOOST_TEST(edges.isClosed());
        BOOST_TEST(edges.touchingEdges == 0u);
        BOOST_TEST(edges.closedEdges > 1000u);
        const Component whole{"", 0, static_cast<std::uint32_t>(cut.mesh.triangles.size())};
        for (std::size_t i = 0; i < heights.size(); i += 97) {
            const double winding = windingBySolidAngles(cut.mesh, whole, tetrahedra.vertices()[i]);
            BOOST_TEST((winding > 0.5) == (heights[i] >= 0), i << " " << heights[i] << " " << winding);
        }
    }
}

BOOST_AUTO_TEST_CASE(halves_keep_what_is_true_of_all_points) {
    Tetrahedra tetrahedra(Box(Vector3(0, 0, 0), Vector3(1, 1, 1)));
    tetrahedra.all()[7].isShallow = true;
    tetrahedra.bisect(7);
    BOOST_TEST(tetrahedra.all()[7].isShallow);
    BOOST_TEST(tetrahedra.all().back().isShallow);
    tetrahedra.bisect(8);
    BOOST_TEST(!tetrahedra.all()[8].isShallow);
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::testing
