// A scene of several obstacles with different margins answers with the obstacle that leaves least clearance.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <memory>

#include "support/oracle.h"
#include "support/part_in_space.h"
#include "support/random_meshes.h"

namespace clearway::testing {
BOOST_AUTO_TEST_SUITE(several_obstacles_test)

constexpr double kMargins[] = {0, 2, 0.5, 6};

struct Yard {
    Yard() {
        for (std::size_t i = 0; i < meshes.size(); ++i) {
            const Mesh mesh = named(meshes[i], "obstacle " + std::to_string(i));
            scene.obstacles.push_back({Model::build(mesh), kMargins[i]});
        }
    }
    Mesh part = bracket(10, 1, 2, 4);
    std::vector<Mesh> meshes = {
        translated(sphere(8, 8), {-20, 0, 0}), translated(box({4, 20, 20}, 4), {20, 0, 0}),
        translated(torus(12, 3, 12), {0, 0, -20}), translated(tube(10, 12, 30, 12), {0, 25, 0})};
    Scene scene{Model::build(part)};
};

PartState randomState(Random& random) {
    PartState state;
    state.position = random.inBox(30);
    state.rotation = Eigen::Quaterniond(random.rotation());
    return state;
}

BOOST_AUTO_TEST_CASE(clearance_is_the_least_of_distance_less_margin_and_tells_whose) {
    const Yard yard;
    const PartInSpace space(yard.scene);
    std::vector<PartInSpace> alone;
    for (const Obstacle& obstacle : yard.scene.obstacles) {
        Scene scene(yard.scene.part);
        scene.obstacles = {obstacle};
        alone.emplace_back(scene);
    }
    Random random(81);
    int valid = 0;
    std::vector<int> nearest(yard.meshes.size(), 0);
    std::vector<std::unique_ptr<const MeshOracle>> oracles;
    for (const Mesh& mesh : yard.meshes)
        oracles.push_back(std::make_unique<const MeshOracle>(yard.part, mesh));
    for (int i = 0; i < 300; ++i) {
        const auto state = space.at(randomState(random));
        double least = std::numeric_limits<double>::infinity(), separate = least, secondLeast = least;
        std::size_t which = 0;
        for (std::size_t k = 0; k < yard.meshes.size(); ++k) {
            const double clearance =
                oracles[k]->distance(space.checker->pose(state.get())).distance - kMargins[k];
            if (clearance < least) which = k;
            secondLeast = std::min(secondLeast, std::max(clearance, least));
            least = std::min(least, clearance);
            const auto same = alone[k].at(space.stateOf(state.get()));
            separate = std::min(separate, alone[k].checker->clearance(same.get()));
        }
        BOOST_TEST_CONTEXT("seed 81, state " << i) {
            const double clearance = space.checker->clearance(state.get());
            BOOST_TEST(space.checker->isValid(state.get()) == (least > 0));
            BOOST_TEST((clearance > 0) == (least > 0));
            if (least > 0) {
                BOOST_TEST(clearance == least, boost::test_tools::tolerance(1e-9));
                BOOST_TEST(clearance == separate, boost::test_tools::tolerance(1e-9));
                const auto report = space.validator->report(state.get(), state.get());
                if (secondLeast > least + 1e-9) {
                    BOOST_TEST(report.closest.obstacle.value() == which);
                    ++nearest[which];
                }
                ++valid;
            }
        }
    }
    BOOST_TEST(valid > 60);
    for (const int count : nearest) BOOST_TEST(count > 2);
}

BOOST_AUTO_TEST_CASE(verdicts_of_motions_are_those_of_each_obstacle_alone) {
    const Yard yard;
    const PartInSpace space(yard.scene, 100);
    std::vector<PartInSpace> alone;
    for (const Obstacle& obstacle : yard.scene.obstacles) {
        Scene scene(yard.scene.part);
        scene.obstacles = {obstacle};
        alone.emplace_back(scene, 100);
    }
    int valid = 0;
    for (int seed = 1; seed <= 60; ++seed) {
        Random random(static_cast<std::uint64_t>(seed));
        const auto s1 = space.at(randomState(random));
        PartState to = space.stateOf(s1.get());
        to.position += random.direction() * random.uniform(1, 10);
        const auto s2 = space.at(to);
        if (!space.checker->isValid(s1.get())) continue;
        bool expected = true;
        for (const PartInSpace& one : alone) {
            expected = expected &&
                       one.validator->checkMotion(one.at(space.stateOf(s1.get())).get(), one.at(to).get());
        }
        BOOST_TEST(space.validator->checkMotion(s1.get(), s2.get()) == expected, "seed " << seed);
        valid += expected;
    }
    BOOST_TEST(valid > 3);
}

BOOST_AUTO_TEST_CASE(an_obstacle_comes_and_goes_without_building_the_others) {
    Yard yard;
    std::vector<std::uint64_t> ids;
    for (const Obstacle& obstacle : yard.scene.obstacles) ids.push_back(obstacle.model.id());
    const Vector3 inBox(20, 0, 0);
    BOOST_TEST(!PartInSpace(yard.scene).isValid(inBox));
    const Obstacle box = yard.scene.obstacles[1];
    yard.scene.obstacles.erase(yard.scene.obstacles.begin() + 1);
    BOOST_TEST(PartInSpace(yard.scene).isValid(inBox));
    yard.scene.obstacles.push_back(box);
    const PartInSpace again(yard.scene);
    BOOST_TEST(!again.isValid(inBox));
    BOOST_TEST(again.checker->scene().obstacles[0].model.id() == ids[0]);
    BOOST_TEST(again.checker->scene().obstacles[1].model.id() == ids[2]);
    BOOST_TEST(again.checker->scene().obstacles[3].model.id() == ids[1]);
}

BOOST_AUTO_TEST_CASE(without_obstacles_all_is_valid_within_the_bounds) {
    const PartInSpace space(Scene(Model::build(box({1, 1, 1}))), 100);
    BOOST_TEST(space.isValid({0, 0, 0}));
    BOOST_TEST(!space.isValid({101, 0, 0}));
    BOOST_TEST(std::isinf(space.checker->clearance(space.at({0, 0, 0}).get())));
    BOOST_TEST(space.check({0, 0, 0}, {50, 50, 50}));
    BOOST_TEST(!space.check({0, 0, 0}, {150, 50, 50}));
    const auto report = space.validator->report(space.at({0, 0, 0}).get(), space.at({9, 9, 9}, 1).get());
    BOOST_TEST((report.verdict == planning::MotionVerdict::kValid));
    BOOST_TEST(std::isinf(report.lowerClearance));
    BOOST_TEST(!report.closest.obstacle);
}

BOOST_AUTO_TEST_CASE(a_wrong_margin_of_any_obstacle_is_refused) {
    Yard yard;
    yard.scene.obstacles[2].margin = -1;
    BOOST_CHECK_THROW(PartInSpace{yard.scene}, std::invalid_argument);
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::testing
