#include "clearway/targets.h"

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <mutex>

#include "clearway/errors.h"
#include "core/text.h"
#include "hwy/targets.h"
#include "query/queries.h"

namespace clearway {
namespace {

constexpr const char* kTargetVariable = "CLEARWAY_TARGET";

std::mutex choosingTarget;
std::atomic<bool> isTargetSettled{false};  ///< by useTarget, or from the environment by the first query
std::int64_t chosenTarget = 0;             ///< 0: the best one

/// The sets of this machine, best first: Highway gives better sets lower bits. Read before Highway is told to use one of them.
const std::vector<std::int64_t>& machineTargets() {
    static const std::vector<std::int64_t> targets = hwy::SupportedAndGeneratedTargets();
    return targets;
}

std::string nameOf(std::int64_t target) {
    std::string name = hwy::TargetName(target);
    std::transform(name.begin(), name.end(), name.begin(),
                   [](unsigned char c) { return char(std::tolower(c)); });
    return name;
}

/// The set with this name, 0 for "best". source: where the name stands, for the message that refuses it.
std::int64_t targetNamed(const std::string& name, const char* source) {
    const std::vector<std::int64_t>& targets = machineTargets();
    if (name == "best") return 0;
    const auto found = std::find_if(targets.begin(), targets.end(),
                                    [&](std::int64_t target) { return nameOf(target) == name; });
    if (found != targets.end()) return *found;
    throw ArgumentError(std::string(source) + " is '" + name +
                        "', expected best or one this machine runs: " + joined(availableTargets()));
}

/// The caller holds the lock.
void choose(std::int64_t target) {
    hwy::SetSupportedTargetsForTest(target);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
    chosenTarget = target;
    isTargetSettled.store(true, std::memory_order_release);
}

}  // namespace

void settleTarget() {
    if (isTargetSettled.load(std::memory_order_acquire)) return;
    const std::lock_guard<std::mutex> lock(choosingTarget);
    if (isTargetSettled.load(std::memory_order_relaxed)) return;
    const char* const name = std::getenv(kTargetVariable);
    if (name != nullptr && *name != '\0') {
        choose(targetNamed(name, kTargetVariable));
    } else {
        isTargetSettled.store(true, std::memory_order_release);  // Highway takes the best set by itself
    }
}

std::vector<std::string> availableTargets() {
    std::vector<std::string> names;
    for (const std::int64_t target : machineTargets()) names.push_back(nameOf(target));
    return names;
}

void useTarget(const std::string& name) {
    const std::lock_guard<std::mutex> lock(choosingTarget);
    choose(targetNamed(name, "target"));
}

std::string currentTarget() {
    settleTarget();
    const std::lock_guard<std::mutex> lock(choosingTarget);
    return chosenTarget == 0 ? availableTargets().front() : nameOf(chosenTarget);
}

}  // namespace clearway
