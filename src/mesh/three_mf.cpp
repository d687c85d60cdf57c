#include "mesh/three_mf.h"

#include <fmt/format.h>
#include <cmath>
#include <iterator>

#include "clearway/errors.h"
#include "core/json.h"
#include "core/text.h"
#include "mesh/check.h"
#include "mesh/components.h"
#include "mesh/read/zip_archive.h"
#include "mesh/renumber.h"

namespace clearway {

namespace {

constexpr const char* kContentTypes =
    R"(<?xml version="1.0" encoding="UTF-8"?>
<Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types">
 <Default Extension="rels" ContentType="application/vnd.openxmlformats-package.relationships+xml"/>
 <Default Extension="model" ContentType="application/vnd.ms-package.3dmanufacturing-3dmodel+xml"/>
</Types>
)";
constexpr const char* kRelationships =
    R"(<?xml version="1.0" encoding="UTF-8"?>
<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships">
 <Relationship Target="/3D/3dmodel.model" Id="model" Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/>
</Relationships>
)";

/// The text as the value of an attribute in UTF-8.
std::string attributeText(const std::string& text) {
    std::string escaped;
    for (const char c : utf8Of(text)) {
        if (static_cast<unsigned char>(c) < ' ')
            throw ArgumentError(fmt::format(
                "a component's name is {}, expected one without control characters", quote(text)));
        const bool isPlain = c != '&' && c != '<' && c != '>' && c != '"';
        escaped += isPlain ? std::string(1, c) : fmt::format("&#{};", static_cast<int>(c));
    }
    return escaped;
}

/// The name of the unit; empty where the mesh has none.
std::string threeMfUnitOf(const MeshOrigin& origin) {
    if (origin.unitMetres == 0) return "";
    const double metres = origin.unitMetres / origin.scale;
    for (const ThreeMfUnit& unit : kThreeMfUnits) {
        if (std::abs(unit.metres - metres) <= 1e-9 * metres) return unit.name;
    }
    throw ArgumentError(fmt::format("the unit of the mesh is {} m, expected one that 3MF has: {}", metres,
                                    joined(namesOf(kThreeMfUnits))));
}

class ModelText {
  public:
    template <class... Values>
    void add(fmt::format_string<Values...> text, const Values&... values) {
        fmt::format_to(std::back_inserter(text_), text, values...);
    }

    void addObject(const Mesh& mesh, const Component& component, FirstUseOrder& order) {
        order.restart();
        std::string triangles;
        add("   <mesh>\n    <vertices>\n");
        for (std::size_t i = 0; i < component.triangleCount; ++i) {
            TriangleIndices corners = mesh.triangles[component.firstTriangle + i];
            for (std::uint32_t& corner : corners) {
                corner = order(corner, [&](std::uint32_t vertex) {
                    const Vector3& at = mesh.vertices[vertex];
                    add("     <vertex x=\"{}\" y=\"{}\" z=\"{}\"/>\n", at.x(), at.y(), at.z());
                });
            }
            fmt::format_to(std::back_inserter(triangles), "     <triangle v1=\"{}\" v2=\"{}\" v3=\"{}\"/>\n",
                           corners[0], corners[1], corners[2]);
        }
        add("    </vertices>\n    <triangles>\n{}    </triangles>\n   </mesh>\n", triangles);
    }

    const std::string& str() const { return text_; }

  private:
    std::string text_;
};

}  // namespace

std::string threeMfOf(const Mesh& mesh, const std::string& namelessName) {
    requireSoundMesh(mesh);
    const std::string unit = threeMfUnitOf(mesh.origin);
    ModelText model;
    model.add("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<model{}",
              unit.empty() ? "" : " unit=\"" + unit + "\"");
    model.add(" xml:lang=\"en-US\" xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\"");
    model.add(" xmlns:clearway=\"{}\">\n", kClearwaySpace);
    if (unit.empty()) model.add(" <metadata name=\"clearway:unit\">none</metadata>\n");
    model.add(" <resources>\n");
    std::size_t objects = 0;
    FirstUseOrder order(mesh.vertices.size());
    for (const Component& component : componentsOf(mesh)) {
        if (component.triangleCount == 0) continue;
        model.add("  <object id=\"{}\" type=\"model\" name=\"{}\">\n", ++objects,
                  attributeText(component.name.empty() ? namelessName : component.name));
        if (component.deflection > 0) {
            model.add("   <metadatagroup><metadata name=\"clearway:deflection\">{}</metadata>",
                      component.deflection);
            model.add("</metadatagroup>\n");
        }
        model.addObject(mesh, component, order);
        model.add("  </object>\n");
    }
    model.add(" </resources>\n <build>\n");
    for (std::size_t id = 1; id <= objects; ++id) model.add("  <item objectid=\"{}\"/>\n", id);
    model.add(" </build>\n</model>\n");
    return zipOf({{"[Content_Types].xml", kContentTypes},
                  {"_rels/.rels", kRelationships},
                  {"3D/3dmodel.model", model.str()}});
}

}  // namespace clearway
