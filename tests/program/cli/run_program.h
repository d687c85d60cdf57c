// Runs the program clearway, or another one, in a folder and catches what it prints.
#pragma once

#include <sys/wait.h>

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <csignal>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "support/temporary_folder.h"
#include "support/words.h"

namespace clearway::testing {

constexpr const char* kProgram = CLEARWAY_PROGRAM;
constexpr const char* kSceneProgram = CLEARWAY_PROGRAM "-scene";
constexpr const char* kStudyProgram = CLEARWAY_PROGRAM "-study";

struct Outcome {
    int code = -1;  ///< exit code; -1 when the program did not end by itself
    std::string out;
    std::string err;
};

/// Runs the program in the folder. arguments: as a shell takes them; may redirect standard output.
inline Outcome runIn(const TemporaryFolder& folder, const std::string& arguments,
                     const std::string& program = kProgram) {
    const TemporaryFolder caught;
    const std::string command = "cd '" + folder.path() + "' && " + program + " 2> '" + caught.file("err") +
                                "' > '" + caught.file("out") + "' " + arguments;
    const int status = std::system(command.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, readText(caught.file("out")),
            readText(caught.file("err"))};
}

/// Runs the program until it is sent SIGINT, after more and more time: on a busy machine it may still be
/// starting. The signal is sent once: a second one would end the program at once.
inline Outcome interruptIn(const TemporaryFolder& folder, const std::string& arguments,
                           const std::string& program = kProgram) {
    constexpr int kEndedBySignal = 128 + SIGINT;
    const TemporaryFolder caught;
    Outcome outcome;
    outcome.code = kEndedBySignal;
    for (int seconds = 1; outcome.code == kEndedBySignal && seconds < 100; seconds *= 2) {
        const std::string command = "cd '" + folder.path() +
                                    "' && timeout --foreground --preserve-status -s INT " +
                                    std::to_string(seconds) + " " + program + " " + arguments + " > '" +
                                    caught.file("out") + "' 2> '" + caught.file("err") + "'";
        const int status = std::system(command.c_str());
        outcome = {WIFEXITED(status) ? WEXITSTATUS(status) : -1, readText(caught.file("out")),
                   readText(caught.file("err"))};
    }
    return outcome;
}

/// The JSON that the program writes to standard output. Checks the exit code, and that nothing else is printed.
inline nlohmann::json factsOf(const TemporaryFolder& folder, const std::string& arguments, int code = 0,
                              const std::string& program = kProgram) {
    const Outcome outcome = runIn(folder, arguments + " --json -", program);
    BOOST_TEST_REQUIRE(outcome.code == code, arguments << " said: " << outcome.err);
    return nlohmann::json::parse(outcome.out);
}

/// The JSON of a file in the folder.
inline nlohmann::json jsonIn(const TemporaryFolder& folder, const std::string& file) {
    return nlohmann::json::parse(readText(folder.file(file)));
}

/// The value of a "label:  value" row; the first row if there are several.
inline std::string row(const Outcome& outcome, const std::string& label) {
    const std::string text = "\n" + outcome.out;
    const std::size_t begin = text.find("\n" + label + ":");
    BOOST_TEST_REQUIRE(begin != std::string::npos, "no row '" << label << "' in:" << text);
    const std::size_t value = text.find_first_not_of(' ', begin + label.size() + 2);
    return text.substr(value, text.find('\n', value) - value);
}

/// Checks that bad input or usage gives exit code 2 and exactly one line on stderr that holds all the words,
/// and neither adds nor removes a file.
inline void requireRefused(const TemporaryFolder& folder, const std::string& arguments,
                           const std::vector<std::string>& words, const std::string& program = kProgram) {
    const std::vector<std::string> before = folder.names();
    const Outcome outcome = runIn(folder, arguments, program);
    BOOST_TEST(outcome.code == 2, "exit code " << outcome.code << " of: " << arguments);
    BOOST_TEST(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 1,
               arguments << " said: " << outcome.err);
    const std::string name = program.substr(program.find_last_of('/') + 1) + ": ";
    BOOST_TEST(outcome.err.compare(0, name.size(), name) == 0, arguments << " said: " << outcome.err);
    for (const std::string& word : words) {
        BOOST_TEST(holds(outcome.err, word),
                   "no \"" << word << "\" in what " << arguments << " said: " << outcome.err);
    }
    BOOST_TEST(folder.names() == before, boost::test_tools::per_element());
}

/// A closed box with its corners at low and high, as the text of an .obj file.
inline std::string boxObj(double low, double high, const std::string& name = "box") {
    std::string text = "o " + name + "\n";
    for (int corner = 0; corner < 8; ++corner) {
        text += "v";
        for (int axis = 0; axis < 3; ++axis) text += " " + std::to_string(corner >> axis & 1 ? high : low);
        text += "\n";
    }
    return text +
           "f 1 3 4\nf 1 4 2\nf 5 6 8\nf 5 8 7\nf 1 2 6\nf 1 6 5\nf 3 7 8\nf 3 8 4\nf 1 5 7\nf 1 7 3\nf 2 4 "
           "8\nf 2 8 6\n";
}

}  // namespace clearway::testing
