// Finds the components of an environment that a name stands for, by the rules in clearway/obstacle_rules.h.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "clearway/mesh.h"

namespace clearway {

class ObstacleNames {
  public:
    explicit ObstacleNames(const std::vector<Mesh>& files);

    struct Component {
        std::string name;  ///< unique
        std::string bare;  ///< the name within its file
        std::size_t file = 0;
    };
    const std::vector<Component>& components() const { return components_; }

    /// The components that a name stands for, in order. rule: the rule that has the name, such as "ignore",
    /// for messages. Throws ArgumentError when the name stands for no component, suggests the nearest ones, and lists the names;
    /// or when it is ambiguous, and lists the possible ones.
    std::vector<std::size_t> find(const std::string& rule, const std::string& name) const;

  private:
    void labelFiles();

    /// Says which names may have been meant by one that stands for nothing: " (did you mean 'bolt'?)", or nothing.
    std::string insteadOf(const std::string& rule, const std::string& name) const;

    /// The files whose path ends with the name, with or without the file's ending.
    std::vector<std::size_t> filesCalled(const std::string& name) const;

    std::vector<std::filesystem::path> files_;  ///< an empty path for a mesh without a file
    std::vector<std::string> labels_;           ///< one for each mesh; unique among the meshes with files
    std::vector<Component> components_;
};

/// The names in quotes, and how many there are beyond the most that are shown: "'a', 'b' and 7 more".
std::string listed(const std::vector<std::string>& names, std::size_t most = 30);

}  // namespace clearway
