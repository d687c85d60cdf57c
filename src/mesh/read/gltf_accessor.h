// A glTF file: its lists of items, its buffers and its accessors.
// Source: Khronos Group, glTF 2.0 Specification.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mesh/read/collector.h"
#include "mesh/read/gltf_item.h"

namespace clearway {

/// Rows of numbers in a buffer.
struct GltfRows {
    const char* data = nullptr;     ///< null: all numbers are 0
    std::size_t stride = 0;         ///< bytes from one row to the next
    std::size_t count = 0;          ///< rows
    std::size_t width = 0;          ///< numbers in a row
    std::size_t componentType = 0;  ///< glTF's code, 5120 to 5126
    bool isNormalized = false;

    /// Writes the numbers of rows first to first + rows - 1, which exist.
    void read(std::size_t first, std::size_t rows, double* numbers) const;
};

/// Rows, some of which a sparse accessor replaces.
struct GltfAccessor : GltfRows {
    std::size_t number = 0;             ///< in the file's list
    std::vector<std::size_t> replaced;  ///< rising row numbers
    GltfRows replacements;

    bool hasData() const { return data || !replaced.empty(); }
    void read(std::size_t first, std::size_t rows, double* numbers) const;
};

/// An open file. Refuses files that are not glTF 2, and reads buffers when they are asked for.
class GltfFile {
  public:
    GltfFile(std::string_view bytes, const MeshCollector& mesh);

    const GltfItem& root() const { return root_; }
    std::size_t count(const char* list) const;

    /// An object of one of the file's lists ("nodes"). user: refers to it.
    GltfItem item(const char* list, std::size_t number, const GltfItem& user) const;

    /// Checks an accessor's rows against the buffers. type: what the user expects, such as "VEC3".
    GltfAccessor accessor(std::size_t number, const std::string& type, const GltfItem& user);

  private:
    std::string_view chunksOf(std::string_view bytes);
    void requireVersion2() const;
    std::string_view buffer(std::size_t number, const GltfItem& user);
    std::string_view view(std::size_t number, std::size_t& stride, const GltfItem& user);
    std::string besideFile(const std::string& uri, std::size_t bytes, const GltfItem& item) const;
    void setRows(GltfRows& rows, const GltfItem& item, const GltfItem& owner);
    void readSparse(GltfAccessor& accessor, const GltfItem& sparse);

    const MeshCollector& mesh_;
    nlohmann::json json_;
    GltfItem root_;
    std::optional<std::string_view> binary_;      ///< of a .glb
    std::map<std::size_t, std::string> buffers_;  ///< that are not in binary_
    std::size_t bytes_;                           ///< of the file and the buffers
};

}  // namespace clearway
