// Refuses what is no mesh file, in one line that says what, why and what was expected.
#pragma once

#include <string>

namespace clearway {

/// Throws std::runtime_error. reason: may be a reader's own words, with several lines and a full stop.
[[noreturn]] void refuseMeshFile(const std::string& file, std::string reason);

/// Refuses a file that is missing, a folder, not to be opened, empty, or a PLY file cut within its header.
void requireReadableMeshFile(const std::string& file);

}  // namespace clearway
