// Shared by the readers of XML formats: parsing, numbers in texts, and bounds on what a small file may unfold into.
// Positions in messages count from 0.
#pragma once

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "core/number.h"
#include "core/text.h"
#include "mesh/read/collector.h"
#include "mesh/read/decimal.h"

namespace clearway {

/// Levels of nested nodes or components: recursion goes no deeper.
constexpr std::size_t kDeepestNesting = 1000;

/// A file of a few lines, each of which places the next one twice, would otherwise be read for years.
constexpr std::size_t kMostPlacements = 1'000'000;

/// Parses the bytes in place and returns the only root element. The bytes must outlive the document. part names them in
/// messages. Refuses entities, which could hold elements that the parser leaves out.
inline pugi::xml_node parseXml(pugi::xml_document& document, std::string& bytes, const std::string& part,
                               const MeshCollector& mesh) {
    constexpr unsigned kParts =
        pugi::parse_escapes | pugi::parse_cdata | pugi::parse_wconv_attribute | pugi::parse_doctype;
    const pugi::xml_parse_result result = document.load_buffer_inplace(bytes.data(), bytes.size(), kParts);
    if (!result) {
        mesh.refuse("{} is not sound XML at byte {} of {}: {}", part, result.offset, bytes.size(),
                    result.description());
    }
    pugi::xml_node root;
    for (const pugi::xml_node node : document) {
        if (node.type() == pugi::node_doctype &&
            std::string_view(node.value()).find('[') != std::string_view::npos) {
            mesh.refuse(part + " has a DOCTYPE with declarations, expected none");
        }
        if (node.type() != pugi::node_element) continue;
        if (root) mesh.refuse("{} has a second root element <{}>, expected one", part, node.name());
        root = node;
    }
    return root;
}

/// The element's whole text. A comment divides it into several nodes; only then `joinedText` holds it.
inline std::string_view textOf(const pugi::xml_node& element, std::string& joinedText) {
    const pugi::xml_node first = element.first_child();
    if (!first) return {};
    if (!first.next_sibling()) return first.value();
    joinedText.clear();
    for (const pugi::xml_node part : element) joinedText += part.value();
    return joinedText;
}

constexpr bool isXmlBlank(char c) {
    return c == ' ' || c == '\n' || c == '\t' || c == '\r';
}

/// Reads the number at the beginning of the text and removes it. False if none is there, or if it goes on with other letters.
template <typename Number>
bool takeNumber(std::string_view& text, Number& value) {
    const char* const end = text.data() + text.size();
    const bool hasPlus = text.size() > 1 && text[0] == '+' && text[1] != '-';
    std::from_chars_result read{};
    if constexpr (std::is_same_v<Number, double>) {
        read = fromDecimal(text.data() + hasPlus, end, value);
    } else {
        read = std::from_chars(text.data() + hasPlus, end, value);
    }
    const auto [stop, error] = read;
    if (error != std::errc{} || (stop != end && !isXmlBlank(*stop))) return false;
    text.remove_prefix(static_cast<std::size_t>(stop - text.data()));
    return true;
}

inline void skipXmlBlanks(std::string_view& text) {
    while (!text.empty() && isXmlBlank(text.front())) text.remove_prefix(1);
}

/// All numbers of a text. what: names the text in messages.
template <typename Number>
std::vector<Number> numbersIn(std::string_view text, const std::string& what, const MeshCollector& mesh) {
    std::vector<Number> numbers;
    for (skipXmlBlanks(text); !text.empty(); skipXmlBlanks(text)) {
        Number value{};
        if (!takeNumber(text, value)) {
            const char* const expected =
                std::is_integral_v<Number> ? "a whole number, 0 or more" : "a number";
            mesh.refuse("number {} of {} is {}, expected {}", numbers.size(), what,
                        quote(text.substr(0, text.find_first_of(" \t\r\n"))), expected);
        }
        numbers.push_back(value);
    }
    return numbers;
}

/// The one number that a text holds. False for any other text.
template <typename Number>
bool isNumber(std::string_view text, Number& value) {
    skipXmlBlanks(text);
    if (!takeNumber(text, value)) return false;
    skipXmlBlanks(text);
    return text.empty();
}

/// The quoted value of an attribute, for messages; "missing" if it is not there.
inline std::string valueOf(const pugi::xml_attribute& attribute) {
    return attribute ? quote(attribute.value()) : "missing";
}

/// Keeps the path from the root to the node that is being placed: refuses cycles, and files that nest or place too much.
class PlacementPath {
  public:
    explicit PlacementPath(const MeshCollector& mesh) : mesh_(mesh) {}

    /// what: names the node in messages.
    void enter(const pugi::xml_node& node, const std::string& what) {
        if (std::find(nodes_.begin(), nodes_.end(), node) != nodes_.end())
            mesh_.refuse(what + " contains itself");
        if (nodes_.size() == kDeepestNesting) {
            mesh_.refuse("{} is nested deeper than {} levels", what, kDeepestNesting);
        }
        if (++placed_ > kMostPlacements) {
            mesh_.refuse("it places more than {} nodes", kMostPlacements);
        }
        nodes_.push_back(node);
    }
    void leave() { nodes_.pop_back(); }

  private:
    const MeshCollector& mesh_;
    std::vector<pugi::xml_node> nodes_;
    std::size_t placed_ = 0;
};

}  // namespace clearway
