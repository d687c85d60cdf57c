// OFF and its variants with colours, normals and texture coordinates, as text.
// Source: Geomview's manual, "OFF: the generic polyhedral format".
#include <fmt/format.h>
#include <algorithm>
#include <vector>

#include "mesh/read/formats.h"
#include "mesh/read/scanner.h"

namespace clearway {
namespace {

class OffFile {
  public:
    OffFile(std::string_view bytes, MeshCollector& mesh) : scanner_(bytes, mesh), mesh_(mesh) {
        scanner_.trimEnd();
        scanner_.passOverComments('#');
    }

    void read() {
        readHeader();
        mesh_.reserve(vertices_, faces_);
        for (std::size_t i = 0; i < vertices_; ++i) readVertex(i);
        for (std::size_t i = 0; i < faces_; ++i) readFace(i);
        if (scanner_.skipSpace()) {
            scanner_.refuse(
                "{} stands after the {} faces that the header states, expected the end of the file",
                quote(scanner_.word()), faces_);
        }
    }

  private:
    void readHeader() {
        if (!scanner_.skipSpace()) mesh_.refuse("it holds no OFF header");
        Scanner ahead = scanner_;
        const std::string_view word = ahead.word();
        if (word.find_first_not_of("0123456789") != word.npos) readKeyword();
        vertices_ = readCount("vertices");
        faces_ = readCount("faces");
        if (!scanner_.isAtLineEnd()) scanner_.integer([] { return std::string("the number of edges"); });
        if (!scanner_.isAtLineEnd())
            scanner_.refuse("the header has {} after its counts", quote(scanner_.word()));
    }

    void readKeyword() {
        const std::string_view keyword = scanner_.word();
        const std::size_t off = keyword.size() < 3 ? keyword.npos : keyword.size() - 3;
        const std::string_view kind = keyword.substr(0, std::min(off, keyword.size()));
        const bool isKnown = off != keyword.npos && keyword.substr(off) == "OFF" &&
                             kind.find_first_not_of("STCN") == kind.npos;
        if (!isKnown)
            scanner_.refuse("the header is {}, expected OFF, COFF, NOFF, STOFF or a mixture", quote(keyword));
        hasExtras_ = !kind.empty();
        if (!scanner_.isAtLineEnd() && (*scanner_.at() < '0' || *scanner_.at() > '9')) {
            scanner_.refuse("the header has {} after {}, expected a text file's numbers",
                            quote(scanner_.word()), quote(keyword));
        }
    }

    /// An item takes at least two bytes.
    std::size_t readCount(const std::string& things) {
        if (!scanner_.skipSpace()) mesh_.refuse("it ends before the number of its " + things);
        const std::int64_t count = scanner_.integer([&] { return "the number of " + things; });
        if (count < 0 || std::uint64_t(count) > scanner_.bytesLeft() / 2) {
            scanner_.refuse("the header states {} {}, and {} bytes follow", count, things,
                            scanner_.bytesLeft());
        }
        return std::size_t(count);
    }

    void readVertex(std::size_t id) {
        const auto name = [&] { return fmt::format("vertex {}", id); };
        beginItem(name, vertices_, "vertices");
        Vector3 vertex;
        for (int i = 0; i < 3; ++i) vertex[i] = scanner_.number(name);
        const std::size_t more = countRest(name);
        if (!hasExtras_ && more != 0 && more != 3 && more != 4) {
            scanner_.refuse("{} has {} numbers, expected 3, or 6 or 7 with a colour", name(), 3 + more);
        }
        mesh_.addVertex(vertex);
    }

    void readFace(std::size_t id) {
        const auto name = [&] { return fmt::format("face {}", id); };
        beginItem(name, faces_, "faces");
        const std::int64_t count = scanner_.integer(name);
        if (count < 1 || std::uint64_t(count) > scanner_.bytesLeft()) {
            scanner_.refuse("{} has {} corners, expected at least 1", name(), count);
        }
        corners_.clear();
        for (std::int64_t i = 0; i < count; ++i) {
            const std::int64_t corner = scanner_.integer(name);
            if (corner < 0 || std::uint64_t(corner) >= vertices_) {
                scanner_.refuse("{} refers to vertex {}, expected one below {}", name(), corner, vertices_);
            }
            corners_.push_back(static_cast<std::uint32_t>(corner));
        }
        if (const std::size_t more = countRest(name); more > 4) {
            scanner_.refuse("{} has {} numbers after its corners, expected a colour of at most 4", name(),
                            more);
        }
        mesh_.addFace(corners_.data(), corners_.size());
    }

    template <class Name>
    void beginItem(const Name& name, std::size_t stated, const char* things) {
        if (scanner_.skipSpace()) return;
        scanner_.refuse("the file ends before {}, expected the {} {} that its header states", name(), stated,
                        things);
    }

    /// The number of numbers up to the end of the line: colours, normals, texture coordinates.
    template <class Name>
    std::size_t countRest(const Name& name) {
        std::size_t count = 0;
        for (; !scanner_.isAtLineEnd(); ++count) scanner_.number(name);
        scanner_.nextLine();
        return count;
    }

    Scanner scanner_;
    MeshCollector& mesh_;
    std::size_t vertices_ = 0, faces_ = 0;
    bool hasExtras_ = false;
    std::vector<std::uint32_t> corners_;
};

}  // namespace

void readOff(std::string_view bytes, MeshCollector& mesh) {
    OffFile(bytes, mesh).read();
}

}  // namespace clearway
