#include "model/arguments.h"

#include <sstream>
#include <stdexcept>

#include "model/model_data.h"
#include "tree/flat_tree.h"

namespace clearway {

void requireSameWidth(const Model& part, const Model& environment) {
    const int partWidth = treeOf(part).nodeWidth, environmentWidth = treeOf(environment).nodeWidth;
    if (partWidth == environmentWidth) return;
    std::ostringstream message;
    message << "the part's nodes have " << partWidth << " children and the environment's " << environmentWidth
            << ", expected both models to be built with the same nodeWidth";
    throw std::invalid_argument(message.str());
}

}  // namespace clearway
