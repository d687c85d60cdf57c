// STL, as text and binary. Each facet is a triangle of its own; equal corners are welded when a tree is built.
#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <cstring>
#include <vector>

#include "mesh/read/formats.h"
#include "mesh/read/scanner.h"

namespace clearway {
namespace {

constexpr std::size_t kHeader = 80, kStart = 84, kFacet = 50;

std::string lower(std::string_view word) {
    std::string text(word);
    for (char& c : text) c = c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c;
    return text;
}

/// How many triangles a binary file states.
std::size_t statedTriangles(std::string_view bytes) {
    std::uint32_t count = 0;
    std::memcpy(&count, bytes.data() + kHeader, sizeof count);
    return count;
}

/// A text begins with "solid", and its first facet or its end follows that line. Binary files may begin with "solid", too.
bool isText(std::string_view bytes, const MeshCollector& mesh) {
    if (bytes.size() >= kStart && bytes.size() == kStart + kFacet * statedTriangles(bytes)) return false;
    Scanner scanner(bytes, mesh);
    if (!scanner.skipSpace() || lower(scanner.word()) != "solid") return false;
    scanner.nextLine();
    if (!scanner.skipSpace()) return bytes.size() < kStart || bytes.find('\0') == bytes.npos;
    const std::string next = lower(scanner.word());
    return next == "facet" || next == "endsolid" || bytes.find('\0') == bytes.npos;
}

/// Reads facets by keywords, in upper or lower case. Some writers add words after a keyword.
class StlText {
  public:
    StlText(std::string_view bytes, MeshCollector& mesh) : scanner_(bytes, mesh), mesh_(mesh) {
        scanner_.trimEnd();
    }

    void read() {
        while (scanner_.skipSpace()) {
            const std::string word = lower(scanner_.word());
            if (word != "solid") scanner_.refuse("{} stands after {}, expected solid", quote(word), place());
            mesh_.beginComponent(scanner_.restOfLine());
            while (readFacet()) continue;
            scanner_.nextLine();  // the solid's name stands there again
        }
    }

  private:
    /// False at the solid's end.
    bool readFacet() {
        std::string first = nextKeyword();
        while (first == "color") {  // of the facets that follow, in some programs
            scanner_.nextLine();
            first = nextKeyword();
        }
        if (first == "endsolid") return false;
        if (first == "end" && lower(scanner_.word()) == "solid") return false;
        if (first != "facet") refuseWord(first, "facet or endsolid");
        require("outer");
        require("loop");
        std::array<std::uint32_t, 3> corners{};
        for (std::uint32_t& corner : corners) {
            require("vertex");
            Vector3 vertex;
            for (int i = 0; i < 3; ++i) vertex[i] = scanner_.number([&] { return "a vertex of " + place(); });
            followsVertex_ = true;
            corner = mesh_.addVertex(vertex);
        }
        require("endloop");
        require("endfacet");
        mesh_.addTriangle(corners[0], corners[1], corners[2]);
        ++facets_;
        return true;
    }

    void require(const char* keyword) {
        const std::string word = nextKeyword();
        if (word != keyword) refuseWord(word, keyword);
    }

    /// The next keyword. The numbers of a normal, or other words, may stand in the line before it.
    std::string nextKeyword() {
        while (!scanner_.isAtLineEnd()) {
            std::string word = lower(scanner_.word());
            if (isKeyword(word)) return followsVertex_ = false, word;
            if (followsVertex_)
                scanner_.refuse("a vertex of {} has {} after its three numbers", place(), quote(word));
        }
        followsVertex_ = false;
        if (!scanner_.skipSpace()) scanner_.refuse("the file ends at {}, expected endsolid", place());
        return lower(scanner_.word());
    }

    [[noreturn]] void refuseWord(const std::string& word, const std::string& expected) {
        scanner_.refuse("{} has {}, expected {}", place(), quote(word), expected);
    }

    static bool isKeyword(const std::string& word) {
        constexpr const char* kKeywords[] = {"facet",   "outer",    "loop",    "vertex",
                                             "endloop", "endfacet", "endsolid"};
        return std::find(std::begin(kKeywords), std::end(kKeywords), word) != std::end(kKeywords);
    }

    std::string place() const { return fmt::format("facet {}", facets_); }

    Scanner scanner_;
    MeshCollector& mesh_;
    std::size_t facets_ = 0;
    bool followsVertex_ = false;  ///< then only a keyword may stand in the line
};

void readBinary(std::string_view bytes, MeshCollector& mesh) {
    const std::string_view start = bytes.substr(0, kStart);
    if (std::all_of(start.begin(), start.end(), [](unsigned char c) { return c >= 9; })) {
        const std::vector<std::string_view> all = words(start);
        mesh.refuse("its text begins with {}, expected solid", quote(all.empty() ? "" : all[0]));
    }
    const std::string cut = fmt::format("it ends after {} bytes of ", bytes.size());
    if (bytes.size() < kStart) mesh.refuse(cut + "the 84 with which a binary STL file begins");
    const std::size_t count = statedTriangles(bytes), whole = kStart + kFacet * count;
    if (bytes.size() < whole) {
        mesh.refuse("{}{}, which its {} triangles take", cut, whole, count);
    }
    mesh.acceptTail(bytes.substr(whole), kFacet - 1, fmt::format("its {} triangles", count));
    mesh.reserve(3 * count, count);
    for (std::size_t facet = 0; facet < count; ++facet) {
        float corners[9];
        std::memcpy(corners, bytes.data() + kStart + kFacet * facet + 12, sizeof corners);
        std::uint32_t first = 0;
        for (int i = 0; i < 3; ++i) {
            const std::uint32_t vertex =
                mesh.addVertex({corners[3 * i], corners[3 * i + 1], corners[3 * i + 2]});
            if (i == 0) first = vertex;
        }
        mesh.addTriangle(first, first + 1, first + 2);
    }
}

}  // namespace

void readStl(std::string_view bytes, MeshCollector& mesh) {
    if (isText(bytes, mesh)) {
        StlText(bytes, mesh).read();
    } else {
        readBinary(bytes, mesh);
    }
}

}  // namespace clearway
