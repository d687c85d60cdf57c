// The lines of a .cfg: sections in brackets, key = value, # begins a comment anywhere in a line; in
// [clearway] not within quotes.
#pragma once

#include <string>
#include <vector>

namespace clearway {

struct ConfigEntry {
    std::string name;   ///< section and key, "problem.start.x"; before the first section the key alone
    std::string value;  ///< may be empty
    int line = 0;       ///< counted from 1
};

/// In the file's order. Throws std::runtime_error when the file cannot be read and std::invalid_argument,
/// naming the line, when one is neither a section nor key = value.
std::vector<ConfigEntry> readConfigFile(const std::string& file);

/// "problem" of "problem.start.x" and "start.x", its rest; a name without a dot is a key in no section.
std::string sectionOf(const std::string& name);
std::string keyOf(const std::string& name);

/// As messages show a name: "[problem] start.x".
std::string shown(const std::string& name);

}  // namespace clearway
