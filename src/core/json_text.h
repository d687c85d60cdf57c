// Any text, as JSON holds it.
#pragma once

#include <string>

namespace clearway {

/// A JSON string, with < escaped, so that no tag can end the script it stands in. Bytes that are no UTF-8,
/// which readers of JSON refuse, are taken for Latin-1, as old mesh files have it.
std::string jsonText(const std::string& text);

}  // namespace clearway
