// A COLLADA document: which element a reference names, and the numbers and words of its sources.
// Source: COLLADA Digital Asset Schema Release 1.4.1 and 1.5.0.
#pragma once

#include <initializer_list>
#include <string>
#include <unordered_map>
#include <vector>

#include "mesh/read/xml.h"

namespace clearway {

class DaeDocument {
  public:
    /// Parses the bytes in place; bytes and mesh must outlive the document. Refuses versions other than 1.4 and 1.5, and units
    /// or up axes of single elements that differ from the document's.
    DaeDocument(std::string& bytes, MeshCollector& mesh);

    pugi::xml_node root() const { return root_; }
    MeshCollector& mesh() const { return mesh_; }

    /// "geometry 'g'": an element for messages, by its id, or else its name.
    static std::string textOf(const pugi::xml_node& element);

    /// The element that an attribute, such as url, refers to. kinds: the names that it may have. A child of `scope` comes
    /// first, because exporters repeat ids. Refuses references to other files, to nothing, or to several elements.
    pugi::xml_node find(const pugi::xml_attribute& reference, std::initializer_list<const char*> kinds,
                        const std::string& what, const pugi::xml_node& scope = {}) const;

    /// The element that has the id.
    pugi::xml_node named(const std::string& id, std::initializer_list<const char*> kinds,
                         const std::string& what) const;

    /// The source that an element's only input of a semantic refers to. scope: see find.
    pugi::xml_node sourceOf(const pugi::xml_node& element, const char* semantic,
                            const pugi::xml_node& scope) const;

    /// The rows of a source, each of so many numbers: X, Y and Z; a matrix of 16; or a weight.
    std::vector<double> numbersOf(const pugi::xml_node& source, std::size_t width) const;

    /// The words of a source of names or of ids.
    std::vector<std::string> wordsOf(const pugi::xml_node& source) const;

    /// An attribute that counts something or states a position; `missing` is taken when it is not there.
    std::size_t countIn(const pugi::xml_node& element, const char* attribute, const std::string& what,
                        const std::size_t* missing = nullptr) const;

  private:
    void index();
    void readAsset();
    void requireSameAsset(const pugi::xml_node& asset) const;
    std::vector<std::size_t> columnsOf(const pugi::xml_node& accessor, std::size_t width,
                                       const std::string& what) const;

    pugi::xml_document document_;
    pugi::xml_node root_;
    MeshCollector& mesh_;
    std::unordered_map<std::string, std::vector<pugi::xml_node>> elements_;  ///< by id
    double unitMetres_ = 1;
    std::string upAxis_ = "Y_UP";
};

}  // namespace clearway
