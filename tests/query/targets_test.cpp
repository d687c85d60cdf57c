// Which instruction sets queries run on, and how one is chosen.
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <set>
#include <stdexcept>

#include "clearway/targets.h"
#include "support/query_cases.h"

BOOST_AUTO_TEST_SUITE(targets_test)

using namespace clearway;
using namespace clearway::testing;

BOOST_AUTO_TEST_CASE(available_sets_are_known_ones_best_first) {
    const std::vector<std::string> known = {"avx3", "avx2", "sse4", "neon", "scalar"};
    const std::vector<std::string> available = availableTargets();
    BOOST_TEST_REQUIRE(!available.empty());
    BOOST_TEST(available.back() == "scalar");
    std::size_t rank = 0;
    for (const std::string& name : available) {
        const auto place =
            static_cast<std::size_t>(std::find(known.begin(), known.end(), name) - known.begin());
        BOOST_TEST(place < known.size(), name);
        BOOST_TEST(place >= rank);
        rank = place + 1;
    }
}

BOOST_AUTO_TEST_CASE(the_chosen_set_is_the_current_one) {
    BOOST_TEST(currentTarget() == availableTargets().front());
    for (const std::string& name : availableTargets()) {
        useTarget(name);
        BOOST_TEST(currentTarget() == name);
    }
    useTarget("best");
    BOOST_TEST(currentTarget() == availableTargets().front());
}

BOOST_AUTO_TEST_CASE(an_unknown_set_is_refused_with_the_known_ones) {
    const std::string before = currentTarget();
    for (const std::string wrong : {"mmx", "", "AVX2", "scalar "}) {
        try {
            useTarget(wrong);
            BOOST_ERROR("accepted '" << wrong << "'");
        } catch (const std::invalid_argument& error) {
            const std::string message = error.what();
            BOOST_TEST(message.find(wrong) != std::string::npos);
            for (const std::string& name : availableTargets()) {
                BOOST_TEST(message.find(name) != std::string::npos, message);
            }
        }
    }
    BOOST_TEST(currentTarget() == before);
}

BOOST_AUTO_TEST_CASE(instruction_sets_differ_by_rounding_only) {
    for (const QueryCase& queryCase : queryCases()) {
        const ModelPair models = buildPair(queryCase);
        for (const Pose& pose : queryCase.poses) {
            std::vector<double> distances;
            std::set<bool> touching;
            for (const std::string& name : availableTargets()) {
                useTarget(name);
                Workspace workspace;
                distances.push_back(distance(models.part, models.environment, pose, {}, workspace).distance);
                touching.insert(collides(models.part, models.environment, pose, workspace));
            }
            useTarget("best");
            const auto [least, largest] = std::minmax_element(distances.begin(), distances.end());
            BOOST_TEST(*largest - *least <= 16 * kUnitRoundoff * largestCoordinate(queryCase, pose),
                       queryCase.name);
            BOOST_TEST(touching.size() == 1u, queryCase.name);
        }
    }
}

BOOST_AUTO_TEST_SUITE_END()
