// How messages begin that say why a pose or a motion is not valid. tests/scene/why_invalid_test.cpp alone holds the words.
#pragma once

#include <string>

#include "clearway/scene_clearance.h"

namespace clearway::testing {

/// The beginning of the words of this kind, up to their colon.
inline std::string beginningOf(WhyInvalid::Kind kind) {
    WhyInvalid why;
    why.kind = kind;
    why.nearest.witness.emplace();
    const std::string words = why.words();
    return words.substr(0, words.find(':'));
}

}  // namespace clearway::testing
