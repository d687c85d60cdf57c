// The syntax of .cfg files: sections in brackets and lines `key = value`, where # begins a comment anywhere
// in a line (in [clearway] not within quotes). Here too: strictly read values, and lists of names such as: a,
// b c, "with, a comma".
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "core/text.h"

// clearway::planning uses it too, from another shared library.
#pragma GCC visibility push(default)

namespace clearway {

/// The names of the coordinates in keys such as "start.x".
constexpr const char* kAxisNames[] = {"x", "y", "z"};

struct ConfigEntry {
    std::string name;   ///< section and key, "problem.start.x"; before the first section the key alone
    std::string value;  ///< may be empty
    int line = 0;       ///< counted from 1
};

struct ConfigSection {
    std::string name;
    int line = 0;
};

struct ConfigFile {
    std::vector<ConfigEntry> entries;
    std::vector<ConfigSection> sections;  ///< one for each line in brackets, also where no entry follows

    bool hasSection(const std::string& name) const;
};

/// All entries and sections in the file's order. Throws FileError when the file cannot be read, and
/// ArgumentError, naming the line, when a line is neither a section nor key = value.
ConfigFile readConfigFile(const std::string& file);

/// The parts of a name: "problem" and "start.x" for "problem.start.x". A name without a dot is a key in no
/// section.
std::string sectionOf(const std::string& name);
std::string keyOf(const std::string& name);

/// A name as messages show it: "[problem] start.x".
std::string shown(const std::string& name);

/// The values of sections in which each key may stand once. Remembers which values have been read.
class ConfigValues {
  public:
    /// Takes the entries of the named sections. Throws ArgumentError when a key stands twice.
    ConfigValues(std::string file, const std::vector<ConfigEntry>& entries,
                 const std::set<std::string>& sections);

    bool has(const std::string& name) const { return entries_.count(name) > 0; }

    /// The value of a key; empty when the key is missing. Throws ArgumentError naming the file, the
    /// line, the key and its value when the value is empty or, for number(), not a finite number.
    std::optional<std::string> text(const std::string& name);
    std::optional<double> number(const std::string& name);

    /// The value of a key. Throws as text() and number() do, and also ArgumentError naming the key
    /// when it is missing. expected: a description of the value, for the message.
    std::string requiredText(const std::string& name, const std::string& expected);
    double requiredNumber(const std::string& name, const std::string& expected);

    /// True for 1, true, yes and on; false for 0, false, no and off; empty when the key is missing. Throws
    /// ArgumentError for other values.
    std::optional<bool> flag(const std::string& name);

    /// Throws ArgumentError: the key's value is wrong.
    [[noreturn]] void refuse(const std::string& name, const std::string& expected) const;

    /// "p.cfg:7: ", for messages about a key that is there.
    std::string placeOf(const std::string& name) const { return place(file_, entries_.at(name).line); }

    /// The entries that have not been read, in the file's order.
    std::vector<ConfigEntry> unread() const;

  private:
    std::string insteadOf(const std::string& name) const;
    [[noreturn]] void refuseMissing(const std::string& name, const std::string& expected) const;

    std::string file_;
    std::map<std::string, ConfigEntry> entries_;
    std::set<std::string> read_;
};

/// The items of a list between commas, without white space at their ends and without the quotes around them.
/// Empty when an item is empty or has a quote in another place.
std::optional<std::vector<std::string>> splitNames(std::string_view text);

/// The names as a list that splitNames reads back, each in quotes where necessary. Empty when a name cannot
/// be written.
std::optional<std::string> writtenNames(const std::vector<std::string>& names);

}  // namespace clearway

#pragma GCC visibility pop
