// The transform of a COLLADA node or skin.
#pragma once

#include "mesh/read/dae_document.h"

namespace clearway {

/// The 16 numbers of an element's text, row by row. Refuses a last row other than 0 0 0 1.
Placement daeMatrixOf(const DaeDocument& document, const pugi::xml_node& element);

/// The product of a node's transform elements in the document's order. Refuses <skew>.
Placement daeTransformOf(const DaeDocument& document, const pugi::xml_node& node);

}  // namespace clearway
