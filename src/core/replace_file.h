// Files appear whole or not at all: written under a temporary name in the same folder, then renamed.
#pragma once

#include <functional>
#include <iosfwd>
#include <string>

namespace clearway {

/// Calls write with a stream to a temporary file (file + ".<number>.tmp"), then renames it to file, replacing
/// what was there. Throws std::runtime_error naming the file when it cannot be written; then, and when write
/// throws, the temporary file is removed and what was there before is untouched.
void replaceFile(const std::string& file, const std::function<void(std::ostream&)>& write);

/// Throws what replaceFile would throw before calling write: for saying so before long work rather than
/// after.
void requireReplaceable(const std::string& file);

/// Makes the folder, and those it is in, unless it is there. Throws std::runtime_error naming it when it
/// cannot.
void makeFolder(const std::string& folder);

}  // namespace clearway
