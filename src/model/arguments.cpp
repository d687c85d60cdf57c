#include "model/arguments.h"

#include <sstream>

#include "clearway/errors.h"
#include "tree/flat_tree.h"

namespace clearway {

void requireSameWidth(const Model& part, const Model& environment) {
    const int partWidth = part.tree().nodeWidth, environmentWidth = environment.tree().nodeWidth;
    if (partWidth == environmentWidth) return;
    std::ostringstream message;
    message << "the part's nodes have " << partWidth << " children and the environment's " << environmentWidth
            << ", expected both models to be built with the same nodeWidth";
    throw ArgumentError(message.str());
}

}  // namespace clearway
