#include "support/motion_scene.h"

#include <algorithm>
#include <cmath>

#include "demos/scenes/scenes.h"
#include "planning/space/ompl_states.h"
#include "support/assembled_problems.h"
#include "support/golden_section.h"
#include "support/window_scene.h"

namespace clearway::testing {

using namespace scenes;
namespace {

struct Found {
    double time, distance;
    bool operator<(const Found& other) const { return distance < other.distance; }
};

Box around(const std::vector<PartState>& path, double more) {
    Box box;
    for (const PartState& state : path) box.extend(state.position);
    return Box(box.min() - Vector3::Constant(more), box.max() + Vector3::Constant(more));
}

std::shared_ptr<const MotionScene> generated(const GeneratedScene& made, double margin) {
    return std::make_shared<const MotionScene>(made.name, Space::kSe3, made.part, made.environment,
                                               around(made.path, 50), margin, made.path);
}

std::shared_ptr<const MotionScene> tunnelConsole(double margin) {
    const std::string base = CLEARWAY_DATA_DIR "/tunnel-console-small/tunnel-console";
    const Problem problem = readProblem(base + ".cfg");
    return std::make_shared<const MotionScene>("tunnel-console", Space::kSe3, loadPart(problem),
                                               loadEnvironment(problem), *problem.volume, margin,
                                               readPath(base + ".path", Space::kSe3));
}

/// In the plane the plate lies flat. A turned plate does not fit through the window.
std::shared_ptr<const MotionScene> window(Space kind, double margin) {
    const WindowScene made = windowScene();
    std::vector<PartState> path(3, made.problem.start);
    if (kind == Space::kSe2) path[0].rotation = Eigen::Quaterniond::Identity();
    path[1].position.setZero();
    path[1].rotation = Eigen::Quaterniond::Identity();
    path[2] = path[0];
    path[2].position.x() = 60;
    return std::make_shared<const MotionScene>("window", kind, made.partMesh, made.wallMesh,
                                               *made.problem.volume, margin, path);
}

}  // namespace

MotionScene::MotionScene(std::string theName, Space theKind, const Mesh& thePart, const Mesh& theEnvironment,
                         const Box& bounds, double margin, std::vector<PartState> thePath, double theSpread)
    : name(std::move(theName)),
      kind(theKind),
      partMesh(thePart),
      environmentMesh(theEnvironment),
      oracle(partMesh, environmentMesh),
      scene{Model::build(partMesh), Model::build(environmentMesh), margin},
      path(std::move(thePath)),
      spread(theSpread),
      space(planning::makeSpace(kind, bounds, 1)),
      si(std::make_shared<ob::SpaceInformation>(space)),
      checker(std::make_shared<planning::ValidityChecker>(si, scene)),
      validator(std::make_shared<planning::MotionValidator>(si, scene)) {
    planning::MotionOptions options;
    options.leastInterval = 0.01 * validator->leastInterval();
    close = std::make_shared<planning::MotionValidator>(si, scene, options);
    si->setStateValidityChecker(checker);
    si->setMotionValidator(validator);
    si->setup();
}

ob::ScopedState<> MotionScene::state(const PartState& partState) const {
    return planning::toOmpl(space, kind, partState);
}

PartState MotionScene::stateOf(const ob::State* omplState) const {
    return planning::fromOmpl(kind, omplState);
}

PartState MotionScene::nearPath(Random& random, double distance, double angle) const {
    const auto k = static_cast<std::size_t>(random.below(static_cast<int>(path.size() - 1)));
    const double t = random.uniform(0, 1);
    PartState result = path[k];
    const Vector3 away = random.direction() * distance * random.uniform(0, 1);
    result.position = (1 - t) * path[k].position + t * path[k + 1].position + away;
    const Eigen::Quaterniond between = Eigen::Quaterniond(path[k].rotation.coeffs())
                                           .slerp(t, Eigen::Quaterniond(path[k + 1].rotation.coeffs()));
    const Vector3 axis = kind == Space::kSe2 ? Vector3(0, 0, 1) : random.direction();
    result.rotation = (Eigen::AngleAxisd(angle * random.uniform(-1, 1), axis) * between).normalized();
    if (kind == Space::kSe2) result.position.z() = 0;
    return result;
}

double MotionScene::trueClearance(const ob::State* at) const {
    return oracle.distance(checker->pose(at)).distance - scene.largestMargin();
}

double MotionScene::trueClearance(const ob::State* s1, const ob::State* s2, double time) const {
    if (time >= 1) return trueClearance(s2);
    ob::ScopedState<> between(space);
    space->interpolate(s1, s2, time, between.get());
    return trueClearance(between.get());
}

double MotionScene::leastTrueClearance(const ob::State* s1, const ob::State* s2, double until, int poses,
                                       int judged) const {
    ob::ScopedState<> between(space);
    std::vector<Found> found;
    const auto distanceAt = [&](double time) {
        space->interpolate(s1, s2, time, between.get());
        found.push_back({time, checker->distance(between.get()).lower});
        return found.back().distance;
    };
    for (int i = 0; i <= poses; ++i) distanceAt(until * i / poses);
    const double middle = std::min_element(found.begin(), found.end())->time;
    searchLeast(distanceAt, middle, until / poses, until);
    std::sort(found.begin(), found.end());
    double least = trueClearance(s1, s2, until);
    for (std::size_t i = 0; i < std::min(found.size(), static_cast<std::size_t>(judged)); ++i) {
        space->interpolate(s1, s2, found[i].time, between.get());
        least = std::min(least, trueClearance(between.get()));
    }
    return least;
}

std::vector<std::shared_ptr<const MotionScene>> motionScenes() {
    std::vector<std::shared_ptr<const MotionScene>> scenes;
    scenes.push_back(window(Space::kSe3, 0));
    scenes.push_back(window(Space::kSe2, 3));
    scenes.push_back(tunnelConsole(0));
    scenes.push_back(tunnelConsole(1));
    scenes.push_back(generated(makeBoxes(kBoxes), 0.5));
    scenes.push_back(generated(makePuzzle(kPuzzle), 0));
    return scenes;
}

std::shared_ptr<const MotionScene> screwMotionScene() {
    const AssembledProblem made = screwAndNut({12, 3.5, 3.5}, 0);
    const std::vector<PartState> path = alongThread(4);
    constexpr double kSpread = 0.03;  // the thread leaves the screw 0.08 of play
    return std::make_shared<const MotionScene>(made.name, Space::kSe3, made.part, made.environment,
                                               around(path, 50), 0, path, kSpread);
}

}  // namespace clearway::testing
