#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <iostream>
#include <regex>
#include <sstream>
#include <thread>

#include "clearway/targets.h"
#include "program/cli/run_program.h"
#include "program/options/print.h"

namespace clearway::testing {
BOOST_AUTO_TEST_SUITE(program_test)

BOOST_AUTO_TEST_CASE(every_subcommand_that_help_lists_has_its_own_help) {
    const TemporaryFolder folder;
    const std::string help = runIn(folder, "--help").out;
    int listed = 0;
    for (std::size_t at = help.find("\n  "); at != std::string::npos; at = help.find("\n  ", at + 1)) {
        const std::string name = help.substr(at + 3, help.find(' ', at + 3) - at - 3);
        if (name == "clearway") break;  // the lines about --help and --version
        ++listed;
        const Outcome outcome = runIn(folder, name + " --help");
        BOOST_TEST(outcome.code == 0, name);
        BOOST_TEST(outcome.out.find("Usage: clearway " + name + " ") == 0, outcome.out);
    }
    BOOST_TEST(listed == 7);
}

BOOST_AUTO_TEST_CASE(progress_is_told_line_by_line_where_stderr_is_no_terminal) {
    std::ostringstream told;
    std::streambuf* const before = std::cerr.rdbuf(told.rdbuf());
    {
        const cli::ElapsedLine elapsed("waiting", std::chrono::milliseconds(300));
        std::this_thread::sleep_for(std::chrono::milliseconds(1600));
    }
    std::cerr.rdbuf(before);
    // A terminal is told every second, and nothing else.
    const char* const expected =
        isatty(STDERR_FILENO) ? "\rwaiting 1 s" : "waiting 0 s\nwaiting 0 s\nwaiting 0 s\nwaiting 1 s\n";
    BOOST_TEST(holds(told.str(), expected), told.str());
}

BOOST_AUTO_TEST_CASE(wrong_subcommands_are_refused_with_the_known_ones) {
    const TemporaryFolder folder;
    requireRefused(folder, "", {"no subcommand", "info, query", "--help"});
    requireRefused(folder, "inform", {"'inform'", "info, query"});
    requireRefused(folder, "--verbose", {"'--verbose'", "info, query"});
    requireRefused(folder, "chekc", {"'chekc'", "'check'"});
    requireRefused(folder, "--verison", {"'--verison'", "'--version'"});
    requireRefused(folder, "help kyes", {"'kyes'", "'keys'"});
    requireRefused(folder, "plan --pth x", {"'--path'"});
    requireRefused(folder, "info ''", {"MESH|FOLDER|PROBLEM.cfg is ''", "expected: clearway info"});
    requireRefused(folder, "--help > /dev/full", {"standard output"});
    for (const char* asked : {"-h", "--help", "--version"}) BOOST_TEST(runIn(folder, asked).code == 0);
}

BOOST_AUTO_TEST_CASE(an_instruction_set_that_the_environment_names_is_used_or_refused) {
    const TemporaryFolder folder;
    for (const std::string& name : availableTargets()) {
        setenv("CLEARWAY_TARGET", name.c_str(), 1);
        BOOST_TEST(std::regex_search(runIn(folder, "--version").out,
                                     std::regex("instruction set: +" + name + "\n")));
    }
    setenv("CLEARWAY_TARGET", "avx9", 1);
    const std::string expected = "CLEARWAY_TARGET is 'avx9', expected best or one this machine runs: ";
    requireRefused(folder, "info nothing.stl", {expected, availableTargets().back()});
    BOOST_TEST(runIn(folder, "help query").code == 0);
    unsetenv("CLEARWAY_TARGET");
}

BOOST_AUTO_TEST_CASE(scenes_and_the_study_are_programs_of_their_own) {
    const TemporaryFolder folder;
    requireRefused(folder, "scene tunnel-console --out out",
                   {"scene is a program of its own: clearway-scene"});
    for (const char* option : {"--study leaf-strategies", "--study=leaf-strategies", "--study --help"})
        requireRefused(folder, std::string("bench ") + option,
                       {"--study is a program of its own: clearway-study"});
    for (const std::string program : {kSceneProgram, kStudyProgram}) {
        const std::string name = program.substr(program.rfind('/') + 1);
        BOOST_TEST(runIn(folder, "--version", program).out.find(name + " ") == 0u);
        setenv("CLEARWAY_TARGET", "avx9", 1);
        requireRefused(folder, "", {"CLEARWAY_TARGET is 'avx9'"}, program);
        unsetenv("CLEARWAY_TARGET");
    }
}

BOOST_AUTO_TEST_CASE(output_that_cannot_be_written_and_misspelt_words_are_refused) {
    const TemporaryFolder folder;
    requireRefused(folder, "--help > /dev/full", {"standard output"});
    for (const char* asked : {"-h", "--help", "--version"}) BOOST_TEST(runIn(folder, asked).code == 0);
    requireRefused(folder, "pln", {"did you mean 'plan'"});
    requireRefused(folder, "plan --pth x", {"did you mean '--path'"});
}

BOOST_AUTO_TEST_CASE(a_reader_that_has_gone_is_an_error_and_not_a_signal) {
    const TemporaryFolder folder;
    // The status is the program's own, not the pipe's. The program writes it to a file after the reader has
    // closed the pipe.
    runIn(folder,
          "--version > /dev/null; { sleep 0.3; " CLEARWAY_PROGRAM " --help 2> err; echo $? > code; } | true");
    BOOST_TEST(readText(folder.file("code")) == "2\n");
    BOOST_TEST(readText(folder.file("err")).find("standard output") != std::string::npos);
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::testing
