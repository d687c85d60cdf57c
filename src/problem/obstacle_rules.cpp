// Reads and writes the rules for obstacles.
#include "problem/obstacle_rules.h"

#include <cmath>
#include <stdexcept>

#include "core/number.h"
#include "core/text.h"

namespace clearway {
namespace {

constexpr const char* kMarginOf = "clearway.margin.";
constexpr const char* kNames = "names, separated by commas";
constexpr const char* kAll = "all";

std::vector<std::string> readNames(ConfigValues& values, const std::string& key) {
    const std::optional<std::string> text = values.text(key);
    if (!text) return {};
    const std::optional<std::vector<std::string>> names = splitNames(*text);
    if (!names) values.refuse(key, kNames);
    return *names;
}

std::optional<ContactRule> readContact(ConfigValues& values, const std::string& key) {
    if (!values.has(key)) return std::nullopt;
    ContactRule contact;
    contact.names = readNames(values, key);
    const std::optional<double> distance = parseNumber(contact.names.back());
    if (contact.names.size() < 2 || !distance || !(*distance > 0)) {
        values.refuse(key, "names and a length above 0, separated by commas");
    }
    contact.names.pop_back();
    contact.distance = *distance;
    return contact;
}

void readMargins(ConfigValues& values, std::map<std::string, double>& margins) {
    const std::string prefix = kMarginOf;
    for (const ConfigEntry& entry : values.unread()) {
        if (entry.name.compare(0, prefix.size(), prefix) != 0) continue;
        const auto names = splitNames(std::string_view(entry.name).substr(prefix.size()));
        const double margin = values.number(entry.name).value_or(-1);
        if (!(margin >= 0)) values.refuse(entry.name, "a number of at least 0");
        if (!names || names->size() != 1 || !margins.insert({names->front(), margin}).second) {
            values.refuse(entry.name,
                          "margin.NAME = M with each name once, and a name that has a comma in quotes");
        }
    }
}

std::string namesOf(const std::string& key, const std::vector<std::string>& names) {
    const std::optional<std::string> written = writtenNames(names);
    if (written && !written->empty()) return *written;
    throw std::invalid_argument(key +
                                " has a name that is empty or contains a quote or a line end, expected "
                                "a name without these");
}

void addContact(const std::string& key, const std::optional<ContactRule>& contact,
                std::vector<std::pair<std::string, std::string>>& lines) {
    if (!contact) return;
    if (!(contact->distance > 0) || !std::isfinite(contact->distance)) {
        throw std::invalid_argument(key + " has the length " + shortNumber(contact->distance) +
                                    ", expected a finite length above 0");
    }
    lines.emplace_back(key, namesOf(key, contact->names) + ", " + formatNumber(contact->distance));
}

}  // namespace

ObstacleRules readObstacleRules(ConfigValues& values) {
    ObstacleRules rules;
    readMargins(values, rules.margins);
    rules.ignored = readNames(values, "clearway.ignore");
    rules.isAllSolid = values.has("clearway.solid") && *values.text("clearway.solid") == kAll;
    if (!rules.isAllSolid) rules.solid = readNames(values, "clearway.solid");
    rules.startContact = readContact(values, "clearway.contact.start");
    rules.goalContact = readContact(values, "clearway.contact.goal");
    return rules;
}

std::vector<std::pair<std::string, std::string>> writtenRules(const ObstacleRules& rules) {
    std::vector<std::pair<std::string, std::string>> lines;
    for (const auto& [name, margin] : rules.margins) {
        if (!(margin >= 0) || !std::isfinite(margin)) {
            throw std::invalid_argument("margin." + name + " is " + shortNumber(margin) +
                                        ", expected a finite number >= 0");
        }
        lines.emplace_back("margin." + namesOf("margin", {name}), formatNumber(margin));
    }
    if (!rules.ignored.empty()) lines.emplace_back("ignore", namesOf("ignore", rules.ignored));
    if (rules.isAllSolid) {
        lines.emplace_back("solid", kAll);
    } else if (!rules.solid.empty()) {
        const std::string names = namesOf("solid", rules.solid);
        lines.emplace_back("solid", names == kAll ? "\"all\"" : names);
    }
    addContact("contact.start", rules.startContact, lines);
    addContact("contact.goal", rules.goalContact, lines);
    return lines;
}

}  // namespace clearway
