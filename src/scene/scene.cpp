// Refuses wrong lengths of a scene where they are stated, before anything is loaded or asked.
#include "clearway/scene.h"

#include <cmath>

#include "clearway/errors.h"
#include "core/number.h"

namespace clearway {

Obstacle::Obstacle(Model theModel, double theMargin) : model(std::move(theModel)), margin(theMargin) {
    requireNotNegative("margin", margin);
}

ContactZone::ContactZone(const Pose& pose, double theDistance)
    : X_environmentPart(pose), distance(theDistance) {
    if (distance > 0 && std::isfinite(distance)) return;
    throw ArgumentError("the contact zone's distance is " + shortNumber(distance) +
                        ", expected a finite length above 0");
}

}  // namespace clearway
