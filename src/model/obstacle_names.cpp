#include "model/obstacle_names.h"

#include <algorithm>
#include <filesystem>
#include <set>
#include <stdexcept>

#include "mesh/component_mesh.h"

namespace clearway {
namespace {

constexpr std::size_t kMostListed = 30;

std::string stemOf(const std::string& file) {
    return std::filesystem::path(file).stem().string();
}

std::string unique(std::set<std::string>& taken, const std::string& name) {
    std::string tried = name;
    for (int i = 2; !taken.insert(tried).second; ++i) tried = name + "#" + std::to_string(i);
    return tried;
}

template <class Is>
std::vector<std::size_t> where(const std::vector<ObstacleNames::Component>& components, const Is& is) {
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < components.size(); ++i) {
        if (is(components[i])) found.push_back(i);
    }
    return found;
}

}  // namespace

std::string listed(const std::vector<std::string>& names) {
    std::string all;
    for (std::size_t i = 0; i < std::min(names.size(), kMostListed); ++i) {
        all += (i == 0 ? "'" : ", '") + names[i] + "'";
    }
    if (names.size() > kMostListed) all += " and " + std::to_string(names.size() - kMostListed) + " more";
    return all;
}

ObstacleNames::ObstacleNames(const std::vector<Mesh>& files) {
    std::set<std::string> taken;
    for (std::size_t f = 0; f < files.size(); ++f) {
        files_.push_back(std::filesystem::path(files[f].origin.file).filename().string());
        const std::string stem = files_[f].empty() ? "obstacle" : stemOf(files_[f]);
        for (const clearway::Component& component : componentsOf(files[f])) {
            const std::string bare = component.name.empty() ? stem : component.name;
            const std::string full = files.size() == 1 || bare == stem ? bare : stem + "/" + bare;
            components_.push_back({unique(taken, full), bare, f});
        }
    }
}

std::vector<std::size_t> ObstacleNames::ofFile(const std::string& name) const {
    return where(components_, [&](const Component& component) {
        const std::string& file = files_[component.file];
        return file == name || (!file.empty() && stemOf(file) == name);
    });
}

std::vector<std::size_t> ObstacleNames::find(const std::string& rule, const std::string& name) const {
    std::vector<std::size_t> found =
        where(components_, [&](const Component& component) { return component.name == name; });
    if (!found.empty()) return found;
    found = where(components_, [&](const Component& component) {
        return component.name.compare(0, name.size() + 1, name + "/") == 0;
    });
    if (found.empty()) found = ofFile(name);
    if (!found.empty()) return found;
    found = where(components_, [&](const Component& component) { return component.bare == name; });
    if (found.size() == 1) return found;
    std::vector<std::string> names;
    for (std::size_t i = 0; i < components_.size(); ++i) {
        if (found.empty() || std::count(found.begin(), found.end(), i) > 0) {
            names.push_back(components_[i].name);
        }
    }
    throw std::invalid_argument(rule + " names '" + name + "', " +
                                (found.empty() ? "which is no obstacle" : "which is in several files") +
                                ", expected one of " + listed(names));
}

}  // namespace clearway
