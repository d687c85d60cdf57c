// Reads and writes the rules for obstacles.
#include "problem/obstacle_rules.h"

#include <cmath>

#include "clearway/errors.h"
#include "core/number.h"
#include "core/text.h"

namespace clearway {
namespace {

constexpr const char* kMargin = "margin";
constexpr const char* kOverlap = "overlap";
constexpr const char* kNames = "names, separated by commas";
constexpr const char* kAll = "all";

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

/// Reads the keys KEY.NAME = length. key: "margin" or "overlap".
void readLengths(ConfigValues& values, const std::string& key, std::map<std::string, double>& lengths) {
    const std::string prefix = "clearway." + key + ".";
    for (const ConfigEntry& entry : values.unread()) {
        if (entry.name.compare(0, prefix.size(), prefix) != 0) continue;
        const auto names = splitNames(std::string_view(entry.name).substr(prefix.size()));
        const double length = values.number(entry.name).value_or(-1);
        if (!(length >= 0)) values.refuse(entry.name, "a number of at least 0");
        if (!names || names->size() != 1 || !lengths.insert({names->front(), length}).second) {
            values.refuse(entry.name, key + ".NAME = " + (key == kOverlap ? "X" : "M") +
                                          " with each name once, and a name that has a comma in quotes");
        }
    }
}

OverlapRules readOverlap(ConfigValues& values) {
    OverlapRules rules;
    rules.common = values.number("clearway.overlap").value_or(0);
    if (!(rules.common >= 0)) values.refuse("clearway.overlap", "a number of at least 0");
    const char* quoted = " (an obstacle of that name stands in quotes)";
    if (values.has("clearway.overlap.tolerance"))
        values.refuse(
            "clearway.overlap.tolerance",
            std::string("no such key: write the overlap and its tolerance, added up, as the overlap") +
                quoted);
    if (values.has("clearway.overlap.thin"))
        values.refuse("clearway.overlap.thin",
                      std::string("no such key: thin places are told, and never refused") + quoted);
    readLengths(values, kOverlap, rules.byName);
    return rules;
}

void addContact(const std::string& key, const std::optional<ContactRule>& contact,
                std::vector<std::pair<std::string, std::string>>& lines) {
    if (!contact) return;
    if (!(contact->distance > 0) || !std::isfinite(contact->distance)) {
        throw ArgumentError(key + " has the length " + shortNumber(contact->distance) +
                            ", expected a finite length above 0");
    }
    lines.emplace_back(key, namesOf(key, contact->names) + ", " + formatNumber(contact->distance));
}

void addLengths(const std::string& key, const std::map<std::string, double>& lengths,
                std::vector<std::pair<std::string, std::string>>& lines) {
    for (const auto& [name, length] : lengths) {
        requireNotNegative(key + "." + name, length);
        std::string written = namesOf(key, {name});
        // Without quotes these would be keys of their own.
        if (key == kOverlap && (name == "tolerance" || name == "thin")) written = "\"" + name + "\"";
        lines.emplace_back(key + "." + written, formatNumber(length));
    }
}

void addOverlap(const OverlapRules& rules, std::vector<std::pair<std::string, std::string>>& lines) {
    requireNotNegative(kOverlap, rules.common);
    if (rules.common > 0) lines.emplace_back(kOverlap, formatNumber(rules.common));
    addLengths(kOverlap, rules.byName, lines);
}

}  // namespace

std::vector<std::string> readNames(ConfigValues& values, const std::string& key) {
    const std::optional<std::string> text = values.text(key);
    if (!text) return {};
    const std::optional<std::vector<std::string>> names = splitNames(*text);
    if (!names) values.refuse(key, kNames);
    return *names;
}

std::string namesOf(const std::string& key, const std::vector<std::string>& names) {
    const std::optional<std::string> written = writtenNames(names);
    if (written && !written->empty()) return *written;
    throw ArgumentError(key +
                        " has a name that is empty or contains a quote or a line end, expected "
                        "a name without these");
}

ObstacleRules readObstacleRules(ConfigValues& values) {
    ObstacleRules rules;
    readLengths(values, kMargin, rules.margins);
    rules.overlap = readOverlap(values);
    rules.ignored = readNames(values, "clearway.ignore");
    rules.isAllSolid = values.has("clearway.solid") && *values.text("clearway.solid") == kAll;
    if (!rules.isAllSolid) rules.solid = readNames(values, "clearway.solid");
    rules.startContact = readContact(values, "clearway.contact.start");
    rules.goalContact = readContact(values, "clearway.contact.goal");
    return rules;
}

std::vector<std::pair<std::string, std::string>> writtenRules(const ObstacleRules& rules) {
    std::vector<std::pair<std::string, std::string>> lines;
    addLengths(kMargin, rules.margins, lines);
    addOverlap(rules.overlap, lines);
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
