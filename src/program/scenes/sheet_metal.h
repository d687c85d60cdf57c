// What bodies of sheet metal are collected in: panels, beams along spines and small parts, made or only
// counted.
#pragma once

#include <string>

#include "program/scenes/detail.h"
#include "program/scenes/loft.h"
#include "program/scenes/panel.h"
#include "program/scenes/spine.h"

namespace clearway::scenes {

class SheetMetal {
  public:
    /// onlyCount: nothing large is made, triangleCount() is the same.
    SheetMetal(const Detail& detail, bool onlyCount) : detail_(detail), onlyCount_(onlyCount) {}

    const Detail& detail() const { return detail_; }

    /// Names are used once.
    void panel(const std::string& name, const PanelShape& shape);

    /// A section along a spine, cut as finely as the detail says.
    void beam(const std::string& name, const Spine& spine, const Section& section);

    /// One of many, named by `stem` and a number.
    void part(const std::string& stem, const Piece& piece);

    /// An outline turned about z (see turned), its foot at `at`, its axis along `axis`.
    void turnedPart(const std::string& stem, const Polyline& outline, const Vector3& at, const Vector3& axis);

    /// All that the other has, its names with the prefix before them. Both only count, or neither does.
    void include(const std::string& prefix, const SheetMetal& other);

    /// Runs `build` twice: as it is, for the side of positive y, its names ending in _right, then mirrored at
    /// y = 0, ending in _left.
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

    /// A line with each inner corner rounded by `radius`.
    Polyline rounded(const Polyline& line, double radius) const;

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

/// A mesh's sheet metal at that detail with so many studs beside it, all of the same number of triangles.
using BuildSheetMetal = std::function<SheetMetal(const Detail& detail, int studs, bool onlyCount)>;

/// The build at the finest detail, filled up with studs. Where the coarsest has more triangles, small
/// components are left out, except those whose names begin as `kept` says; studs do. Throws as finestDetail.
Mesh sheetMetalTo(std::size_t triangles, const std::string& option, const FinenessRange& range,
                  const std::vector<std::string>& kept, const BuildSheetMetal& build);

/// A hat open below, `width` and `height` at the top, its flanges standing out by `flange` on the line z = 0.
Polyline hatLine(double width, double height, double flange);

/// Solids of a section that is given along (-x, z), pulled along y from one value to another.
Spine across(double fromY, double toY);

}  // namespace clearway::scenes
