#include "mesh/components.h"

#include <algorithm>
#include <unordered_map>
#include <unordered_set>

#include "mesh/renumber.h"

namespace clearway {

namespace {

bool isMadeUp(const std::string& name) {
    return name.empty() || name == "defaultobject" || name.front() == '$' ||
           (name.front() == '<' && name.back() == '>');
}

}  // namespace

std::vector<Component> componentsOf(const Mesh& mesh) {
    if (!mesh.components.empty()) return mesh.components;
    return {{"", 0, static_cast<std::uint32_t>(mesh.triangles.size())}};
}

Mesh meshOfComponents(const Mesh& mesh, const std::vector<std::size_t>& components) {
    const std::vector<Component> all = componentsOf(mesh);
    Mesh result;
    result.origin = mesh.origin;
    for (const std::size_t index : components) {
        const Component& component = all[index];
        result.components.push_back({component.name, static_cast<std::uint32_t>(result.triangles.size()),
                                     component.triangleCount, component.deflection});
        const auto first = mesh.triangles.begin() + component.firstTriangle;
        result.triangles.insert(result.triangles.end(), first, first + component.triangleCount);
    }
    result.vertices = takeUsedVertices(mesh.vertices, result.triangles);
    return result;
}

double deflectionOf(const Mesh& mesh) {
    double largest = 0;
    for (const Component& component : mesh.components) largest = std::max(largest, component.deflection);
    return largest;
}

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
        // Skip a number that makes a name the file itself uses elsewhere, so that the other component keeps
        // its name.
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
