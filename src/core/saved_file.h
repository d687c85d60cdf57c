// Files of the cache. Layout: "clearway" (8 bytes), version, byte order mark, key, payload bytes, hash (8 bytes each), payload. The
// hash covers the key and the payload. Numbers are written as in memory; the mark reveals another byte order.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "core/archive.h"

namespace clearway {

struct SavedFile {
    std::uint64_t key = 0;
    std::string bytes;  ///< of the whole file

    std::string_view payload() const;
};

/// The kind of contents of a file.
struct SavedKind {
    const char* name;  ///< in errors, after "saved"
    std::uint64_t version;
};

/// Replaces the file. Throws FileError if it cannot be written.
void writeSavedFile(const std::string& file, const SavedKind& kind, std::uint64_t key,
                    const ArchiveWriter& payload);

/// Throws FileError if the file cannot be read, has another version or is damaged.
SavedFile readSavedFile(const std::string& file, const SavedKind& kind);

[[noreturn]] void refuseSavedFile(const std::string& file, const SavedKind& kind, const std::string& reason);

}  // namespace clearway
