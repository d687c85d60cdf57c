// The values of a .cfg's sections where each key may stand once, read strictly and crossed off as they are
// read.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "problem/config_file.h"

namespace clearway {

class ConfigValues {
  public:
    /// Takes the entries of the named sections. Throws std::invalid_argument when a key stands twice.
    ConfigValues(std::string file, const std::vector<ConfigEntry>& entries,
                 const std::set<std::string>& sections);

    bool has(const std::string& name) const { return entries_.count(name) > 0; }

    /// Nothing when the key is not there. Throws std::invalid_argument naming the file, the line, the key and
    /// its value when the value is empty or no finite number.
    std::optional<std::string> text(const std::string& name);
    std::optional<double> number(const std::string& name);

    /// The same, and throws std::invalid_argument naming the key when it is not there. expected: what it
    /// should be.
    std::string requiredText(const std::string& name, const std::string& expected);
    double requiredNumber(const std::string& name, const std::string& expected);

    /// 1, true, yes or on; 0, false, no or off. Throws likewise.
    std::optional<bool> flag(const std::string& name);

    /// Throws std::invalid_argument: the key's value is wrong.
    [[noreturn]] void refuse(const std::string& name, const std::string& expected) const;

    /// What nobody asked for, in the file's order.
    std::vector<ConfigEntry> unread() const;

  private:
    [[noreturn]] void refuseMissing(const std::string& name, const std::string& expected) const;

    std::string file_;
    std::map<std::string, ConfigEntry> entries_;
    std::set<std::string> read_;
};

}  // namespace clearway
