#include "support/random_motion.h"

#include <cmath>
#include <utility>

namespace clearway::testing {
namespace {

namespace ob = ompl::base;

/// Moves the state on in some direction until the part is about to touch, to within a millionth of its size.
void closeIn(const MotionScene& scene, Random& random, ob::ScopedState<>& state) {
    PartState away = scene.stateOf(state.get());
    away.position += random.direction() * 100;
    if (scene.kind == Space::kSe2) away.position.z() = 0;
    std::pair<ob::State*, double> lastValid(state.get(), 0);
    scene.close->checkMotion(state.get(), scene.state(away).get(), lastValid);
}

/// Changes the quaternion's norm by up to 1e-9, as far as OMPL accepts. This moves the angle below which OMPL
/// omits a turn.
void unsettleNorm(Random& random, ob::ScopedState<>& state) {
    const double norm = 1 + random.uniform(-0.9e-9, 0.9e-9);
    for (unsigned int i = 3; i < 7; ++i) state[i] *= norm;
}

}  // namespace

RandomMotion::RandomMotion(const MotionScene& scene, Random& random)
    : s1(scene.state(scene.nearPath(random, scene.spread, 0.01 * scene.spread))), s2(s1) {
    const int kind = random.below(4);
    if (kind >= 2) closeIn(scene, random, s1);
    if (kind == 0) {
        s2 = scene.state(scene.nearPath(random, 4 * scene.spread, 0.1 * scene.spread));
        return;
    }
    PartState from = scene.stateOf(s1.get());
    const double angle = kind == 1 ? random.uniform(0, 0.3) : random.uniform(0.6e-4, 1.6e-4);
    const double length = std::pow(10, random.uniform(-3, 1.5));
    const Vector3 axis = scene.kind == Space::kSe2 ? Vector3(0, 0, 1) : random.direction();
    from.position += random.direction() * length * (random.below(3) > 0);
    from.rotation = (Eigen::AngleAxisd(angle, axis) * from.rotation).normalized();
    if (scene.kind == Space::kSe2) from.position.z() = 0;
    s2 = scene.state(from);
    if (scene.kind == Space::kSe3) unsettleNorm(random, s2);
    if (random.below(2) == 0) std::swap(s1, s2);
}

}  // namespace clearway::testing
