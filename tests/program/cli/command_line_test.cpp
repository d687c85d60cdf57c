#include "program/options/command_line.h"

#include <sys/wait.h>
#include <unistd.h>

#include <boost/test/unit_test.hpp>
#include <csignal>

#include "support/words.h"

namespace clearway::testing {
BOOST_AUTO_TEST_SUITE(command_line_test)

using namespace cli;

/// One command line with an argument of each kind, and what it read.
struct Read {
    std::string problem, path, out;
    std::vector<std::string> views;
    bool isShort = false;
    bool isHelp = false;

    explicit Read(const Arguments& words) {
        CommandLine line("clearway draw PROBLEM.cfg [IN.path] [options]", "Draws.");
        line.argument("PROBLEM.cfg", to(problem));
        line.argument("[IN.path]", to(path));
        line.option("--out FILE", "the picture", to(out));
        line.option("--view NAME", "a view", appendedTo(views), CommandLine::Count::kRepeatable);
        line.flag("--short", "less of it", isShort);
        isHelp = !line.parse(words);
    }
};

/// The message with which the words are refused.
std::string refusal(const Arguments& words) {
    return refusalBy([&] { Read read(words); });
}

bool begins(const std::string& text, const std::string& with) {
    return text.compare(0, with.size(), with) == 0;
}

BOOST_AUTO_TEST_CASE(a_value_stands_behind_its_option_or_behind_an_equals_sign) {
    const Read read({"--out", "a.png", "p.cfg", "--view=top", "--short", "in.path", "--view", "a=b"});
    BOOST_TEST(read.out == "a.png");
    BOOST_TEST(read.problem == "p.cfg");
    BOOST_TEST(read.path == "in.path");
    BOOST_TEST(read.views == std::vector<std::string>({"top", "a=b"}), boost::test_tools::per_element());
    BOOST_TEST(read.isShort);
}

BOOST_AUTO_TEST_CASE(an_empty_value_never_takes_the_next_word_in_its_place) {
    const std::string expected = "--out is '', expected a value";
    BOOST_TEST(refusal({"p.cfg", "--out=", "in.path"}) == expected);
    BOOST_TEST(refusal({"p.cfg", "--out="}) == expected);
    BOOST_TEST(refusal({"p.cfg", "--out", ""}) == expected);
    BOOST_TEST(begins(refusal({"p.cfg", "--out"}), "--out has no value"));
    BOOST_TEST(refusal({"p.cfg", "--out", "--short"}) == "--out is '--short', expected a value");
}

BOOST_AUTO_TEST_CASE(an_option_without_a_value_takes_none) {
    for (const char* word : {"--short=yes", "--short=true", "--short="}) {
        BOOST_TEST(begins(refusal({"p.cfg", word}), std::string(word) + " gives a value"), word);
    }
}

BOOST_AUTO_TEST_CASE(unknown_repeated_and_missing_words_are_refused_by_name) {
    BOOST_TEST(begins(refusal({"p.cfg", "--outt", "a"}), "unknown option '--outt'"));
    BOOST_TEST(begins(refusal({"p.cfg", "--ou", "a"}), "unknown option '--ou'"));
    BOOST_TEST(begins(refusal({"p.cfg", "--out", "a", "--out=b"}), "--out is given more than once"));
    BOOST_TEST(begins(refusal({"--short"}), "PROBLEM.cfg is missing"));
    BOOST_TEST(begins(refusal({"a", "b", "c"}), "unexpected argument 'c'"));
}

BOOST_AUTO_TEST_CASE(file_names_are_taken_as_they_stand) {
    BOOST_TEST(Read({"[a,b].cfg", "-x"}).problem == "[a,b].cfg");
    BOOST_TEST(Read({"[a,b].cfg", "-x"}).path == "-x");
    BOOST_TEST(Read({"--short", "--", "-"}).problem == "-");
    BOOST_TEST(Read({"--short", "--", "--p.cfg", "--out"}).path == "--out");
    BOOST_TEST(Read({"p.cfg", "--out=--a.png"}).out == "--a.png");
    BOOST_TEST(Read({"p.cfg", "--out", "-3"}).out == "-3");
    BOOST_TEST(Read({"p.cfg", "-h"}).isHelp);
}

BOOST_AUTO_TEST_CASE(the_second_interrupt_ends_the_program_at_once) {
    const pid_t child = fork();
    BOOST_REQUIRE(child >= 0);
    if (child == 0) {
        heedInterrupts();
        raise(SIGINT);
        if (!isInterrupted()) _exit(1);
        raise(SIGINT);
        _exit(2);
    }
    int status = 0;
    BOOST_REQUIRE(waitpid(child, &status, 0) == child);
    BOOST_TEST(WIFSIGNALED(status));  // a shell's exit code is then 130
    BOOST_TEST(WTERMSIG(status) == SIGINT);
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::testing
