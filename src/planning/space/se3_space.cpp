#include "clearway/planning/se3_space.h"

#include <cmath>

namespace clearway::planning {

namespace ob = ompl::base;

namespace {

/// A state with its components, in two lines of the cache.
struct alignas(64) WholeState : ob::SE3StateSpace::StateType {
    WholeState() {
        components = parts;
        position.values = coordinates;
    }
    ob::RealVectorStateSpace::StateType position;
    ob::SO3StateSpace::StateType rotation;
    double coordinates[3];
    ob::State* parts[2] = {&position, &rotation};
};

}  // namespace

ob::State* Se3Space::allocState() const {
    return new WholeState;
}

void Se3Space::freeState(ob::State* state) const {
    delete static_cast<WholeState*>(state);
}

/// Sums in the order of OMPL's subspaces, so that planners of one seed find the same paths in both spaces. The states may be
/// those of another SE(3).
double Se3Space::distance(const ob::State* a, const ob::State* b) const {
    constexpr double kMostNormError =
        1e-9;  // OMPL's: quaternions whose product is nearer to 1 count as equal
    const auto *from = a->as<StateType>(), *to = b->as<StateType>();
    const double x = from->getX() - to->getX(), y = from->getY() - to->getY(), z = from->getZ() - to->getZ();
    const auto &p = from->rotation(), &q = to->rotation();
    const double product = std::fabs(p.x * q.x + p.y * q.y + p.z * q.z + p.w * q.w);
    const double turn = product > 1 - kMostNormError ? 0 : std::acos(product);
    return weights_[0] * std::sqrt(x * x + y * y + z * z) + weights_[1] * turn;
}

}  // namespace clearway::planning
