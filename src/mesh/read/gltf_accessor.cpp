#include "mesh/read/gltf_accessor.h"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>

#include "core/text.h"

namespace clearway {
namespace {

using nlohmann::json;

constexpr std::string_view kBinaryMagic = "glTF";
constexpr std::size_t kGlbHeader = 12, kChunkHeader = 8;  ///< bytes
constexpr std::uint32_t kJsonChunk = 0x4E4F534A, kBinaryChunk = 0x004E4942;

std::uint32_t wordAt(std::string_view bytes, std::size_t at) {
    std::uint32_t word = 0;
    std::memcpy(&word, bytes.data() + at, sizeof word);
    return word;
}

std::string decodePercents(const std::string& uri, const GltfItem& item) {
    std::string text;
    for (std::size_t i = 0; i < uri.size(); ++i) {
        if (uri[i] != '%') {
            text += uri[i];
            continue;
        }
        const auto isHex = [&](std::size_t at) {
            return at < uri.size() && std::isxdigit(static_cast<unsigned char>(uri[at]));
        };
        if (!isHex(i + 1) || !isHex(i + 2)) {
            item.refuse("has uri {}, expected two hexadecimal digits after each %", quote(uri));
        }
        text += static_cast<char>(std::stoi(uri.substr(i + 1, 2), nullptr, 16));
        i += 2;
    }
    return text;
}

std::string decodeBase64(std::string_view text, const GltfItem& item) {
    constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::array<int, 256> values;
    values.fill(-1);
    for (std::size_t i = 0; i < kDigits.size(); ++i) {
        values[static_cast<unsigned char>(kDigits[i])] = static_cast<int>(i);
    }
    for (int i = 0; i < 2 && !text.empty() && text.back() == '='; ++i) text.remove_suffix(1);
    if (text.size() % 4 == 1) item.refuse("has base64 data that end within a byte");
    std::string bytes;
    bytes.reserve(text.size() / 4 * 3 + 2);
    unsigned bits = 0;
    int held = 0;
    for (const char& c : text) {
        const int value = values[static_cast<unsigned char>(c)];
        if (value < 0) {
            item.refuse("has {} at position {} of its base64 data, expected A-Z, a-z, 0-9, + and /",
                        quote({&c, 1}), &c - text.data());
        }
        bits = bits << 6 | static_cast<unsigned>(value);
        held += 6;
        if (held < 8) continue;
        held -= 8;
        bytes += static_cast<char>(bits >> held & 0xFF);
    }
    return bytes;
}

std::size_t widthOf(const std::string& type) {
    if (type == "SCALAR") return 1;
    if (type == "VEC3") return 3;
    return type == "VEC4" ? 4 : 16;
}

template <class Component>
void convert(const GltfRows& rows, std::size_t first, std::size_t count, double* numbers) {
    const double most = double(std::numeric_limits<Component>::max());
    const char* row = rows.data + first * rows.stride;
    for (std::size_t r = 0; r < count; ++r, row += rows.stride) {
        for (std::size_t i = 0; i < rows.width; ++i) {
            Component component;
            std::memcpy(&component, row + i * sizeof component, sizeof component);
            const double number = double(component);
            *numbers++ = rows.isNormalized ? std::max(number / most, -1.0) : number;
        }
    }
}

struct ComponentType {
    std::size_t code, bytes;
    void (*convert)(const GltfRows& rows, std::size_t first, std::size_t count, double* numbers);
};
constexpr ComponentType kComponentTypes[] = {
    {5120, 1, convert<std::int8_t>},   {5121, 1, convert<std::uint8_t>},  {5122, 2, convert<std::int16_t>},
    {5123, 2, convert<std::uint16_t>}, {5125, 4, convert<std::uint32_t>}, {5126, 4, convert<float>}};

const ComponentType* typeOf(const GltfRows& rows) {
    const auto isIt = [&](const ComponentType& type) { return type.code == rows.componentType; };
    const auto type = std::find_if(std::begin(kComponentTypes), std::end(kComponentTypes), isIt);
    return type == std::end(kComponentTypes) ? nullptr : type;
}

}  // namespace

void GltfRows::read(std::size_t first, std::size_t rows, double* numbers) const {
    if (!data) return void(std::fill_n(numbers, rows * width, 0.0));
    typeOf(*this)->convert(*this, first, rows, numbers);
}

void GltfAccessor::read(std::size_t first, std::size_t rows, double* numbers) const {
    GltfRows::read(first, rows, numbers);
    auto row = std::lower_bound(replaced.begin(), replaced.end(), first);
    for (; row != replaced.end() && *row < first + rows; ++row) {
        replacements.read(std::size_t(row - replaced.begin()), 1, numbers + (*row - first) * width);
    }
}

GltfFile::GltfFile(std::string_view bytes, const MeshCollector& mesh) : mesh_(mesh), bytes_(bytes.size()) {
    const bool isBinary = bytes.substr(0, kBinaryMagic.size()) == kBinaryMagic;
    const std::string_view text = isBinary ? chunksOf(bytes) : bytes;
    try {
        json_ = json::parse(text.begin(), text.end());  // skips a byte order mark
    } catch (const json::exception& error) {
        const std::string reason = error.what();  // "[json.exception.parse_error.101] parse error at ..."
        mesh.refuse("its JSON is malformed: " +
                    reason.substr(std::min(reason.find("] ") + 2, reason.size())));
    }
    root_ = {&mesh, &json_, "it"};
    if (!json_.is_object()) mesh.refuse("its JSON is {}, expected an object", shownJson(json_));
    requireVersion2();
}

std::string_view GltfFile::chunksOf(std::string_view bytes) {
    const auto ends = [&](std::size_t declared, const std::string& what) {
        mesh_.refuse("{} declares {} bytes, the file has {}", what, declared, bytes.size());
    };
    if (bytes.size() < kGlbHeader) ends(kGlbHeader, "its header");
    const std::uint32_t version = wordAt(bytes, 4);
    if (version != 2) mesh_.refuse("it is binary glTF {}, expected glTF 2", version);
    if (wordAt(bytes, 8) > bytes.size()) ends(wordAt(bytes, 8), "its header");
    bytes = bytes.substr(0, wordAt(bytes, 8));  // some writers pad the file after its end
    std::optional<std::string_view> text;
    for (std::size_t at = kGlbHeader, chunk = 0; at < bytes.size(); ++chunk) {
        const std::string name = fmt::format("chunk {} at byte {}", chunk, at);
        if (bytes.size() - at < kChunkHeader) ends(kChunkHeader, "the header of " + name);
        const std::size_t length = wordAt(bytes, at), type = wordAt(bytes, at + 4);
        at += kChunkHeader;
        if (length > bytes.size() - at) ends(length, name);
        if (chunk == 0 && type == kJsonChunk) text = bytes.substr(at, length);
        if (chunk == 1 && type == kBinaryChunk) binary_ = bytes.substr(at, length);
        at += length;
    }
    if (!text) mesh_.refuse("its first chunk is not JSON");
    return *text;
}

void GltfFile::requireVersion2() const {
    const std::optional<GltfItem> asset = root_.object("asset");
    const std::optional<std::string> version = asset ? asset->text("version") : std::nullopt;
    if (!version) mesh_.refuse("it has no asset.version, expected '2.0'");
    if (version->substr(0, 2) != "2.") mesh_.refuse("it is glTF {}, expected '2.0'", quote(*version));
    const std::string least = asset->text("minVersion").value_or("2.0");
    if (least != "2.0") mesh_.refuse("it needs a reader of glTF {}, expected '2.0'", quote(least));
}

std::size_t GltfFile::count(const char* list) const {
    const json* const items = root_.array(list);
    return items ? items->size() : 0;
}

GltfItem GltfFile::item(const char* list, std::size_t number, const GltfItem& user) const {
    std::string kind = list;
    kind.resize(kind.size() - (kind == "meshes" ? 2 : 1));
    kind += fmt::format(" {}", number);
    const std::size_t items = count(list);
    if (number >= items) user.refuse("refers to {}, the file has {} {}", kind, items, list);
    return namedItem(root_, json_.find(list)->at(number), std::move(kind));
}

std::string GltfFile::besideFile(const std::string& uri, std::size_t bytes, const GltfItem& item) const {
    if (uri.find(':') != uri.npos)
        item.refuse("has uri {}, expected a file's path or base64 data", quote(uri));
    const auto path = std::filesystem::path(mesh_.file()).parent_path() / decodePercents(uri, item);
    std::error_code error;
    if (!std::filesystem::is_regular_file(path, error)) {
        item.refuse("is in {}, there is no file '{}'", quote(uri), path.string());
    }
    const std::size_t size = std::filesystem::file_size(path, error);
    if (error || size < bytes) {
        item.refuse("declares {} bytes, '{}' has {}", bytes, path.string(), std::to_string(error ? 0 : size));
    }
    std::string content(bytes, '\0');
    std::ifstream stream(path, std::ios::binary);
    if (!stream.read(content.data(), static_cast<std::streamsize>(bytes))) {
        item.refuse("is in '{}', which cannot be read", path.string());
    }
    return content;
}

std::string_view GltfFile::buffer(std::size_t number, const GltfItem& user) {
    const GltfItem item = this->item("buffers", number, user);
    const std::size_t bytes = item.requiredNumber("byteLength");
    const json* const uri = item.find("uri");
    std::string_view content;
    if (!uri) {
        // The buffer of a fallback that was left out bears an extension, such as EXT_meshopt_compression.
        const std::string compression = item.extensionNames();
        if (!compression.empty())
            item.refuse("has no data, only an extension, which is not read: " + compression);
        if (number != 0 || !binary_) item.refuse("has no uri");
        content = *binary_;
    } else if (const auto known = buffers_.find(number); known != buffers_.end()) {
        content = known->second;
    } else {
        if (!uri->is_string()) item.refuse("has uri {}, expected a string", shownJson(*uri));
        const std::string& place = uri->get_ref<const std::string&>();
        const std::size_t comma = place.find(";base64,");
        const bool isInside = place.compare(0, 5, "data:") == 0 && comma != place.npos;
        content = buffers_[number] = isInside ? decodeBase64(std::string_view(place).substr(comma + 8), item)
                                              : besideFile(place, bytes, item);
        bytes_ += content.size();
    }
    if (content.size() < bytes) {
        item.refuse("declares {} bytes, its data have {}", bytes, content.size());
    }
    return content.substr(0, bytes);
}

std::string_view GltfFile::view(std::size_t number, std::size_t& stride, const GltfItem& user) {
    const GltfItem item = this->item("bufferViews", number, user);
    const std::string_view whole = buffer(item.requiredNumber("buffer"), item);
    const std::size_t first = item.number("byteOffset").value_or(0),
                      bytes = item.requiredNumber("byteLength");
    if (first > whole.size() || bytes > whole.size() - first) {
        item.refuse("covers bytes {} to {} of a buffer of {}", first, first + bytes, whole.size());
    }
    const std::optional<std::size_t> stated = item.number("byteStride");
    if (stated && (*stated < stride || *stated > 252)) {
        item.refuse("has byteStride {}, expected {} to 252 for {}", *stated, stride, user.name);
    }
    stride = stated.value_or(stride);
    return whole.substr(first, bytes);
}

void GltfFile::setRows(GltfRows& rows, const GltfItem& item, const GltfItem& owner) {
    const ComponentType* const type = typeOf(rows);
    if (!type) {
        owner.refuse("has componentType {}, expected 5120 to 5123, 5125 or 5126", rows.componentType);
    }
    const std::optional<std::size_t> number = item.number("bufferView");
    if (!number) return;
    const std::size_t row = rows.width * type->bytes;
    rows.stride = row;
    const std::string_view bytes = view(*number, rows.stride, item);
    const std::size_t first = item.number("byteOffset").value_or(0);
    const std::size_t left = first > bytes.size() ? 0 : bytes.size() - first;
    const std::size_t fitting = left < row ? 0 : (left - row) / rows.stride + 1;
    if (rows.count > fitting) {
        item.refuse("has {} elements, bufferView {} has room for {}", rows.count, *number, fitting);
    }
    rows.data = bytes.data() + std::min(first, bytes.size());
}

void GltfFile::readSparse(GltfAccessor& accessor, const GltfItem& sparse) {
    const std::optional<GltfItem> at = sparse.object("indices"), values = sparse.object("values");
    if (!at || !values) sparse.refuse("has no indices or no values");
    GltfRows indices;
    indices.count = sparse.requiredNumber("count");
    indices.width = 1;
    indices.componentType = at->requiredNumber("componentType");
    if (indices.componentType != 5121 && indices.componentType != 5123 && indices.componentType != 5125) {
        at->refuse("have componentType {}, expected 5121, 5123 or 5125", indices.componentType);
    }
    at->requiredNumber("bufferView");
    setRows(indices, *at, *at);
    accessor.replacements = accessor;
    accessor.replacements.count = indices.count;
    values->requiredNumber("bufferView");
    setRows(accessor.replacements, *values, sparse);
    std::vector<double> numbers(indices.count);
    indices.read(0, indices.count, numbers.data());
    double least = 0;
    for (const double number : numbers) {
        if (!(number >= least && number < double(accessor.count))) {
            at->refuse("have {}, expected whole numbers that rise and are below {}", shownJson(json(number)),
                       accessor.count);
        }
        accessor.replaced.push_back(static_cast<std::size_t>(number));
        least = number + 1;
    }
}

GltfAccessor GltfFile::accessor(std::size_t number, const std::string& type, const GltfItem& user) {
    const GltfItem item = this->item("accessors", number, user);
    const std::string ownType = item.text("type").value_or("");
    if (ownType != type) item.refuse("has type {}, expected {} for {}", quote(ownType), type, user.name);
    GltfAccessor accessor;
    accessor.number = number;
    accessor.count = item.requiredNumber("count");
    accessor.width = widthOf(type);
    accessor.componentType = item.requiredNumber("componentType");
    accessor.isNormalized = item.flag("normalized");
    const ComponentType* const stated = typeOf(accessor);
    if (accessor.isNormalized && stated && stated->bytes == 4) {
        item.refuse("is normalized with componentType {}, expected 5120 to 5123", accessor.componentType);
    }
    setRows(accessor, item, item);
    if (const std::optional<GltfItem> sparse = item.object("sparse")) readSparse(accessor, *sparse);
    if (!accessor.data && accessor.count > bytes_) {
        item.refuse("has {} elements without data, the file has {} bytes", accessor.count, bytes_);
    }
    return accessor;
}

}  // namespace clearway
