// JSON values and their text, by the library nlohmann/json.
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace clearway {

/// JSON that keeps the order of its fields.
using Json = nlohmann::ordered_json;

/// JSON whose numbers other than integers are floats: their text has as few digits as read back to the same
/// float, and a number that no finite float holds becomes null.
using FloatJson = nlohmann::basic_json<nlohmann::ordered_map, std::vector, std::string, bool, std::int64_t,
                                       std::uint64_t, float>;

/// The text in UTF-8: bytes that are not are read as Latin-1, which old mesh files use.
std::string utf8Of(const std::string& text);

/// The value on one line. The character < is escaped, so that no tag inside can end an HTML script. Strings
/// are made UTF-8, because readers of JSON refuse others.
std::string jsonText(FloatJson value);

}  // namespace clearway
