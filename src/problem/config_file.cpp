#include "problem/config_file.h"

#include <stdexcept>

#include "core/text.h"
#include "problem/name_lists.h"

namespace clearway {

std::vector<ConfigEntry> readConfigFile(const std::string& file) {
    std::vector<ConfigEntry> entries;
    std::string prefix;
    int number = 0;
    for (const std::string& whole : readLines(file, "a problem file (.cfg)")) {
        ++number;
        const bool hasQuotes = prefix == "clearway.";
        const auto before = [&](std::string_view text, char character) {
            return hasQuotes ? beforeUnquoted(text, character) : text.substr(0, text.find(character));
        };
        const std::string_view line = trimmed(before(whole, '#'));
        if (line.empty()) continue;
        if (line.front() == '[' && line.back() == ']') {
            prefix = std::string(trimmed(line.substr(1, line.size() - 2))) + ".";
            continue;
        }
        const std::size_t equals = before(line, '=').size();
        const std::string_view key = trimmed(line.substr(0, equals));
        if (equals == line.size() || key.empty()) {
            throw std::invalid_argument(place(file, number) + "the line is " + quote(line) +
                                        ", expected [section] or key = value");
        }
        entries.push_back({prefix + std::string(key), std::string(trimmed(line.substr(equals + 1))), number});
    }
    return entries;
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

}  // namespace clearway
