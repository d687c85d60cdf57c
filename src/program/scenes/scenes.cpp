#include "program/scenes/scenes.h"

#include <stdexcept>

#include "program/scenes/apartment.h"
#include "program/scenes/boxes.h"
#include "program/scenes/cembox.h"
#include "program/scenes/large_environment.h"
#include "program/scenes/peg_in_hole.h"
#include "program/scenes/puzzle.h"
#include "program/scenes/tunnel_console.h"

namespace clearway::scenes {

namespace {

/// "tunnel-console-1" without its "-1".
std::string withoutVersion(const std::string& name) {
    return name.substr(0, name.rfind('-'));
}

std::string allNames() {
    std::string all;
    for (const NamedScene& scene : namedScenes()) all += (all.empty() ? "" : ", ") + std::string(scene.name);
    return all;
}

/// Three quarters of the poses collide, and keep to where the part is in the tunnel.
constexpr Replay kInTunnel{0.75, 0.75, true};
/// Faces stay parallel.
constexpr Replay kParallel{0.1, 1, false};

}  // namespace

/// Of one scene's versions the newest comes last.
const std::vector<NamedScene>& namedScenes() {
    static const std::vector<NamedScene> kScenes = {
        {"tunnel-console-1", "a centre console to be threaded out of a bent tunnel", kTunnelConsole,
         makeTunnelConsole1, kInTunnel, "inside"},
        {"tunnel-console-2", "the same, near its tunnel in places only", kTunnelConsole, makeTunnelConsole2,
         kInTunnel, "inside"},
        {"tunnel-console-3", "the same, with all that a car has there", kTunnelConsole3, makeTunnelConsole3,
         kInTunnel},
        {"cembox-1", "a control module to be drawn out of its rails in an engine bay", kCembox, makeCembox},
        {"cembox-2", "the same in a fuller engine bay, at any size", kCembox, makeCembox2},
        {"boxes-1", "a box that slides along two others, face to face", kBoxes, makeBoxes, kParallel},
        {"large-environment-1", "an instrument carrier on its way into a car body of fine sheets in layers",
         kLargeEnvironment, makeLargeEnvironment},
        {"large-environment-2", "the tray of a sliding roof between two sheets that follow it, in a car body",
         kLargeEnvironment2, makeLargeEnvironment2},
        {"puzzle-1", "two interlocked bent bars, one to be slid through the eye of the other", kPuzzle,
         makePuzzle},
        {"puzzle-2", "the same, with loops that are open", kPuzzle, makePuzzle2},
        {"peg-in-hole-1", "a round peg to be put into a hole, as narrow as the clearance says", kPegInHole,
         makePegInHole},
        {"apartment-1",
         "a piano to be carried through two doors and a corridor",
         kApartment,
         makeApartment,
         {},
         "top"},
    };
    return kScenes;
}

const NamedScene& sceneNamed(const std::string& name) {
    const NamedScene* newest = nullptr;
    for (const NamedScene& scene : namedScenes()) {
        if (name == scene.name) return scene;
        if (name == withoutVersion(scene.name)) newest = &scene;
    }
    if (newest != nullptr) return *newest;
    throw std::invalid_argument("the scene is '" + name + "', expected one of " + allNames());
}

}  // namespace clearway::scenes
