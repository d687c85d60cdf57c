#include "support/hard_motion.h"

#include <cmath>
#include <tuple>
#include <utility>

namespace clearway::testing {
namespace {

namespace ob = ompl::base;

double drawnPower(Random& random, double low, double high) {
    return std::pow(10, random.uniform(low, high));
}

/// Draws motions' ends. Lengths are those of the body, which turns about its middle.
class EndDraw {
  public:
    EndDraw(const CrowdedScene& scene, Random& random) : scene_(scene), random_(random) {}

    ob::ScopedState<> startOf(HardKind kind);
    ob::ScopedState<> endOf(HardKind kind, const ob::ScopedState<>& from);

    /// Moves the state on in some direction until a contact or the border of a zone is about to come.
    void closeIn(ob::ScopedState<>& state) {
        const auto away = moved(scene_.bodyState(state.get()), 2 * scene_.spread, 0);
        std::pair<ob::State*, double> lastValid(state.get(), 0);
        scene_.close->checkMotion(state.get(), away.get(), lastValid);
    }

    /// Moves the state towards its nearest obstacle until it has this much clearance, if that is soon done.
    void nestle(ob::ScopedState<>& state, double clearance);

  private:
    const CrowdedLayout::Place& place() {
        const int place = random_.below(static_cast<int>(scene_.places.size()));
        return scene_.places[static_cast<std::size_t>(place)];
    }
    ob::ScopedState<> nearPlace() {
        return moved(place().body, scene_.spread * random_.uniform(0, 1),
                     scene_.turn * random_.uniform(0, 1));
    }
    ob::ScopedState<> moved(const PartState& body, double length, double angle) {
        return moved(body, random_.direction() * length, angle);
    }
    ob::ScopedState<> moved(PartState body, const Vector3& by, double angle);
    ob::ScopedState<> hardlyTurned(const PartState& from);
    ob::ScopedState<> outOfBounds(const PartState& from);
    ob::ScopedState<> wayOut(const ob::ScopedState<>& from);

    const CrowdedScene& scene_;
    Random& random_;
};

ob::ScopedState<> EndDraw::startOf(HardKind kind) {
    if (kind == HardKind::kAssembled) return scene_.state(scene_.places[random_.bits() % 2].body);
    if (random_.below(20) == 0) return scene_.state(place().body);
    ob::ScopedState<> state = nearPlace();
    if (random_.below(10) == 0) return state;
    for (int i = 0; i < 10 && !scene_.checker->isValid(state.get()); ++i) state = nearPlace();
    return state;
}

ob::ScopedState<> EndDraw::moved(PartState body, const Vector3& by, double angle) {
    const bool isPlanar = scene_.kind == Space::kSe2;
    const Vector3 axis = isPlanar ? Vector3(0, 0, 1 - 2 * random_.below(2)) : random_.direction();
    body.position += by;
    if (isPlanar) body.position.z() = 0;
    body.rotation = (Eigen::AngleAxisd(angle, axis) * body.rotation.normalized()).normalized();
    return scene_.state(body);
}

void EndDraw::nestle(ob::ScopedState<>& state, double clearance) {
    for (int i = 0; i < 5 && scene_.checker->isValid(state.get()); ++i) {
        const SceneDistance near = scene_.checker->distance(state.get());
        if (!near.witness || !(near.distance > 0)) return;
        const double margin = scene_.scene.obstacles[*near.obstacle].margin;
        const Vector3 towards =
            (near.witness->pointOnEnvironment - near.witness->pointOnPart) / near.distance;
        const auto closer =
            moved(scene_.bodyState(state.get()), (near.distance - margin - clearance) * towards, 0);
        if (!scene_.checker->isValid(closer.get())) return;
        state = closer;
    }
}

/// Below 1.6e-4 rad OMPL leaves turns out.
ob::ScopedState<> EndDraw::hardlyTurned(const PartState& from) {
    const double angle =
        random_.below(2) == 0 ? random_.uniform(0.6e-4, 2.2e-4) : drawnPower(random_, -9, -3);
    const int way = random_.below(4);
    if (way == 0) return moved(from, 0, angle);
    return moved(from, drawnPower(random_, way == 1 ? -8 : -3, way == 1 ? -3 : 0.5) * scene_.diagonal, angle);
}

ob::ScopedState<> EndDraw::outOfBounds(const PartState& from) {
    ob::ScopedState<> state = scene_.state(from);
    for (double length = scene_.spread; scene_.si->satisfiesBounds(state.get()); length *= 2) {
        state = moved(from, length, scene_.turn * random_.uniform(0, 1));
    }
    return state;
}

/// Out of the contact at the start or at the goal, about as far as its zone reaches.
ob::ScopedState<> EndDraw::wayOut(const ob::ScopedState<>& from) {
    const PartState body = scene_.bodyState(from.get());
    if (!scene_.hasZones() || random_.below(5) == 0) return hardlyTurned(body);
    const auto& [first, second] = std::tie(scene_.places[0], scene_.places[1]);
    const bool isFirst =
        (body.position - first.body.position).norm() < (body.position - second.body.position).norm();
    const double length = (isFirst ? scene_.scene.startContact : scene_.scene.goalContact)->distance;
    const Vector3 out = (isFirst ? first : second).wayOut + random_.below(2) * 0.2 * random_.direction();
    const double angle = random_.below(2) * scene_.turn * drawnPower(random_, -4, -1);
    return moved(body, random_.uniform(0.3, 3) * length * out, angle);
}

ob::ScopedState<> EndDraw::endOf(HardKind kind, const ob::ScopedState<>& from) {
    constexpr double kLargestRadius = 1e4;  // of the part's diagonal; half a turn would lead too far
    const PartState body = scene_.bodyState(from.get());
    switch (kind) {
        case HardKind::kLong:
            return nearPlace();
        case HardKind::kStay:
            return from;
        case HardKind::kMinute:
            return moved(body, 1e-6 * scene_.diagonal * random_.uniform(0, 1), 1e-6 * random_.uniform(0, 1));
        case HardKind::kHalfTurn: {
            if (scene_.bodyInPart.norm() > kLargestRadius * scene_.diagonal) return hardlyTurned(body);
            const double off = (random_.below(3) - 1) * drawnPower(random_, -16, -8);
            return moved(body, random_.below(2) * random_.uniform(0, 0.3) * scene_.diagonal, M_PI + off);
        }
        case HardKind::kLeavesBounds:
            return outOfBounds(body);
        case HardKind::kAssembled:
            return wayOut(from);
        case HardKind::kSmallTurn:
            return hardlyTurned(body);
        default:
            return moved(body, drawnPower(random_, -2.5, 0) * scene_.diagonal,
                         random_.below(2) * scene_.turn * drawnPower(random_, -3, 0));
    }
}

/// Changes the sign of the quaternion, and its norm by up to 1e-9, as far as OMPL accepts. The latter moves the
/// angle below which OMPL leaves out a turn.
void changeQuaternion(Random& random, ob::ScopedState<>& state) {
    const double sign = random.below(3) == 0 ? -1 : 1;
    const double norm = random.below(2) == 0 ? 1 : 1 + random.uniform(-0.9e-9, 0.9e-9);
    for (unsigned int i = 3; i < 7; ++i) state[i] *= sign * norm;
}

}  // namespace

HardMotion::HardMotion(const CrowdedScene& scene, HardKind kind, Random& random)
    : s1(scene.space), s2(scene.space) {
    EndDraw draw(scene, random);
    s1 = draw.startOf(kind);
    const double clearance = drawnPower(random, -10, -5) * scene.diagonal;
    if (kind == HardKind::kSkim) {
        draw.nestle(s1, clearance);
    } else if (random.below(3) == 0) {
        draw.closeIn(s1);
    }
    s2 = draw.endOf(kind, s1);
    if (kind == HardKind::kSkim) draw.nestle(s2, clearance);
    if (scene.kind == Space::kSe3) {
        changeQuaternion(random, s1);
        changeQuaternion(random, s2);
    }
    if (random.below(2) == 0) std::swap(s1, s2);
}

}  // namespace clearway::testing
