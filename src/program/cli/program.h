// The main function that the programs share.
#pragma once

#include "program/cli/command_line.h"

namespace clearway::cli {

/// Calls `run` with the words after the program's name, and writes the facts; or prints versions, if the first word is --version.
/// Turns what `run` throws into one line on stderr. Returns the exit code.
int runProgram(int argc, char** argv, const char* name, int (*run)(const Arguments& words));

}  // namespace clearway::cli
