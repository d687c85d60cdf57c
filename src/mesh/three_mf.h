// The 3MF files that clearway writes: text with the shortest numbers that read back to equal doubles.
// Source: 3MF Core Specification 1.3.
#pragma once

#include <string>

#include "clearway/mesh.h"

namespace clearway {

struct ThreeMfUnit {
    const char* name;
    double metres;
};
constexpr ThreeMfUnit kThreeMfUnits[] = {{"micron", 1e-6}, {"millimeter", 1e-3}, {"centimeter", 1e-2},
                                         {"inch", 0.0254}, {"foot", 0.3048},     {"meter", 1}};

/// The namespace of clearway's own metadata: "deflection" of an object, and "unit" of a model, "none" where the mesh states no unit.
constexpr const char* kClearwaySpace = "urn:clearway:3mf";

/// The bytes of a file with one object for each component that has triangles. Throws ArgumentError as saveMesh does. namelessName: that
/// of a component without a name.
std::string threeMfOf(const Mesh& mesh, const std::string& namelessName);

}  // namespace clearway
