#include "model/arguments.h"

#include <fmt/format.h>

#include "clearway/errors.h"
#include "model/model_data.h"
#include "tree/flat_tree.h"

namespace clearway {

void requireSameWidth(const Model& part, const Model& environment) {
    const int partWidth = treeOf(part).nodeWidth, environmentWidth = treeOf(environment).nodeWidth;
    if (partWidth == environmentWidth) return;
    throw ArgumentError(
        fmt::format("the part's nodes have {} children and the environment's {}, expected both models to be "
                    "built with the same nodeWidth",
                    partWidth, environmentWidth));
}

}  // namespace clearway
