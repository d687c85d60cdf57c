#include "program/cli/window_folder.h"
#include "support/invalid_words.h"

namespace clearway::testing {
BOOST_AUTO_TEST_SUITE(kept_path_test)

struct KeptFolder : WindowProblemFolder {
    KeptFolder() {
        Problem problem = window.problem;
        problem.goal.position = {-60, 30, 0};  // before the wall as the start is
        rewrite(problem, "easy.cfg");
    }
};

constexpr const char* kFails = "plan window.cfg --path out.path --time 0.2 --margin 12";
constexpr const char* kOld = "1 2 3 0 0 0 1\n";

BOOST_AUTO_TEST_CASE(an_interrupt_keeps_the_best_path_so_far) {
    const KeptFolder folder;
    const Outcome outcome = interruptIn(
        folder,
        "plan easy.cfg --path out.path --time 300 --objective length --planner RRTstar --json facts.json");
    BOOST_TEST(outcome.code == 0, outcome.err);
    const auto facts = jsonIn(folder, "facts.json");
    BOOST_TEST(facts["interrupted"] == true);
    BOOST_TEST(facts["audit"]["verdict"] == "valid");
    BOOST_TEST(runIn(folder, "check easy.cfg out.path").code == 0);
}

BOOST_AUTO_TEST_CASE(a_path_that_cannot_be_written_is_printed_and_the_exit_code_is_2) {
    const KeptFolder folder;
    // With no blocks to write, files can be made but stay empty. Pipes are no files.
    const std::string command =
        "cd '" + folder.path() +
        "' && { ( ulimit -f 0; " CLEARWAY_PROGRAM
        " plan easy.cfg --path out.path --quick --iterations 10000; echo code $? ) 2>&1; } | cat > all";
    BOOST_TEST(std::system(command.c_str()) == 0);
    const std::string all = readText(folder.file("all"));
    BOOST_TEST(holds(all, "\ncode 2\n", "cannot write 'out.path': "), all);
    BOOST_TEST(readText(folder.file("out.path")) == "");
    const std::string label = "not written, its states follow\n";
    const std::size_t begin = all.find(label) + label.size(), end = all.find("clearway: ");
    BOOST_REQUIRE(begin < end);
    folder.write("printed.path", all.substr(begin, end - begin));
    const Outcome checked = runIn(folder, "check easy.cfg printed.path");
    BOOST_TEST(checked.code == 0, checked.out);
    BOOST_TEST(checked.err == "");
}

BOOST_AUTO_TEST_CASE(a_plan_that_fails_sets_an_old_path_aside_and_says_so) {
    const KeptFolder folder;
    for (const char* name : {"out.path.old", "out.path.old.2", "out.path.old.3"}) {
        folder.write("out.path", kOld);
        const Outcome outcome = runIn(folder, kFails);
        BOOST_TEST(outcome.code == 1);
        BOOST_TEST(row(outcome, "old path").find(std::string("moved to ") + name + ",") == 0u);
        BOOST_TEST(readText(folder.file(name)) == kOld);
        BOOST_TEST(readText(folder.file("out.path")) == "");
    }
    const auto names = folder.names();
    BOOST_TEST(!holds(runIn(folder, kFails).out, "old path"));
    BOOST_TEST(folder.names() == names, boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(a_plan_that_is_refused_or_interrupted_sets_an_old_path_aside) {
    const KeptFolder folder;
    folder.write("out.path", kOld);
    const Outcome refused = runIn(folder, "plan window.cfg --path out.path --margin 100");
    BOOST_TEST(refused.code == 2);
    BOOST_TEST(holds(refused.err, "start is " + beginningOf(WhyInvalid::Kind::kTooClose)), refused.err);
    BOOST_TEST(readText(folder.file("out.path.old")) == kOld);

    folder.write("out.path", kOld);
    const Outcome ended = interruptIn(folder, "plan window.cfg --path out.path --time 300 --margin 12");
    BOOST_TEST(ended.code == 1);
    BOOST_TEST(row(ended, "path") == "none, interrupted");
    BOOST_TEST(readText(folder.file("out.path.old.2")) == kOld);
}

BOOST_AUTO_TEST_CASE(a_new_path_replaces_the_old_one_and_wrong_usage_leaves_it) {
    const KeptFolder folder;
    folder.write("out.path", kOld);
    for (const char* wrong :
         {"--time soon", "--iterations 9 --threads 4", "--planner-param beauty=1", "--seed 0"}) {
        requireRefused(folder, std::string("plan window.cfg --path out.path ") + wrong, {});
        BOOST_TEST(readText(folder.file("out.path")) == kOld, wrong);
    }
    requireRefused(folder, "plan " CLEARWAY_DATA_DIR "/bracket/bracket.cfg --path out.path --explain 5",
                   {"--explain"});
    BOOST_TEST(runIn(folder, "plan easy.cfg --path out.path --quick --iterations 10000").code == 0);
    BOOST_TEST(readText(folder.file("out.path")) != kOld);
    BOOST_TEST(readText(folder.file("out.path.old")) == "");
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::testing
