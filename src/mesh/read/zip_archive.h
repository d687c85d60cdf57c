// A zip archive in memory, whose parts are named as the Open Packaging Conventions name them (ECMA-376, part 2).
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "mesh/read/collector.h"

struct zip;

namespace clearway {

class ZipArchive {
  public:
    /// The bytes and the mesh must outlive the archive. Refuses what is not a whole zip archive.
    ZipArchive(std::string_view bytes, const MeshCollector& mesh);
    ~ZipArchive();
    ZipArchive(const ZipArchive&) = delete;
    ZipArchive& operator=(const ZipArchive&) = delete;

    /// A part's name as the archive compares them: percent-decoded, in lower case, without a leading slash.
    static std::string partName(std::string_view name);

    /// The names of all parts, in alphabetical order.
    std::vector<std::string> names() const;
    bool has(const std::string& name) const { return entries_.count(partName(name)) != 0; }

    /// The part's bytes. Refuses a part that is missing or named twice, whose bytes do not match their stated size and
    /// checksum, or that is larger than the archive can hold.
    std::string read(const std::string& name);

  private:
    const MeshCollector& mesh_;
    zip* archive_ = nullptr;
    std::multimap<std::string, std::uint64_t> entries_;
    std::uint64_t bytesRead_ = 0;
};

struct ZipPart {
    std::string name, bytes;
};

/// The bytes of an archive with these parts, compressed. Equal parts give equal bytes.
std::string zipOf(const std::vector<ZipPart>& parts);

}  // namespace clearway
