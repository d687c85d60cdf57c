#include "program/cli/print_why_no_path.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/text.h"
#include "model/obstacle_names.h"
#include "program/options/print.h"

namespace clearway::cli {

namespace {

using planning::Blocker;
using planning::ReachedFrom;
using planning::WhyNoPath;

/// Names in one row; the others are counted.
constexpr std::size_t kMostBlockers = 5;

/// From this share of the stopped motions on, the bounds are worth a hint.
constexpr double kManyAtBounds = 0.2;

/// Up to this multiple of the length of contact.start, the part counts as held where its obstacles count again.
constexpr double kLittleBeyond = 1.25;

std::string nameOf(const Blocker& blocker) {
    if (blocker.isBounds()) return "the bounds";
    return "'" + blocker.name + "'" +
           (blocker.partMesh.empty() ? "" : " (the part's '" + blocker.partMesh + "')");
}

std::string inPercent(double share) {
    return std::to_string(std::lround(100 * share)) + " %";
}

/// "82 % 'door' (the part's 'box'), 18 % the bounds", of the motions that `count` counts.
template <class Count>
std::string shares(std::vector<Blocker> blockers, std::size_t all, const Count& count) {
    std::stable_sort(blockers.begin(), blockers.end(),
                     [&](const Blocker& a, const Blocker& b) { return count(a) > count(b); });
    std::vector<std::string> texts;
    std::size_t others = 0, rest = 0;
    for (const Blocker& blocker : blockers) {
        if (count(blocker) == 0) continue;
        if (texts.size() < kMostBlockers) {
            texts.push_back(inPercent(double(count(blocker)) / double(all)) + " " + nameOf(blocker));
        } else {
            ++others;
            rest += count(blocker);
        }
    }
    if (others > 0) {
        texts.push_back(inPercent(double(rest) / double(all)) + " " + counted(others, "other"));
    }
    return joined(texts);
}

void printReached(const WhyNoPath& why, const ReachedFrom& end, const std::string& name) {
    const std::string label = "from the " + name;
    if (!end.hasTree && end.states > 1) return printRow(label, counted(end.states, "state") + " reached");
    if (!end.hasTree) return printRow(label, "this planner does not expose its tree");
    std::string text = counted(end.states, "state") +
                       " reached, where no point of the part has moved by more than " +
                       shownLength(end.farthest);
    if (why.isShutIn(end))
        text += ": less than " + readable(planning::kShutIn) + " diagonals, so it may be shut in there";
    printRow(label, text);
}

void printBlockers(const WhyNoPath& why) {
    const std::size_t stopped = why.start.motionsStopped + why.goal.motionsStopped;
    printRow("motions tried", std::to_string(why.motionsTried) + " from random states reached, " +
                                  std::to_string(stopped) + " of them stopped");
    if (stopped == 0) return;
    printRow("stopped by", shares(why.blockers, stopped, [](const Blocker& b) { return b.motions(); }));
    const auto printEnd = [&](const char* label, const ReachedFrom& end, std::size_t Blocker::*count) {
        if (!why.isShutIn(end) || end.motionsStopped == 0) return;
        printRow(label, shares(why.blockers, end.motionsStopped, [&](const Blocker& b) { return b.*count; }));
    };
    printEnd("at the start", why.start, &Blocker::atStart);
    printEnd("at the goal", why.goal, &Blocker::atGoal);
}

/// "3 followed: 2 end square to 'nut' (the part's 'thread'), 1 ends beside 'nut'"
void printTracks(const WhyNoPath& why) {
    if (why.tracks.empty()) return;
    std::vector<std::pair<std::string, std::size_t>> ends;
    for (const planning::FollowedTrack& track : why.tracks) {
        const std::string end = track.obstacleMesh.empty()
                                    ? "at the bounds"
                                    : std::string(track.isSquare ? "square to" : "beside") + " '" +
                                          track.obstacleMesh + "' (the part's '" + track.partMesh + "')";
        const auto known =
            std::find_if(ends.begin(), ends.end(), [&](const auto& each) { return each.first == end; });
        known == ends.end() ? ends.push_back({end, 1}) : void(++known->second);
    }
    std::stable_sort(ends.begin(), ends.end(),
                     [](const auto& a, const auto& b) { return a.second > b.second; });
    std::vector<std::string> texts;
    for (const auto& [end, count] : ends) {
        if (texts.size() == kMostBlockers) break;
        texts.push_back(std::to_string(count) + (count == 1 ? " ends " : " end ") + end);
    }
    printRow("tracks", std::to_string(why.tracks.size()) + " followed from the start along contacts: " +
                           joined(texts) + (ends.size() > texts.size() ? ", ..." : ""));
}

void printTouchedBounds(const ReachedFrom& end, const std::string& name) {
    std::vector<std::string> names;
    for (const BoxSide& bound : end.bounds) names.push_back(planning::boundNamed(bound));
    if (!names.empty()) printRow("bounds", "the " + name + " is at the " + joined(names));
}

std::string volumeKey(const BoxSide& bound) {
    return std::string(bound.isUpper ? "volume.max." : "volume.min.") + "xyz"[bound.axis];
}

void printHintOfBounds(const WhyNoPath& why, const Problem& problem) {
    std::vector<std::string> keys;
    for (const ReachedFrom* end : {&why.start, &why.goal}) {
        for (const BoxSide& bound : end->bounds) {
            if (std::find(keys.begin(), keys.end(), volumeKey(bound)) == keys.end())
                keys.push_back(volumeKey(bound));
        }
    }
    std::size_t atBounds = 0, stopped = why.start.motionsStopped + why.goal.motionsStopped;
    for (const Blocker& blocker : why.blockers) atBounds += blocker.isBounds() ? blocker.motions() : 0;
    if (keys.empty() && double(atBounds) < std::max(1.0, kManyAtBounds * double(stopped))) return;
    const std::string named = keys.empty() ? "volume.min.x ... volume.max.z" : joined(keys);
    printRow("hint", named + (problem.volume ? " of the problem file may leave too little room"
                                             : " in the problem file can leave the part more room than the "
                                               "environment's box, which is the bounds otherwise"));
}

/// The part may be held by an obstacle that counts again although it has not left it.
void printHintOfContact(const WhyNoPath& why, const Problem& problem) {
    if (!problem.rules.startContact || !why.start.hasTree) return;
    const double length = problem.rules.startContact->distance;
    if (why.start.farthest > kLittleBeyond * length) return;
    printRow("hint",
             "contact.start may need a length above " + statedLength(length) +
                 ": its obstacles count from there on, and no state reached is much farther from the start");
}

void printMarginFound(const planning::Explanation& explanation, double largestMargin) {
    if (!explanation.isMarginTried) return;
    if (!explanation.marginScale)
        return printRow("found with margin", "none by these trials, not even with margins of 0");
    const double scale = *explanation.marginScale;
    std::string text = shownLength(scale * largestMargin);
    text += " in place of " + statedLength(largestMargin) + " (all margins times " + readable(scale) + ")";
    if (explanation.refusedScale < 1)
        text += "; none by these trials with " + shownLength(explanation.refusedScale * largestMargin);
    printRow("found with margin", text);
}

}  // namespace

void printWhyNoPath(const WhyNoPath& why) {
    printRow("part's diagonal", shownLength(why.diagonal));
    printReached(why, why.start, "start");
    printReached(why, why.goal, "goal");
    printTouchedBounds(why.start, "start");
    printTouchedBounds(why.goal, "goal");
    printBlockers(why);
    printTracks(why);
    printRow("nearest miss",
             "states reached from start and goal are " + shownLength(why.nearest.displacement) + " apart");
}

void printExplanation(const planning::Explanation& explanation, double largestMargin) {
    const double seconds = explanation.trialSeconds;
    const std::string trialLength = seconds > 0 ? " of up to " + readable(seconds) + " s" : "";
    printRow("explained by", counted(explanation.trials, "trial") + trialLength +
                                 (explanation.isStopped     ? ", until interrupted"
                                  : explanation.isOutOfTime ? ", until the time was over"
                                                            : "") +
                                 (explanation.areObstaclesTried ? " (greedy; smaller sets may exist)" : ""));
    if (!explanation.path.empty()) return;  // nothing has to go
    for (const std::vector<std::string>& set : explanation.withoutThese)
        printRow("found without", listed(set, set.size()));
    if (explanation.areObstaclesTried && explanation.withoutThese.empty()) {
        printRow("found without", "none of the sets of obstacles that were tried");
    }
    printMarginFound(explanation, largestMargin);
}

void printHints(const WhyNoPath& why, const Problem& problem, const Scene& scene, const AskedFor& asked) {
    printHintOfContact(why, problem);
    printHintOfBounds(why, problem);
    if (problem.margin > 0) {
        printRow("hint", "--margin may be smaller than " + statedLength(problem.margin));
    } else if (scene.largestMargin() > 0) {
        printRow("hint", "margin.NAME of the problem file may be smaller");
    }
    printRow("hint", "--time gives the planners longer");
    if (!asked.isExplained && planning::isExplainable(scene)) {
        printRow("hint", "--explain 60 looks for obstacles and margins without which there is a path");
    }
    if (!asked.hasNearest)
        printRow("hint",
                 "--nearest FILE writes the nearest miss as a path, --report FILE a page to look at it");
}

}  // namespace clearway::cli
