#include "problem/config_values.h"

#include <algorithm>
#include <stdexcept>

#include "core/number.h"
#include "core/text.h"

namespace clearway {

ConfigValues::ConfigValues(std::string file, const std::vector<ConfigEntry>& entries,
                           const std::set<std::string>& sections)
    : file_(std::move(file)) {
    for (const ConfigEntry& entry : entries) {
        if (sections.count(sectionOf(entry.name)) == 0) continue;
        const auto [first, isNew] = entries_.insert({entry.name, entry});
        if (isNew) continue;
        throw std::invalid_argument(place(file_, entry.line) + shown(entry.name) + " is given again as " +
                                    quote(entry.value) + ", after " + quote(first->second.value) +
                                    " in line " + std::to_string(first->second.line) + ", expected once");
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
    throw std::invalid_argument(place(file_, entry.line) + shown(name) + " is " + quote(entry.value) +
                                ", expected " + expected);
}

void ConfigValues::refuseMissing(const std::string& name, const std::string& expected) const {
    throw std::invalid_argument(file_ + ": " + shown(name) + " is missing, expected " + expected);
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
