// Which components of an environment a name stands for: see clearway/obstacle_rules.h.
#pragma once

#include <cstddef>
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
    std::vector<std::size_t> ofFile(const std::string& name) const;

    std::vector<std::string> files_;  ///< names without folders
    std::vector<Component> components_;
};

/// "'a', 'b' and 7 more".
std::string listed(const std::vector<std::string>& names);

}  // namespace clearway
