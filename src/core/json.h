// JSON, by the library of that name.
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace clearway {

/// Keeps the order of its fields. Its numbers that are no integers are floats: as text they have the few
/// digits it takes to read back the same float, and what no finite float holds is null.
using Json = nlohmann::basic_json<nlohmann::ordered_map, std::vector, std::string, bool, std::int64_t,
                                  std::uint64_t, float>;

/// In one line, with < escaped, so that no tag can end the script it stands in. Bytes that are no UTF-8,
/// which readers of JSON refuse, are taken for Latin-1, as old mesh files have it.
std::string jsonText(Json value);

}  // namespace clearway
