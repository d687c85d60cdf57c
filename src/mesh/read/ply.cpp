// PLY, as text and binary in both byte orders: faces and triangle strips over vertices; other elements are passed over.
// Source: Turk, The PLY polygon file format, 1994.
#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <vector>

#include "core/number.h"
#include "mesh/read/formats.h"
#include "mesh/read/scanner.h"

namespace clearway {
namespace {

enum class Form { kText, kLittle, kBig };

template <class Value>
double plyNumber(const char* bytes) {
    Value value;
    std::memcpy(&value, bytes, sizeof value);
    return static_cast<double>(value);
}

struct NumberType {
    std::string_view name, otherName;
    std::size_t bytes;
    double (*value)(const char* bytes);
};

constexpr NumberType kNumberTypes[] = {
    {"char", "int8", 1, plyNumber<std::int8_t>},    {"uchar", "uint8", 1, plyNumber<std::uint8_t>},
    {"short", "int16", 2, plyNumber<std::int16_t>}, {"ushort", "uint16", 2, plyNumber<std::uint16_t>},
    {"int", "int32", 4, plyNumber<std::int32_t>},   {"uint", "uint32", 4, plyNumber<std::uint32_t>},
    {"float", "float32", 4, plyNumber<float>},      {"double", "float64", 8, plyNumber<double>}};

struct Property {
    std::string name;
    const NumberType* type = nullptr;
    const NumberType* countType = nullptr;  ///< null unless it is a list
};

struct Element {
    std::string name;
    std::size_t count = 0;
    std::vector<Property> properties;

    /// Position of the property with one of two names; properties.size() without one.
    std::size_t find(std::string_view name1, std::string_view name2) const {
        const auto found = std::find_if(properties.begin(), properties.end(), [&](const Property& property) {
            return property.name == name1 || property.name == name2;
        });
        return std::size_t(found - properties.begin());
    }
};

struct Header {
    Form form = Form::kText;
    std::vector<Element> elements;
};

const NumberType& typeNamed(std::string_view name, const Scanner& scanner) {
    for (const NumberType& type : kNumberTypes) {
        if (name == type.name || name == type.otherName) return type;
    }
    scanner.refuse(
        "a property has the type {}, expected char, uchar, short, ushort, int, uint, float or double",
        quote(name));
}

Form readForm(Scanner& scanner) {
    const std::string_view word = scanner.word();
    if (word == "ascii") return Form::kText;
    if (word == "binary_little_endian") return Form::kLittle;
    if (word == "binary_big_endian") return Form::kBig;
    scanner.refuse("the format is {}, expected ascii, binary_little_endian or binary_big_endian",
                   quote(word));
}

Element readElement(Scanner& scanner) {
    Element element;
    element.name = scanner.word();
    const std::int64_t count = scanner.integer([&] { return "element " + quote(element.name); });
    if (count < 0) scanner.refuse("element {} has the count {}", quote(element.name), count);
    element.count = std::size_t(count);
    return element;
}

Property readProperty(Scanner& scanner) {
    Property property;
    std::string_view word = scanner.word();
    if (word == "list") {
        property.countType = &typeNamed(scanner.word(), scanner);
        word = scanner.word();
    }
    property.type = &typeNamed(word, scanner);
    property.name = scanner.word();
    return property;
}

/// Leaves the scanner at the first byte of the data.
Header readHeader(Scanner& scanner) {
    Header header;
    bool hasForm = false;
    const std::string_view magic = scanner.word();
    if (magic != "ply" && magic != "PLY")
        scanner.refuse("the header begins with {}, expected ply", quote(magic));
    const bool endsWithReturn = scanner.isAt('\r') && scanner.bytesLeft() > 1 && scanner.at()[1] != '\n';
    for (std::string_view word; word != "end_header";) {
        scanner.nextLine();
        if (scanner.isAtEnd()) scanner.refuse("the header has no end_header");
        word = scanner.word();
        if (word == "format") {
            header.form = readForm(scanner);
            hasForm = true;
        } else if (word == "element") {
            header.elements.push_back(readElement(scanner));
        } else if (word == "property" && !header.elements.empty()) {
            header.elements.back().properties.push_back(readProperty(scanner));
        } else if (!header.elements.empty() && !word.empty() && word != "comment" && word != "obj_info" &&
                   word != "end_header") {  // before the first element, writers forget the word comment
            scanner.refuse("the header has {}, expected element, its properties, comment or end_header",
                           quote(word));
        }
    }
    if (!hasForm) scanner.refuse("the header has no format");
    if (!scanner.isAtLineEnd()) scanner.refuse("end_header is followed by " + quote(scanner.word()));
    if (endsWithReturn) {
        scanner.skip('\r');  // binary data may begin with the byte of "\n"
    } else {
        scanner.nextLine();
    }
    return header;
}

/// Bytes after the data that are less than any face takes.
constexpr std::size_t kMostTail = 3;

class PlyData {
  public:
    PlyData(const Scanner& scanner, const Header& header, MeshCollector& mesh)
        : scanner_(scanner), header_(header), isText_(header.form == Form::kText), mesh_(mesh) {}

    void read() {
        for (const Element& element : header_.elements) requireOne(element);
        for (const Element& element : header_.elements) requireRoom(element);
        for (const Element& element : header_.elements) readRows(element);
        addFaces();
        const std::string_view rest(scanner_.at(), scanner_.bytesLeft());
        if (!isText_) return mesh_.acceptTail(rest, kMostTail, "the elements that its header states");
        if (scanner_.skipSpace()) scanner_.refuse("a row follows those that the header states");
    }

  private:
    /// Refuses a second element, and a second property, of a name.
    void requireOne(const Element& element) const {
        const auto count = [](const auto& rows, std::string_view name) {
            return std::count_if(rows.begin(), rows.end(), [&](const auto& row) { return row.name == name; });
        };
        if (count(header_.elements, element.name) > 1)
            mesh_.refuse("it has two elements {}, expected one", quote(element.name));
        for (const Property& property : element.properties) {
            if (count(element.properties, property.name) == 1) continue;
            mesh_.refuse("element {} has two properties {}, expected one", quote(element.name),
                         quote(property.name));
        }
        if (count(element.properties, "vertex_index") + count(element.properties, "vertex_indices") > 1) {
            mesh_.refuse("element {} has two lists of vertices, expected one", quote(element.name));
        }
    }

    /// Refuses a count above what the data can hold. A number of a text takes a digit and what ends it.
    void requireRoom(const Element& element) const {
        if (element.count == 0) return;
        std::size_t least = 0;
        for (const Property& property : element.properties) {
            least += isText_ ? 2 : (property.countType ? property.countType : property.type)->bytes;
        }
        const std::string stated =
            fmt::format("element {} has the count {}", quote(element.name), element.count);
        if (least == 0) mesh_.refuse(stated + " and no property");
        if (element.count > (scanner_.bytesLeft() + 1) / least) {
            mesh_.refuse("{}, and {} bytes follow the header", stated, scanner_.bytesLeft());
        }
    }

    void readRows(const Element& element) {
        const std::string& kind = element.name;
        if (kind == "vertex") {
            readVertices(element);
        } else if (kind == "face" || kind == "tristrips") {
            readFaces(element, kind == "face");
        } else if (kind == "range_grid") {
            mesh_.refuse("its surface is an element range_grid, expected faces");
        } else {
            const std::size_t none = element.properties.size();
            if (element.find("vertex_indices", "vertex_index") < none) {
                mesh_.refuse("element {} has a list of vertices, expected it of face or tristrips only",
                             quote(kind));
            }
            forEachRow(element, none, [] {});
        }
    }

    void readVertices(const Element& element) {
        const std::size_t places[] = {element.find("x", "x"), element.find("y", "y"), element.find("z", "z")};
        for (const std::size_t place : places) {
            if (place < element.properties.size() && !element.properties[place].countType) continue;
            mesh_.refuse("its vertices lack one of the properties x, y and z");
        }
        mesh_.reserve(element.count, 0);
        forEachRow(element, element.properties.size(), [&] {
            mesh_.addVertex({numbers_[places[0]], numbers_[places[1]], numbers_[places[2]]});
        });
    }

    void readFaces(const Element& element, bool areFaces) {
        const std::size_t place = element.find("vertex_indices", "vertex_index");
        if (place == element.properties.size() || !element.properties[place].countType) {
            mesh_.refuse("element {} lacks the list vertex_indices", quote(element.name));
        }
        std::vector<std::size_t>& ends = areFaces ? faceEnds_ : stripEnds_;
        std::vector<double>& corners = areFaces ? faceCorners_ : stripCorners_;
        ends.reserve(element.count);
        forEachRow(element, place, [&] {
            corners.insert(corners.end(), list_.begin(), list_.end());
            ends.push_back(corners.size());
        });
    }

    /// Reads each row into numbers_ and, of one of its lists, into list_.
    template <class Use>
    void forEachRow(const Element& element, std::size_t listPlace, const Use& use) {
        numbers_.resize(element.properties.size());
        for (std::size_t row = 0; row < element.count; ++row) {
            const auto name = [&] { return fmt::format("{} {}", element.name, row); };
            if (isText_ && !scanner_.skipSpace()) refuseCut(name());
            for (std::size_t i = 0; i < element.properties.size(); ++i) {
                const Property& property = element.properties[i];
                if (property.countType) {
                    readList(property, i == listPlace, name);
                } else {
                    numbers_[i] = readNumber(*property.type, name);
                }
            }
            if (isText_ && !scanner_.isAtLineEnd()) {
                scanner_.refuse("{} has {} after its properties", name(), quote(scanner_.word()));
            }
            if (isText_) scanner_.nextLine();
            use();
        }
    }

    template <class Name>
    void readList(const Property& property, bool isKept, const Name& name) {
        const double count = readNumber(*property.countType, name);
        if (!(count >= 0) || count != std::floor(count) || count > double(scanner_.bytesLeft())) {
            mesh_.refuse("{} has a list of {} values, and {} bytes follow", name(), shortNumber(count),
                         scanner_.bytesLeft());
        }
        if (isKept) list_.clear();
        for (std::size_t i = 0; i < std::size_t(count); ++i) {
            const double value = readNumber(*property.type, name);
            if (isKept) list_.push_back(value);
        }
    }

    template <class Name>
    double readNumber(const NumberType& type, const Name& name) {
        if (isText_) return scanner_.number(name);
        if (scanner_.bytesLeft() < type.bytes) refuseCut(name());
        const char* const at = scanner_.take(type.bytes);
        if (header_.form == Form::kLittle) return type.value(at);
        std::array<char, 8> turned{};
        std::reverse_copy(at, at + type.bytes, turned.begin());
        return type.value(turned.data());
    }

    [[noreturn]] void refuseCut(const std::string& where) const {
        mesh_.refuse("the file ends at {}, expected the rows that its header states", where);
    }

    /// Faces wait until now, because they may precede the vertices.
    void addFaces() {
        std::size_t first = 0;
        std::vector<std::uint32_t> corners;
        for (std::size_t face = 0; face < faceEnds_.size(); first = faceEnds_[face++]) {
            corners.clear();
            for (std::size_t i = first; i < faceEnds_[face]; ++i)
                corners.push_back(corner(faceCorners_[i], face, "face "));
            if (corners.empty()) mesh_.refuse("face {} has no corner", face);
            mesh_.addFace(corners.data(), corners.size());
        }
        first = 0;
        for (std::size_t strip = 0; strip < stripEnds_.size(); first = stripEnds_[strip++])
            addStrips(strip, first);
    }

    /// A list of strips; -1 ends one. Each corner after the second makes a triangle with the two before it. They take turns in two places, which keeps the sides alike.
    void addStrips(std::size_t list, std::size_t first) {
        std::array<std::uint32_t, 2> last{};
        std::size_t length = 0;
        for (std::size_t i = first; i < stripEnds_[list]; ++i) {
            if (stripCorners_[i] == -1) {
                length = 0;
                continue;
            }
            const std::uint32_t next = corner(stripCorners_[i], list, "tristrips ");
            if (length >= 2) mesh_.addTriangle(last[0], last[1], next);
            last[length++ % 2] = next;
        }
    }

    std::uint32_t corner(double index, std::size_t row, const char* element) const {
        if (index >= 0 && index < double(mesh_.vertexCount()) && index == std::floor(index))
            return static_cast<std::uint32_t>(index);
        mesh_.refuse("{}{} refers to vertex {}, expected one below {}", element, row, shortNumber(index),
                     mesh_.vertexCount());
    }

    Scanner scanner_;
    const Header& header_;
    bool isText_;
    MeshCollector& mesh_;
    std::vector<double> numbers_, list_, faceCorners_, stripCorners_;
    std::vector<std::size_t> faceEnds_, stripEnds_;
};

}  // namespace

void readPly(std::string_view bytes, MeshCollector& mesh) {
    Scanner scanner(bytes, mesh);
    const Header header = readHeader(scanner);
    if (header.form == Form::kText) scanner.trimEnd();
    PlyData(scanner, header, mesh).read();
}

}  // namespace clearway
