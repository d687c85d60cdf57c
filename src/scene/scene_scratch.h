// The parts of SceneClearance that its files share: the data that threads keep between queries.
#pragma once

#include <tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <array>
#include <limits>
#include <memory>
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

/// The last poses found free. Planners check a state and then several motions to it.
class SceneClearance::FreePoses {
  public:
    bool contain(const Pose& pose) const {
        return std::any_of(poses_.begin(), poses_.end(), [&](const Pose& known) {
            return known.translation == pose.translation && known.rotation == pose.rotation;
        });
    }
    void add(const Pose& pose) {
        poses_[next_] = pose;
        next_ = (next_ + 1) % poses_.size();
    }

  private:
    static constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    std::array<Pose, 8> poses_ = noPoses();
    std::size_t next_ = 0;

    /// NaN equals no pose.
    static std::array<Pose, 8> noPoses() {
        std::array<Pose, 8> none;
        none.fill({Matrix3::Identity(), Vector3::Constant(kNone)});
        return none;
    }
};

/// The data that one thread keeps from query to query.
struct SceneClearance::Scratch {
    std::vector<Workspace> workspaces;  ///< one for each obstacle
    std::size_t nearest = 0;            ///< the obstacle that was nearest, or in the way, last time
    FreePoses freePoses{};
    bool isInMotion = false;  ///< a query of a motion is under way; see ThreadScratch::ForMotion
};

struct SceneClearance::ThreadScratch {
    struct Both {
        Scratch warm, cold{};  ///< cold: made by the first ColdStart
        bool isCold = false;
    };

    explicit ThreadScratch(std::size_t obstacles)
        : perThread([obstacles] { return Both{Scratch{std::vector<Workspace>(obstacles)}}; }) {}

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
};

struct SceneClearance::Enclosure {
    const std::string* obstacleMesh;
    const std::string* partMesh;
    bool isPartInside;
};

/// Counts the queries of the calling thread; see takeQueryTally.
QueryTally& tallyOfThisThread();

}  // namespace clearway
