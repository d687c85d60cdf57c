// Which instruction sets queries run on, and how one is chosen.
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>
#include <stdexcept>
#include <thread>

#include "clearway/sweep.h"
#include "clearway/targets.h"
#include "support/query_cases.h"
#include "support/temporary_folder.h"

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

constexpr int kQuestions = 4;

/// Asks every kind of query, the given one first. Their lanes depend on the instruction set that the kernels ran on.
std::string lanesOfEveryQuery(int first = 0) {
    Random random(1);
    const Model part = Model::build(randomSoup(random, 300, 5, 1));
    const Pose apart{Matrix3::Identity(), {13, 0, 0}};
    const MotionPieces motion = piecesOf({apart, {-2, 5, 0}, {0, 0, 0.3}}, part);
    std::string lanes[kQuestions];
    for (int i = 0; i < kQuestions; ++i) {
        const int question = (first + i) % kQuestions;
        Workspace workspace;
        if (question == 0) distance(part, part, apart, {}, workspace);
        if (question == 1) isWithin(part, part, apart, 3, workspace);
        if (question == 2) sweep(part, part, motion, {}, workspace);
        if (question == 3) leastDistance(part, part, motion, {}, workspace);
        lanes[question] = std::to_string(workspace.counters().kernelLanes) + " ";
    }
    return lanes[0] + lanes[1] + lanes[2] + lanes[3];
}

/// Returns the text that the case below writes in a child process of this program, with the variable set.
std::string toldByChild(const std::string& value, const std::string& question) {
    const TemporaryFolder folder;
    const std::string program = std::filesystem::read_symlink("/proc/self/exe").string();
    const std::string command = "CLEARWAY_TARGET='" + value + "' CLEARWAY_TEST_QUESTION=" + question +
                                " CLEARWAY_TEST_ANSWER='" + folder.file("answer") +
                                "' " CLEARWAY_TEST_EMULATOR " '" + program +
                                "' --run_test=targets_test/child_process > '" + folder.file("log") + "' 2>&1";
    BOOST_TEST(std::system(command.c_str()) == 0, readText(folder.file("log")));
    return readText(folder.file("answer"));
}

/// Does nothing by itself: the cases after it run it in a process of its own.
BOOST_AUTO_TEST_CASE(child_process) {
    const char *question = std::getenv("CLEARWAY_TEST_QUESTION"), *file = std::getenv("CLEARWAY_TEST_ANSWER");
    if (question == nullptr || file == nullptr) return;
    const std::string asked = question;
    std::ofstream answer(file);
    const auto tell = [&](const auto& work) {
        try {
            answer << work() << "\n";
        } catch (const std::invalid_argument& error) {
            answer << error.what() << "\n";
        }
    };
    for (int first = 0; first < kQuestions; ++first) {
        if (asked != "lanes" + std::to_string(first)) continue;
        for (int again = 0; again < 2; ++again) tell([=] { return lanesOfEveryQuery(first); });
        tell(currentTarget);
    }
    if (asked == "override")
        tell([] { return useTarget("scalar"), lanesOfEveryQuery(); }), tell(currentTarget);
    if (asked == "available") tell([] { return availableTargets().front(); });
    if (asked == "threads") {
        std::vector<std::string> told(8);
        std::vector<std::thread> threads;
        for (std::string& mine : told) threads.emplace_back([&] { mine = lanesOfEveryQuery(); });
        for (std::thread& thread : threads) thread.join();
        answer << *std::min_element(told.begin(), told.end()) << "\n"
               << *std::max_element(told.begin(), told.end()) << "\n";
    }
}

BOOST_AUTO_TEST_CASE(the_environment_names_the_set_from_the_first_query_on) {
    std::vector<std::string> names = availableTargets();
    std::set<std::string> distinct;
    for (const std::string& name : names) {
        useTarget(name);
        const std::string lanes = lanesOfEveryQuery();
        distinct.insert(lanes);
        for (const std::string first : {"lanes0", "lanes1", "lanes2", "lanes3"}) {
            BOOST_TEST(toldByChild(name, first) == lanes + "\n" + lanes + "\n" + name + "\n");
        }
        BOOST_TEST(toldByChild(name, "threads") == lanes + "\n" + lanes + "\n");
    }
    BOOST_TEST(distinct.size() > (names.size() > 1 ? 1u : 0u));  // so the lanes do tell the sets apart
    useTarget("best");
    for (const std::string value : {"", "best"}) {
        const std::string lanes = lanesOfEveryQuery() + "\n";
        BOOST_TEST(toldByChild(value, "lanes0") == lanes + lanes + names.front() + "\n");
    }
    useTarget("scalar");
    BOOST_TEST(toldByChild(names.front(), "override") == lanesOfEveryQuery() + "\nscalar\n");
    BOOST_TEST(toldByChild("nonsense", "override") == lanesOfEveryQuery() + "\nscalar\n");
    useTarget("best");
}

BOOST_AUTO_TEST_CASE(a_set_that_the_environment_names_wrongly_is_refused_by_every_query) {
    for (const std::string wrong : {"avx9", "AVX2", "neon,", " "}) {
        std::string refusal = "CLEARWAY_TARGET is '" + wrong + "', expected best or one this machine runs: ";
        for (const std::string& name : availableTargets())
            refusal += (name == availableTargets().front() ? "" : ", ") + name;
        refusal += "\n";
        for (const std::string first : {"lanes0", "lanes2"}) {
            BOOST_TEST(toldByChild(wrong, first) == refusal + refusal + refusal);
        }
        BOOST_TEST(toldByChild(wrong, "available") == availableTargets().front() + "\n");
    }
}

BOOST_AUTO_TEST_SUITE_END()
