#include "program/cli/enclosure.h"

#include "model/solids.h"
#include "problem/config.h"

namespace clearway::cli {

std::string enclosureNote(const Mesh& part, const std::vector<Mesh>& worlds, const Pose& X_environmentPart) {
    const Solids partSolids(part);
    for (const Mesh& world : worlds) {
        const Solids worldSolids(world);
        const auto found = worldSolids.holding({}, partSolids, X_environmentPart);
        if (!found) continue;
        const std::string name = writtenNames({*found->outer}).value_or(*found->outer);
        return "the part is inside '" + *found->outer +
               "', a closed surface; if that is solid, write solid = " + name + " in [clearway]";
    }
    return "";
}

}  // namespace clearway::cli
