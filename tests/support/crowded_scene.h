// Scenes with all that motions know: several obstacles with margins of their own, contact zones, solids, overlaps and
// reaches; also far from the origin, with a part far from its own origin, and made of needles.
#pragma once

#include <ompl/base/ScopedState.h>
#include <ompl/base/SpaceInformation.h>

#include <memory>
#include <string>
#include <vector>

#include "clearway/planning/motion_validator.h"
#include "clearway/planning/validity_checker.h"
#include "clearway/problem.h"

namespace clearway::testing {

/// Describes a crowded scene before its two moves: `bodyInPart` moves the body away from the origin of the part's
/// coordinates, `at` moves everything else. All lengths, places and boxes are those before the moves.
struct CrowdedLayout {
    struct Piece {
        Mesh mesh;
        double margin = 0;
        bool isSolid = false, isIgnoredAtStart = false, isIgnoredAtGoal = false;
        double overlap = 0;           ///< how deep the piece may reach into the body, or
        bool isItselfShrunk = false;  ///< the body into the piece
    };
    /// A pose of the body at and near which motions begin and end.
    struct Place {
        PartState body;
        Vector3 wayOut = Vector3::Zero();  ///< unit vector out of the contact there; 0 where there is none
    };
    std::string name;
    Space kind = Space::kSe3;
    Mesh body;
    std::vector<Piece> pieces;
    Box room;                   ///< the body's positions
    std::vector<Place> places;  ///< the first two are the assembled poses at start and goal
    double spread = 10;         ///< how far from a place
    double turn = M_PI;         ///< from a place, radians
    double startZone = 0;       ///< length of the contact zone about the first place; 0 for none
    double goalZone = 0;        ///< about the second place

    Vector3 at = Vector3::Zero();          ///< the environment is moved here
    Vector3 bodyInPart = Vector3::Zero();  ///< the body is moved here in the part's coordinates
    bool hasRange = false;                 ///< obstacles are built for the bounds, and lose a piece far away
};

/// Stops searches that take long, which leaves their motions undecided. It counts how often a validator asks whether
/// to stop; call begin before each motion.
struct SearchLimit {
    static constexpr int kMost = 1000;
    std::shared_ptr<int> asked = std::make_shared<int>(0);

    void begin() const { *asked = 0; }
    bool isReached() const { return *asked > kMost; }
    planning::MotionOptions options() const {
        planning::MotionOptions limited;
        limited.isStopped = [count = asked] { return ++*count > kMost; };
        return limited;
    }
};

struct CrowdedScene {
    explicit CrowdedScene(const CrowdedLayout& layout);

    /// The part's state where its body has this one, and back.
    PartState partState(const PartState& body) const;
    PartState bodyState(const ompl::base::State* state) const;
    ompl::base::ScopedState<> state(const PartState& body) const {
        return planning::toOmpl(space, kind, partState(body));
    }

    bool hasZones() const { return scene.startContact || scene.goalContact; }

    std::string name;
    Space kind;
    std::vector<CrowdedLayout::Place> places;
    double spread, turn;
    Vector3 bodyInPart;
    Scene scene;
    ompl::base::StateSpacePtr space;
    ompl::base::SpaceInformationPtr si;
    std::shared_ptr<planning::ValidityChecker> checker;
    SearchLimit limit;                                     ///< of the validator
    std::shared_ptr<planning::MotionValidator> validator;  ///< both belong to si
    std::shared_ptr<planning::MotionValidator> close;      ///< has a hundredth of the other's least interval
    double mostClearance;                                  ///< the obstacles' reaches tell no more
    double diagonal;                                       ///< of the part
    double rounding;  ///< twice the default width of a distance's interval
};

std::vector<CrowdedLayout> crowdedLayouts();

}  // namespace clearway::testing
