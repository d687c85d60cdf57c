// Text in files and in messages: lines, words, quotes, lists of names, and tables whose rows have names.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "clearway/errors.h"

// clearway::planning uses it too, from another shared library.
#pragma GCC visibility push(default)

namespace clearway {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";  ///< of UTF-8

/// The lines of a file without their ends ("\n" or "\r\n") and without a byte order mark. Throws
/// FileError when the file cannot be read; the message names the file and what was expected ("a
/// problem file").
std::vector<std::string> readLines(const std::string& file, const char* expected);

/// The text without white space at its ends.
std::string_view trimmed(std::string_view text);

/// The runs of characters between white space.
std::vector<std::string_view> words(std::string_view line);

/// "FILE:LINE: ", the start of a message about a line. Lines count from 1.
std::string place(const std::string& file, int line);

/// The text in single quotes for a one-line message: cut after 60 characters, with control characters as '?'.
std::string quote(std::string_view text);

/// All texts with the separator between them: "a, b, c".
std::string joined(const std::vector<std::string>& texts, const std::string& separator = ", ");

/// " (did you mean 'NAME'?)" for the name that takes the fewest letters to change, insert, leave out or swap, if these are
/// at most a third of the word's; without one, for a name that the word begins with ("in" for "inch"); otherwise empty.
/// Upper and lower case are alike. Parts between dots that word and name share do not count: "start.w" is not near
/// "start.x".
std::string didYouMean(std::string_view word, const std::vector<std::string>& names);

/// The names of a table's rows, in order.
template <class Table>
std::vector<std::string> namesOf(const Table& table) {
    std::vector<std::string> names;
    for (const auto& row : table) names.emplace_back(row.name);
    return names;
}

/// The table's row of this name. Otherwise throws ArgumentError, which lists the table's names:
/// "WHAT is 'NAME' (did you mean 'A'?), expected one of A, B, C".
template <class Table>
const auto& rowNamed(const Table& table, const std::string& what, const std::string& name) {
    for (const auto& row : table) {
        if (name == row.name) return row;
    }
    throw ArgumentError(what + " is " + quote(name) + didYouMean(name, namesOf(table)) +
                        ", expected one of " + joined(namesOf(table)));
}

}  // namespace clearway

#pragma GCC visibility pop
