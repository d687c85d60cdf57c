// Refuses what is no mesh file, in one line that says what, why and what was expected.
#pragma once

#include <string>

namespace clearway {

/// Throws std::runtime_error. reason: may be a reader's own words, with several lines and a full stop.
[[noreturn]] void refuseMeshFile(const std::string& file, std::string reason);

/// Refuses a file that is missing, a folder, not to be opened or empty, a PLY file cut within its header, and an
/// OFF file whose header states more than the file can hold.
void requireReadableMeshFile(const std::string& file);

}  // namespace clearway
