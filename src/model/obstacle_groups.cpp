// Applies the rules to the components, groups those that count alike, and builds the scene.
#include "clearway/obstacle_groups.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <tuple>

#include "clearway/errors.h"
#include "core/number.h"
#include "core/text.h"
#include "mesh/check.h"
#include "mesh/components.h"
#include "model/obstacle_names.h"
#include "model/solids.h"

namespace clearway {
namespace {

/// How one component counts by the rules.
struct Treatment {
    double margin = 0, overlap = 0;
    bool isSolid = false, isIgnoredAtStart = false, isIgnoredAtGoal = false, isIgnored = false;
    std::size_t apart = 0;  ///< a number of its own for a component that shares its group with no other one

    auto key() const {
        return std::make_tuple(margin, overlap, isSolid, isIgnoredAtStart, isIgnoredAtGoal, apart);
    }
};

class Rules {
  public:
    Rules(const ObstacleNames& names, double margin, double overlap) : names_(names) {
        requireNotNegative("margin", margin);
        requireNotNegative("overlap", overlap);
        Treatment usual;
        usual.margin = margin;
        usual.overlap = overlap;
        treatments_.assign(names.components().size(), usual);
    }

    void apply(const ObstacleRules& rules) {
        setLengths("margin", rules.margins, &Treatment::margin);
        setLengths("overlap", rules.overlap.byName, &Treatment::overlap);
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
        requireOneLength();
    }

    const std::vector<Treatment>& treatments() const { return treatments_; }

  private:
    void set(const std::string& rule, const std::vector<std::string>& names, bool Treatment::*flag) {
        for (const std::string& name : names) {
            for (const std::size_t i : names_.find(rule, name)) treatments_[i].*flag = true;
        }
    }

    /// rule: "margin" or "overlap", of which the lengths are.
    void setLengths(const std::string& rule, const std::map<std::string, double>& lengths,
                    double Treatment::*which) {
        struct Length {
            std::size_t count;  ///< of components that the name stands for
            const std::string* name;
            double length;
        };
        std::vector<std::optional<Length>> found(treatments_.size());
        for (const auto& [name, length] : lengths) {
            const std::string key = rule + "." + name;
            requireNotNegative(key, length);
            const std::vector<std::size_t> members = names_.find(key, name);
            for (const std::size_t i : members) {
                if (found[i] && found[i]->count == members.size() && found[i]->length != length) {
                    throw ArgumentError("the " + rule + " of '" + names_.components()[i].name + "' is " +
                                        shortNumber(found[i]->length) + " by " + rule + "." +
                                        *found[i]->name + " and " + shortNumber(length) + " by " + key +
                                        ", expected one");
                }
                if (found[i] && found[i]->count < members.size()) continue;
                found[i] = Length{members.size(), &name, length};
                treatments_[i].*which = length;
            }
        }
    }

    void requireOneLength() const {
        for (std::size_t i = 0; i < treatments_.size(); ++i) {
            const Treatment& treatment = treatments_[i];
            if (treatment.isIgnored || !(treatment.margin > 0) || !(treatment.overlap > 0)) continue;
            throw ArgumentError("the obstacle '" + names_.components()[i].name + "' has the margin " +
                                shortNumber(treatment.margin) + " and the overlap " +
                                shortNumber(treatment.overlap) + ", expected at least one of them to be 0");
        }
    }

    const ObstacleNames& names_;
    std::vector<Treatment> treatments_;
};

/// Makes the solids of a group. For an overlap open components are fine: they hold nothing.
void makeSolid(ObstacleGroup& group, bool isRule, std::vector<std::string>& notes) {
    const MadeSolids made = makeSolids(group.mesh);
    if (isRule && !made.refusals.empty()) {
        const std::size_t others = made.refusals.size() - 1;
        throw ArgumentError(
            "solid: " + made.refusals[0] +
            (others == 0 ? "" : "; " + std::to_string(others) + " more of the solids enclose nothing"));
    }
    group.solids = made.solids;
    for (const std::string& name : made.turnedOver) {
        notes.push_back("the solid '" + name + "' faces inwards: it is turned over");
    }
}

std::shared_ptr<const ShrunkModel> shrunkBy(double overlap,
                                            const std::vector<std::shared_ptr<const ShrunkModel>>& shrunk) {
    for (const auto& model : shrunk) {
        if (model->overlap == overlap) return model;
    }
    throw ArgumentError("no shrunk part for the overlap " + shortNumber(overlap) + ", expected one for each");
}

/// The first triangle of each component in its own file.
std::vector<std::uint32_t> firstTrianglesOf(const std::vector<Mesh>& files) {
    std::vector<std::uint32_t> first;
    for (const Mesh& file : files) {
        for (const Component& component : componentsOf(file)) first.push_back(component.firstTriangle);
    }
    return first;
}

/// The sums of what the files' origins count, their lines, and the unit and axis that all of them state.
MeshOrigin joinedOrigin(const std::vector<Mesh>& files) {
    MeshOrigin all;
    all.unitMetres = files.front().origin.unitMetres;
    all.upAxis = files.front().origin.upAxis;
    std::vector<std::string> names, formats;
    for (const Mesh& file : files) {
        const MeshOrigin& one = file.origin;
        names.push_back(one.file);
        if (std::find(formats.begin(), formats.end(), one.format) == formats.end())
            formats.push_back(one.format);
        all.isChecked = all.isChecked && one.isChecked;
        if (all.unitMetres != one.unitMetres) all.unitMetres = 0;
        if (all.upAxis != one.upAxis) all.upAxis = 0;
        all.ignoredFaces += one.ignoredFaces;
        all.crossingFaces += one.crossingFaces;
        all.bentFaces += one.bentFaces;
        all.bentBy = std::max(all.bentBy, one.bentBy);
        all.deflection = std::max(all.deflection, one.deflection * one.scale);
        all.warnings.insert(all.warnings.end(), one.warnings.begin(), one.warnings.end());
        for (const std::string& note : one.notes) all.notes.push_back(one.file + ": " + note);
    }
    all.file = joined(names);
    all.format = joined(formats);
    return all;
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
    }
    all.origin = joinedOrigin(files);
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

std::vector<double> ObstacleGroups::overlaps() const {
    std::set<double> found;
    for (const ObstacleGroup& group : groups) {
        if (group.overlap > 0) found.insert(group.overlap);
    }
    return {found.begin(), found.end()};
}

Box ObstacleGroups::environmentBox() const {
    Box box = ignoredBox;
    for (const ObstacleGroup& group : groups) box.extend(boundingBox(group.mesh));
    return box;
}

ObstacleGroups groupObstacles(const std::vector<Mesh>& files, double margin, const ObstacleRules& rules) {
    for (const Mesh& file : files) requireComponents(file);  // a triangle outside of them would be lost
    const ObstacleNames names(files);
    Rules applied(names, margin, rules.overlap.common);
    applied.apply(rules);
    const Mesh all = joinedEnvironment(files);
    const std::vector<std::uint32_t> fileTriangles = firstTrianglesOf(files);
    std::map<decltype(Treatment().key()), std::vector<std::size_t>> members;
    std::vector<std::size_t> ignored;
    ObstacleGroups result;
    const std::vector<Component> components = componentsOf(all);
    for (std::size_t i = 0; i < components.size(); ++i) {
        if (components[i].triangleCount == 0) continue;  // it moves, as the part or with it
        const Treatment& treatment = applied.treatments()[i];
        if (treatment.isIgnored) result.ignored.push_back(names.components()[i].name);
        (treatment.isIgnored ? ignored : members[treatment.key()]).push_back(i);
    }
    if (!ignored.empty()) result.ignoredBox = boundingBox(meshOfComponents(all, ignored));
    for (const auto& [key, alike] : members) {
        ObstacleGroup group;
        bool isSolid = false;
        std::tie(group.margin, group.overlap, isSolid, group.isIgnoredAtStart, group.isIgnoredAtGoal,
                 std::ignore) = key;
        group.mesh = alike.size() == components.size() ? all : meshOfComponents(all, alike);
        for (const std::size_t i : alike) group.fileTriangles.push_back(fileTriangles[i]);
        if (isSolid || group.overlap > 0) makeSolid(group, isSolid, result.notes);
        result.groups.push_back(std::move(group));
    }
    return result;
}

Scene makeScene(Model part, std::shared_ptr<const Solids> partSolids, const ObstacleGroups& obstacles,
                const ObstacleRules& rules, const Pose& X_environmentStart, const Pose& X_environmentGoal,
                const std::function<Model(const Mesh&)>& build,
                const std::vector<std::shared_ptr<const ShrunkModel>>& shrunk) {
    Scene scene(std::move(part));
    scene.partSolids = std::move(partSolids);
    scene.ignoredBox = obstacles.ignoredBox;
    if (rules.startContact)
        scene.startContact = ContactZone{X_environmentStart, rules.startContact->distance};
    if (rules.goalContact) scene.goalContact = ContactZone{X_environmentGoal, rules.goalContact->distance};
    for (const ObstacleGroup& group : obstacles.groups) {
        Obstacle obstacle(build(group.mesh), group.margin);
        obstacle.fileTriangles = group.fileTriangles;
        obstacle.solids = group.solids;
        obstacle.isIgnoredAtStart = group.isIgnoredAtStart;
        obstacle.isIgnoredAtGoal = group.isIgnoredAtGoal;
        obstacle.shrunkBy = group.shrunkBy;
        if (group.overlap > group.shrunkBy) obstacle.shrunk = shrunkBy(group.overlap, shrunk);
        scene.obstacles.push_back(std::move(obstacle));
    }
    return scene;
}

}  // namespace clearway
