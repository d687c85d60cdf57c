// Lists of names as a .cfg writes them: a, b c, "with, a comma".
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace clearway {

/// The text up to the first of the characters outside quotes ("..."), or all of it. A quote that is not
/// closed is a character like any other.
std::string_view beforeUnquoted(std::string_view text, char character);

/// The items between commas, without white space at their ends and without quotes around them. Nothing when
/// one is empty or has a quote anywhere else.
std::optional<std::vector<std::string>> splitNames(std::string_view text);

/// The name as splitNames takes it, in quotes where it must be. Nothing when it cannot be written.
std::optional<std::string> writtenName(const std::string& name);

/// Likewise of all.
std::optional<std::string> writtenNames(const std::vector<std::string>& names);

}  // namespace clearway
