// Writes files that appear whole or not at all: under a temporary name in the same folder, then renamed.
#pragma once

#include <functional>
#include <iosfwd>
#include <string>

namespace clearway {

/// Calls `write` with a stream to a temporary file (file + ".<number>.tmp"), then renames this file to
/// `file`, replacing an existing one. Throws std::runtime_error naming the file when it cannot be written.
/// After any exception, including one from `write`, the temporary file is gone and an existing file is
/// unchanged.
void replaceFile(const std::string& file, const std::function<void(std::ostream&)>& write);

/// Throws what replaceFile would throw before it calls `write`. Call it before long work, so that a file that
/// cannot be written is reported at once.
void requireReplaceable(const std::string& file);

/// Makes the folder and its parents unless they exist. Throws std::runtime_error naming the folder when it
/// cannot be made.
void makeFolder(const std::string& folder);

}  // namespace clearway
