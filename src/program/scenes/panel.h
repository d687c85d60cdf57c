// Sheet metal: a surface in a grid of two parameters, with openings, as a closed solid of some thickness.
#pragma once

#include <functional>
#include <vector>

#include "program/scenes/piece.h"
#include "program/scenes/section.h"

namespace clearway::scenes {

/// A hole in a panel, in its parameters.
struct Opening {
    Vector2 centre;
    Vector2 half;           ///< of its width in each parameter
    double squareness = 2;  ///< 2 is an ellipse; the larger, the nearer to a rectangle, 1e6 is one
};

struct PanelShape {
    /// Smooth; one unit of a parameter is about a millimetre. du x dv is the sheet's upper side.
    std::function<Vector3(double u, double v)> surface;
    Vector2 low, high;  ///< of the parameters
    double thickness = 1;
    double offset = 0;  ///< of the sheet's middle from the surface, towards its upper side
    std::vector<Opening> openings{};
    std::vector<double> uLines{}, vLines{};  ///< wanted among the grid's lines: where beads begin and end
    /// Among them however coarse they are. Openings that would bend one of v are left out.
    std::vector<double> keptULines{}, keptVLines{};
    double finer = 1;  ///< its grid's step is that of others over this
};

/// How finely a panel is cut.
struct PanelDetail {
    double step = 20;   ///< greatest distance of two lines, in the parameters
    int holeSpans = 2;  ///< least number of cells across an opening
};

/// The grid of a panel. Lines crowd where openings and beads want them: flat, long triangles between.
class Panel {
  public:
    /// Openings that reach into each other or beyond the border are left out, the later ones first; so are
    /// those below 200 mm for which the lines are too far apart.
    Panel(PanelShape shape, const PanelDetail& detail);

    std::size_t triangleCount() const;
    Piece piece() const;

  private:
    /// An opening as cells: [low, high) are missing, those within [outerLow, outerHigh) are bent to its
    /// shape.
    struct Block {
        int low[2], high[2], outerLow[2], outerHigh[2];
        double squareness;
    };

    void place(const Opening& opening);
    bool isMissing(int i, int j) const;
    Vector2 bentToOpenings(int i, int j) const;
    std::pair<Vector3, Vector3> sides(const Vector2& parameters) const;
    int cells(int axis) const { return static_cast<int>(lines_[axis].size()) - 1; }

    PanelShape shape_;
    std::vector<double> lines_[2];
    std::vector<Block> blocks_;
};

/// 0 before `from`, 1 after `to`, smooth between.
double smoothStep(double x, double from, double to);

/// 1 within `half` of the middle, 0 beyond half + flank, smooth between: the profile of a bead.
double beadAt(double x, double middle, double half, double flank);

}  // namespace clearway::scenes
