// Samples of valid states where a planner's roadmap lacks them: beside obstacles, and in gaps between them.
// For planners that ask for valid states (PRM and its kin), by
//   si->setValidStateSamplerAllocator([](const auto* si) { return std::make_shared<NarrowGapSampler>(si); });
#pragma once

#include <ompl/base/SpaceInformation.h>
#include <ompl/base/ValidStateSampler.h>

#include <memory>

#include "clearway/planning/validity_checker.h"
#include "clearway/types.h"

namespace clearway::planning {

/// Moves the part by what its scene says at a state. Not to be shared by threads, as OMPL's samplers.
class WitnessSampler : public ompl::base::ValidStateSampler {
  protected:
    /// Throws std::invalid_argument when si's validity checker is none of clearway's or its space is neither
    /// SE(3) nor SE(2), by name.
    WitnessSampler(const ompl::base::SpaceInformation* si, const char* name);
    ~WitnessSampler() override;

    struct Room {
        bool isValid = false;
        double clearance = 0;            ///< as ValidityChecker::clearance
        Vector3 away = Vector3::Zero();  ///< of length 1, from the nearest obstacle; 0 when there is none
    };
    Room roomAt(const ompl::base::State* state) const;
    void translate(ompl::base::State* state, const Vector3& by) const;
    double partDiagonal() const;

    std::shared_ptr<const ValidityChecker> checker_;
    ompl::base::StateSamplerPtr sampler_;
    ompl::base::State* other_;  ///< scratch
    bool isPlanar_;
};

/// A state as it is drawn when it is valid and has the wanted clearance. One that is too near is moved along
/// the witness normal until it has that clearance, or as much of it as a few moves give. One that collides is
/// first moved towards a valid one beside it, as far as it collides.
/// Its parameter "clearance" is that length, in environment units; a hundredth of the part's diagonal at
/// first.
class ContactNormalSampler : public WitnessSampler {
  public:
    /// Throws as WitnessSampler does.
    explicit ContactNormalSampler(const ompl::base::SpaceInformation* si);
    ~ContactNormalSampler() override;

    bool sample(ompl::base::State* state) override;

    /// No farther than distance from near. False when no attempt gave one.
    bool sampleNear(ompl::base::State* state, const ompl::base::State* near, double distance) override;

  private:
    bool settle(ompl::base::State* state);
    bool pushAway(ompl::base::State* state) const;

    double wanted_;
    double beside_;
    ompl::base::State* free_;  ///< scratch
};

/// Only states in gaps: the part, moved away from its nearest obstacle, comes near another one on the far
/// side. It is put in the middle between the two, where its clearance is at most half the gap. Candidates are
/// valid states near obstacles, and those in the middle between two that collide (the bridge test of Hsu,
/// Jiang, Reif and Sun, 2003).
/// Its parameter "gap" is how far the part may be able to move between the two, in environment units; a tenth
/// of the part's diagonal at first.
class NarrowGapSampler : public WitnessSampler {
  public:
    /// Throws as WitnessSampler does.
    explicit NarrowGapSampler(const ompl::base::SpaceInformation* si);

    /// False when no attempt met a gap: planners try again.
    bool sample(ompl::base::State* state) override;

    /// No farther than distance from near. False when no attempt gave one.
    bool sampleNear(ompl::base::State* state, const ompl::base::State* near, double distance) override;

  private:
    bool findGap(ompl::base::State* state);
    bool centre(ompl::base::State* state) const;
    void balance(ompl::base::State* state, const Vector3& away, double width) const;

    double gap_;
};

}  // namespace clearway::planning
