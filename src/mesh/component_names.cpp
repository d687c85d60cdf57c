#include "mesh/component_names.h"

#include <unordered_map>
#include <unordered_set>

namespace clearway {

namespace {

bool isMadeUp(const std::string& name) {
    return name.empty() || name == "defaultobject" || name.front() == '$' ||
           (name.front() == '<' && name.back() == '>');
}

}  // namespace

std::string componentName(const std::string& node, const std::string& mesh) {
    if (isMadeUp(node)) return isMadeUp(mesh) ? std::string() : mesh;
    if (isMadeUp(mesh) || mesh == node) return node;
    return node + "/" + mesh;
}

void makeNamesDistinct(std::vector<Component>& components, const std::string& fallback) {
    std::unordered_set<std::string> inFile;
    for (Component& component : components) {
        if (component.name.empty()) component.name = fallback;
        inFile.insert(component.name);
    }
    std::unordered_set<std::string> taken;
    std::unordered_map<std::string, int> lastNumber;
    for (Component& component : components) {
        if (taken.insert(component.name).second) continue;
        // A number that makes a name the file itself uses elsewhere is passed over, so that one keeps its
        // name.
        int& number = lastNumber.try_emplace(component.name, 1).first->second;
        std::string numbered;
        do {
            numbered = component.name + "#" + std::to_string(++number);
        } while (inFile.count(numbered) != 0);
        component.name = numbered;
        taken.insert(component.name);
    }
}

}  // namespace clearway
