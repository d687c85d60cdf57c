// The room a part needs on its way: what is built around the path stays out of it.
#pragma once

#include <vector>

#include "clearway/problem.h"
#include "program/scenes/piece.h"

namespace clearway::scenes {

class KeptFree {
  public:
    /// boxes: hold the part, in its own coordinates.
    explicit KeptFree(std::vector<Box> boxes);

    /// Adds the room within `margin` of the boxes on the straight motion with the shortest rotation between
    /// two states, a planner's interpolation.
    void addMotion(const PartState& from, const PartState& to, double margin);

    /// True when every triangle of the piece is farther than the margin from the boxes all along the motions;
    /// may be false when one is a little farther than that.
    bool isClearOf(const Piece& piece) const;

  private:
    struct Obstacle {  ///< a grown box at a pose on the way
        Pose X_partWorld;
        Box box;      ///< part coordinates
        Box inWorld;  ///< its bounds
    };

    bool meets(const Vector3& a, const Vector3& b, const Vector3& c) const;

    std::vector<Box> boxes_;
    double radius_ = 0;  ///< of the boxes about the part's origin
    std::vector<Obstacle> obstacles_;
    Box all_;
};

}  // namespace clearway::scenes
