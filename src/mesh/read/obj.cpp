// Wavefront OBJ: polygons with their groups and objects. Free-form surfaces are refused.
// Source: Wavefront's Advanced Visualizer manual, appendix B1.
#include <fmt/format.h>
#include <algorithm>
#include <iterator>
#include <vector>

#include "core/number.h"
#include "mesh/read/formats.h"
#include "mesh/read/scanner.h"

namespace clearway {
namespace {

/// Statements that bring no surface by themselves.
constexpr std::string_view kIgnored[] = {"vc",       "vt",       "vn",     "vp",         "usemtl",
                                         "mtllib",   "s",        "mg",     "lod",        "bevel",
                                         "c_interp", "d_interp", "usemap", "maplib",     "cstype",
                                         "deg",      "ctech",    "stech",  "shadow_obj", "trace_obj"};

/// Statements that bring surfaces or other files.
constexpr std::string_view kRefused[] = {"call", "csh",  "curv", "curv2", "surf", "bzp",  "bsp",
                                         "cdc",  "cdp",  "res",  "bmat",  "step", "parm", "trim",
                                         "hole", "scrv", "sp",   "con",   "end"};

template <std::size_t n>
bool contains(const std::string_view (&words)[n], std::string_view word) {
    return std::find(std::begin(words), std::end(words), word) != std::end(words);
}

/// Reads all vertices first, because faces may refer to later ones.
class ObjFile {
  public:
    ObjFile(std::string_view bytes, MeshCollector& mesh) : bytes_(bytes), mesh_(mesh) {}

    void read() {
        Scanner start(bytes_, mesh_);
        start.trimEnd();
        start.passOverComments('#');
        for (Scanner scanner = start; scanner.skipSpace(); scanner.nextLine()) {
            if (*scanner.at() == 'v' && scanner.word() == "v") readVertex(scanner);
        }
        for (Scanner scanner = start; scanner.skipSpace(); scanner.nextLine()) {
            readStatement(scanner, scanner.word());
        }
    }

  private:
    void readVertex(Scanner& scanner) {
        const auto name = [&] { return fmt::format("vertex {}", mesh_.vertexCount() + 1); };
        scanner.joinLines(true);
        double numbers[7] = {};
        int count = 0;
        for (; count < 3 || (count < 7 && !scanner.isAtLineEnd()); ++count)
            numbers[count] = scanner.number(name);
        // The others are a colour, or the weight with which only free-form surfaces use the vertex.
        const bool isKnown = count == 3 || count == 6 || count == 7 || (count == 4 && numbers[3] == 1);
        if (!isKnown || !scanner.isAtLineEnd()) {
            scanner.refuse(
                "{} has {} numbers{}, then {}, expected 3, or 4 of which the last is 1, or 6 or 7 with a "
                "colour",
                name(), count, count == 4 ? ", the last of which is " + shortNumber(numbers[3]) : "",
                quote(scanner.restOfLine()));
        }
        scanner.joinLines(false);
        mesh_.addVertex({numbers[0], numbers[1], numbers[2]});
    }

    void readStatement(Scanner& scanner, std::string_view word) {
        if (word == "v") {
            ++verticesBefore_;
            skipJoinedLines(scanner);
        } else if (word == "f" || word == "fo") {
            readFace(scanner);
        } else if (word == "g" || word == "o") {
            mesh_.beginComponent(scanner.restOfLine());
        } else if (word == "l" || word == "p") {
            const std::size_t points = skipJoinedLines(scanner);
            mesh_.ignoreFaces(word == "l" ? std::max<std::size_t>(points, 2) - 1 : points);
        } else if (word == "vt" || word == "vn" || word == "vp") {
            skipJoinedLines(scanner);
        } else if (contains(kRefused, word)) {
            scanner.refuse(quote(word) + " is not read, expected polygons in one file");
        } else if (!contains(kIgnored, word)) {
            scanner.refuse(quote(word) + " is no statement of an OBJ file");
        }
    }

    /// Goes to the end of a statement of numbers, and returns how many words it has. Names end with their line: they may be Windows paths
    /// with a backslash at the end.
    static std::size_t skipJoinedLines(Scanner& scanner) {
        std::size_t words = 0;
        scanner.joinLines(true);
        for (; !scanner.isAtLineEnd(); ++words) scanner.word();
        scanner.joinLines(false);
        return words;
    }

    void readFace(Scanner& scanner) {
        ++faces_;
        corners_.clear();
        scanner.joinLines(true);
        while (!scanner.isAtLineEnd()) corners_.push_back(readCorner(scanner));
        scanner.joinLines(false);
        if (corners_.size() < 3) {
            scanner.refuse("{} has {} corners, expected at least 3", faceName(), corners_.size());
        }
        mesh_.addFace(corners_.data(), corners_.size());
    }

    /// "7", "7/1", "7//2" or "7/1/2", of which the first number is the vertex; negative ones count back from the latest vertex.
    std::uint32_t readCorner(Scanner& scanner) {
        const auto name = [&] { return faceName(); };
        const std::int64_t number = scanner.integerBefore('/', name);
        for (int i = 0; i < 2 && scanner.skip('/'); ++i) {
            if (!scanner.isAtWordEnd() && !scanner.isAt('/')) scanner.integerBefore('/', name);
        }
        if (!scanner.isAtWordEnd()) scanner.refuse(faceName() + " has a corner of more than three numbers");
        const auto count = std::int64_t(mesh_.vertexCount());
        const std::int64_t place = number > 0 ? number - 1 : std::int64_t(verticesBefore_) + number;
        if (number == 0 || place < 0 || place >= count) {
            scanner.refuse(
                "{} refers to vertex {}, expected 1 to {}, or a negative number that counts back from the "
                "latest of {}",
                faceName(), number, count, verticesBefore_);
        }
        return static_cast<std::uint32_t>(place);
    }

    std::string faceName() const { return fmt::format("face {}", faces_); }

    std::string_view bytes_;
    MeshCollector& mesh_;
    std::size_t verticesBefore_ = 0;  ///< the statement that is being read
    std::size_t faces_ = 0;
    std::vector<std::uint32_t> corners_;
};

}  // namespace

void readObj(std::string_view bytes, MeshCollector& mesh) {
    ObjFile(bytes, mesh).read();
}

}  // namespace clearway
