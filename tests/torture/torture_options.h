// What the torture program can be told.
#pragma once

#include <optional>

#include "torture/runs.h"

namespace clearway::testing {

/// Nothing when help was asked for and printed. Throws std::invalid_argument naming a value that is wrong and
/// what was expected, std::runtime_error when the CSV cannot be written.
std::optional<TortureOptions> readOptions(int argc, char** argv);

}  // namespace clearway::testing
