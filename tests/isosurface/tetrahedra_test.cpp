#include "isosurface/tetrahedra.h"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <map>

#include "support/random_meshes.h"

namespace clearway::testing {
namespace {

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

BOOST_AUTO_TEST_CASE(conforming_tetrahedra_fill_the_box_and_share_whole_faces) {
    const Box box(Vector3(-1, -2, -3), Vector3(4, 5, 6));
    Tetrahedra tetrahedra(box);
    const double before = volumeOf(tetrahedra);
    BOOST_TEST(before > box.volume());
    refineAround(tetrahedra, {0.3, 0.4, 0.5}, 0.05);
    tetrahedra.makeConforming();
    refineAround(tetrahedra, {2.3, -1.4, 2.5}, 0.1);
    tetrahedra.makeConforming();
    BOOST_TEST(volumeOf(tetrahedra) == before, boost::test_tools::tolerance(1e-12));
    std::map<std::array<std::uint32_t, 3>, int> faces;
    for (const Tetrahedron& t : tetrahedra.all()) {
        for (int left = 0; left < 4; ++left) {
            std::array<std::uint32_t, 3> face;
            for (int k = 0, at = 0; k < 4; ++k) {
                if (k != left) face[at++] = t.corners[k];
            }
            std::sort(face.begin(), face.end());
            ++faces[face];
        }
    }
    Box all;
    for (const Vector3& v : tetrahedra.vertices()) all.extend(v);
    for (const auto& [face, count] : faces) {
        BOOST_REQUIRE(count <= 2);
        if (count == 2) continue;
        const auto& v = tetrahedra.vertices();  // one tetrahedron alone: a face of the whole
        bool isBorder = false;
        for (int axis = 0; axis < 3; ++axis) {
            for (const double end : {all.min()[axis], all.max()[axis]}) {
                isBorder = isBorder ||
                           (v[face[0]][axis] == end && v[face[1]][axis] == end && v[face[2]][axis] == end);
            }
        }
        BOOST_REQUIRE(isBorder);
    }
}

BOOST_AUTO_TEST_CASE(halves_keep_what_is_true_of_all_points) {
    Tetrahedra tetrahedra(Box(Vector3(0, 0, 0), Vector3(1, 1, 1)));
    tetrahedra.all()[7].isShallow = tetrahedra.all()[7].isDone = true;
    tetrahedra.bisect(7);
    BOOST_TEST(tetrahedra.all()[7].isShallow);
    BOOST_TEST(tetrahedra.all().back().isShallow);
    tetrahedra.bisect(8);
    BOOST_TEST(!tetrahedra.all()[8].isShallow);
}

}  // namespace
}  // namespace clearway::testing
