#include "clearway/planning/displacement_bound.h"

#include <ompl/base/spaces/SE2StateSpace.h>

#include <stdexcept>
#include <typeinfo>
#include <utility>

#include "clearway/errors.h"
#include "core/number.h"
#include "planning/space/ompl_states.h"
#include "scene/interpolated_motion.h"

namespace clearway::planning {
namespace {

/// radius: the part's about its origin.
DisplacementBound makeBound(const ob::StateSpace& space, double radius, RadiusAbout radiusAbout) {
    if (isOmplSe3(space)) {
        return [radius, about = std::move(radiusAbout)](const ob::State* a, const ob::State* b) {
            return se3Displacement(partStateOfSe3(a), partStateOfSe3(b), radius, about);
        };
    }
    if (typeid(space) == typeid(ob::SE2StateSpace)) {
        return [aboutZ = radiusAbout(Vector3::UnitZ())](const ob::State* a, const ob::State* b) {
            return se2Displacement(planarNumbersOf(a), planarNumbersOf(b), aboutZ);
        };
    }
    throw ArgumentError("state space '" + space.getName() +
                        "' is neither OMPL's SE(3) nor its SE(2), expected a displacement bound of its own");
}

}  // namespace

DisplacementBound displacementBound(const ob::StateSpace& space, double partRadius) {
    requireNotNegative("partRadius", partRadius);
    return makeBound(space, partRadius, [partRadius](const Vector3&) { return partRadius; });
}

DisplacementBound displacementBound(const ob::StateSpace& space, const Model& part) {
    return makeBound(space, part.radiusAboutOrigin(),
                     [part](const Vector3& axis) { return part.radiusAboutAxis(axis); });
}

}  // namespace clearway::planning
