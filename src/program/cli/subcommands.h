// The subcommands of the program: one file each, one row each in main.cpp.
#pragma once

#include <string>
#include <vector>

namespace clearway::cli {

using Arguments = std::vector<std::string>;  ///< what follows the subcommand's name

/// Exit codes of the program. Every subcommand returns one of the first two; kBadInput is what main makes of
/// an exception, whose message it prints as one line on stderr.
constexpr int kDone = 0;
constexpr int kAnswerIsNo = 1;  ///< no path found, path not valid
constexpr int kBadInput = 2;

struct Subcommand {
    const char* name;
    const char* purpose;  ///< one line for --help
    int (*run)(const Arguments& arguments);
};

int info(const Arguments& arguments);
int query(const Arguments& arguments);
int scene(const Arguments& arguments);
int plan(const Arguments& arguments);
int check(const Arguments& arguments);
int render(const Arguments& arguments);
int bench(const Arguments& arguments);

}  // namespace clearway::cli
