#include "support/exact_check.h"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>

#include "clearway/targets.h"
#include "support/each_target.h"
#include "support/triangle_distance.h"

namespace clearway::testing {
namespace {

constexpr double kUnbounded = std::numeric_limits<double>::infinity();

/// The least denormal: results among denormal numbers round by it.
constexpr double kLeast = std::numeric_limits<double>::denorm_min();

/// Share of the largest coordinate, far above the error of long double: a pair whose distance exceeds the
/// least one by more is certainly not the closest.
constexpr long double kSurelyFarther = 1e-14L;

double largestOf(const Mesh& part, const Mesh& environment, const Pose& pose) {
    double largest = pose.translation.cwiseAbs().maxCoeff();
    for (const Vector3& vertex : part.vertices) {
        largest = std::max({largest, vertex.cwiseAbs().maxCoeff(), (pose * vertex).cwiseAbs().maxCoeff()});
    }
    for (const Vector3& vertex : environment.vertices)
        largest = std::max(largest, vertex.cwiseAbs().maxCoeff());
    return largest;
}

double diagonalOf(const Mesh& mesh) {
    Box box;
    for (const Vector3& vertex : mesh.vertices) box.extend(vertex);
    return box.sizes().stableNorm();
}

void checkWitnesses(const ExactCase& exact, const DistanceResult& result) {
    BOOST_TEST_REQUIRE(result.witness.has_value());
    BOOST_TEST_REQUIRE(result.witness->partTriangle >= 0);
    BOOST_TEST_REQUIRE(result.witness->environmentTriangle >= 0);
    const auto a = cornersOf(exact.part, static_cast<std::size_t>(result.witness->partTriangle)),
               b = cornersOf(exact.environment,
                             static_cast<std::size_t>(result.witness->environmentTriangle));
    const Vector3 &p = result.witness->pointOnPart, &q = result.witness->pointOnEnvironment;
    const double rounding = kUnitRoundoff * exact.largestCoordinate + kLeast;
    const double off = (exact.truth.isZero() ? 16 : 8) * rounding;
    BOOST_TEST(exactDistance(exact.pose, a, {p, p, p}).compare(off) <= 0);
    BOOST_TEST(exactDistance(Pose{}, {q, q, q}, b).compare(off) <= 0);
    const ExactDistance apart = exactDistance(Pose{}, {p, p, p}, {q, q, q});
    const double lengthOff = 4 * kUnitRoundoff * result.distance + 2 * kLeast;
    BOOST_TEST(apart.compare(result.distance + lengthOff) <= 0);
    BOOST_TEST(apart.compare(std::max(0.0, result.distance - lengthOff)) >= 0);
    BOOST_TEST(result.distance >= result.lower - 16 * rounding);
    BOOST_TEST(result.distance <= result.upper);
    BOOST_TEST(result.upper <= result.distance + 16 * rounding);
    if (exact.truth.isZero()) BOOST_TEST(p == q);
}

void checkVerdicts(const ExactCase& exact, const ModelPair& models, const DistanceResult& result,
                   Workspace& workspace) {
    const auto within = [&](double d) {
        return isWithin(models.part, models.environment, exact.pose, d, workspace);
    };
    const bool touches = exact.truth.isZero();
    BOOST_TEST(result.collides() == touches);
    BOOST_TEST(collides(models.part, models.environment, exact.pose, workspace) == touches);
    BOOST_TEST(within(0) == touches);
    const Enclosing around = enclosing(exact.truth);
    BOOST_TEST(within(around.above));
    if (around.below >= 0) BOOST_TEST(!within(around.below));
    BOOST_TEST(within(result.upper));
    if (result.lower > 0) BOOST_TEST(!within(std::nextafter(result.lower, 0.0)));
}

}  // namespace

ExactDistance exactMeshDistance(const Mesh& part, const Mesh& environment, const Pose& X_environmentPart) {
    std::vector<LongTriangle> parts, environments;
    for (std::size_t i = 0; i < part.triangles.size(); ++i)
        parts.push_back(moved(X_environmentPart, cornersOf(part, i)));
    for (std::size_t j = 0; j < environment.triangles.size(); ++j)
        environments.push_back(toLong(cornersOf(environment, j)));

    const std::size_t columns = environments.size();
    std::vector<long double> distances;
    for (const LongTriangle& a : parts) {
        for (const LongTriangle& b : environments) distances.push_back(triangleDistance(a, b).distance);
    }
    const long double near = *std::min_element(distances.begin(), distances.end()) +
                             kSurelyFarther * largestOf(part, environment, X_environmentPart);
    ExactDistance least;
    bool found = false;
    for (std::size_t k = 0; k < distances.size(); ++k) {
        if (distances[k] > near) continue;
        const ExactDistance distance = exactDistance(X_environmentPart, cornersOf(part, k / columns),
                                                     cornersOf(environment, k % columns));
        if (!found || distance.compare(least) < 0) least = distance;
        found = true;
        if (least.isZero()) break;
    }
    return least;
}

ExactCase exactCase(const std::string& name, const Mesh& part, const Mesh& environment, const Pose& pose) {
    return {name,
            part,
            environment,
            pose,
            exactMeshDistance(part, environment, pose),
            largestOf(part, environment, pose),
            diagonalOf(part) + diagonalOf(environment)};
}

Enclosing enclosing(const ExactDistance& distance) {
    double above = static_cast<double>(distance.rounded());
    while (distance.compare(above) > 0) above = std::nextafter(above, kUnbounded);
    double below = std::nextafter(above, -kUnbounded);
    while (below >= 0 && distance.compare(below) <= 0) {
        above = below;
        below = std::nextafter(below, -kUnbounded);
    }
    return {below, above};
}

ModelPair buildPair(const ExactCase& exact, const BuildOptions& options) {
    return {Model::build(exact.part, options), Model::build(exact.environment, options)};
}

DistanceResult checkExactly(const ExactCase& exact, const ModelPair& models, Workspace& workspace) {
    const DistanceResult result = distance(models.part, models.environment, exact.pose, {}, workspace);
    BOOST_TEST_CONTEXT(exact.name << ", distance " << exact.truth.rounded() << ", interval " << result.lower
                                  << " to " << result.upper) {
        BOOST_TEST(exact.truth.compare(result.lower) >= 0);
        BOOST_TEST(exact.truth.compare(result.upper) <= 0);
        BOOST_TEST(result.upper - result.lower <=
                   1e-12 * exact.sceneSize + 32 * kUnitRoundoff * exact.largestCoordinate + 2 * kLeast);
        checkWitnesses(exact, result);
        checkVerdicts(exact, models, result, workspace);
    }
    return result;
}

void checkEveryBuild(const ExactCase& exact) {
    for (const int width : nodeWidths()) {
        for (const std::string& leaf : leafSplitNames()) {
            const BuildChoice build = buildChoice("sah", leaf, 4, width);
            const ModelPair models = buildPair(exact, build);
            for (const std::string& target : availableTargets()) {
                const UsingTarget using_(target);
                Workspace workspace;
                BOOST_TEST_CONTEXT(target << ", " << build) {
                    checkExactly(exact, models, workspace);
                }
            }
        }
    }
}

}  // namespace clearway::testing
