// The options that say how trees are built.
#pragma once

#include "clearway/build_options.h"
#include "cli/command_line.h"

namespace clearway {

/// Declares --preset, --general-split, --leaf-split, --fit, --leaf-size and --node-width.
void addTreeOptions(CommandLine& commandLine);

/// What was asked for, the preset's values or the defaults for the rest. Throws std::invalid_argument that
/// names the option, its value and the known ones.
BuildOptions treeOptions(const Options& options);

/// "sah, fitted by frames, leaves of up to 4 split by none, 8 wide".
std::string description(const BuildOptions& options);

}  // namespace clearway
