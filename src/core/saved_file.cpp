#include "core/saved_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "core/hash.h"
#include "core/replace_file.h"

namespace clearway {
namespace {

constexpr char kMagic[8] = {'c', 'l', 'e', 'a', 'r', 'w', 'a', 'y'};
constexpr std::uint64_t kByteOrder = 0x0102030405060708u;
constexpr std::size_t kHeader = sizeof kMagic + 5 * sizeof(std::uint64_t);

std::uint64_t hashOf(std::uint64_t key, std::string_view payload) {
    Hash hash;
    hash.add(key);
    hash.add(payload.data(), payload.size());
    return hash.value();
}

std::string readWhole(const std::string& file, const SavedKind& kind) {
    std::error_code unreadable;
    std::ifstream in;
    if (std::filesystem::is_regular_file(file, unreadable)) in.open(file, std::ios::binary | std::ios::ate);
    if (!in.is_open()) throw FileError(file + ": cannot be read, expected a saved " + kind.name);
    std::string bytes(static_cast<std::size_t>(std::max<std::streamoff>(0, in.tellg())), '\0');
    in.seekg(0);
    in.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    bytes.resize(static_cast<std::size_t>(in.gcount()));
    return bytes;
}

}  // namespace

std::string_view SavedFile::payload() const {
    return std::string_view(bytes).substr(kHeader);
}

void writeSavedFile(const std::string& file, const SavedKind& kind, std::uint64_t key,
                    const ArchiveWriter& payload) {
    ArchiveWriter header;
    header.addBytes(kMagic, sizeof kMagic);
    for (const std::uint64_t field : {kind.version, kByteOrder, key, std::uint64_t(payload.bytes().size()),
                                      hashOf(key, payload.bytes())}) {
        header.add(field);
    }
    replaceFile(file, [&](std::ostream& out) { out << header.bytes() << payload.bytes(); });
}

SavedFile readSavedFile(const std::string& file, const SavedKind& kind) {
    SavedFile saved;
    saved.bytes = readWhole(file, kind);
    const auto refuse = [&](const std::string& reason) { refuseSavedFile(file, kind, reason); };
    if (saved.bytes.size() < kHeader) refuse("ends too early");
    ArchiveReader in(saved.bytes);
    char magic[sizeof kMagic];
    in.readBytes(magic, sizeof magic);
    if (std::memcmp(magic, kMagic, sizeof magic) != 0) refuse(fmt::format("is not a saved {}", kind.name));
    if (const auto version = in.read<std::uint64_t>(); version != kind.version)
        refuse(fmt::format("has format version {}", version));
    if (in.read<std::uint64_t>() != kByteOrder) refuse("was saved with another byte order");
    saved.key = in.read<std::uint64_t>();
    const auto size = in.read<std::uint64_t>(), hash = in.read<std::uint64_t>();
    if (size != saved.payload().size() || hash != hashOf(saved.key, saved.payload())) refuse("is damaged");
    return saved;
}

void refuseSavedFile(const std::string& file, const SavedKind& kind, const std::string& reason) {
    throw FileError(
        fmt::format("{}: {}, expected a {} saved by this version of clearway", file, reason, kind.name));
}

}  // namespace clearway
