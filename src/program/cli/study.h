// clearway bench --study: planner runs and replays by the hundred that answer one question.
#pragma once

#include "program/cli/subcommands.h"

namespace clearway::cli {

/// arguments: those of bench, with --study among them.
int study(const Arguments& arguments);

}  // namespace clearway::cli
