// The material of scenes: closed solids, placed in space and collected under names; how finely they are cut
// and how many details there are; and the search for the detail that gives the wanted number of triangles.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "clearway/mesh.h"

namespace clearway::scenes {

/// One closed solid, its triangles counter-clockwise seen from outside.
struct Piece {
    std::vector<Vector3> vertices;
    std::vector<TriangleIndices> triangles;
};

/// Maps a point of a piece. A placement must keep right-handed axes right-handed, or the piece turns inside
/// out.
using Placement = std::function<Vector3(const Vector3&)>;

Piece placed(Piece piece, const Placement& placement);

/// The placement that puts a piece's origin at `origin` and its z axis along `axis`, turned by `turn` radians
/// about the axis.
Placement standingAt(const Vector3& origin, const Vector3& axis, double turn = 0);

/// The placement that puts a piece's origin at `origin`, its z axis along `up`, and its x axis as nearly
/// along `along` as `up` allows.
Placement facing(const Vector3& origin, const Vector3& along, const Vector3& up);

/// Pieces as the named components of one mesh, in the order they were added.
class Assembly {
  public:
    void add(const std::string& name, const Piece& piece);

    /// Adds the other's components; the prefix is put before their names.
    void include(const std::string& prefix, const Assembly& other);

    /// A new numbered name: the number of names made from `stem` so far, plus one, in two digits: "rib" gives
    /// "rib_01", "rib_02", ...
    std::string nextName(const std::string& stem);

    void addNumbered(const std::string& stem, const Piece& piece) { add(nextName(stem), piece); }

    std::size_t triangleCount() const { return mesh_.triangles.size(); }
    const std::vector<Component>& components() const { return mesh_.components; }

    /// The assembly without the components whose entry in `isKept` is false.
    Assembly keeping(const std::vector<bool>& isKept) const;

    /// The bounding box of a component.
    Box boxOf(std::size_t component) const;

    /// The mesh moved by `shift`, its coordinates rounded to float: mesh files hold no more.
    Mesh mesh(const Vector3& shift = Vector3::Zero()) const;

  private:
    Mesh mesh_;
    std::vector<std::pair<std::string, int>> counts_;
};

/// Throws std::invalid_argument, naming the option, unless the number is `least` to 4 million. `where` ends
/// the message.
void requireTriangles(std::size_t triangles, const std::string& option, std::size_t least,
                      const std::string& where = "");

struct Detail {
    int segmentsPerQuarter = 2;
    int segmentsPerTurn = 16;  ///< a multiple of 4
    double step = 60;          ///< mm between a sweep's stations
    double richness = 1;       ///< numbers of details are multiplied by it

    int count(double atRichnessOne) const;  ///< at least 1
};

/// The range of the fineness, the one number that determines a Detail.
struct FinenessRange {
    double step = 60;     ///< mm between a sweep's stations at fineness 1
    double coarsest = 1;  ///< the least fineness; below 1 roundings are single chords and details are few
};

/// The finest detail at which countAt gives at most `triangles`. option: the name of the number in error
/// messages. Throws std::invalid_argument when even the coarsest detail has more triangles, or when more than
/// 4 million are asked for.
Detail finestDetail(std::size_t triangles, const std::string& option, const FinenessRange& range,
                    const std::function<std::size_t(const Detail&)>& countAt);

Detail coarsestDetail(const FinenessRange& range);

/// Leaves out small components, the one with the smallest box first, until at most `triangles` remain.
/// Components whose names begin with an entry of `kept` stay. Throws std::invalid_argument if these
/// components alone have more triangles.
Assembly leavingOutSmall(const Assembly& whole, std::size_t triangles, const std::string& option,
                         const std::vector<std::string>& kept);

/// Builds a mesh's pieces at that detail with that number of studs; all studs have equally many triangles.
using BuildAssembly = std::function<Assembly(const Detail& detail, int studs)>;

/// The build at the finest detail, filled up with studs. Throws as finestDetail does.
Mesh buildTo(std::size_t triangles, const std::string& option, const FinenessRange& range,
             const BuildAssembly& build);

/// If even the coarsest build has too many triangles, small components are left out, except those whose names
/// begin with an entry of `kept`, which include the studs'.
Mesh buildTo(std::size_t triangles, const std::string& option, const FinenessRange& range,
             const std::vector<std::string>& kept, const BuildAssembly& build);

}  // namespace clearway::scenes
