// A plane line with rounded corners by its length: what pressed sheets follow across their beads.
#pragma once

#include <vector>

#include "program/scenes/section.h"

namespace clearway::scenes {

class Profile {
  public:
    /// The line with each inner corner replaced by an arc of its radius, or of the largest one that fits.
    /// radii: one for each inner corner.
    Profile(const Polyline& line, const std::vector<double>& radii);

    double length() const { return length_; }

    /// The point at that length; before the beginning and after the end the line goes on straight.
    Vector2 at(double length) const;

    /// Where arcs begin and end, and between so that no chord spans more than 90 degrees /
    /// segmentsPerQuarter.
    std::vector<double> arcLines(int segmentsPerQuarter) const;

    /// The length at which the inner corner's arc is half way.
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

}  // namespace clearway::scenes
