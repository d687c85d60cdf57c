// Lines through space as points, and what is pulled along them: hoses, pipes, cables.
#pragma once

#include <functional>
#include <vector>

#include "program/scenes/piece.h"
#include "program/scenes/section.h"

namespace clearway::scenes {

using Line = std::vector<Vector3>;

/// Spine::through as a line of points, as pipes are bent, a quarter turn cut into `segmentsPerQuarter`
/// chords.
Line bent(const Line& line, double radius, int segmentsPerQuarter);

/// A smooth curve through all the points (a centripetal Catmull-Rom spline), as hoses and cables hang, in
/// steps of about `step`, at least two between two points.
Line smooth(const Line& points, double step);

/// The section pulled along the line, on frames that do not twist: its first direction is perpendicular to
/// the line and at the beginning nearest to `first`. The line's corners are mitred by half; it must not turn
/// back on itself more sharply than the section is wide.
Piece pulled(const Section& section, const Line& line, const Vector3& first = Vector3::UnitZ());

/// A round bar along the line.
Piece rod(const Line& line, double radius, int segments);

/// A pipe along the line, open at its ends.
Piece pipe(const Line& line, double radius, double wall, int segments);

/// A round bar whose radius is given along its length (mm from the beginning): conduits, bellows, plugs.
Piece variedRod(const Line& line, const std::function<double(double)>& radiusAt, int segments);

double lengthOf(const Line& line);

}  // namespace clearway::scenes
