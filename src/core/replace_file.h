// Writes files that appear whole or not at all: under a temporary name in the same folder, then renamed.
#pragma once

#include <functional>
#include <iosfwd>
#include <optional>
#include <string>

namespace clearway {

/// Calls `write` with a stream to a temporary file (file + ".<number>.tmp"), waits until the disk holds this file,
/// and renames it to `file`. An existing file is replaced and its mode kept; a link stays, and the file that it leads
/// to is replaced or made. Throws FileError naming the file when it cannot be written.
/// After any exception, including one from `write`, the temporary file is gone and an existing file is
/// unchanged.
void replaceFile(const std::string& file, const std::function<void(std::ostream&)>& write);

/// As replaceFile, for writers that open the file themselves: `write` gets the name of the temporary file and
/// tells whether it is complete. If not, an existing file is unchanged. Returns what `write` told.
bool replaceFileByName(const std::string& file,
                       const std::function<bool(const std::string& temporary)>& write);

/// Throws what replaceFile would throw before it calls `write`: when the name is that of a folder, a device,
/// a pipe or a stream of a process such as /dev/stdout, wherever that leads to, or no file can be made beside
/// it. Call it before long work, so that a file that cannot be written is reported at once.
void requireReplaceable(const std::string& file);

/// Renames a regular file to file.old or, where that name is taken, to the first of file.old.2, file.old.3,
/// ... that is not: no file is overwritten. A symbolic link stays, and the file that it leads to is renamed. Returns the
/// new name; nothing when there is no such file. Throws FileError naming the file when it cannot be
/// renamed.
std::optional<std::string> setAside(const std::string& file);

/// Makes the folder and its parents unless they exist. Throws FileError naming the folder when it
/// cannot be made.
void makeFolder(const std::string& folder);

/// Whether both names mean one file, which need not exist yet: ./a.html and a.html.
bool isSameFile(const std::string& a, const std::string& b);

}  // namespace clearway
