// The parts of SceneClearance that its files share: the data that threads keep between queries.
#pragma once

#include <tbb/enumerable_thread_specific.h>

#include <cstdint>
#include <cstring>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "clearway/scene_clearance.h"

namespace clearway {

/// Visits the obstacles until `visit` returns false. The obstacle that was nearest last time comes first: it blocks
/// most often, and its distance caps the queries after it.
template <class Visit>
bool visitAll(std::size_t count, std::size_t first, const Visit& visit) {
    if (count == 0) return true;
    if (!visit(first)) return false;
    for (std::size_t i = 0; i < count; ++i) {
        if (i != first && !visit(i)) return false;
    }
    return true;
}

inline bool isSamePose(const Pose& a, const Pose& b) {
    return a.translation == b.translation && a.rotation == b.rotation;
}

/// Poses found free, each in the place that its numbers choose, until another one takes it. Planners check a state and then several
/// motions to it.
class SceneClearance::FreePoses {
  public:
    static constexpr std::size_t kFew = 16;
    /// Enough for the states of a planner's trees: from each, motions go on to states that need not be looked at then.
    static constexpr std::size_t kOfTrees = 16384;

    /// places: a power of two.
    explicit FreePoses(std::size_t places = kFew) : places_(places) {}

    bool contain(const Pose& pose) const {
        return !poses_.empty() && isSamePose(poses_[placeOf(pose)], pose);
    }

    void add(const Pose& pose) {
        if (poses_.empty()) poses_.assign(places_, {Matrix3::Identity(), Vector3::Constant(kNone)});
        poses_[placeOf(pose)] = pose;
    }

  private:
    static constexpr double kNone = std::numeric_limits<double>::quiet_NaN();  ///< equals no pose

    std::size_t placeOf(const Pose& pose) const {
        std::uint64_t mixed = 0;
        const auto mix = [&](double number) {
            std::uint64_t bits = 0;
            number += 0;  // -0 equals 0
            std::memcpy(&bits, &number, sizeof bits);
            mixed = (mixed ^ bits) * 0x9e3779b97f4a7c15u;
            mixed ^= mixed >> 32;
        };
        for (const double number : pose.translation) mix(number);
        mix(pose.rotation(0, 1));
        mix(pose.rotation(1, 2));
        return mixed & (places_ - 1);
    }

    std::size_t places_;
    std::vector<Pose> poses_;  ///< empty until the first one
};

/// The data that one thread keeps from query to query.
struct SceneClearance::Scratch {
    std::vector<Workspace> workspaces;  ///< one for each obstacle
    std::size_t nearest = 0;            ///< the obstacle that was nearest, or in the way, last time
    FreePoses freePoses{};
    std::optional<Pose> clearPose{};  ///< the last one that isClearOfSurfaces() found clear
    bool isInMotion = false;          ///< a query of a motion is under way; see ThreadScratch::ForMotion
};

struct SceneClearance::ThreadScratch {
    struct Both {
        Scratch warm, cold{};  ///< cold: made by the first ColdStart
        bool isCold = false;
    };

    explicit ThreadScratch(std::size_t obstacles)
        : perThread([obstacles, this] {
              Both both{Scratch{std::vector<Workspace>(obstacles)}};
              both.warm.freePoses = FreePoses(warmPoses_);
              return both;
          }) {}

    /// Warm threads remember as many free poses as planners' trees have. Call it before they ask.
    void rememberTrees() {
        warmPoses_ = FreePoses::kOfTrees;
        perThread.clear();
    }

    Scratch& mine() {
        Both& both = perThread.local();
        return both.isCold ? both.cold : both.warm;
    }

    /// The scratch for a query of a motion. The query's callbacks may ask about other motions on the same thread: those get
    /// scratch of their own, because a sweep keeps its place in its workspace.
    class ForMotion {
      public:
        explicit ForMotion(ThreadScratch& all) : mine_(&all.mine()) {
            if (mine_->isInMotion) {
                inner_ = std::make_unique<Scratch>();
                inner_->workspaces.resize(mine_->workspaces.size());
                mine_ = inner_.get();
            }
            mine_->isInMotion = true;
        }
        ~ForMotion() { mine_->isInMotion = false; }
        ForMotion(const ForMotion&) = delete;
        ForMotion& operator=(const ForMotion&) = delete;

        Scratch* operator->() const { return mine_; }

      private:
        Scratch* mine_;
        std::unique_ptr<Scratch> inner_;
    };

    /// The scratch of a thread is from the standard allocator: TBB's has locks, which do not survive a fork.
    tbb::enumerable_thread_specific<Both, std::allocator<Both>> perThread;

  private:
    std::size_t warmPoses_ = FreePoses::kFew;
};

struct SceneClearance::Enclosure {
    const std::string* obstacleMesh;
    const std::string* partMesh;
    bool isPartInside;
};

/// Counts the queries of the calling thread; see takeQueryTally.
QueryTally& tallyOfThisThread();

}  // namespace clearway
