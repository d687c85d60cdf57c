// Compares the answers of validators to one motion with the motion's poses.
#pragma once

#include <ostream>

#include "support/motion_answers.h"

namespace clearway::testing {

/// Counts of motions.
struct MotionTally {
    int valid = 0, invalid = 0, undecided = 0;  ///< by the scene's own validator
    int kept = 0, lost = 0;                     ///< valid motions that keep or do not keep a floor
    int crossing = 0;                           ///< valid motions across a contact zone's border
    int atBorder = 0;                           ///< valid motions whose clearance a border leaves less sure
    int enclosed = 0;                           ///< invalid motions that solids alone block
    int outOfBounds = 0;                        ///< motions that leave the bounds after a certified part
    int turnLeftOut = 0;                        ///< valid motions whose turn OMPL leaves out until s2
    int otherValid = 0;                         ///< motions that another validator calls valid, too

    MotionTally& operator+=(const MotionTally& other);
};

std::ostream& operator<<(std::ostream& to, const MotionTally& tally);

/// Fails the running test where an answer contradicts the validity or the clearance of one of at least so many
/// poses, another answer, or the contract of validators.
MotionTally judgeMotion(const CrowdedScene& scene, const OtherValidators& others, const HardMotion& motion,
                        int poses, Random& random);

}  // namespace clearway::testing
