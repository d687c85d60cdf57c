// The options that say how trees are built.
#pragma once

#include <optional>
#include <string>

#include "clearway/model.h"
#include "program/cli/command_line.h"

namespace clearway::cli {

/// Declares --preset, --general-split, --leaf-split, --fit, --leaf-size and --node-width.
void addTreeOptions(CommandLine& commandLine);

/// What was asked for, the preset's values or the defaults for the rest. Throws std::invalid_argument that
/// names the option, its value and the known ones.
BuildOptions treeOptions(const Options& options);

/// Declares --cache.
void addCacheOption(CommandLine& commandLine);

/// The folder of --cache, made or found to be writable; empty without it. Throws std::runtime_error when it
/// is no folder.
std::string cacheFolder(const Options& options);

/// The mesh's model, from the cache folder when one is given. A file there that cannot be used is replaced,
/// with a warning on stderr.
Model buildModel(const Mesh& mesh, const BuildOptions& options, const std::string& cacheFolder,
                 const std::optional<Reach>& reach = std::nullopt);

/// "sah, fitted by frames, leaves of up to 4 split by none, 8 wide".
std::string description(const BuildOptions& options);

}  // namespace clearway::cli
