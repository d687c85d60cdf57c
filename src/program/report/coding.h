// Bytes and texts as an HTML page holds them.
#pragma once

#include <cstddef>
#include <string>

namespace clearway::report {

std::string base64(const void* bytes, std::size_t count);

/// With &, <, > and quotes as entities.
std::string htmlText(std::string text);

}  // namespace clearway::report
