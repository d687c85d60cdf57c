// The verdicts, reports and profiles that several validators give for one motion of a crowded scene.
#pragma once

#include <string>

#include "support/hard_motion.h"

namespace clearway::testing {

/// Validators that must not contradict the scene's own one.
struct OtherValidators {
    explicit OtherValidators(const CrowdedScene& scene);

    planning::MotionValidator reversed;     ///< has the obstacles in the opposite order
    planning::MotionValidator byCallbacks;  ///< is given the motions of the part by callbacks
    planning::MotionValidator byClearance;  ///< certifies by clearances of the whole part
};

/// The answers of one validator to one motion. Checks that they are complete and consistent in themselves.
struct MotionAnswers {
    MotionAnswers(std::string name, const planning::MotionValidator& validator, const CrowdedScene& scene,
                  const HardMotion& motion);

    const planning::MotionReport& report() const { return profile.report; }
    bool says(planning::MotionVerdict verdict) const;
    /// The time up to which some answer certifies the motion.
    double certified() const;

    std::string name;
    double leastInterval;
    planning::MotionVerdict check, forward;  ///< of checkMotion without and with lastValid
    double lastValid = 1;
    planning::MotionProfile profile;  ///< of long motions it has only the report
    bool isStopped = false;           ///< by the scene's limit
};

}  // namespace clearway::testing
