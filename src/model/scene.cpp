// Margins and boxes of a scene.
#include "clearway/scene.h"

#include <algorithm>

namespace clearway {

double Scene::largestMargin() const {
    double largest = 0;
    for (const Obstacle& obstacle : obstacles) largest = std::max(largest, obstacle.margin);
    return largest;
}

Box Scene::environmentBox() const {
    Box box = ignoredBox;
    for (const Obstacle& obstacle : obstacles) box.extend(obstacle.model.box());
    return box;
}

}  // namespace clearway
