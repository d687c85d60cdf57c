#include "model/solids.h"

#include <algorithm>
#include <stdexcept>

#include "mesh/clean.h"
#include "mesh/components.h"
#include "mesh/topology.h"

namespace clearway {
namespace {

/// Of the lengths involved: far more than rounding and a pose's defect, for tests that only save time.
constexpr double kPlaceSlack = 1e-9;

}  // namespace

Solids::Solids(const Mesh& mesh) {
    const std::vector<Component> components = componentsOf(mesh);
    for (std::size_t i = 0; i < components.size(); ++i) {
        names_.push_back(components[i].name.empty() ? "unnamed" : components[i].name);
        if (components[i].triangleCount == 0) continue;
        const Mesh component = meshOfComponents(mesh, {i});
        addPieces(component, i);
        try {
            Solid solid(component, names_[i]);
            if (solid.isTurnedOver()) turnedOver_.push_back(names_[i]);
            solids_.push_back({std::move(solid), i});
        } catch (const std::invalid_argument& refusal) {
            refusals_.push_back(refusal.what());
        }
    }
    Box box;
    for (const Piece& piece : pieces_) box.extend(piece.vertex);
    if (box.isEmpty()) return;
    centre_ = box.center();
    for (const Piece& piece : pieces_) radius_ = std::max(radius_, (piece.vertex - centre_).norm());
}

void Solids::addPieces(const Mesh& component, std::size_t number) {
    const CleanMesh cleaned = clean(component);
    const Shells shells = findShells(cleaned.triangles);
    std::uint32_t next = 0;
    for (std::size_t t = 0; t < cleaned.triangles.size(); ++t) {
        if (shells.ofTriangle[t] != next) continue;
        pieces_.push_back({cleaned.vertices[cleaned.triangles[t][0]], number});
        ++next;
    }
}

std::optional<Solids::Enclosure> Solids::holding(const Pose& X_aThis, const Solids& inner,
                                                 const Pose& X_aInner) const {
    const Pose X_thisInner = inverse(X_aThis) * X_aInner;
    const Vector3 centre = X_thisInner * inner.centre_;
    const double sizes = centre.norm() + inner.centre_.norm() + inner.radius_ + X_aThis.translation.norm() +
                         X_aInner.translation.norm();
    const double slack = kPlaceSlack * sizes, reach = inner.radius_ + slack;
    for (const NamedSolid& outer : solids_) {
        const Box& box = outer.solid.box();
        if (box.squaredExteriorDistance(centre) > reach * reach) continue;
        const Box near(box.min().array() - slack, box.max().array() + slack);
        for (const Piece& piece : inner.pieces_) {
            if (!near.contains(X_thisInner * piece.vertex)) continue;
            if (outer.solid.winding(X_aThis, X_aInner, piece.vertex) <= 0) continue;
            return Enclosure{&names_[outer.component], &inner.names_[piece.component]};
        }
    }
    return std::nullopt;
}

MadeSolids makeSolids(const Mesh& mesh) {
    auto solids = std::make_shared<const Solids>(mesh);
    return {solids, solids->refusals(), solids->turnedOver()};
}

}  // namespace clearway
