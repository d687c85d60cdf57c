// Threads share models but not workspaces: four threads get the answers of one.
#include <boost/test/unit_test.hpp>
#include <thread>

#include "support/each_target.h"
#include "support/query_cases.h"

BOOST_AUTO_TEST_SUITE(shared_models_test)

using namespace clearway;
using namespace clearway::testing;

struct Answers {
    std::vector<double> lower, upper, distance;
    std::vector<bool> touching, near;

    bool operator==(const Answers& other) const {
        return lower == other.lower && upper == other.upper && distance == other.distance &&
               touching == other.touching && near == other.near;
    }
};

/// workspace: one, or none.
template <class... OneOrNone>
Answers answersOf(const std::vector<ModelPair>& models, OneOrNone&... workspace) {
    constexpr int kRepetitions = 20;
    Answers answers;
    for (int repetition = 0; repetition < kRepetitions; ++repetition) {
        for (std::size_t c = 0; c < models.size(); ++c) {
            for (const Pose& pose : queryCases()[c].poses) {
                const ModelPair& pair = models[c];
                const DistanceResult result = distance(pair.part, pair.environment, pose, {}, workspace...);
                answers.lower.push_back(result.lower);
                answers.upper.push_back(result.upper);
                answers.distance.push_back(result.distance);
                answers.touching.push_back(collides(pair.part, pair.environment, pose, workspace...));
                answers.near.push_back(isWithin(pair.part, pair.environment, pose, 1, workspace...));
            }
        }
    }
    return answers;
}

BOOST_DATA_TEST_CASE(four_threads_get_the_answers_of_one, eachWidth(), width) {
    std::vector<ModelPair> models;
    for (const QueryCase& queryCase : queryCases()) models.push_back(buildPair(queryCase, ofWidth(width)));
    Workspace workspace;
    const Answers alone = answersOf(models, workspace);
    for (const bool haveWorkspaces : {true, false}) {
        std::vector<Answers> together(4);
        std::vector<std::thread> threads;
        for (Answers& answers : together) {
            threads.emplace_back([&] {
                Workspace mine;
                answers = haveWorkspaces ? answersOf(models, mine) : answersOf(models);
            });
        }
        for (std::thread& thread : threads) thread.join();
        for (const Answers& answers : together) BOOST_TEST((answers == alone));
    }
}

BOOST_AUTO_TEST_CASE(a_moved_workspace_goes_on_serving) {
    const QueryCase& queryCase = queryCases()[0];
    const ModelPair models = buildPair(queryCase);
    Workspace first;
    distance(models.part, models.environment, queryCase.poses[0], {}, first);
    Workspace second = std::move(first);
    checkDistance(distance(models.part, models.environment, queryCase.poses[1], {}, second), queryCase,
                  queryCase.poses[1], queryCase.answers[1]);
    Workspace third;
    third = std::move(second);
    checkDistance(distance(models.part, models.environment, queryCase.poses[2], {}, third), queryCase,
                  queryCase.poses[2], queryCase.answers[2]);
}

BOOST_AUTO_TEST_SUITE_END()
