// Reads the [planner] section line by line.
#include "problem/planner_choices.h"

#include <algorithm>
#include <boost/algorithm/string/case_conv.hpp>
#include <boost/algorithm/string/predicate.hpp>

#include "clearway/errors.h"
#include "core/number.h"
#include "core/text.h"

namespace clearway {

namespace {

/// Parameters of OMPL's space information and of its valid-state samplers.
constexpr const char* kSettings[] = {"longest_valid_segment_fraction", "valid_segment_count_factor",
                                     "nr_attempts", "nr_improve_attempts", "standard_deviation"};
constexpr const char* kProjection = "projection.";

/// The last planner of the name. Adds one if there is none, because in OMPL.app parameters may come first.
PlannerChoice& lastOf(std::vector<PlannerChoice>& planners, const std::string& name) {
    const auto last = std::find_if(planners.rbegin(), planners.rend(),
                                   [&](const PlannerChoice& planner) { return planner.name == name; });
    if (last != planners.rend()) return *last;
    planners.push_back({name, {}, {}});
    return planners.back();
}

void set(NamedTexts& texts, const std::string& key, const std::string& value) {
    for (auto& [name, old] : texts) {
        if (name == key) {
            old = value;
            return;
        }
    }
    texts.emplace_back(key, value);
}

/// Reads the lines of the section one after the other.
class Section {
  public:
    /// hasObjective: whether [problem] names an objective.
    Section(const std::string& file, Problem& problem, bool isClearways, bool hasObjective)
        : file_(file), problem_(problem), isClearways_(isClearways), hasObjective_(hasObjective) {}

    void read(const ConfigEntry& entry) {
        const std::string key = boost::to_lower_copy(keyOf(entry.name));
        const std::size_t dot = key.find('.');
        const std::string name = key.substr(0, dot);
        const std::string rest = dot == std::string::npos ? "" : key.substr(dot + 1);
        if (name.empty() || (dot != std::string::npos && rest.empty())) {
            throw ArgumentError(place(file_, entry.line) + "[planner] key is " + quote(key) +
                                ", expected NAME = or NAME.PARAMETER = VALUE");
        }
        if (name == "problem") return readSetting(entry, rest);
        if (dot == std::string::npos) return add(entry, name);
        PlannerChoice& planner = lastOf(problem_.planning.planners, name);
        set(planner.parameters, rest, entry.value);
        take(planner);
    }

    /// Warns of settings that no planner followed.
    void end() const {
        if (!pending_.empty()) {
            problem_.warnings.push_back(file_ + ": [planner] problem." + pending_.front().first +
                                        " has no effect: no planner is named");
        }
    }

  private:
    void add(const ConfigEntry& entry, const std::string& name) {
        problem_.planning.planners.push_back({name, {}, {}});
        take(problem_.planning.planners.back());
        if (entry.value.empty()) return;
        warn(entry, " is " + quote(entry.value) +
                        ", which has no effect: parameters are set as NAME.PARAMETER = VALUE");
    }

    /// Makes this the planner that gets the next settings, and gives it the settings that were waiting for a
    /// planner.
    void take(PlannerChoice& planner) {
        last_ = &planner - problem_.planning.planners.data();
        for (const auto& [key, value] : pending_) set(planner.settings, key, value);
        pending_.clear();
    }

    void readSetting(const ConfigEntry& entry, const std::string& key) {
        if (key == "objective") return readObjective(entry);
        if (key == "objective.threshold" && !parseNumber(entry.value)) {
            throw ArgumentError(place(file_, entry.line) + shown(entry.name) + " is " + quote(entry.value) +
                                ", expected a finite number");
        }
        if (key != "sampler" && key != "objective.threshold" && !isSetting(key)) {
            return judgeUnknown(entry, key);
        }
        set(last_ < 0 ? pending_ : problem_.planning.planners[static_cast<std::size_t>(last_)].settings, key,
            entry.value);
    }

    void judgeUnknown(const ConfigEntry& entry, const std::string& key) {
        std::vector<std::string> known(std::begin(kSettings), std::end(kSettings));
        known.insert(known.end(),
                     {"sampler", "objective", "objective.threshold", "projection.cellsize_factor"});
        const std::string meant = didYouMean(key, known);
        if (!isClearways_) return warn(entry, " has no effect here" + meant);
        throw ArgumentError(place(file_, entry.line) + shown(entry.name) + " is an unknown setting" + meant +
                            ", expected problem.KEY, KEY one of " + joined(known));
    }

    /// There is one objective for all planners: the problem's, or the first that is named for a planner.
    void readObjective(const ConfigEntry& entry) {
        if (!hasObjective_) problem_.planning.objective = entry.value;
        hasObjective_ = true;
        if (problem_.planning.objective != entry.value) {
            warn(entry, " is " + quote(entry.value) +
                            ", which has no effect: the objective of all planners is " +
                            quote(problem_.planning.objective));
        }
    }

    void warn(const ConfigEntry& entry, const std::string& what) {
        problem_.warnings.push_back(place(file_, entry.line) + shown(entry.name) + what);
    }

    const std::string& file_;
    Problem& problem_;
    std::ptrdiff_t last_ = -1;  ///< position of the planner named last
    NamedTexts pending_;        ///< settings before any planner
    bool isClearways_, hasObjective_;
};

}  // namespace

bool isSetting(const std::string& key) {
    return boost::starts_with(key, kProjection) ||
           std::find(std::begin(kSettings), std::end(kSettings), key) != std::end(kSettings);
}

void readPlanners(const std::string& file, const std::vector<ConfigEntry>& entries, bool isClearways,
                  Problem& problem) {
    const bool hasObjective = std::any_of(entries.begin(), entries.end(), [](const ConfigEntry& entry) {
        return entry.name == "problem.objective";
    });
    Section section(file, problem, isClearways, hasObjective);
    for (const ConfigEntry& entry : entries) {
        if (sectionOf(entry.name) == "planner") section.read(entry);
    }
    section.end();
}

}  // namespace clearway
