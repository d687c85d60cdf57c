#include "support/byu_mesh.h"

#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "core/number.h"
#include "core/text.h"

namespace clearway::testing {
namespace {

/// The words of a file, one by one, with errors that name the file and the line.
class WordReader {
  public:
    explicit WordReader(const std::string& file) : file_(file), lines_(readLines(file, "a .g file")) {
        int number = 0;
        for (const std::string& line : lines_) {
            ++number;
            for (const std::string_view word : words(line)) words_.push_back({word, number});
        }
    }

    std::size_t left() const { return words_.size() - next_; }

    double number(const char* expected) {
        const Word word = take(expected);
        const std::optional<double> value = parseNumber(word.text);
        if (!value) refuse(word, expected);
        return *value;
    }

    std::int64_t integer(std::int64_t least, std::int64_t most, const char* expected) {
        const Word word = take(expected);
        const std::optional<std::int64_t> value = parseInteger(word.text);
        if (!value || *value < least || *value > most) refuse(word, expected);
        return *value;
    }

    [[noreturn]] void refuse(const std::string& trouble) const {
        throw std::invalid_argument(file_ + ": " + trouble);
    }

  private:
    struct Word {
        std::string_view text;
        int line = 0;
    };

    Word take(const char* expected) {
        if (left() == 0) refuse(std::string("the file ends, expected ") + expected);
        return words_[next_++];
    }
    [[noreturn]] void refuse(const Word& word, const char* expected) const {
        throw std::invalid_argument(place(file_, word.line) + quote(word.text) + " is there, expected " +
                                    expected);
    }

    std::string file_;
    std::vector<std::string> lines_;
    std::vector<Word> words_;
    std::size_t next_ = 0;
};

/// Cuts the next polygon into triangles and appends them. Returns the number of its corners.
std::size_t appendPolygon(WordReader& words, std::int64_t vertexCount, Mesh& mesh) {
    std::vector<std::uint32_t> corners;
    for (bool isLast = false; !isLast;) {
        const std::int64_t corner =
            words.integer(-vertexCount, vertexCount, "a corner, from 1 to the number of vertices");
        if (corner == 0) words.refuse("a corner is 0, expected one counted from 1");
        isLast = corner < 0;
        corners.push_back(static_cast<std::uint32_t>(std::abs(corner) - 1));
    }
    for (std::size_t i = 2; i < corners.size(); ++i) {
        mesh.triangles.push_back({corners[0], corners[i - 1], corners[i]});
    }
    return corners.size();
}

}  // namespace

Mesh readByuMesh(const std::string& file) {
    WordReader words(file);
    const auto most = static_cast<std::int64_t>(words.left());  // each count has at least as many words
    const std::int64_t partCount = words.integer(1, most, "the number of parts");
    const std::int64_t vertexCount = words.integer(3, most, "the number of vertices, at least 3");
    const std::int64_t polygonCount = words.integer(1, most, "the number of polygons");
    const std::int64_t cornerCount = words.integer(3, most, "the number of the polygons' corners");
    std::vector<std::int64_t> lastPolygons;
    for (std::int64_t i = 0, next = 1; i < partCount; ++i) {
        words.integer(next, next, "the part's first polygon, the next one");
        lastPolygons.push_back(words.integer(next, polygonCount, "the part's last polygon"));
        next = lastPolygons.back() + 1;
    }
    if (lastPolygons.back() != polygonCount) {
        words.refuse("the last part ends with polygon " + std::to_string(lastPolygons.back()) +
                     ", expected " + std::to_string(polygonCount));
    }

    Mesh mesh;
    mesh.origin.file = file;
    for (std::int64_t i = 0; i < vertexCount; ++i) {
        Vector3 vertex;
        for (double& coordinate : vertex) coordinate = words.number("a coordinate, a finite number");
        mesh.vertices.push_back(vertex);
    }
    std::int64_t polygon = 0, corners = 0;
    for (std::int64_t part = 0; part < partCount; ++part) {
        Component component;
        component.name = "part_" + std::to_string(part + 1);
        component.firstTriangle = static_cast<std::uint32_t>(mesh.triangles.size());
        for (; polygon < lastPolygons[static_cast<std::size_t>(part)]; ++polygon) {
            corners += static_cast<std::int64_t>(appendPolygon(words, vertexCount, mesh));
        }
        component.triangleCount = static_cast<std::uint32_t>(mesh.triangles.size()) - component.firstTriangle;
        mesh.components.push_back(component);
    }
    if (corners != cornerCount || words.left() != 0) {
        words.refuse("the polygons have " + std::to_string(corners) + " corners and " +
                     std::to_string(words.left()) + " words follow, expected " + std::to_string(cornerCount) +
                     " and none");
    }
    if (mesh.triangles.empty()) words.refuse("no polygon has three corners, expected a surface");
    return mesh;
}

}  // namespace clearway::testing
