// The main function that the programs share.
#pragma once

#include <functional>

#include "program/options/command_line.h"

namespace clearway::cli {

/// Calls `run` with the words after the program's name, and writes the facts; or prints versions, if the first word is --version.
/// Turns what `run` throws into one line on stderr. Returns the exit code.
int runProgram(int argc, char** argv, const char* name, int (*run)(const Arguments& words));

/// Ends the process with the exit code that `run` returns, once the facts are written, as runProgram does, whatever the other
/// threads are doing.
[[noreturn]] void leaveProgram(const char* name, const std::function<int()>& run);

/// Tells that an interrupt has ended the program while it loaded its files. Returns the exit code.
int tellCutLoading();

}  // namespace clearway::cli
