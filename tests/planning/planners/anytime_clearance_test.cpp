// Anytime planners find paths of more and more clearance, and of more clearance than a planner that ends at
// its first path.
#include <boost/test/unit_test.hpp>
#include <string>
#include <vector>

#include "support/anytime_planner.h"
#include "support/planar_scenes.h"

namespace clearway::testing {
BOOST_AUTO_TEST_SUITE(anytime_clearance_test)

constexpr std::uint32_t kSeeds = 2;
constexpr int kMostRounds = 20;

/// Costs summed over the seeds; 0 without a path.
struct Course {
    double first = 0;  ///< RRTConnect's cost
    double early = 0, late = 0;
};

template <class Place, class PlanOn>
Course courseIn(const Place& place, const std::string& name, const AnytimePlanner::Parameters& parameters,
                const PlanOn& planOn) {
    Course course;
    for (std::uint32_t seed = 1; seed <= kSeeds; ++seed) {
        BOOST_TEST_CONTEXT(name << ", seed " << seed) {
            AnytimePlanner single(place.problem, place.scene, "RRTConnect", {{"range", "60"}},
                                  "max_min_clearance", seed);
            single.planSeconds(20);
            BOOST_TEST_REQUIRE(single.best().has_value());
            course.first += *single.best();
            AnytimePlanner planner(place.problem, place.scene, name, parameters, "max_min_clearance", seed);
            planOn(planner, 1);
            const double early = planner.best().value_or(0);
            // Planners with threads share the time as the machine has it, and a round may find nothing.
            for (int round = 0; round < kMostRounds && planner.best().value_or(0) <= early; ++round)
                planOn(planner, 7);
            BOOST_TEST_REQUIRE(planner.best().has_value());
            BOOST_TEST(*planner.best() >= early);
            BOOST_TEST(*planner.best() <= planner.certifiedClearance() + 0.1);  // 1 % of the most possible
            course.early += early;
            course.late += *planner.best();
        }
    }
    BOOST_TEST_MESSAGE(name << ": " << course.early / kSeeds << ", at last " << course.late / kSeeds
                            << ", RRTConnect " << course.first / kSeeds);
    return course;
}

BOOST_AUTO_TEST_CASE(rrt_star_improves_and_beats_a_first_path) {
    const Course course =
        courseIn(gatesScene(), "RRTstar", {{"range", "60"}},
                 [](AnytimePlanner& planner, int parts) { planner.planIterations(45 * parts); });
    BOOST_TEST(course.late > course.early);
    BOOST_TEST(course.late > course.first);
}

BOOST_AUTO_TEST_CASE(prm_star_improves_and_beats_a_first_path) {
    const Course course = courseIn(postsScene(), "PRMstar", {}, [](AnytimePlanner& planner, int parts) {
        planner.planSeconds(0.1 * parts);
    });
    BOOST_TEST(course.late > course.early);
    BOOST_TEST(course.late > course.first);
}

BOOST_AUTO_TEST_CASE(anytime_path_shortening_improves_and_beats_a_first_path) {
    const std::string two = "RRTConnect[range=60],RRTConnect[range=60]";
    const Course course =
        courseIn(postsScene(), "AnytimePathShortening", {{"planners", two}},
                 [](AnytimePlanner& planner, int parts) { planner.planSeconds(0.1 * parts); });
    BOOST_TEST(course.late > course.early);
    BOOST_TEST(course.late > course.first);
}

BOOST_AUTO_TEST_CASE(a_rising_floor_improves_and_beats_a_first_path) {
    const Course course =
        courseIn(postsScene(), "RisingFloor", {{"range", "60"}},
                 [](AnytimePlanner& planner, int parts) { planner.planSeconds(0.1 * parts); });
    BOOST_TEST(course.late > course.early);
    BOOST_TEST(course.late > course.first);
}

double fmtCost(int samples, const std::string& objective) {
    const PlanarScene posts = postsScene();
    double sum = 0;
    for (std::uint32_t seed = 1; seed <= kSeeds; ++seed) {
        AnytimePlanner planner(posts.problem, posts.scene, "FMT", {{"num_samples", std::to_string(samples)}},
                               objective, seed);
        planner.planSeconds(20);
        BOOST_TEST_REQUIRE(planner.best().has_value(), samples << " samples, seed " << seed);
        BOOST_TEST(planner.certifiedClearance() > 0);
        sum += *planner.best();
    }
    return sum;
}

BOOST_AUTO_TEST_CASE(fmt_improves_with_samples) {
    BOOST_TEST(fmtCost(400, "clearance_integral") < fmtCost(100, "clearance_integral"));
}

BOOST_AUTO_TEST_CASE(fmt_finds_paths_with_a_bottleneck_for_a_cost) {
    BOOST_TEST(fmtCost(150, "max_min_clearance") > 0);
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::testing
