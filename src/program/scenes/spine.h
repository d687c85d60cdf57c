// Smooth lines through space, made of straights and circular bends, and sections swept along them: bars,
// hoses, cables, beams that follow a body. The frame is carried along without twist, so that a bend is one
// rotation about one axis.
#pragma once

#include <vector>

#include "program/scenes/sweep.h"

namespace clearway::scenes {

class Spine {
  public:
    /// X_worldStart: x is the direction in which the line begins, y and z span its section.
    explicit Spine(const Pose& X_worldStart = {}) : end_(X_worldStart) {}

    /// From the first point to the last, each corner replaced by a bend of the radius; where that does not
    /// fit, by the largest that does. At least two points, no two neighbours equal. The first frame's z is as
    /// near to `up` as the direction allows.
    static Spine through(const std::vector<Vector3>& points, double radius,
                         const Vector3& up = Vector3::UnitZ());

    Spine& straight(double length);

    /// Turns by `angle` > 0 (radians) towards the direction that lies `towards` radians from the frame's y to
    /// its z.
    Spine& bend(double radius, double angle, double towards = 0);

    double length() const { return length_; }

    /// The frame (x along the line) at that length; before the beginning and after the end the line goes on
    /// straight.
    Pose frameAt(double length) const;

    /// Lengths at which to put sections: the ends of all pieces, straights cut into pieces no longer than
    /// `longestStep`, bends into angles no larger than `largestAngle`.
    std::vector<double> stations(double longestStep, double largestAngle) const;

    struct Piece {
        Pose X_worldStart;
        double start = 0;  ///< length from the spine's beginning
        double length = 0;
        double curvature = 0;  ///< 0 for a straight
        double towards = 0;
    };
    const std::vector<Piece>& pieces() const { return pieces_; }

  private:
    std::vector<Piece> pieces_;
    Pose end_;
    double length_ = 0;
};

/// The section, its first coordinate along the frame's y and its second along z, at the stations (which
/// increase). scales: one for each station, or none at all for 1 everywhere. Bends must be wider than the
/// section.
Piece sweptAlong(const Spine& spine, const Section& section, const std::vector<double>& stations,
                 const std::vector<double>& scales = {});

}  // namespace clearway::scenes
