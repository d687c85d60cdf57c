#include "mesh/read/gltf_item.h"

#include <fmt/format.h>
#include <cmath>

#include "core/text.h"

namespace clearway {

using nlohmann::json;

namespace {

constexpr double kMostWhole = 9007199254740992;  ///< 2^53: doubles above it skip whole numbers

[[noreturn]] void refuseField(const GltfItem& item, const char* key, const json& value,
                              const char* expected) {
    item.refuse("has {} {}, expected {}", key, shownJson(value), expected);
}

std::size_t wholeNumber(const GltfItem& item, const char* key, const json& value) {
    const double number = value.is_number() ? value.get<double>() : -1;
    if (!(number >= 0 && number <= kMostWhole && std::floor(number) == number)) {
        refuseField(item, key, value, "a whole number >= 0");
    }
    return static_cast<std::size_t>(number);
}

const std::string& textOf(const GltfItem& item, const char* key, const json& value) {
    if (!value.is_string()) refuseField(item, key, value, "a string");
    return value.get_ref<const std::string&>();
}

/// The field's values, each as `read` takes it; empty if the field is missing.
template <class Value, class Read>
std::vector<Value> listOf(const GltfItem& item, const char* key, Read read) {
    std::vector<Value> values;
    const json* const list = item.array(key);
    for (std::size_t i = 0; list && i < list->size(); ++i) values.push_back(read((*list)[i]));
    return values;
}

}  // namespace

std::string shownJson(const json& value) {
    if (value.is_structured()) return std::string("an ") + value.type_name();
    return value.is_string() ? quote(value.get_ref<const std::string&>()) : value.dump();
}

GltfItem namedItem(const GltfItem& parent, const json& value, std::string name) {
    GltfItem item{parent.mesh, &value, std::move(name)};
    if (!value.is_object()) parent.mesh->refuse("{} is {}, expected an object", item.name, shownJson(value));
    const json* const ownName = item.find("name");
    if (ownName && ownName->is_string()) item.name += " " + quote(ownName->get_ref<const std::string&>());
    return item;
}

const json* GltfItem::find(const char* key) const {
    const auto field = json->find(key);
    return field == json->end() ? nullptr : &*field;
}

std::optional<std::size_t> GltfItem::number(const char* key) const {
    const nlohmann::json* const value = find(key);
    if (!value) return {};
    return wholeNumber(*this, key, *value);
}

std::size_t GltfItem::requiredNumber(const char* key) const {
    const std::optional<std::size_t> value = number(key);
    if (!value) refuse("has no " + std::string(key));
    return *value;
}

std::optional<std::string> GltfItem::text(const char* key) const {
    const nlohmann::json* const value = find(key);
    if (!value) return {};
    return textOf(*this, key, *value);
}

bool GltfItem::flag(const char* key) const {
    const nlohmann::json* const value = find(key);
    if (value && !value->is_boolean()) refuseField(*this, key, *value, "true or false");
    return value && value->get<bool>();
}

const json* GltfItem::array(const char* key) const {
    const nlohmann::json* const list = find(key);
    if (list && !list->is_array()) refuseField(*this, key, *list, "an array");
    return list;
}

std::vector<double> GltfItem::numbers(const char* key, std::size_t count) const {
    std::vector<double> values = listOf<double>(*this, key, [&](const nlohmann::json& value) {
        if (!value.is_number()) refuseField(*this, key, value, "numbers");
        return value.get<double>();
    });
    if (count > 0 && find(key) && values.size() != count) {
        refuse("has {} numbers as {}, expected {}", values.size(), key, count);
    }
    return values;
}

std::vector<std::size_t> GltfItem::wholeNumbers(const char* key) const {
    return listOf<std::size_t>(*this, key, [&](const auto& value) { return wholeNumber(*this, key, value); });
}

std::vector<std::string> GltfItem::texts(const char* key) const {
    return listOf<std::string>(*this, key, [&](const auto& value) { return textOf(*this, key, value); });
}

std::optional<GltfItem> GltfItem::object(const char* key) const {
    const nlohmann::json* const value = find(key);
    if (!value) return {};
    return namedItem(*this, *value, fmt::format("{} of {}", key, name));
}

std::vector<GltfItem> GltfItem::objects(const char* key, const char* kind) const {
    std::size_t number = 0;
    return listOf<GltfItem>(*this, key, [&](const nlohmann::json& value) {
        return namedItem(*this, value, fmt::format("{} {} of {}", kind, number++, name));
    });
}

std::optional<GltfItem> GltfItem::extension(const char* extensionName) const {
    const std::optional<GltfItem> extensions = object("extensions");
    if (!extensions || !extensions->find(extensionName)) return {};
    return namedItem(*this, *extensions->find(extensionName), fmt::format("{} of {}", extensionName, name));
}

std::string GltfItem::extensionNames() const {
    const std::optional<GltfItem> extensions = object("extensions");
    std::vector<std::string> names;
    if (!extensions) return "";
    for (const auto& extension : extensions->json->items()) names.push_back(extension.key());
    return joined(names);
}

}  // namespace clearway
