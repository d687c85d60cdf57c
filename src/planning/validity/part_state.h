// What an SE(3) or SE(2) state of OMPL holds, as path files state it.
#pragma once

#include <ompl/base/State.h>

#include "clearway/problem.h"

namespace clearway::planning {

PartState partStateOfSe3(const ompl::base::State* state);
PartState partStateOfSe2(const ompl::base::State* state);

}  // namespace clearway::planning
