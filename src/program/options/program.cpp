#include "program/options/program.h"

#include <csignal>
#include <cstdlib>
#include <exception>
#include <iostream>

#include "clearway/shrink.h"
#include "clearway/targets.h"
#include "clearway/version.h"
#include "program/options/facts.h"
#include "program/options/help.h"
#include "program/options/print.h"

namespace clearway::cli {

namespace {

int printVersion(const char* name) {
    std::cout << name << " " CLEARWAY_VERSION "\n";
    printRow("instruction set", currentTarget());
    for (const auto& [library, version] : libraryVersions()) printRow(library, version);
    return kDone;
}

int finish(int code) {
    writeFacts();
    requirePrinted();
    return code;
}

int refuse(const char* name, const std::string& why) {
    std::cout.flush();
    std::cerr << name + (": " + oneLine(why)) + "\n";  // at once: mpirun mixes what its ranks write
    return kBadInput;
}

/// Runs to the end. Turns what is thrown into a row or a line on stderr.
int guarded(const char* name, const std::function<int()>& run) {
    try {
        return finish(run());
    } catch (const ShrinkStopped& stopped) {
        printRow("interrupted", std::string(stopped.what()) + "; nothing is written");
        facts()["interrupted"] = true;
        return finish(kAnswerIsNo);
    } catch (const std::exception& error) {
        return refuse(name, error.what());
    }
}

}  // namespace

int runProgram(int argc, char** argv, const char* name, int (*run)(const Arguments& words)) {
    // A closed pipe and a file that may not grow become errors to report, instead of ending the program.
    std::signal(SIGPIPE, SIG_IGN);
    std::signal(SIGXFSZ, SIG_IGN);
    const Arguments words(argv + 1, argv + argc);
    const bool isVersion = !words.empty() && words[0] == "--version";
    return guarded(name, [&] { return isVersion ? printVersion(name) : run(words); });
}

void leaveProgram(const char* name, const std::function<int()>& run) {
    const int code = guarded(name, run);
    std::cout.flush();
    std::_Exit(code);
}

int tellCutLoading() {
    printRow("interrupted", "while files were loaded; nothing is written");
    facts()["interrupted"] = true;
    return kAnswerIsNo;
}

}  // namespace clearway::cli
