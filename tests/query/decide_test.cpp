// Pairs that double leaves open are decided exactly: the interval holds the truth and is as narrow as
// promised, and isWithin turns from false to true between the two doubles that enclose the distance.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>

#include "query/decide.h"
#include "support/each_target.h"
#include "support/exact_triangle.h"
#include "support/hard_triangles.h"
#include "support/query_cases.h"

BOOST_AUTO_TEST_SUITE(decide_test)

using namespace clearway;
using namespace clearway::testing;

namespace {

constexpr std::uint64_t kSeed = 97;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct Draw {
    std::string name;
    TrianglePair pair;
    Pose pose;
    Rational distanceSquared;
};

double diagonalOf(const Triangle& triangle) {
    Box box;
    for (const Vector3& corner : triangle) box.extend(corner);
    return box.diagonal().norm();
}

// Two triangles with coordinates of 46 digits, a corner of one on the other's face, edge or corner. The
// contact is exact and beyond twice a double's digits, because a height is a sum of products of three
// coordinates.
TrianglePair touchingOfManyDigits(Random& random) {
    const auto corner = [&] {
        const auto coordinate = [&] { return std::floor(random.uniform(-0x1p46, 0x1p46)); };
        return Vector3(4 * coordinate(), 4 * coordinate(), 4 * coordinate());
    };
    TrianglePair pair{{corner(), corner(), corner()}, {corner(), corner(), corner()}};
    const Vector3 onto = (pair.b[0] + pair.b[1] + 2 * pair.b[2]) / 4 - pair.a[0];
    for (Vector3& vertex : pair.a) vertex += onto;
    return pair;
}

// Every family, as drawn and moved.
const std::vector<Draw>& draws() {
    static const std::vector<Draw> drawn = [] {
        std::vector<Draw> result;
        Random random(kSeed);
        std::vector<TriangleFamily> families = hardTriangleFamilies();
        families.push_back({0, "touching, many digits", touchingOfManyDigits});
        for (const TriangleFamily& family : families) {
            if (family.name == "denormals") continue;  // their sizes differ too much for a query
            for (int i = 0; i < 8; ++i) {
                const TrianglePair pair = family.make(random);
                const Pose pose = i % 2 == 1 ? poseFor(random, pair) : Pose{};
                result.push_back(
                    {family.name + ", seed " + std::to_string(kSeed) + ", draw " + std::to_string(i), pair,
                     pose, exactDistanceSquared(exactlyMoved(pose, pair.a), toExact(pair.b))});
            }
        }
        return result;
    }();
    return drawn;
}

struct Models {
    explicit Models(const TrianglePair& pair)
        : part(Model::build(meshOf(pair.a))), environment(Model::build(meshOf(pair.b))) {}
    Model part, environment;
};

Rational square(double x) {
    return Rational(x) * Rational(x);
}

double largestOf(const Draw& draw) {
    double largest = draw.pose.translation.cwiseAbs().maxCoeff();
    for (int k = 0; k < 3; ++k) {
        largest =
            std::max({largest, draw.pair.a[k].cwiseAbs().maxCoeff(), draw.pair.b[k].cwiseAbs().maxCoeff(),
                      (draw.pose * draw.pair.a[k]).cwiseAbs().maxCoeff()});
    }
    return largest;
}

}  // namespace

BOOST_AUTO_TEST_CASE(intervals_hold_the_exact_distance_and_are_as_narrow_as_promised) {
    QueryCounters work;
    for (const Draw& draw : draws()) {
        const Models models(draw.pair);
        Workspace workspace;
        const DistanceResult result = distance(models.part, models.environment, draw.pose, {}, workspace);
        const double M = largestOf(draw),
                     width =
                         1e-12 * (diagonalOf(draw.pair.a) + diagonalOf(draw.pair.b)) + 32 * kUnitRoundoff * M;
        BOOST_TEST_CONTEXT(draw.name << ", distance " << rootOf(draw.distanceSquared) << ", interval "
                                     << result.lower << " to " << result.upper) {
            BOOST_TEST((square(result.lower) <= draw.distanceSquared));
            BOOST_TEST((square(result.upper) >= draw.distanceSquared));
            BOOST_TEST(result.upper - result.lower <= width);
            BOOST_TEST(result.collides() == (draw.distanceSquared == 0));
        }
        work += result.counters;
    }
    BOOST_TEST_MESSAGE(work.refinedPairs << " pairs, " << work.doubleDoublePairs << " in double-double, "
                                         << work.exactPairs << " exact");
    BOOST_TEST(work.doubleDoublePairs > 0u);
    BOOST_TEST(work.exactPairs > 0u);
    BOOST_TEST(work.exactPairs < work.doubleDoublePairs);
}

BOOST_AUTO_TEST_CASE(contact_points_lie_on_both_triangles) {
    for (const Draw& draw : draws()) {
        if (draw.distanceSquared != 0) continue;
        const Models models(draw.pair);
        Workspace workspace;
        const DistanceResult result = distance(models.part, models.environment, draw.pose, {}, workspace);
        BOOST_TEST(result.witness->pointOnPart == result.witness->pointOnEnvironment);
        const Triangle point = {result.witness->pointOnPart, result.witness->pointOnPart,
                                result.witness->pointOnPart};
        const Rational most = square(16 * kUnitRoundoff * largestOf(draw));
        BOOST_TEST_CONTEXT(draw.name) {
            BOOST_TEST((exactDistanceSquared(toExact(point), exactlyMoved(draw.pose, draw.pair.a)) <= most));
            BOOST_TEST((exactDistanceSquared(toExact(point), toExact(draw.pair.b)) <= most));
        }
    }
}

BOOST_DATA_TEST_CASE(within_turns_at_the_exact_distance, eachTarget(), target) {
    const UsingTarget using_(target);
    for (const Draw& draw : draws()) {
        const Models models(draw.pair);
        Workspace workspace;
        const double near = static_cast<double>(rootOf(draw.distanceSquared));
        double d = std::nextafter(std::nextafter(near, -kInfinity), -kInfinity);
        for (int step = 0; step < 5; ++step, d = std::nextafter(d, kInfinity)) {
            if (d < 0) continue;
            BOOST_TEST_CONTEXT(draw.name << ", distance " << near << ", step " << step) {
                BOOST_TEST(isWithin(models.part, models.environment, draw.pose, d, workspace) ==
                           (square(d) >= draw.distanceSquared));
            }
        }
        BOOST_TEST(collides(models.part, models.environment, draw.pose, workspace) ==
                   (draw.distanceSquared == 0));
    }
}

BOOST_AUTO_TEST_SUITE_END()
