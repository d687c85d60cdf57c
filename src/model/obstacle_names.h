// Which components of an environment a name stands for: see clearway/obstacle_rules.h.
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
        std::string name;  ///< unlike any other's
        std::string bare;  ///< within its file
        std::size_t file = 0;
    };
    const std::vector<Component>& components() const { return components_; }

    /// The components a rule's name stands for, in order. rule: "ignore", say. Throws std::invalid_argument
    /// that lists the names there are, when it stands for none, or those it may mean.
    std::vector<std::size_t> find(const std::string& rule, const std::string& name) const;

  private:
    void labelFiles();

    /// By the end of its path, with or without its ending.
    std::vector<std::size_t> filesCalled(const std::string& name) const;

    std::vector<std::filesystem::path> files_;  ///< empty: a mesh that is of none
    std::vector<std::string> labels_;           ///< unlike each other's, of those of files
    std::vector<Component> components_;
};

/// "'a', 'b' and 7 more".
std::string listed(const std::vector<std::string>& names);

}  // namespace clearway
