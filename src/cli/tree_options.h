// The options that say how trees are built.
#pragma once

#include "clearway/build_options.h"
#include "cli/command_line.h"

namespace clearway {

/// Declares --general-split, --leaf-split, --leaf-size and --node-width.
void addTreeOptions(CommandLine& commandLine);

/// What was asked for, the defaults for the rest. Throws std::invalid_argument that names the option, its
/// value and the known ones.
BuildOptions treeOptions(const Options& options);

/// "axis, leaves of up to 4 split by none, 8 wide".
std::string description(const BuildOptions& options);

}  // namespace clearway
