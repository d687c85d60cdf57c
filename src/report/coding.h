// Data as a page holds it: JSON that fits into HTML, and base64.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "clearway/types.h"

namespace clearway {

/// null for what is not finite; else so many digits that a float reads back the same.
std::string jsonNumber(double value);
std::string jsonPoint(const Vector3& point);
/// "[" items "]"
std::string jsonList(const std::vector<std::string>& items);

std::string base64(const void* bytes, std::size_t count);

/// With &, <, > and quotes as entities.
std::string htmlText(const std::string& text);

}  // namespace clearway
