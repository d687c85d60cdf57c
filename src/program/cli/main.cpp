// The program clearway: finds the subcommand and runs it.
#include <algorithm>
#include <climits>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

#ifdef __GLIBC__
#include <malloc.h>
#include <sys/mman.h>
#endif

#include "clearway/targets.h"
#include "core/text.h"
#include "program/options/command_line.h"
#include "program/options/help.h"
#include "program/options/program.h"

namespace clearway::cli {

namespace {

/// The subcommands, in the order of --help.
constexpr Subcommand kSubcommands[] = {
    {"init", "writes a problem file for a part and its surroundings, to begin with", init},
    {"info", "shows what a mesh or a problem holds, and its trees", info},
    {"query", "asks for the distance or contact at every pose of a file, and times the queries", query},
    {"plan", "finds a path for the part from the start of a problem to its goal", plan},
    {"check", "audits a path along its whole length: how close it comes, where, and what is not valid",
     check},
    {"bench", "runs a problem's planners several times and writes OMPL's benchmark log", bench},
    {"render", "draws a problem and the part on its way, coloured by clearance, as a picture or a film",
     render},
};

std::string names() {
    return joined(namesOf(kSubcommands));
}

constexpr const char* kUsage = "clearway SUBCOMMAND [arguments]";
constexpr const char* kPurpose = "planning and validity checking for a rigid part in a tight assembly";

void printHelp() {
    std::cout << "clearway: " << kPurpose << "\n\nUsage: " << kUsage << "\n\n";
    for (const Subcommand& subcommand : kSubcommands) {
        const std::string name = subcommand.name;
        std::cout << "  " << name << std::string(8 - std::min<std::size_t>(name.size(), 7), ' ')
                  << subcommand.purpose << "\n";
    }
    std::cout
        << "\n  clearway help SUBCOMMAND     shows its arguments, as clearway SUBCOMMAND --help does\n"
           "  clearway help TOPIC          shows a page about "
        << joined(topicNames(), " or ")
        << "\n"
           "  clearway --man               prints this page for man, clearway SUBCOMMAND --man that of a "
           "subcommand\n"
           "                               (clearway --man | man -l -)\n"
           "  clearway --version           shows the versions of clearway and its libraries\n"
           "  clearway --completion        prints a script that completes words in bash\n\n"
           "Exit codes: 0 done; 1 the answer is no (no path found, or the path is not valid); 2 bad "
           "input or\n"
           "usage, with one line on stderr\n";
}

void printProgramsPage() {
    ManPage page{"clearway", kUsage, kPurpose, "SUBCOMMANDS", {}};
    for (const Subcommand& subcommand : kSubcommands)
        page.rows.emplace_back("clearway " + std::string(subcommand.name), subcommand.purpose);
    page.rows.emplace_back("clearway help SUBCOMMAND", "shows its arguments");
    page.rows.emplace_back("clearway help TOPIC", "shows a page about " + joined(topicNames(), " or "));
    page.rows.emplace_back("clearway --version", "shows the versions of clearway and its libraries");
    page.rows.emplace_back("clearway --completion", "prints a script that completes words in bash");
    printManPage(page);
}

int help(const Arguments& words) {
    if (words.empty()) return printHelp(), kDone;
    if (words.size() > 1)
        throw std::invalid_argument("unexpected argument '" + words[1] + "', expected one topic");
    for (const Subcommand& subcommand : kSubcommands) {
        if (words[0] == subcommand.name) return subcommand.run({"--help"});
    }
    if (const char* text = topicNamed(words[0])) return std::cout << text, kDone;
    std::vector<std::string> known = namesOf(kSubcommands);
    for (const std::string& topic : topicNames()) known.push_back(topic);
    throw std::invalid_argument("unknown topic '" + words[0] + "'" + didYouMean(words[0], known) +
                                ", expected one of " + joined(known));
}

/// Memory that is freed is kept for the next use, and comes in pages of 2 MB where the system has them. Meshes and trees are made
/// in large vectors, one after the other: to get each page anew takes longer than to fill it, above all on virtual machines.
void keepMemory() {
#ifdef __GLIBC__
    constexpr std::size_t kReserved = std::size_t(1) << 30, kHugePage = std::size_t(1) << 21;
    mallopt(M_MMAP_MAX, 0);
    mallopt(M_TRIM_THRESHOLD, INT_MAX);
    mallopt(M_TOP_PAD, 1 << 26);
    void* const reserved = std::malloc(kReserved);  // addresses alone: nothing is written there
    if (!reserved) return;
    const auto begin = (reinterpret_cast<std::uintptr_t>(reserved) + kHugePage - 1) & ~(kHugePage - 1);
    madvise(reinterpret_cast<void*>(begin), kReserved - kHugePage, MADV_HUGEPAGE);
    std::free(reserved);
#endif
}

int run(const Arguments& words) {
    if (words.empty())
        throw std::invalid_argument("no subcommand, expected one of " + names() + ", or --help");
    const Arguments rest(words.begin() + 1, words.end());
    if (words[0] == "--help" || words[0] == "-h") return printHelp(), kDone;
    if (words[0] == "help") return help(rest);
    if (words[0] == "--man") return printProgramsPage(), kDone;
    if (words[0] == "--completion") return std::cout << completionScript(namesOf(kSubcommands)), kDone;
    for (const Subcommand& subcommand : kSubcommands) {
        if (words[0] != subcommand.name) continue;
        currentTarget();                        // refuses CLEARWAY_TARGET before any work
        if (words[0] != "bench") keepMemory();  // which would hide what planners take
        return subcommand.run(rest);
    }
    if (words[0] == "scene") throw std::invalid_argument("scene is a program of its own: clearway-scene");
    std::vector<std::string> known = namesOf(kSubcommands);
    known.insert(known.end(), {"help", "--help", "--man", "--version", "--completion"});
    throw std::invalid_argument("unknown subcommand '" + words[0] + "'" + didYouMean(words[0], known) +
                                ", expected one of " + names() + ", or --help");
}

}  // namespace
}  // namespace clearway::cli

int main(int argc, char** argv) {
    return clearway::cli::runProgram(argc, argv, "clearway", clearway::cli::run);
}
