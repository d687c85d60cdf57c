#include "program/cli/enclosure.h"

#include "problem/config.h"

namespace clearway::cli {

std::string EnclosureNotes::at(const Pose& X_environmentPart) {
    if (!part_) part_.emplace(meshes_.part);
    for (std::size_t i = 0; i < meshes_.worlds.size(); ++i) {
        if (i == worlds_.size()) worlds_.emplace_back(meshes_.worlds[i]);
        const auto found = worlds_[i].holding({}, *part_, X_environmentPart);
        if (!found) continue;
        const std::string name = writtenNames({*found->outer}).value_or(*found->outer);
        return "the part is inside '" + *found->outer +
               "', a closed surface; if that is solid, write solid = " + name + " in [clearway]";
    }
    return "";
}

}  // namespace clearway::cli
