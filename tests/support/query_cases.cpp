#include "support/query_cases.h"

#include <algorithm>
#include <boost/test/unit_test.hpp>

#include "support/triangle_distance.h"

namespace clearway::testing {
namespace {

constexpr std::uint64_t kSeed = 20130401;

// Far and colliding poses at random, then some at a chosen gap: wide, near, and within rounding of contact.
std::vector<Pose> casePoses(Random& random, const MeshOracle& oracle) {
    const double size = oracle.sceneSize();
    std::vector<Pose> poses;
    for (int i = 0; i < 6; ++i) poses.push_back(random.pose(0.12 * size * (1 + i % 3)));
    const auto distanceAt = [&](const Pose& pose) { return oracle.distance(pose).distance; };
    for (const double gap : {1e-2, 1e-4, 1e-7, 1e-11}) {
        poses.push_back(
            poseAtGap(random.pose(0.05 * size), random.direction(), 2 * size, gap * size, distanceAt));
    }
    return poses;
}

LongTriangle partTriangle(const QueryCase& queryCase, const Pose& pose, std::int64_t id) {
    return moved(pose, cornersOf(queryCase.part, static_cast<std::size_t>(id)));
}

double distanceToTriangle(const Vector3& point, const LongTriangle& triangle) {
    const LongVector p = point.cast<long double>();
    return static_cast<double>((closestOnTriangle(p, triangle) - p).norm());
}

void checkWitnesses(const DistanceResult& result, const QueryCase& queryCase, const Pose& pose) {
    const double rounding = kUnitRoundoff * largestCoordinate(queryCase, pose);
    BOOST_TEST_REQUIRE(result.witness.has_value());
    BOOST_TEST_REQUIRE(result.witness->partTriangle >= 0);
    BOOST_TEST_REQUIRE(result.witness->environmentTriangle >= 0);
    BOOST_TEST_REQUIRE(result.witness->partTriangle <
                       static_cast<std::int64_t>(queryCase.part.triangles.size()));
    BOOST_TEST_REQUIRE(result.witness->environmentTriangle <
                       static_cast<std::int64_t>(queryCase.environment.triangles.size()));
    const double reach = result.collides() ? 16 * rounding : 8 * rounding;
    const LongTriangle onEnvironment = toLong(
        cornersOf(queryCase.environment, static_cast<std::size_t>(result.witness->environmentTriangle)));
    BOOST_TEST(distanceToTriangle(result.witness->pointOnPart,
                                  partTriangle(queryCase, pose, result.witness->partTriangle)) <= reach);
    BOOST_TEST(distanceToTriangle(result.witness->pointOnEnvironment, onEnvironment) <= reach);
    const double apart = (result.witness->pointOnPart - result.witness->pointOnEnvironment).norm();
    BOOST_TEST(std::abs(apart - result.distance) <= 4 * rounding);
    if (result.collides()) BOOST_TEST(apart == 0.0);
    BOOST_TEST(result.witness->partComponent == 0);
    BOOST_TEST(result.witness->environmentComponent == 0);
}

}  // namespace

const std::vector<QueryCase>& queryCases() {
    static const std::vector<QueryCase> cases = [] {
        std::vector<QueryCase> result;
        Random random(kSeed);
        for (const MeshPair& pair : meshPairs(kSeed)) {
            const MeshOracle oracle(pair.part, pair.environment);
            result.push_back(makeCase(pair.name + ", seed " + std::to_string(kSeed), pair.part,
                                      pair.environment, casePoses(random, oracle)));
        }
        return result;
    }();
    return cases;
}

QueryCase makeCase(const std::string& name, const Mesh& part, const Mesh& environment,
                   const std::vector<Pose>& poses) {
    QueryCase result{name, part, environment, std::make_shared<MeshOracle>(part, environment), poses, {}};
    for (const Pose& pose : poses) result.answers.push_back(result.oracle->distance(pose));
    return result;
}

ModelPair buildPair(const QueryCase& queryCase, const BuildOptions& options) {
    return {Model::build(queryCase.part, options), Model::build(queryCase.environment, options)};
}

double largestCoordinate(const QueryCase& queryCase, const Pose& pose) {
    double largest = pose.translation.cwiseAbs().maxCoeff();
    for (const Vector3& vertex : queryCase.part.vertices) {
        largest = std::max({largest, vertex.cwiseAbs().maxCoeff(), (pose * vertex).cwiseAbs().maxCoeff()});
    }
    for (const Vector3& vertex : queryCase.environment.vertices) {
        largest = std::max(largest, vertex.cwiseAbs().maxCoeff());
    }
    return largest;
}

double widestDefault(const QueryCase& queryCase, const Pose& pose) {
    return 1e-12 * queryCase.oracle->sceneSize() + 32 * kUnitRoundoff * largestCoordinate(queryCase, pose);
}

void checkDistance(const DistanceResult& result, const QueryCase& queryCase, const Pose& pose,
                   const OracleAnswer& truth, double width) {
    const double accuracy = widestDefault(queryCase, pose);
    const double rounding = 16 * kUnitRoundoff * largestCoordinate(queryCase, pose);
    if (width < 0) width = accuracy;
    BOOST_TEST(result.lower <= truth.distance);
    if (!result.collides()) BOOST_TEST(truth.distance <= result.upper);
    BOOST_TEST(result.upper - result.lower <= width);
    BOOST_TEST(std::abs(result.distance - truth.distance) <= std::max(width, accuracy));
    BOOST_TEST(result.lower - rounding <= result.distance);
    BOOST_TEST(result.distance <= result.upper);
    BOOST_TEST(result.upper <= result.distance + rounding);
    if (result.collides()) {
        BOOST_TEST(result.lower == 0.0);
        BOOST_TEST(result.distance == 0.0);
    }
    checkWitnesses(result, queryCase, pose);
    const double ofPair =
        queryCase.oracle->pairDistance(pose, static_cast<std::size_t>(result.witness->partTriangle),
                                       static_cast<std::size_t>(result.witness->environmentTriangle));
    BOOST_TEST(std::abs(ofPair - result.distance) <= accuracy);
}

}  // namespace clearway::testing
