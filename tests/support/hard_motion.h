// Random motions of a crowded scene that are hard to judge: beside obstacles, across the borders of contact
// zones, hardly turning, turning by half a turn, staying, moving by a millionth of the part, and leaving the
// bounds.
#pragma once

#include <ompl/base/ScopedState.h>

#include "support/crowded_scene.h"
#include "support/random_meshes.h"

namespace clearway::testing {

enum class HardKind {
    kLong,
    kShort,
    kSmallTurn,
    kStay,
    kMinute,
    kHalfTurn,
    kLeavesBounds,
    kAssembled,
    kSkim
};
constexpr int kHardKinds = 9;
constexpr const char* kHardKindNames[kHardKinds] = {
    "long", "short", "small turn", "stay", "minute", "half turn", "leaves bounds", "assembled", "skim"};

struct HardMotion {
    HardMotion(const CrowdedScene& scene, HardKind kind, Random& random);

    ompl::base::ScopedState<> s1, s2;
};

}  // namespace clearway::testing
