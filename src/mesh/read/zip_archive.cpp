#include "mesh/read/zip_archive.h"

#include <zip.h>

#include <algorithm>
#include <charconv>
#include <memory>

#include "clearway/errors.h"
#include "core/text.h"

namespace clearway {
namespace {

constexpr std::uint64_t kMostBytes = std::uint64_t(16) << 30;  // of all parts that are read

/// Deflate makes at most 1032 bytes of one.
constexpr std::uint64_t kMostExpansion = 1032;

std::string messageOf(zip_error_t& error) {
    const std::string message = zip_error_strerror(&error);
    zip_error_fini(&error);
    return message;
}

}  // namespace

ZipArchive::ZipArchive(std::string_view bytes, const MeshCollector& mesh) : mesh_(mesh) {
    zip_error_t error;
    zip_error_init(&error);
    zip_source_t* const source = zip_source_buffer_create(bytes.data(), bytes.size(), 0, &error);
    if (source) archive_ = zip_open_from_source(source, ZIP_RDONLY, &error);
    if (!archive_) {
        zip_source_free(source);
        mesh.refuse("it is not a whole zip archive: " + messageOf(error));
    }
    const zip_int64_t count = zip_get_num_entries(archive_, 0);
    for (zip_int64_t i = 0; i < count; ++i) {
        const auto index = static_cast<zip_uint64_t>(i);
        if (const char* const name = zip_get_name(archive_, index, 0))
            entries_.emplace(partName(name), index);
    }
}

ZipArchive::~ZipArchive() {
    zip_discard(archive_);
}

std::string ZipArchive::partName(std::string_view name) {
    std::string decoded;
    while (!name.empty()) {
        unsigned char code = static_cast<unsigned char>(name[0]);
        std::size_t length = 1;
        const char* const end = name.data() + std::min<std::size_t>(name.size(), 3);
        if (code == '%' && name.size() >= 3 && std::from_chars(name.data() + 1, end, code, 16).ptr == end)
            length = 3;
        if (code >= 'A' && code <= 'Z') code = static_cast<unsigned char>(code - 'A' + 'a');
        const bool isLeadingSlash = decoded.empty() && (code == '/' || code == '\\');
        if (!isLeadingSlash) decoded += code == '\\' ? '/' : static_cast<char>(code);
        name.remove_prefix(length);
    }
    return decoded;
}

std::vector<std::string> ZipArchive::names() const {
    std::vector<std::string> names;
    for (const auto& entry : entries_) names.push_back(entry.first);
    return names;
}

std::string ZipArchive::read(const std::string& name) {
    const std::string part = "part " + quote(name);
    const auto [entry, end] = entries_.equal_range(partName(name));
    if (entry == end) mesh_.refuse(part + " is not in the archive");
    if (std::next(entry) != end) mesh_.refuse(part + " is in the archive twice");
    zip_stat_t stat;
    constexpr zip_uint64_t kSizes = ZIP_STAT_SIZE | ZIP_STAT_COMP_SIZE;
    if (zip_stat_index(archive_, entry->second, 0, &stat) != 0 || (stat.valid & kSizes) != kSizes) {
        mesh_.refuse(part + " has no stated size");
    }
    bytesRead_ += std::min(stat.size, kMostBytes);
    if (stat.size / kMostExpansion > stat.comp_size || bytesRead_ >= kMostBytes) {
        mesh_.refuse(
            "{} states {} bytes, compressed to {}, expected at most 1032 times as many and 16 GiB in all",
            part, stat.size, stat.comp_size);
    }
    const std::unique_ptr<zip_file_t, int (*)(zip_file_t*)> file(zip_fopen_index(archive_, entry->second, 0),
                                                                 zip_fclose);
    if (!file) mesh_.refuse("{} cannot be read: {}", part, zip_strerror(archive_));
    std::string bytes(stat.size + 1,
                      '\0');  // one more than is there: only at the end is the checksum compared
    std::size_t size = 0;
    while (size < bytes.size()) {
        const zip_int64_t count = zip_fread(file.get(), &bytes[size], bytes.size() - size);
        if (count < 0) mesh_.refuse("{} is damaged: {}", part, zip_file_strerror(file.get()));
        if (count == 0) break;
        size += static_cast<std::size_t>(count);
    }
    if (size != stat.size) {
        mesh_.refuse("{} has {} bytes, expected the stated {}", part,
                     size < stat.size ? std::to_string(size) : "more", stat.size);
    }
    bytes.pop_back();
    return bytes;
}

std::string zipOf(const std::vector<ZipPart>& parts) {
    const auto require = [](bool isDone, const std::string& what) {
        if (!isDone) throw FileError("cannot make a zip archive: " + what);
    };
    zip_error_t error;
    zip_error_init(&error);
    zip_source_t* const all = zip_source_buffer_create(nullptr, 0, 0, &error);
    require(all != nullptr, zip_error_strerror(&error));
    const std::unique_ptr<zip_source_t, void (*)(zip_source_t*)> owner(all, zip_source_free);
    std::unique_ptr<zip_t, void (*)(zip_t*)> archive(
        zip_open_from_source(all, ZIP_CREATE | ZIP_TRUNCATE, &error), zip_discard);
    require(archive != nullptr, zip_error_strerror(&error));
    zip_source_keep(all);  // closing the archive frees it once
    for (const ZipPart& part : parts) {
        zip_source_t* const source =
            zip_source_buffer(archive.get(), part.bytes.data(), part.bytes.size(), 0);
        const zip_int64_t index = zip_file_add(archive.get(), part.name.c_str(), source, ZIP_FL_ENC_UTF_8);
        require(index >= 0, zip_strerror(archive.get()));
        zip_file_set_dostime(archive.get(), static_cast<zip_uint64_t>(index), 0, 0x21,
                             0);  // the first day of 1980
    }
    require(zip_close(archive.get()) == 0, zip_strerror(archive.get()));
    archive.release();  // is closed
    zip_stat_t stat;
    require(zip_source_stat(all, &stat) == 0 && zip_source_open(all) == 0, "it cannot be read back");
    std::string bytes(stat.size, '\0');
    const zip_int64_t count = zip_source_read(all, bytes.data(), bytes.size());
    zip_source_close(all);
    require(count == static_cast<zip_int64_t>(bytes.size()), "it cannot be read back whole");
    return bytes;
}

}  // namespace clearway
