#include "clearway/targets.h"

#include <algorithm>
#include <stdexcept>

#include "core/text.h"
#include "hwy/targets.h"

namespace clearway {
namespace {

std::string nameOf(std::int64_t target) {
    std::string name = hwy::TargetName(target);
    std::transform(name.begin(), name.end(), name.begin(),
                   [](unsigned char c) { return char(std::tolower(c)); });
    return name;
}

/// The sets of this machine, best first: Highway gives better sets lower bits.
std::vector<std::int64_t> machineTargets() {
    hwy::SetSupportedTargetsForTest(0);
    return hwy::SupportedAndGeneratedTargets();
}

std::int64_t& chosen() {
    static std::int64_t target = 0;  // 0: the best one
    return target;
}

void choose(std::int64_t target) {
    hwy::SetSupportedTargetsForTest(target);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
    chosen() = target;
}

}  // namespace

std::vector<std::string> availableTargets() {
    std::vector<std::string> names;
    for (const std::int64_t target : machineTargets()) names.push_back(nameOf(target));
    choose(chosen());
    return names;
}

void useTarget(const std::string& name) {
    if (name == "best") return choose(0);
    for (const std::int64_t target : machineTargets()) {
        if (nameOf(target) == name) return choose(target);
    }
    throw std::invalid_argument("target is '" + name +
                                "', expected best or one this machine runs: " + joined(availableTargets()));
}

std::string currentTarget() {
    return chosen() == 0 ? availableTargets().front() : nameOf(chosen());
}

}  // namespace clearway
