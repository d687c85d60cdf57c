// An object of a glTF file's JSON. Its fields are read strictly: a field of a wrong type is refused by name.
#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "mesh/read/collector.h"

namespace clearway {

struct GltfItem {
    const MeshCollector* mesh = nullptr;
    const nlohmann::json* json = nullptr;
    std::string name;  ///< for messages, such as "node 3 'bracket'"

    /// Refuses the file. The reason follows the name: "has mesh ...".
    [[noreturn]] void refuse(const std::string& reason) const { mesh->refuse("{} {}", name, reason); }
    template <class... Values>
    [[noreturn]] void refuse(fmt::format_string<Values...> reason, Values&&... values) const {
        refuse(fmt::format(reason, std::forward<Values>(values)...));
    }

    /// The field, or null if it is missing.
    const nlohmann::json* find(const char* key) const;
    const nlohmann::json* array(const char* key) const;

    std::optional<std::size_t> number(const char* key) const;
    std::size_t requiredNumber(const char* key) const;
    std::optional<std::string> text(const char* key) const;
    bool flag(const char* key) const;  ///< false if it is missing

    /// The field's numbers, with a zero count as many as there are; empty if it is missing.
    std::vector<double> numbers(const char* key, std::size_t count = 0) const;
    std::vector<std::size_t> wholeNumbers(const char* key) const;
    std::vector<std::string> texts(const char* key) const;

    /// The field's object, or object of its list; empty if it is missing.
    std::optional<GltfItem> object(const char* key) const;
    std::vector<GltfItem> objects(const char* key, const char* kind) const;
    std::optional<GltfItem> extension(const char* extensionName) const;
    std::string extensionNames() const;
};

/// The object as an item. Its own name, if it has one, follows the given one.
GltfItem namedItem(const GltfItem& parent, const nlohmann::json& value, std::string name);

/// A value for messages.
std::string shownJson(const nlohmann::json& value);

}  // namespace clearway
