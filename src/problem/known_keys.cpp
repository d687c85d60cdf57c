#include "problem/known_keys.h"

#include <algorithm>
#include <boost/algorithm/string/case_conv.hpp>
#include <vector>

#include "clearway/errors.h"
#include "core/text.h"

namespace clearway {
namespace {

struct KnownKeys {
    const char* section;
    std::vector<std::string> keys;  ///< those with a NAME in them stand for many
};

const std::vector<KnownKeys>& knownKeys() {
    static const std::vector<KnownKeys> all = {
        {"problem",
         splitNames("name, robot, world, start.x, start.y, start.z, start.axis.x, start.axis.y, "
                    "start.axis.z, start.theta, goal.x, goal.y, goal.z, goal.axis.x, goal.axis.y, "
                    "goal.axis.z, goal.theta, threshold, volume.min.x, volume.min.y, volume.min.z, "
                    "volume.max.x, volume.max.y, volume.max.z, objective, objective.threshold, "
                    "sampler, standard_deviation, longest_valid_segment_fraction, "
                    "projection.cellsize_factor")
             .value()},
        {"benchmark", {"time_limit", "mem_limit", "run_count", "output", "save_paths", "simplify"}},
        {"clearway", splitNames("contact.goal, contact.start, deflection, fineness, goal, goal.degrees, "
                                "ignore, margin, margin.NAME, outside, overlap, overlap.NAME, part, reading, "
                                "robot.scale, solid, start.degrees, step, unit, world.scale")
                         .value()},
    };
    return all;
}

/// " (did you mean ...?)" for a key near one of its own section or, shown with its section, near one of another section.
std::string nearKey(const std::string& key, const KnownKeys& own) {
    const std::string meant = didYouMean(key, own.keys);
    if (!meant.empty()) return meant;
    for (const KnownKeys& other : knownKeys()) {
        for (const std::string& known : other.keys) {
            if (!didYouMean(key, {known}).empty())
                return " (did you mean '" + known + "' of [" + other.section + "]?)";
        }
    }
    return "";
}

/// The first section that has the key; empty when none has.
std::string sectionWith(const std::string& key) {
    for (const KnownKeys& one : knownKeys()) {
        if (std::find(one.keys.begin(), one.keys.end(), key) != one.keys.end()) return one.section;
    }
    return "";
}

}  // namespace

void judgeUnread(const std::string& file, bool isClearways, const ConfigValues& values, Problem& problem) {
    for (const ConfigEntry& entry : values.unread()) {
        const std::string what = place(file, entry.line) + shown(entry.name) + " = " + quote(entry.value);
        if (entry.name == "problem.control" || entry.name == "problem.statespace") {
            problem.warnings.push_back(what + " is not supported: planned as a free rigid body");
            continue;
        }
        const auto section = std::find_if(knownKeys().begin(), knownKeys().end(), [&](const KnownKeys& one) {
            return one.section == sectionOf(entry.name);
        });
        const std::string key = keyOf(entry.name), home = sectionWith(key);
        const std::string meant = home.empty() ? nearKey(key, *section) : "; it belongs in [" + home + "]";
        if (home == section->section) {
            problem.warnings.push_back(what + " has no effect in this problem");
            continue;
        }
        if (isClearways) {
            throw ArgumentError(what + " is an unknown key" + meant + ", expected one of " +
                                joined(section->keys));
        }
        problem.warnings.push_back(what + " has no effect here" + meant);
    }
}

void judgeSections(const std::string& file, const ConfigFile& config, Problem& problem) {
    const std::vector<std::string> known = {"problem", "benchmark", "planner", "clearway"};
    for (const ConfigSection& section : config.sections) {
        if (std::find(known.begin(), known.end(), section.name) != known.end()) continue;
        const std::string what = place(file, section.line) + "the section is [" + section.name + "]";
        const std::string meant = didYouMean(boost::to_lower_copy(section.name), known);
        if (!meant.empty() || config.hasSection("clearway")) {
            throw ArgumentError(what + meant + ", expected [problem], [benchmark], [planner] or [clearway]");
        }
        problem.warnings.push_back(what + ", which has no effect here");
    }
    const auto isBare = [](const ConfigEntry& entry) { return sectionOf(entry.name).empty(); };
    const auto bare = std::find_if(config.entries.begin(), config.entries.end(), isBare);
    if (bare == config.entries.end()) return;
    problem.warnings.push_back(place(file, bare->line) + "a key before the first section has no effect here");
}

}  // namespace clearway
