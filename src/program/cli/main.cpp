// The clearway program: finds the subcommand, runs it, and turns what it throws into one line on stderr.
#include <algorithm>
#include <csignal>
#include <exception>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/text.h"
#include "program/cli/command_line.h"
#include "program/cli/print.h"

namespace clearway::cli {

namespace {

/// The subcommands, in the order of --help.
constexpr Subcommand kSubcommands[] = {
    {"info", "shows what a mesh or a problem holds, and its trees", info},
    {"query", "asks for the distance or contact at every pose of a file, and times the queries", query},
    {"plan", "finds a path for the part from the start of a problem to its goal", plan},
    {"check", "audits a path along its whole length: how close it comes, where, and what is not valid",
     check},
    {"bench", "runs a problem's planners several times and writes OMPL's benchmark log", bench},
    {"render", "draws a problem and the part on its way, coloured by clearance, as a PNG file", render},
    {"scene", "makes a demo scene: two meshes, a problem and a path that solves it", scene},
};

std::string names() {
    std::vector<std::string> all;
    for (const Subcommand& subcommand : kSubcommands) all.push_back(subcommand.name);
    return joined(all);
}

void printHelp() {
    std::cout << "clearway: planning and validity checking for a rigid part in a tight assembly\n\n"
                 "Usage: clearway SUBCOMMAND [arguments]\n\n";
    for (const Subcommand& subcommand : kSubcommands) {
        const std::string name = subcommand.name;
        std::cout << "  " << name << std::string(8 - std::min<std::size_t>(name.size(), 7), ' ')
                  << subcommand.purpose << "\n";
    }
    std::cout << "\n  clearway SUBCOMMAND --help   shows its arguments\n"
                 "  clearway --version           shows the version\n\n"
                 "Exit codes: 0 done; 1 the answer is no (no path found, or the path is not valid); 2 bad "
                 "input or\n"
                 "usage, with one line on stderr\n";
}

int run(const Arguments& words) {
    if (words.empty())
        throw std::invalid_argument("no subcommand, expected one of " + names() + ", or --help");
    if (words[0] == "--help" || words[0] == "-h") return printHelp(), kDone;
    if (words[0] == "--version") return std::cout << "clearway " CLEARWAY_VERSION "\n", kDone;
    for (const Subcommand& subcommand : kSubcommands) {
        if (words[0] == subcommand.name) return subcommand.run({words.begin() + 1, words.end()});
    }
    throw std::invalid_argument("unknown subcommand '" + words[0] + "', expected one of " + names() +
                                ", or --help");
}

}  // namespace
}  // namespace clearway::cli

int main(int argc, char** argv) {
    // A closed pipe and a file that may not grow become errors to report, instead of ending the program.
    std::signal(SIGPIPE, SIG_IGN);
    std::signal(SIGXFSZ, SIG_IGN);
    const clearway::cli::Arguments words(argv + 1, argv + argc);
    try {
        const int code = clearway::cli::run(words);
        clearway::cli::requirePrinted();
        return code;
    } catch (const std::exception& error) {
        std::cout.flush();
        std::cerr << "clearway: " << clearway::cli::oneLine(error.what()) << "\n";
        return clearway::cli::kBadInput;
    }
}
