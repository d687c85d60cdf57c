// The dispatch of sweeps: compiled once per instruction set, and in each once per node width.
#include "query/sweep.h"

#include <Eigen/Geometry>
#include <memory>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "query/sweep.cpp"
#include "hwy/foreach_target.h"  // must come before highway.h and the kernels

#include "hwy/highway.h"
#include "query/sweep-inl.h"

HWY_BEFORE_NAMESPACE();
namespace clearway {
namespace HWY_NAMESPACE {

SweepAnswer SweepTrees(const FlatTree& part, const FlatTree& environment, const MotionPieces& motion,
                       const SweepRequest& request, Workspace::State& state) {
    SweepAnswer answer;
    withNodeWidth(part.nodeWidth, [&](auto width) HWY_ATTR {
        Sweep<width> sweep(part, environment, motion, request, state, answer);
        sweep.run();
    });
    return answer;
}

}  // namespace HWY_NAMESPACE
}  // namespace clearway
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace clearway {

HWY_EXPORT(SweepTrees);

SweepAnswer sweepTrees(const FlatTree& part, const FlatTree& environment, const MotionPieces& motion,
                       const SweepRequest& request, Workspace::State& state) {
    settleTarget();
    return HWY_DYNAMIC_DISPATCH(SweepTrees)(part, environment, motion, request, state);
}

}  // namespace clearway

#endif  // HWY_ONCE
