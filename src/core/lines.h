// Text files as lines, and text of a file as a message may quote it.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace clearway {

/// The lines of a file without their ends ("\n" or "\r\n") and without a byte order mark.
/// Throws std::runtime_error, naming the file and what was expected ("a problem file"), when it cannot be
/// read.
std::vector<std::string> readLines(const std::string& file, const char* expected);

/// Without white space at its ends.
std::string_view trimmed(std::string_view text);

/// The runs of characters between white space.
std::vector<std::string_view> words(std::string_view line);

/// "FILE:LINE: ", with which a message about a line begins. Lines count from 1.
std::string place(const std::string& file, int line);

/// 'text' in quotes, cut after 60 characters and with control characters as '?', so that it fits a one-line
/// message.
std::string quote(std::string_view text);

}  // namespace clearway
