// What a planner asks about: one rigid part, its static environment, and the margin to keep between them.
#pragma once

#include "clearway/model.h"

namespace clearway {

struct Scene {
    Model part;
    Model environment;
    double margin = 0;  ///< environment units; a pose is valid when the distance is larger. >= 0
};

}  // namespace clearway
