// Samplers of valid states where a planner's roadmap lacks them: beside obstacles, and in gaps between them.
// Planners that ask for valid states (PRM and its kin) use one after
//   si->setValidStateSamplerAllocator([](const auto* si) { return std::make_shared<NarrowGapSampler>(si); });
#pragma once

#include <ompl/base/SpaceInformation.h>
#include <ompl/base/ValidStateSampler.h>

#include <memory>

#include "clearway/planning/validity_checker.h"
#include "clearway/types.h"

#pragma GCC visibility push(default)

namespace clearway::planning {

/// The base of samplers that move the part along the witness normal of its nearest obstacle. Like OMPL's
/// samplers, one must not be shared by threads.
class WitnessSampler : public ompl::base::ValidStateSampler {
  public:
    /// Draws a state from the whole space. Returns false when no attempt succeeded: planners try again.
    bool sample(ompl::base::State* state) override;

    /// Samples no farther than `distance` from `near`. Returns false when no attempt succeeded.
    bool sampleNear(ompl::base::State* state, const ompl::base::State* near, double distance) override;

  protected:
    /// Throws ArgumentError when si's validity checker is none of clearway's or its space is neither
    /// SE(3) nor SE(2), by name.
    WitnessSampler(const ompl::base::SpaceInformation* si, const char* name);
    ~WitnessSampler() override;

    /// The clearance of the part at a state.
    struct StateClearance {
        bool isValid = false;  ///< ValidityChecker::isValid
        double clearance = 0;  ///< ValidityChecker::clearance
        Vector3 away =
            Vector3::Zero();  ///< unit vector away from the nearest obstacle; 0 without an obstacle
    };

    /// Turns a drawn state into one that the sampler is for. Returns false where it finds none.
    virtual bool settle(ompl::base::State* state) = 0;

    /// Asks the checker about a state.
    StateClearance clearanceAt(const ompl::base::State* state) const;

    /// Moves a state's position; environment's frame and units. In SE(2) by.z() is left out.
    void translate(ompl::base::State* state, const Vector3& by) const;

    /// Diagonal of the part's box, in environment units.
    double partDiagonal() const;

    std::shared_ptr<const ValidityChecker> checker_;  ///< that of the space information
    ompl::base::StateSamplerPtr sampler_;             ///< draws states of the space, valid or not
    ompl::base::State* other_;                        ///< scratch
    bool isPlanar_;                                   ///< whether the space is SE(2)
};

/// Keeps a drawn state that is valid and has the wanted clearance. A state that is too near is moved along
/// the witness normal until it has that clearance, or as much of it as a few moves give. A state that
/// collides is first moved towards a valid state beside it, until it collides no more. The parameter
/// "clearance" is the wanted clearance, in environment units. Its default is a hundredth of the part's
/// diagonal.
class ContactNormalSampler : public WitnessSampler {
  public:
    /// Throws as WitnessSampler does.
    explicit ContactNormalSampler(const ompl::base::SpaceInformation* si);
    ~ContactNormalSampler() override;

  private:
    bool settle(ompl::base::State* state) override;
    bool pushAway(ompl::base::State* state) const;

    double wanted_;
    double beside_;
    ompl::base::State* free_;  ///< scratch
};

/// Samples only states in gaps: the part, moved away from its nearest obstacle, comes near another obstacle
/// on the far side. The sampler puts it in the middle between the two, where its clearance is at most half
/// the gap. Candidates are valid states near obstacles, and states in the middle between two that collide
/// (the bridge test of Hsu, Jiang, Reif and Sun, 2003). The parameter "gap" is the farthest that the part can
/// move between the two obstacles, in environment units. Its default is a tenth of the part's diagonal.
class NarrowGapSampler : public WitnessSampler {
  public:
    /// Throws as WitnessSampler does.
    explicit NarrowGapSampler(const ompl::base::SpaceInformation* si);

  private:
    bool settle(ompl::base::State* state) override;
    bool centre(ompl::base::State* state) const;
    void balance(ompl::base::State* state, const Vector3& away, double width) const;

    double gap_;
};

}  // namespace clearway::planning

#pragma GCC visibility pop
