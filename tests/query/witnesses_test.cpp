// A workspace remembers the closest pairs of earlier distances, and a distance begins with the one that is nearest at its pose.
#include <boost/test/unit_test.hpp>
#include <cstdint>
#include <vector>

#include "clearway/model.h"
#include "clearway/query.h"
#include "support/each_target.h"
#include "support/random_meshes.h"

BOOST_AUTO_TEST_SUITE(witnesses_test)

using namespace clearway;
using namespace clearway::testing;

constexpr std::uint64_t kSeed = 211;

/// A part within a hollow soup, far away from its own place of the query before.
struct Places {
    Model part, environment;
    std::vector<Pose> poses;
};

Places makePlaces(int count) {
    Random random(kSeed);
    Places made{Model::build(randomSoup(random, 900, 1, 0.3)), Model::build(sphere(10, 24)), {}};
    for (int i = 0; i < count; ++i) made.poses.push_back({random.rotation(), 7 * random.direction()});
    return made;
}

std::uint64_t nodesOf(const Places& places, const Pose& pose, Workspace& workspace) {
    return distance(places.part, places.environment, pose, {}, workspace).counters.nodeVisits;
}

BOOST_DATA_TEST_CASE(poses_in_turn_cost_no_more_than_each_one_again,
                     eachTarget() * boost::unit_test::data::make({1, 2, 7, 17, 64}), target, count) {
    const UsingTarget using_(target);
    const Places places = makePlaces(count);
    Workspace inTurn;
    for (int round = 0; round < 2; ++round) {
        for (const Pose& pose : places.poses) nodesOf(places, pose, inTurn);
    }
    std::uint64_t cold = 0, again = 0;
    for (const Pose& pose : places.poses) {
        Workspace alone;
        cold += nodesOf(places, pose, alone);
        const std::uint64_t alike = nodesOf(places, pose, alone);
        again += alike;
        BOOST_TEST(nodesOf(places, pose, inTurn) == alike);
    }
    BOOST_TEST(again < cold);  // so that the comparison above says something
}

BOOST_DATA_TEST_CASE(the_oldest_of_many_pairs_is_forgotten, eachTarget(), target) {
    const UsingTarget using_(target);
    const Places places = makePlaces(300);
    Workspace one, inTurn;
    std::uint64_t again = 0, after = 0;
    for (const Pose& pose : places.poses) {
        nodesOf(places, pose, one);
        again += nodesOf(places, pose, one);
    }
    for (int round = 0; round < 2; ++round) {
        after = 0;
        for (const Pose& pose : places.poses) after += nodesOf(places, pose, inTurn);
    }
    BOOST_TEST(after > again);
}

BOOST_DATA_TEST_CASE(other_models_begin_with_pairs_of_their_own, eachTarget(), target) {
    const UsingTarget using_(target);
    const Places places = makePlaces(20);
    // Its pairs do not exist in the other models, whose triangles are fewer.
    const Model few = Model::build(box({0.5, 0.5, 0.5}, 1));
    Workspace workspace, alone;
    for (const Pose& pose : places.poses) {
        nodesOf(places, pose, workspace);
        const DistanceResult shared = distance(few, few, pose, {}, workspace),
                             own = distance(few, few, pose, {}, alone);
        BOOST_TEST(shared.lower <= own.upper);
        BOOST_TEST(own.lower <= shared.upper);
        BOOST_TEST(isWithin(few, few, pose, own.upper, workspace));
        BOOST_TEST(isWithin(places.part, places.environment, pose, 100, workspace));
    }
}

BOOST_DATA_TEST_CASE(a_contact_found_before_answers_at_once, eachTarget(), target) {
    const UsingTarget using_(target);
    const Places places = makePlaces(1);
    std::vector<Pose> touching;
    Random random(kSeed + 1);
    for (int i = 0; i < 30; ++i) touching.push_back({random.rotation(), 10 * random.direction()});
    Workspace workspace;
    for (int round = 0; round < 3; ++round) {
        for (const Pose& pose : touching) {
            BOOST_TEST(distance(places.part, places.environment, pose, {}, workspace).collides());
            if (round > 0) BOOST_TEST(workspace.counters().nodeVisits == 0u);
        }
    }
}

BOOST_AUTO_TEST_SUITE_END()
