// Names that results can be told apart by.
#pragma once

#include <string>
#include <vector>

#include "clearway/mesh.h"

namespace clearway {

/// "node/mesh", or the one name when both agree or one is missing. Names that an importer made up for want of
/// one
/// ("<STL_BINARY>", "$ColladaAutoName$_0", "defaultobject") count as missing.
std::string componentName(const std::string& node, const std::string& mesh);

/// Gives nameless components the fallback, then appends #2, #3, ... to names that an earlier component has
/// already.
void makeNamesDistinct(std::vector<Component>& components, const std::string& fallback);

}  // namespace clearway
