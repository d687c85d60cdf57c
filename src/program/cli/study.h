// clearway bench --study.
#pragma once

#include "program/cli/command_line.h"
#include "program/study/ranks.h"

namespace clearway::cli {

/// arguments: the words after `bench`. ranks: null unless mpirun started this process. Returns the exit code, or throws as a
/// subcommand does.
int benchStudy(const Arguments& arguments, study::Ranks* ranks);

}  // namespace clearway::cli
