// Smooth lines: a spine of straights and circular bends in space, a profile with rounded corners in the
// plane, and lines of points for pipes and hoses.
#pragma once

#include <vector>

#include "demos/scenes/section.h"

namespace clearway::scenes {

/// Positions evenly spaced from first to last, at most `step` apart.
std::vector<double> stationsBetween(double first, double last, double step);

class Spine {
  public:
    /// X_worldStart: the line begins along x; y and z span its sections.
    explicit Spine(const Pose& X_worldStart = {}) : end_(X_worldStart) {}

    /// From the first point to the last, each corner replaced by a bend of the radius, or of the largest one
    /// that fits. At least two points, no two neighbours equal. The first frame's z is as near to `up` as the
    /// direction allows.
    static Spine through(const std::vector<Vector3>& points, double radius,
                         const Vector3& up = Vector3::UnitZ());

    Spine& straight(double length);

    /// Turns by `angle` > 0 (radians) towards the direction `towards` radians from the frame's y to its z.
    Spine& bend(double radius, double angle, double towards = 0);

    double length() const { return length_; }

    /// The frame (x along the line) at that length; the line continues straight beyond both ends.
    Pose frameAt(double length) const;

    /// Lengths at which sections are placed: the ends of all pieces, straights cut into steps no longer than
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

class Profile {
  public:
    /// The line with each inner corner replaced by an arc of its radius, or of the largest one that fits.
    /// radii: one for each inner corner.
    Profile(const Polyline& line, const std::vector<double>& radii);

    double length() const { return length_; }

    /// The point at that length; the line continues straight beyond both ends.
    Vector2 at(double length) const;

    /// Lengths where arcs begin and end, and between so that no chord spans more than 90 degrees /
    /// segmentsPerQuarter.
    std::vector<double> arcLines(int segmentsPerQuarter) const;

    /// The length at the middle of the inner corner's arc.
    double corner(std::size_t index) const { return corners_[index]; }

  private:
    struct Leg {
        double start, length, curvature;  ///< curvature > 0 turns left
        Vector2 from, direction;
    };
    void add(double length, double curvature);

    std::vector<Leg> legs_;
    std::vector<double> corners_;
    double length_ = 0;
    Vector2 end_, direction_;
};

using Line = std::vector<Vector3>;

/// Spine::through as a line of points, for pipes: a quarter turn is cut into `segmentsPerQuarter` chords.
Line bent(const Line& line, double radius, int segmentsPerQuarter);

/// A smooth curve through all the points (a centripetal Catmull-Rom spline), for hoses and cables, in steps
/// of about `step`, at least two steps between two points.
Line smooth(const Line& points, double step);

double lengthOf(const Line& line);

}  // namespace clearway::scenes
