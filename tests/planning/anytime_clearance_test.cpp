// Planners that go on find paths of more clearance, and of more than a planner that ends at its first path.
#define BOOST_TEST_MODULE anytime_clearance
#include <boost/test/unit_test.hpp>
#include <string>
#include <vector>

#include "support/anytime_planner.h"
#include "support/gates_scene.h"

namespace clearway::testing {
namespace {

constexpr std::uint32_t kSeeds = 2;

/// Costs summed over the seeds; 0 without a path.
struct Course {
    double first = 0;  ///< RRTConnect's
    double early = 0, late = 0;
};

template <class PlanOn>
Course courseOf(const std::string& name, const AnytimePlanner::Parameters& parameters, const PlanOn& planOn) {
    const GatesScene gates = gatesScene();
    Course course;
    for (std::uint32_t seed = 1; seed <= kSeeds; ++seed) {
        BOOST_TEST_CONTEXT(name << ", seed " << seed) {
            AnytimePlanner single(gates.problem, gates.scene, "RRTConnect", {{"range", "60"}},
                                  "max_min_clearance", seed);
            single.planSeconds(20);
            BOOST_TEST_REQUIRE(single.best().has_value());
            course.first += *single.best();
            AnytimePlanner planner(gates.problem, gates.scene, name, parameters, "max_min_clearance", seed);
            planOn(planner, 1);
            const double early = planner.best().value_or(0);
            planOn(planner, 3);
            BOOST_TEST_REQUIRE(planner.best().has_value());
            BOOST_TEST(*planner.best() >= early);
            BOOST_TEST(*planner.best() <= kWideGates);
            BOOST_TEST(*planner.best() <= planner.certifiedClearance() + 0.01 * kWideGates);
            course.early += early;
            course.late += *planner.best();
        }
    }
    BOOST_TEST_MESSAGE(name << ": " << course.early / kSeeds << ", after four times as much "
                            << course.late / kSeeds << ", RRTConnect " << course.first / kSeeds);
    return course;
}

BOOST_AUTO_TEST_CASE(rrt_star_improves_and_beats_a_first_path) {
    const Course course = courseOf("RRTstar", {{"range", "60"}}, [](AnytimePlanner& planner, int parts) {
        planner.planIterations(90 * parts);
    });
    BOOST_TEST(course.late > course.early);
    BOOST_TEST(course.late > course.first);
}

BOOST_AUTO_TEST_CASE(prm_star_improves_and_beats_a_first_path) {
    const Course course = courseOf(
        "PRMstar", {}, [](AnytimePlanner& planner, int parts) { planner.planSeconds(0.15 * parts); });
    BOOST_TEST(course.late >= course.early);
    BOOST_TEST(course.late > course.first);
}

BOOST_AUTO_TEST_CASE(anytime_path_shortening_improves_and_beats_a_first_path) {
    const std::string two = "RRTConnect[range=60],RRTConnect[range=60]";
    const Course course =
        courseOf("AnytimePathShortening", {{"planners", two}},
                 [](AnytimePlanner& planner, int parts) { planner.planSeconds(0.15 * parts); });
    BOOST_TEST(course.late >= course.early);
    BOOST_TEST(course.late > course.first);
}

}  // namespace
}  // namespace clearway::testing
