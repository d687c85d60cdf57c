#include "torture/fcl_check.h"

#include <cmath>

namespace clearway::testing {

FclCheck::FclCheck(const Mesh& part, const Mesh& environment)
    : distances_(makeFclRss(part, environment)), collisions_(makeFclObbRss(part, environment)) {}

FclAnswer FclCheck::ask(const Pose& pose) const {
    FclAnswer answer;
    answer.distance = distances_.distance(pose).value;
    answer.collides = collisions_.collides(pose).value != 0;
    answer.isThere = !std::isnan(answer.distance);
    return answer;
}

}  // namespace clearway::testing
