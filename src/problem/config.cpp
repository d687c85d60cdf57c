// Reads the lines, values and lists of .cfg files, and writes lists.
#include "problem/config.h"

#include <fmt/format.h>
#include <algorithm>
#include <filesystem>

#include "clearway/errors.h"
#include "core/number.h"
#include "core/text.h"
#include "problem/assembly_files.h"

namespace clearway {
namespace {

constexpr char kQuote = '"';

/// The text up to the first such character outside quotes ("..."), or all of it. A quote that is not closed
/// is an ordinary character.
std::string_view beforeUnquoted(std::string_view text, char character) {
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] == character) return text.substr(0, i);
        if (text[i] != kQuote) continue;
        const std::size_t closing = text.find(kQuote, i + 1);
        if (closing != std::string_view::npos) i = closing;
    }
    return text;
}

/// The name as an item of a list, in quotes where necessary. Empty when it cannot be written.
std::optional<std::string> writtenName(const std::string& name) {
    if (name.empty() || name.find_first_of("\"\n\r") != std::string::npos) return std::nullopt;
    const bool isPlain = trimmed(name) == name && name.find_first_of(",#=[]") == std::string::npos;
    return isPlain ? name : kQuote + name + kQuote;
}

}  // namespace

std::optional<std::vector<std::string>> splitNames(std::string_view text) {
    std::vector<std::string> names;
    for (bool isLast = false; !isLast;) {
        const std::string_view whole = beforeUnquoted(text, ',');
        isLast = whole.size() == text.size();
        std::string_view item = trimmed(whole);
        if (item.size() >= 2 && item.front() == kQuote && item.back() == kQuote) {
            item = item.substr(1, item.size() - 2);
        }
        if (item.empty() || item.find(kQuote) != std::string_view::npos) return std::nullopt;
        names.emplace_back(item);
        if (!isLast) text.remove_prefix(whole.size() + 1);
    }
    return names;
}

std::optional<std::string> writtenNames(const std::vector<std::string>& names) {
    std::vector<std::string> all;
    for (const std::string& name : names) {
        const std::optional<std::string> written = writtenName(name);
        if (!written) return std::nullopt;
        all.push_back(*written);
    }
    return joined(all);
}

bool ConfigFile::hasSection(const std::string& name) const {
    return std::any_of(sections.begin(), sections.end(),
                       [&](const ConfigSection& section) { return section.name == name; });
}

ConfigFile readConfigFile(const std::string& file) {
    ConfigFile read;
    std::string prefix;
    int number = 0;
    const char* const expected = "a problem file (.cfg), which clearway init makes of mesh files";
    std::error_code isUnknown;
    if (const std::string word = shapeFileWord(file);
        !word.empty() && std::filesystem::exists(file, isUnknown))
        throw ArgumentError("'" + file + "' is " + word + ", expected " + expected);
    for (const std::string& whole : readLines(file, expected)) {
        ++number;
        const bool hasQuotes = prefix == "clearway.";
        const auto before = [&](std::string_view text, char character) {
            return hasQuotes ? beforeUnquoted(text, character) : text.substr(0, text.find(character));
        };
        const std::string_view line = trimmed(before(whole, '#'));
        if (line.empty()) continue;
        if (line.front() == '[' && line.back() == ']') {
            read.sections.push_back({std::string(trimmed(line.substr(1, line.size() - 2))), number});
            prefix = read.sections.back().name + ".";
            continue;
        }
        const std::size_t equals = before(line, '=').size();
        const std::string_view key = trimmed(line.substr(0, equals));
        if (equals == line.size() || key.empty()) {
            throw ArgumentError(place(file, number) + "the line is " + quote(line) +
                                ", expected [section] or key = value");
        }
        read.entries.push_back(
            {prefix + std::string(key), std::string(trimmed(line.substr(equals + 1))), number});
    }
    return read;
}

std::string sectionOf(const std::string& name) {
    const std::size_t dot = name.find('.');
    return dot == std::string::npos ? "" : name.substr(0, dot);
}

std::string keyOf(const std::string& name) {
    return name.substr(name.find('.') + 1);  // npos + 1 is 0
}

std::string shown(const std::string& name) {
    return "[" + sectionOf(name) + "] " + keyOf(name);
}

ConfigValues::ConfigValues(std::string file, const std::vector<ConfigEntry>& entries,
                           const std::set<std::string>& sections)
    : file_(std::move(file)) {
    for (const ConfigEntry& entry : entries) {
        if (sections.count(sectionOf(entry.name)) == 0) continue;
        const auto [first, isNew] = entries_.insert({entry.name, entry});
        if (isNew) continue;
        throw ArgumentError(fmt::format("{}{} is given again as {}, after {} in line {}, expected once",
                                        place(file_, entry.line), shown(entry.name), quote(entry.value),
                                        quote(first->second.value), first->second.line));
    }
}

std::optional<std::string> ConfigValues::text(const std::string& name) {
    const auto found = entries_.find(name);
    if (found == entries_.end()) return std::nullopt;
    read_.insert(name);
    if (found->second.value.empty()) refuse(name, "a value");
    return found->second.value;
}

std::optional<double> ConfigValues::number(const std::string& name) {
    const std::optional<std::string> value = text(name);
    if (!value) return std::nullopt;
    const std::optional<double> number = parseNumber(*value);
    if (!number) refuse(name, "a finite number");
    return number;
}

std::optional<bool> ConfigValues::flag(const std::string& name) {
    const std::optional<std::string> value = text(name);
    if (!value) return std::nullopt;
    for (const char* yes : {"1", "true", "yes", "on"}) {
        if (*value == yes) return true;
    }
    for (const char* no : {"0", "false", "no", "off"}) {
        if (*value == no) return false;
    }
    refuse(name, "1, true, yes, on, 0, false, no or off");
}

std::string ConfigValues::requiredText(const std::string& name, const std::string& expected) {
    if (!has(name)) refuseMissing(name, expected);
    return *text(name);
}

double ConfigValues::requiredNumber(const std::string& name, const std::string& expected) {
    if (!has(name)) refuseMissing(name, expected);
    return *number(name);
}

void ConfigValues::refuse(const std::string& name, const std::string& expected) const {
    const ConfigEntry& entry = entries_.at(name);
    throw ArgumentError(placeOf(name) + shown(name) + " is " + quote(entry.value) + ", expected " + expected);
}

/// Names an entry that is probably meant to be a missing one: in another section, or misspelt.
std::string ConfigValues::insteadOf(const std::string& name) const {
    for (const ConfigEntry& entry : unread()) {
        const bool isSameKey = keyOf(entry.name) == keyOf(name);
        const bool isNear =
            sectionOf(entry.name) == sectionOf(name) && !didYouMean(keyOf(entry.name), {keyOf(name)}).empty();
        if (isSameKey || isNear)
            return fmt::format(" (is {} in line {} meant?)", shown(entry.name), entry.line);
    }
    return "";
}

void ConfigValues::refuseMissing(const std::string& name, const std::string& expected) const {
    throw ArgumentError(file_ + ": " + shown(name) + " is missing" + insteadOf(name) + ", expected " +
                        expected);
}

std::vector<ConfigEntry> ConfigValues::unread() const {
    std::vector<ConfigEntry> rest;
    for (const auto& [name, entry] : entries_) {
        if (read_.count(name) == 0) rest.push_back(entry);
    }
    std::sort(rest.begin(), rest.end(),
              [](const ConfigEntry& a, const ConfigEntry& b) { return a.line < b.line; });
    return rest;
}

}  // namespace clearway
