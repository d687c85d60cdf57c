// Problems without a path, as a closed surface around one end proves.
#include <boost/test/unit_test.hpp>

#include "clearway/planning/plan.h"
#include "support/random_meshes.h"
#include "support/winding.h"

namespace clearway::planning {
BOOST_AUTO_TEST_SUITE(shut_in_test)

using Outcome = PlanReport::Outcome;

/// A cube in a case of thin walls about the origin, with as many sides as are asked for, and something else to one side.
struct Case {
    explicit Case(int sides = 6) {
        Mesh shell = testing::box({5, 5, 5}, 3);
        const std::size_t perSide = shell.triangles.size() / 6;
        shell.triangles.resize(perSide * static_cast<std::size_t>(sides));
        const Mesh other = testing::translated(testing::box({1, 1, 1}), {0, 0, 30});
        scene.obstacles.push_back({Model::build(testing::named(shell, "case"))});
        scene.obstacles.push_back({Model::build(testing::named(other, "other"))});
        problem.start.position = {1, 0, 0};
        problem.goal.position = {20, 0, 0};
        problem.volume = Box(Vector3(-30, -30, -30), Vector3(30, 30, 40));
    }

    PlanReport plan() const {
        PlanOptions options;
        options.seconds = 0.2;
        return planning::plan(problem, scene, options);
    }

    Scene scene{Model::build(testing::box({0.5, 0.5, 0.5}))};
    Problem problem;
};

BOOST_AUTO_TEST_CASE(an_end_in_a_closed_surface_proves_that_there_is_no_path) {
    Case inside;
    PlanReport report = inside.plan();
    BOOST_TEST((report.outcome == Outcome::kNotFound));
    BOOST_REQUIRE(report.shutIn.has_value());
    BOOST_TEST(report.shutIn->obstacle == "case");
    BOOST_TEST(report.shutIn->isStart);
    BOOST_TEST(report.planningSeconds == 0);
    BOOST_TEST(!report.whyNoPath);
    std::swap(inside.problem.start, inside.problem.goal);
    report = inside.plan();
    BOOST_REQUIRE(report.shutIn.has_value());
    BOOST_TEST(!report.shutIn->isStart);
    std::swap(inside.problem.start, inside.problem.goal);
    inside.problem.outside = Outside{};
    BOOST_TEST(inside.plan().shutIn.has_value());
}

BOOST_AUTO_TEST_CASE(nothing_is_proved_where_a_way_may_lead_out) {
    const Case open(5);
    BOOST_TEST(!open.plan().shutIn);
    Case both;
    both.problem.goal.position = {-1, 1, 0};
    BOOST_TEST((both.plan().outcome == Outcome::kFound));
    Case outside;
    outside.problem.start.position = {-20, 0, 0};
    BOOST_TEST((outside.plan().outcome == Outcome::kFound));
    Case ignored;
    ignored.scene.obstacles[0].isIgnoredAtStart = true;
    ignored.scene.startContact = ContactZone{poseOf(ignored.problem.start), 8};
    BOOST_TEST(!ignored.plan().shutIn);
    Case shrunk;
    shrunk.scene.obstacles[0].shrunk =
        shrunkModel(shrink(testing::box({0.5, 0.5, 0.5}), {0.1}),
                    Model::build(shrink(testing::box({0.5, 0.5, 0.5}), {0.1}).mesh));
    BOOST_TEST(!shrunk.plan().shutIn);
}

BOOST_AUTO_TEST_CASE(a_surface_within_a_surface_shuts_in_by_itself) {
    Case nested;
    const Mesh around = testing::box({9, 9, 9}, 2);
    nested.scene.obstacles.push_back({Model::build(around)});
    nested.problem.goal.position = {7, 0, 0};  // between the two
    const PlanReport report = nested.plan();
    BOOST_REQUIRE(report.shutIn.has_value());
    BOOST_TEST(report.shutIn->obstacle == "case");
    nested.problem.start.position = {-7, 0, 0};
    BOOST_TEST((nested.plan().outcome == Outcome::kFound));
}

/// A solid with a cavity is one closed surface, which a ray from within crosses twice.
BOOST_AUTO_TEST_CASE(a_cavity_in_a_solid_shuts_in) {
    const Mesh cavity = testing::reversed(testing::box({5, 5, 5}, 3));
    const Mesh solid = testing::named(testing::joined(testing::box({6, 6, 6}, 2), cavity), "solid");
    Case hollow;
    hollow.scene.obstacles = {{Model::build(solid)}};
    const PlanReport report = hollow.plan();
    BOOST_REQUIRE(report.shutIn.has_value());
    BOOST_TEST(report.shutIn->obstacle == "solid");
    hollow.problem.start.position = {-1, 2, 0};
    hollow.problem.goal.position = {-1, -2, 0};
    BOOST_TEST((hollow.plan().outcome == Outcome::kFound));
    hollow.problem.start.position = {-20, 0, 0};
    hollow.problem.goal.position = {20, 0, 0};
    BOOST_TEST((hollow.plan().outcome == Outcome::kFound));
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::planning
