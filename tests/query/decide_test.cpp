// Pairs that double leaves open are decided exactly: the interval holds the truth and is as narrow as
// promised, and isWithin turns from false to true between the two doubles that enclose the distance.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>

#include "query/decide.h"
#include "support/each_target.h"
#include "support/exact_distance.h"
#include "support/hard_triangles.h"
#include "support/query_cases.h"

BOOST_AUTO_TEST_SUITE(decide_test)

using namespace clearway;
using namespace clearway::testing;

constexpr std::uint64_t kSeed = 97;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct Draw {
    std::string name;
    TrianglePair pair;
    Pose pose;
    ExactDistance truth;
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
                     pose, exactDistance(pose, pair.a, pair.b)});
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

double largestOf(const Draw& draw) {
    double largest = draw.pose.translation.cwiseAbs().maxCoeff();
    for (int k = 0; k < 3; ++k) {
        largest =
            std::max({largest, draw.pair.a[k].cwiseAbs().maxCoeff(), draw.pair.b[k].cwiseAbs().maxCoeff(),
                      (draw.pose * draw.pair.a[k]).cwiseAbs().maxCoeff()});
    }
    return largest;
}

BOOST_AUTO_TEST_CASE(intervals_hold_the_exact_distance_and_are_as_narrow_as_promised) {
    QueryCounters work;
    for (const Draw& draw : draws()) {
        const Models models(draw.pair);
        Workspace workspace;
        const DistanceResult result = distance(models.part, models.environment, draw.pose, {}, workspace);
        const double M = largestOf(draw),
                     width =
                         1e-12 * (diagonalOf(draw.pair.a) + diagonalOf(draw.pair.b)) + 32 * kUnitRoundoff * M;
        BOOST_TEST_CONTEXT(draw.name << ", distance " << draw.truth.rounded() << ", interval " << result.lower
                                     << " to " << result.upper) {
            BOOST_TEST(draw.truth.compare(result.lower) >= 0);
            BOOST_TEST(draw.truth.compare(result.upper) <= 0);
            BOOST_TEST(result.upper - result.lower <= width);
            BOOST_TEST(result.collides() == draw.truth.isZero());
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
        if (!draw.truth.isZero()) continue;
        const Models models(draw.pair);
        Workspace workspace;
        const DistanceResult result = distance(models.part, models.environment, draw.pose, {}, workspace);
        BOOST_TEST(result.witness->pointOnPart == result.witness->pointOnEnvironment);
        const Triangle point = {result.witness->pointOnPart, result.witness->pointOnPart,
                                result.witness->pointOnPart};
        const double most = 16 * kUnitRoundoff * largestOf(draw);
        BOOST_TEST_CONTEXT(draw.name) {
            BOOST_TEST(exactDistance(draw.pose, draw.pair.a, point).compare(most) <= 0);
            BOOST_TEST(exactDistance(point, draw.pair.b).compare(most) <= 0);
        }
    }
}

BOOST_DATA_TEST_CASE(within_turns_at_the_exact_distance, eachTarget(), target) {
    const UsingTarget using_(target);
    for (const Draw& draw : draws()) {
        const Models models(draw.pair);
        Workspace workspace;
        const double near = static_cast<double>(draw.truth.rounded());
        double d = std::nextafter(std::nextafter(near, -kInfinity), -kInfinity);
        for (int step = 0; step < 5; ++step, d = std::nextafter(d, kInfinity)) {
            if (d < 0) continue;
            BOOST_TEST_CONTEXT(draw.name << ", distance " << near << ", step " << step) {
                BOOST_TEST(isWithin(models.part, models.environment, draw.pose, d, workspace) ==
                           (draw.truth.compare(d) <= 0));
            }
        }
        BOOST_TEST(collides(models.part, models.environment, draw.pose, workspace) == draw.truth.isZero());
    }
}

BOOST_AUTO_TEST_SUITE_END()
