// Encodes bytes and texts for an HTML page.
#pragma once

#include <cstddef>
#include <string>

namespace clearway::report {

std::string base64(const void* bytes, std::size_t count);

/// Replaces &, <, > and quotes by entities.
std::string htmlText(std::string text);

}  // namespace clearway::report
