// Widens a path: a band of states is pushed off the planes of contact around it while it pulls itself smooth.
// Source of bands: Quinlan, Khatib, Elastic Bands: Connecting Path Planning and Control, 1993.
#pragma once

#include <ompl/geometric/PathGeometric.h>

#include <cstdint>
#include <functional>
#include <limits>
#include <optional>

#include "clearway/planning/motion_validator.h"

namespace clearway::planning {

/// The first share by which a band tries to raise its clearance.
constexpr double kFirstBandGain = 0.3;

/// So many stages of 16 sweeps without gain, ever finer, show that there is hardly more to gain.
constexpr int kMostIdleStages = 24;

/// The clearance to keep while a path is shortened before its band, as a share of the diagonal of the part's box. A band that
/// begins in contact begins slowly.
constexpr double kClearanceBeforeBand = 1e-3;

struct WideningOptions {
    /// Clearance that all motions of the path keep, by MotionValidator::keepsClearance. Environment units, >= 0.
    double clearance = 0;
    /// More clearance than this is not looked for. Nor is more than the clearances of the two ends, or the diagonal of
    /// the part's box.
    double enough = std::numeric_limits<double>::infinity();
    /// Shares of the clearance gained by which the band tries to raise it, at first; > 0. Small shares take long, and
    /// get on where larger ones want the impossible. They become smaller when the band no longer gains.
    double gain = kFirstBandGain;
    /// The band ends after so many sweeps over its states, which is the repeatable limit. Without a limit the band ends
    /// when it no longer gains.
    std::optional<std::uint64_t> sweeps;
    int idleStages = kMostIdleStages;  ///< stages without gain, one after the other, that end the band
    std::function<bool()> isSpent;     ///< called often, also within motions; true ends the band at once
    std::function<void(double)>
        onGain;  ///< called with the clearance kept when a path that keeps more replaced the path
};

/// Moves the states between the first and the last, and adds and removes some, so that the least clearance of the path
/// grows. Returns the clearance that all motions keep then, by MotionValidator::keepsClearance, which is at least
/// options.clearance. The path is replaced only by paths that keep more, so that isSpent may end the band at any time.
/// The way that the path takes around obstacles stays as it is.
///
/// Throws ArgumentError when the space is neither OMPL's SE(3) nor SE(2), when options.clearance is negative or
/// not finite, or options.gain is not above 0.
double widenPath(ompl::geometric::PathGeometric& path, const MotionValidator& validator,
                 const WideningOptions& options);

}  // namespace clearway::planning
