#include "bench/modes.h"

#include <memory>

#include "bench/float_only.h"
#include "bench/scalar_double.h"
#include "core/number.h"

namespace clearway::testing {
namespace {

using Ask = std::function<Answer(const Pose&)>;

Mode modeOf(const std::string& name, Mode::Says says, const Ask& ask, std::function<void()> beforePass) {
    Mode mode{says, false, {}, nullptr};
    mode.series.asked = "distance";
    mode.series.engine = name;
    mode.series.isClearway = true;  // clearway runs every repetition
    mode.series.ask = ask;
    mode.series.beforePass = std::move(beforePass);
    const bool byLower = says != Mode::Says::kNumber;
    mode.isValid = [ask, byLower](const Pose& pose, double margin) {
        const Answer answer = ask(pose);
        return (byLower ? answer.lower : answer.value) > margin;
    };
    return mode;
}

Mode queryMode(const std::string& name, const TreePair& trees, const DistanceOptions& options) {
    const auto workspace = std::make_shared<Workspace>();
    const auto ask = [trees, options, workspace](const Pose& pose) {
        const DistanceResult result = distance(trees.part, trees.environment, pose, options, *workspace);
        return Answer{result.distance, result.lower, result.upper, result.counters};
    };
    Mode mode = modeOf(name, Mode::Says::kInterval, ask, [workspace] { workspace->forgetWarmStart(); });
    mode.isQuery = true;
    return mode;
}

Mode isWithinMode(const TreePair& trees, double timedMargin) {
    const auto workspace = std::make_shared<Workspace>();
    const auto within = [trees, workspace](const Pose& pose, double margin) {
        return isWithin(trees.part, trees.environment, pose, margin, *workspace);
    };
    const auto ask = [within, workspace, timedMargin](const Pose& pose) {
        const bool isNear = within(pose, timedMargin);
        return Answer{isNear ? 1.0 : 0.0, 0, 0, workspace->counters()};
    };
    Mode mode = modeOf("isWithin", Mode::Says::kVerdict, ask, [workspace] { workspace->forgetWarmStart(); });
    mode.isQuery = true;
    mode.isValid = [within](const Pose& pose, double margin) { return !within(pose, margin); };
    return mode;
}

Mode peerMode(const Peer& peer) {
    const auto ask = [ask = peer.distance](const Pose& pose) {
        Answer answer = ask(pose);
        if (answer.value < 0) answer.value = 0;  // contact
        return answer;
    };
    Mode mode = modeOf(peer.name, Mode::Says::kNumber, ask, peer.forgetWarmStart);
    mode.series.isClearway = false;
    return mode;
}

}  // namespace

std::vector<Mode> makeModes(const BenchTask& task, const TreePair& trees, const std::vector<Peer>& peers) {
    const auto scalar = std::make_shared<ScalarDouble>(trees.part, trees.environment);
    const auto inFloat = std::make_shared<FloatOnly>(trees.part, trees.environment);
    std::vector<Mode> modes;
    modes.push_back(modeOf(
        "scalar double", Mode::Says::kInterval, [scalar](const Pose& pose) { return scalar->distance(pose); },
        [scalar] { scalar->forgetWarmStart(); }));
    modes.back().series.isClearway = false;
    modes.push_back(modeOf(
        kFloatOnly, Mode::Says::kInterval, [inFloat](const Pose& pose) { return inFloat->distance(pose); },
        [inFloat] { inFloat->forgetWarmStart(); }));
    modes.push_back(queryMode(kDefault, trees, {}));
    for (const double error : {1e-3, 1e-2, 1e-1}) {
        DistanceOptions options;
        options.relativeError = error;
        modes.push_back(queryMode("relative error " + shortNumber(error), trees, options));
    }
    DistanceOptions capped;
    capped.cap = kCapShare * task.sceneSize();
    modes.push_back(queryMode("cap", trees, capped));
    modes.push_back(isWithinMode(trees, kTimedMargin * task.sceneSize()));
    modes.push_back(modeOf(
        "root volumes", Mode::Says::kLowerBound,
        [scalar](const Pose& pose) { return scalar->rootBound(pose); }, nullptr));
    for (const Peer& peer : peers) {
        if (peer.distance) modes.push_back(peerMode(peer));
    }
    for (Mode& mode : modes) mode.series.order = inOrder(task.poses.size());
    return modes;
}

}  // namespace clearway::testing
