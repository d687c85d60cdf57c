// Bodies of sheet metal: panels, which are surfaces with openings as closed solids of some thickness, beams
// along spines and small parts.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "demos/scenes/solids.h"

namespace clearway::scenes {

/// A hole in a panel, in the panel's parameters.
struct Opening {
    Vector2 centre;
    Vector2 half;           ///< half its width in each parameter
    double squareness = 2;  ///< 2 is an ellipse; the larger, the nearer to a rectangle, 1e6 is one
};

struct PanelShape {
    /// Smooth; one unit of a parameter is about a millimetre. du x dv points to the sheet's upper side.
    std::function<Vector3(double u, double v)> surface;
    Vector2 low, high;  ///< range of the parameters
    double thickness = 1;
    double offset = 0;  ///< distance of the sheet's middle from the surface, towards its upper side
    std::vector<Opening> openings{};
    std::vector<double> uLines{}, vLines{};  ///< preferred grid lines: where beads begin and end
    /// Grid lines at any coarseness. Openings that would bend one of the kept v lines are left out.
    std::vector<double> keptULines{}, keptVLines{};
    double finer = 1;  ///< divides the step of the panel's grid
};

/// How finely a panel is cut.
struct PanelDetail {
    double step = 20;   ///< greatest distance of two neighbouring lines, in the parameters
    int holeSpans = 2;  ///< least number of cells across an opening
};

/// The grid of a panel. Lines crowd at openings and beads; flat regions get long triangles.
class Panel {
  public:
    /// Openings that overlap an earlier opening or reach beyond the border are left out. So are openings
    /// below 200 mm for which the grid's lines are too far apart.
    Panel(PanelShape shape, const PanelDetail& detail);

    std::size_t triangleCount() const;
    Piece piece() const;

  private:
    /// An opening as cells: those in [low, high) are missing, those within [outerLow, outerHigh) are bent to
    /// its shape.
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

/// Rises smoothly from 0 at `from` to 1 at `to`.
double smoothStep(double x, double from, double to);

/// The profile of a bead: 1 within `half` of the middle, falling smoothly to 0 at half + flank.
double beadAt(double x, double middle, double half, double flank);

class SheetMetal {
  public:
    /// onlyCount: only triangleCount() is computed, nothing large is built.
    SheetMetal(const Detail& detail, bool onlyCount) : detail_(detail), onlyCount_(onlyCount) {}

    const Detail& detail() const { return detail_; }

    /// Each name may be used once.
    void panel(const std::string& name, const PanelShape& shape);

    /// Adds a section pulled along a spine, cut as finely as the detail says.
    void beam(const std::string& name, const Spine& spine, const Section& section);

    /// Adds one of many similar parts, named by `stem` and a number.
    void part(const std::string& stem, const Piece& piece);
    /// The piece with its origin at `at` and its z along `axis`, as standingAt() says.
    void part(const std::string& stem, const Piece& piece, const Vector3& at, const Vector3& axis,
              double turn = 0) {
        part(stem, placed(piece, standingAt(at, axis, turn)));
    }

    /// Adds an outline turned about z (see turned), its foot at `at`, its axis along `axis`.
    void turnedPart(const std::string& stem, const Polyline& outline, const Vector3& at,
                    const Vector3& axis) {
        part(stem, placed(turned(outline, detail_.segmentsPerTurn), standingAt(at, axis)));
    }

    /// Adds everything from the other; the prefix is put before its names. Both must have equal onlyCount.
    void include(const std::string& prefix, const SheetMetal& other);

    /// Runs `build` twice: first unchanged, for the side of positive y, with names that end in _right, then
    /// mirrored at y = 0, with names that end in _left.
    template <class Build>
    void onBothSides(const Build& build) {
        for (const bool mirrored : {false, true}) {
            mirrored_ = mirrored;
            ending_ = mirrored ? "_left" : "_right";
            build();
        }
        mirrored_ = false;
        ending_.clear();
    }

    /// The line with each inner corner rounded by `radius`.
    Polyline rounded(const Polyline& line, double radius) const {
        return filleted(line, std::vector<double>(line.size() - 2, radius), detail_.segmentsPerQuarter);
    }

    std::size_t triangleCount() const { return triangles_; }
    const Assembly& assembly() const { return assembly_; }

  private:
    void add(const std::string& name, Piece piece);

    Detail detail_;
    bool onlyCount_;
    bool mirrored_ = false;
    std::string ending_;
    std::size_t triangles_ = 0;
    Assembly assembly_;
};

/// Builds a mesh's sheet metal at that detail with that number of studs; all studs have equally many
/// triangles.
using BuildSheetMetal = std::function<SheetMetal(const Detail& detail, int studs, bool onlyCount)>;

/// The build at the finest detail, filled up with studs. Throws as finestDetail does.
Mesh sheetMetalTo(std::size_t triangles, const std::string& option, const FinenessRange& range,
                  const BuildSheetMetal& build);

/// If even the coarsest build has too many triangles, small components are left out, except those whose names
/// begin with an entry of `kept`, which include the studs'.
Mesh sheetMetalTo(std::size_t triangles, const std::string& option, const FinenessRange& range,
                  const std::vector<std::string>& kept, const BuildSheetMetal& build);

/// A hat profile, open below, `width` and `height` at the top, with flanges of length `flange` on the line z
/// = 0.
Polyline hatLine(double width, double height, double flange);

/// A straight spine along y between two values, for sections given in (-x, z).
Spine across(double fromY, double toY);

}  // namespace clearway::scenes
