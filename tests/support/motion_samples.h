// Poses along a motion, as the validity checker judges them.
#pragma once

#include <ompl/base/ScopedState.h>

#include <vector>

#include "support/hard_motion.h"

namespace clearway::testing {

/// The last time of OMPL's interpolation, and the first one; times 1 and 0 stand for s2 and s1.
constexpr double kJustBeforeEnd = 1 - 0x1p-53, kJustAfterStart = 1e-300;

struct MotionSample {
    double time, clearance;
    bool isValid;
};

/// The motion must outlive the samples.
class MotionSamples {
  public:
    MotionSamples(const CrowdedScene& scene, const HardMotion& motion)
        : scene_(scene), s1_(motion.s1.get()), s2_(motion.s2.get()), between_(scene.space) {}

    /// Looks at poses evenly spread over the motion, and at more of them at both ends of its part up to a time,
    /// and where that part's clearance is least.
    void take(int poses, double until);

    /// Looks at one pose. It is valid when both isValid and clearance say so; they must agree.
    MotionSample look(double time);

    /// s1 at time 0, s2 at time 1, otherwise OMPL's interpolation, until the next call.
    const ompl::base::State* stateAt(double time);

    /// The samples of take by time, then those of look.
    const std::vector<MotionSample>& all() const { return all_; }

    /// The first sample up to a time that is not valid, or else the one with the least clearance.
    MotionSample worst(double until) const;

    /// Whether a pose is so close to the border of a contact zone that obstacles may or may not count there.
    bool isAtZoneBorder(double time);
    bool isSomewhereAtZoneBorder();

  private:
    double fromBorder(const ContactZone& zone, double time);

    const CrowdedScene& scene_;
    const ompl::base::State *s1_, *s2_;
    ompl::base::ScopedState<> between_;
    std::vector<MotionSample> all_;
};

}  // namespace clearway::testing
