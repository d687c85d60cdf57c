// Applies the rules to the components, groups those that count alike, and builds the scene.
#include "clearway/obstacle_groups.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <stdexcept>
#include <tuple>

#include "core/number.h"
#include "mesh/components.h"
#include "model/obstacle_names.h"
#include "model/solids.h"

namespace clearway {
namespace {

/// How one component counts by the rules.
struct Treatment {
    double margin = 0;
    bool isSolid = false, isIgnoredAtStart = false, isIgnoredAtGoal = false, isIgnored = false;
    std::size_t apart = 0;  ///< a number of its own for a component that shares its group with no other one

    auto key() const { return std::make_tuple(margin, isSolid, isIgnoredAtStart, isIgnoredAtGoal, apart); }
};

void requireMargin(const std::string& rule, double margin) {
    if (margin >= 0 && std::isfinite(margin)) return;
    throw std::invalid_argument(rule + " is " + shortNumber(margin) + ", expected a finite number >= 0");
}

class Rules {
  public:
    Rules(const ObstacleNames& names, double margin) : names_(names) {
        requireMargin("margin", margin);
        Treatment usual;
        usual.margin = margin;
        treatments_.assign(names.components().size(), usual);
    }

    void apply(const ObstacleRules& rules) {
        setMargins(rules.margins);
        set("ignore", rules.ignored, &Treatment::isIgnored);
        set("solid", rules.solid, &Treatment::isSolid);
        for (Treatment& treatment : treatments_) treatment.isSolid = treatment.isSolid || rules.isAllSolid;
        if (rules.startContact) {
            set("contact.start", rules.startContact->names, &Treatment::isIgnoredAtStart);
        }
        if (rules.goalContact) set("contact.goal", rules.goalContact->names, &Treatment::isIgnoredAtGoal);
        for (const std::string& name : rules.apart) {
            for (const std::size_t i : names_.find("apart", name)) treatments_[i].apart = i + 1;
        }
    }

    const std::vector<Treatment>& treatments() const { return treatments_; }

  private:
    void set(const std::string& rule, const std::vector<std::string>& names, bool Treatment::*flag) {
        for (const std::string& name : names) {
            for (const std::size_t i : names_.find(rule, name)) treatments_[i].*flag = true;
        }
    }

    void setMargins(const std::map<std::string, double>& margins) {
        struct Margin {
            std::size_t count;  ///< of components that the name stands for
            const std::string* name;
            double margin;
        };
        std::vector<std::optional<Margin>> found(treatments_.size());
        for (const auto& [name, margin] : margins) {
            requireMargin("margin." + name, margin);
            const std::vector<std::size_t> members = names_.find("margin." + name, name);
            for (const std::size_t i : members) {
                if (found[i] && found[i]->count == members.size() && found[i]->margin != margin) {
                    throw std::invalid_argument("the margin of '" + names_.components()[i].name + "' is " +
                                                shortNumber(found[i]->margin) + " by margin." +
                                                *found[i]->name + " and " + shortNumber(margin) +
                                                " by margin." + name + ", expected one");
                }
                if (found[i] && found[i]->count < members.size()) continue;
                found[i] = Margin{members.size(), &name, margin};
                treatments_[i].margin = margin;
            }
        }
    }

    const ObstacleNames& names_;
    std::vector<Treatment> treatments_;
};

void makeSolid(ObstacleGroup& group, std::vector<std::string>& notes) {
    const MadeSolids made = makeSolids(group.mesh);
    if (!made.refusals.empty()) {
        const std::size_t others = made.refusals.size() - 1;
        throw std::invalid_argument(
            "solid: " + made.refusals[0] +
            (others == 0 ? "" : "; " + std::to_string(others) + " more of the solids enclose nothing"));
    }
    group.solids = made.solids;
    for (const std::string& name : made.turnedOver) {
        notes.push_back("the solid '" + name + "' faces inwards: it is turned over");
    }
}

/// The first triangle of each component in its own file.
std::vector<std::uint32_t> firstTrianglesOf(const std::vector<Mesh>& files) {
    std::vector<std::uint32_t> first;
    for (const Mesh& file : files) {
        for (const Component& component : componentsOf(file)) first.push_back(component.firstTriangle);
    }
    return first;
}

}  // namespace

Mesh joinedEnvironment(const std::vector<Mesh>& files) {
    if (files.size() == 1) return files[0];
    const ObstacleNames names(files);
    Mesh all;
    for (const Mesh& file : files) {
        const auto firstVertex = static_cast<std::uint32_t>(all.vertices.size());
        const auto firstTriangle = static_cast<std::uint32_t>(all.triangles.size());
        all.vertices.insert(all.vertices.end(), file.vertices.begin(), file.vertices.end());
        for (TriangleIndices triangle : file.triangles) {
            for (std::uint32_t& vertex : triangle) vertex += firstVertex;
            all.triangles.push_back(triangle);
        }
        for (Component component : componentsOf(file)) {
            component.name = names.components()[all.components.size()].name;
            component.firstTriangle += firstTriangle;
            all.components.push_back(component);
        }
        all.origin.file += (all.origin.file.empty() ? "" : ", ") + file.origin.file;
        all.origin.ignoredFaces += file.origin.ignoredFaces;
        for (const std::string& note : file.origin.notes) {
            all.origin.notes.push_back(file.origin.file + ": " + note);
        }
    }
    return all;
}

double ObstacleGroups::largestMargin() const {
    double largest = 0;
    for (const ObstacleGroup& group : groups) largest = std::max(largest, group.margin);
    return largest;
}

bool ObstacleGroups::hasSolids() const {
    return std::any_of(groups.begin(), groups.end(),
                       [](const ObstacleGroup& group) { return group.solids != nullptr; });
}

Box ObstacleGroups::environmentBox() const {
    Box box = ignoredBox;
    for (const ObstacleGroup& group : groups) box.extend(boundingBox(group.mesh));
    return box;
}

ObstacleGroups groupObstacles(const std::vector<Mesh>& files, double margin, const ObstacleRules& rules) {
    const ObstacleNames names(files);
    Rules applied(names, margin);
    applied.apply(rules);
    const Mesh all = joinedEnvironment(files);
    const std::vector<std::uint32_t> fileTriangles = firstTrianglesOf(files);
    std::map<decltype(Treatment().key()), std::vector<std::size_t>> members;
    std::vector<std::size_t> ignored;
    ObstacleGroups result;
    for (std::size_t i = 0; i < applied.treatments().size(); ++i) {
        const Treatment& treatment = applied.treatments()[i];
        if (treatment.isIgnored) result.ignored.push_back(names.components()[i].name);
        (treatment.isIgnored ? ignored : members[treatment.key()]).push_back(i);
    }
    if (!ignored.empty()) result.ignoredBox = boundingBox(meshOfComponents(all, ignored));
    for (const auto& [key, components] : members) {
        ObstacleGroup group;
        bool isSolid = false;
        std::tie(group.margin, isSolid, group.isIgnoredAtStart, group.isIgnoredAtGoal, std::ignore) = key;
        const bool isAll = components.size() == applied.treatments().size();
        group.mesh = isAll ? all : meshOfComponents(all, components);
        if (group.mesh.triangles.empty()) continue;
        for (const std::size_t i : components) group.fileTriangles.push_back(fileTriangles[i]);
        if (isSolid) makeSolid(group, result.notes);
        result.groups.push_back(std::move(group));
    }
    return result;
}

Scene makeScene(Model part, std::shared_ptr<const Solids> partSolids, const ObstacleGroups& obstacles,
                const ObstacleRules& rules, const Pose& X_environmentStart, const Pose& X_environmentGoal,
                const std::function<Model(const Mesh&)>& build) {
    Scene scene(std::move(part));
    scene.partSolids = std::move(partSolids);
    scene.ignoredBox = obstacles.ignoredBox;
    if (rules.startContact)
        scene.startContact = ContactZone{X_environmentStart, rules.startContact->distance};
    if (rules.goalContact) scene.goalContact = ContactZone{X_environmentGoal, rules.goalContact->distance};
    for (const ObstacleGroup& group : obstacles.groups) {
        scene.obstacles.push_back({build(group.mesh), group.margin, group.fileTriangles, group.solids,
                                   group.isIgnoredAtStart, group.isIgnoredAtGoal});
    }
    return scene;
}

}  // namespace clearway
