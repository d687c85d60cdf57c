// Every strategy, node width and instruction set gives the oracle's distance and keeps all other promises of
// a result.
#include <boost/test/unit_test.hpp>
#include <map>
#include <sstream>

#include "support/each_target.h"
#include "support/query_cases.h"

BOOST_AUTO_TEST_SUITE(distance_test)

using namespace clearway;
using namespace clearway::testing;

// The models of every case, built once for all instruction sets.
const std::vector<ModelPair>& modelsBuiltAs(const BuildChoice& build) {
    static std::map<std::string, std::vector<ModelPair>> built;
    std::ostringstream key;
    key << build;
    std::vector<ModelPair>& models = built[key.str()];
    if (models.empty()) {
        for (const QueryCase& queryCase : queryCases()) models.push_back(buildPair(queryCase, build));
    }
    return models;
}

BOOST_AUTO_TEST_CASE(cases_hold_contact_and_every_kind_of_gap) {
    int touching = 0, within1e10 = 0, near = 0, far = 0;
    for (const QueryCase& queryCase : queryCases()) {
        for (const OracleAnswer& answer : queryCase.answers) {
            const double gap = answer.distance / queryCase.oracle->sceneSize();
            ++(gap == 0 ? touching : gap < 1e-10 ? within1e10 : gap < 1e-3 ? near : far);
        }
    }
    BOOST_TEST(touching >= 6);
    BOOST_TEST(within1e10 >= 4);
    BOOST_TEST(near >= 8);
    BOOST_TEST(far >= 12);
}

BOOST_DATA_TEST_CASE(distance_matches_oracle, eachTarget() * eachBuild(), target, build) {
    const UsingTarget using_(target);
    const std::vector<ModelPair>& models = modelsBuiltAs(build);
    Workspace workspace;
    for (std::size_t c = 0; c < queryCases().size(); ++c) {
        const QueryCase& queryCase = queryCases()[c];
        for (std::size_t i = 0; i < queryCase.poses.size(); ++i) {
            const DistanceResult result =
                distance(models[c].part, models[c].environment, queryCase.poses[i], {}, workspace);
            BOOST_TEST_CONTEXT(queryCase.name << ", pose " << i) {
                checkDistance(result, queryCase, queryCase.poses[i], queryCase.answers[i]);
                BOOST_TEST(result.counters.volumeTests >= result.counters.nodeVisits);
                BOOST_TEST(result.counters.triangleTests == workspace.counters().triangleTests);
            }
        }
    }
}

BOOST_AUTO_TEST_CASE(components_are_those_that_hold_the_triangles) {
    const QueryCase& queryCase = queryCases()[5];
    const auto inFour = [](Mesh mesh) {
        const auto quarter = static_cast<std::uint32_t>(mesh.triangles.size() / 4);
        const auto rest = static_cast<std::uint32_t>(mesh.triangles.size()) - 3 * quarter;
        mesh.components = {{"a", 0, quarter},
                           {"b", quarter, quarter},
                           {"c", 2 * quarter, quarter},
                           {"d", 3 * quarter, rest}};
        return mesh;
    };
    const Mesh partMesh = inFour(queryCase.part), environmentMesh = inFour(queryCase.environment);
    const Model part = Model::build(partMesh), environment = Model::build(environmentMesh);
    Workspace workspace;
    for (const Pose& pose : queryCase.poses) {
        const DistanceResult result = distance(part, environment, pose, {}, workspace);
        BOOST_TEST(result.witness->partComponent ==
                   static_cast<std::int64_t>(componentOf(partMesh, result.witness->partTriangle)));
        BOOST_TEST(
            result.witness->environmentComponent ==
            static_cast<std::int64_t>(componentOf(environmentMesh, result.witness->environmentTriangle)));
    }
}

BOOST_AUTO_TEST_SUITE_END()
