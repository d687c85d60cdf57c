// The pairs of triangles within a band, and how a distance changes as the part moves.
#include <boost/test/data/test_case.hpp>
#include <boost/test/unit_test.hpp>
#include <map>
#include <set>

#include "clearway/model.h"
#include "clearway/query.h"
#include "support/each_target.h"
#include "support/oracle.h"
#include "support/random_meshes.h"

namespace clearway::testing {
BOOST_AUTO_TEST_SUITE(near_pairs_test)

using Ids = std::pair<std::int64_t, std::int64_t>;

BOOST_DATA_TEST_CASE(all_pairs_within_the_band_are_found, eachTarget(), target) {
    const UsingTarget use(target);
    Workspace workspace;
    Random random(3);
    int found = 0;
    for (const MeshPair& pair : meshPairs(1)) {
        if (pair.part.triangles.size() * pair.environment.triangles.size() > 60000) continue;
        const Model part = Model::build(pair.part), environment = Model::build(pair.environment);
        const MeshOracle oracle(pair.part, pair.environment);
        for (int n = 0; n < 3; ++n) {
            const Pose X = random.pose(1);
            const double band = oracle.distance(X).distance + 0.02 * n * oracle.sceneSize();
            std::set<Ids> ids;
            double last = 0;
            const std::vector<DistanceResult> near = nearPairs(part, environment, X, band, workspace);
            if (near.size() > kAllNearPairs) continue;
            for (const DistanceResult& each : near) {
                const Ids id{each.witness->partTriangle, each.witness->environmentTriangle};
                BOOST_REQUIRE(ids.insert(id).second);
                BOOST_REQUIRE(each.distance >= last);
                last = each.distance;
                const double truth = oracle.pairDistance(X, std::size_t(id.first), std::size_t(id.second));
                BOOST_REQUIRE(each.lower <= truth * (1 + 1e-15));
                BOOST_REQUIRE(each.upper >= truth * (1 - 1e-15));
                BOOST_REQUIRE(each.collides() == (truth == 0));
            }
            const double slack = 1e-11 * oracle.sceneSize();
            for (std::size_t i = 0; i < pair.part.triangles.size(); ++i) {
                for (std::size_t k = 0; k < pair.environment.triangles.size(); ++k) {
                    const double truth = oracle.pairDistance(X, i, k);
                    const bool isFound = ids.count({std::int64_t(i), std::int64_t(k)}) > 0;
                    if (truth < band - slack)
                        BOOST_REQUIRE_MESSAGE(isFound, pair.name << " " << i << " " << k);
                    if (truth > band + slack) BOOST_REQUIRE(!isFound);
                    found += isFound;
                }
            }
        }
    }
    BOOST_TEST(found > 1000);
}

BOOST_AUTO_TEST_CASE(many_pairs_are_thinned_and_the_nearest_is_kept) {
    Random random(4);
    const Mesh part = randomTerrain(random, 30, 1, 0.01), environment = randomTerrain(random, 30, 1, 0.01);
    const Model a = Model::build(part), b = Model::build(environment);
    Workspace workspace;
    Pose X;
    X.translation.z() = 0.1;
    const double least = distance(a, b, X, {}, workspace).distance;
    std::size_t before = 0;
    for (const double band : {0.105, 0.13, 0.3, 2.0}) {
        const std::vector<DistanceResult> near = nearPairs(a, b, X, band, workspace);
        BOOST_TEST_CONTEXT("band " << band << ", " << near.size() << " pairs") {
            BOOST_REQUIRE(!near.empty());
            BOOST_TEST(near[0].distance == least, boost::test_tools::tolerance(1e-12));
            BOOST_TEST(near[0].counters.triangleTests > 0);
            for (const DistanceResult& each : near) BOOST_REQUIRE(each.lower <= band);
            if (band >= 0.3) BOOST_TEST(near.size() <= part.triangles.size());
        }
        before = std::max(before, near.size());
    }
    BOOST_TEST(before > 500);
    BOOST_TEST(nearPairs(a, b, X, 0.5 * least, workspace).empty());
    BOOST_CHECK_THROW(nearPairs(a, b, X, -1, workspace), std::invalid_argument);
}

/// At ties the pair that comes closest decides: the derivative is the least over the pairs that are equally near.
BOOST_AUTO_TEST_CASE(gradients_agree_with_finite_differences) {
    Random random(5);
    Workspace workspace;
    int checked = 0;
    for (const MeshPair& pair : meshPairs(2)) {
        const Model part = Model::build(pair.part), environment = Model::build(pair.environment);
        const double size = part.box().diagonal().norm();
        for (int n = 0; n < 40; ++n) {
            const Pose X = random.pose(2);
            const double here = distance(part, environment, X, {}, workspace).distance;
            if (here < 0.02 * size) continue;
            const double step = 1e-5 * here;
            const Vector3 v = random.direction(), w = random.direction() / size;
            Pose moved = X;
            moved.rotation =
                Eigen::AngleAxisd(step * w.norm(), w.normalized()).toRotationMatrix() * X.rotation;
            moved.translation += step * v;
            const double measured =
                (distance(part, environment, moved, {}, workspace).distance - here) / step;
            double expected = std::numeric_limits<double>::infinity();
            for (const DistanceResult& each : nearPairs(part, environment, X, here + 3 * step, workspace)) {
                const auto gradient = distanceGradient(each, X.translation);
                BOOST_REQUIRE(gradient);
                expected = std::min(expected, (each.distance - here) / step + gradient->translation.dot(v) +
                                                  gradient->rotation.dot(w));
            }
            BOOST_TEST_CONTEXT(pair.name << " " << n)
            BOOST_REQUIRE_SMALL(measured - expected, 2e-3);
            ++checked;
        }
    }
    BOOST_TEST(checked > 30);
    DistanceResult contact;
    contact.witness.emplace();
    BOOST_TEST(!distanceGradient(contact, {}));
    BOOST_TEST(!distanceGradient(DistanceResult(), {}));
}

/// Along two faces the pairs of neighbouring triangles are slanted; a step over an edge leads to the pair that is not.
BOOST_AUTO_TEST_CASE(local_minima_are_among_all_pairs_and_stand_square_to_the_faces) {
    Random random(6);
    Workspace workspace;
    for (int n = 0; n < 20; ++n) {
        const Model part = Model::build(box(Vector3(1, 2, 3), 3));
        const Model environment =
            Model::build(translated(box(Vector3(3, 3, 3), 4), {4.01, random.uniform(-0.3, 0.3), 0.1}));
        const std::vector<DistanceResult> all = nearPairs(part, environment, {}, 0.1, workspace);
        const std::vector<DistanceResult> least =
            nearPairs(part, environment, {}, 0.1, workspace, NearPairs::kLocalMinima);
        std::set<Ids> ids;
        for (const DistanceResult& each : all)
            ids.insert({each.witness->partTriangle, each.witness->environmentTriangle});
        BOOST_TEST(!least.empty());
        BOOST_TEST(least.size() < all.size());
        BOOST_TEST(least[0].distance == all[0].distance);
        for (const DistanceResult& each : least) {
            BOOST_TEST(ids.count({each.witness->partTriangle, each.witness->environmentTriangle}) == 1u);
            BOOST_TEST(std::abs(distanceGradient(each, Vector3::Zero())->translation.x()) > 0.999);
        }
    }
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::testing
