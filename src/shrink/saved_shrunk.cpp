// Shrunk parts as files of the cache. Raise the version with every change of the payload and of what shrink() makes.
#include <fmt/format.h>

#include <filesystem>
#include <stdexcept>

#include "clearway/errors.h"
#include "clearway/shrink.h"
#include "core/archive.h"
#include "core/hash.h"
#include "core/replace_file.h"
#include "core/saved_file.h"
#include "mesh/components.h"

namespace clearway {
namespace {

constexpr SavedKind kShrunkPart = {"shrunk part", 1};

std::uint64_t keyOf(const Mesh& part, double overlap) {
    Hash out;
    out.add(kShrunkPart.version);
    out.add(overlap);
    out.addArray(part.vertices);
    out.addArray(part.triangles);
    for (const Component& component : part.components) {
        out.add(component.name);
        out.add(component.triangleCount);
    }
    return out.value();
}

/// Archive: an ArchiveWriter or an ArchiveReader.
template <class Archive, class Shrunk>
void visitShrunk(Archive& archive, Shrunk& shrunk) {
    archive.visitArray(shrunk.mesh.vertices);
    archive.visitArray(shrunk.mesh.triangles);
    archive.visitEach(shrunk.mesh.components, 16, [&](auto& component) {
        archive.visit(component.name, component.firstTriangle, component.triangleCount);
    });
    archive.visitArray(shrunk.partTriangles);
    archive.visit(shrunk.thin.count, shrunk.thin.leastOverlap, shrunk.thin.at);
}

/// Throws FileError.
ShrunkPart load(const std::string& file, std::uint64_t key, const Mesh& part, double overlap) {
    const SavedFile saved = readSavedFile(file, kShrunkPart);
    const auto refuse = [&](const std::string& reason) { refuseSavedFile(file, kShrunkPart, reason); };
    if (saved.key != key) refuse("was shrunk from another part or by another overlap");
    ShrunkPart shrunk;
    try {
        ArchiveReader in(saved.payload());
        visitShrunk(in, shrunk);
        bool fits = in.isAtEnd() && shrunk.partTriangles.size() == shrunk.mesh.triangles.size() &&
                    shrunk.mesh.components.size() == componentsOf(part).size();
        for (const std::uint32_t triangle : shrunk.partTriangles)
            fits = fits && triangle < part.triangles.size();
        if (!fits) throw FileError("has parts that do not fit together");
    } catch (const std::runtime_error& error) {
        refuse(error.what());
    }
    shrunk.options.overlap = overlap;
    shrunk.mesh.origin = part.origin;
    return shrunk;
}

}  // namespace

CachedShrunkPart shrinkCached(const Mesh& part, const ShrinkOptions& options, const std::string& folder) {
    const std::uint64_t key = keyOf(part, options.overlap);
    const std::filesystem::path file = std::filesystem::path(folder) / fmt::format("{:x}.shrunk", key);
    CachedShrunkPart cached;
    std::error_code unreadable;  // such a file is not loaded; saving then says what is wrong
    if (std::filesystem::exists(file, unreadable)) {
        try {
            cached.part = load(file.string(), key, part, options.overlap);
            cached.isLoaded = true;
            return cached;
        } catch (const FileError& error) {
            cached.warning = std::string(error.what()) + "; it is shrunk again";
        }
    }
    cached.part = shrink(part, options);
    try {
        makeFolder(folder);
        ArchiveWriter payload;
        visitShrunk(payload, cached.part);
        writeSavedFile(file.string(), kShrunkPart, key, payload);
    } catch (const std::runtime_error& error) {
        cached.isKept = false;
        cached.warning +=
            (cached.warning.empty() ? "" : "; ") + std::string(error.what()) + "; shrunk parts are not kept";
    }
    return cached;
}

}  // namespace clearway
