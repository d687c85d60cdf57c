// Labels files and components uniquely, and looks names up among them.
#include "model/obstacle_names.h"

#include <fnmatch.h>

#include <algorithm>
#include <boost/algorithm/string/classification.hpp>
#include <boost/algorithm/string/predicate.hpp>
#include <boost/algorithm/string/replace.hpp>
#include <boost/algorithm/string/split.hpp>
#include <filesystem>
#include <map>
#include <set>

#include "clearway/errors.h"
#include "core/text.h"
#include "mesh/components.h"

namespace clearway {
namespace {

using Path = std::filesystem::path;

constexpr std::size_t kMostNear = 4;  ///< names that may have been meant, in a message

/// The last `depth` names of a path, with or without the file's ending.
std::string tailOf(const Path& path, int depth, bool hasEnding) {
    Path tail = hasEnding ? path.filename() : path.stem();
    Path folder = path.parent_path();
    for (int i = 1; i < depth && folder.has_relative_path(); ++i, folder = folder.parent_path()) {
        tail = folder.filename() / tail;
    }
    return tail.generic_string();
}

bool areDifferent(const std::vector<std::string>& names) {
    return std::set<std::string>(names.begin(), names.end()).size() == names.size();
}

/// Labels that distinguish files whose names agree except for their endings: the endings, or the ends of
/// their paths.
std::vector<std::string> labelsOf(const std::vector<Path>& files) {
    const auto tails = [&](int depth, bool hasEnding) {
        std::vector<std::string> all;
        for (const Path& file : files) all.push_back(tailOf(file, depth, hasEnding));
        return all;
    };
    if (files.size() == 1) return tails(1, false);
    if (areDifferent(tails(1, true))) return tails(1, true);
    std::ptrdiff_t deepest = 2;
    for (const Path& file : files) deepest = std::max(deepest, std::distance(file.begin(), file.end()));
    for (int depth = 2; depth < deepest; ++depth) {
        if (areDifferent(tails(depth, false))) return tails(depth, false);
    }
    return tails(static_cast<int>(deepest), true);
}

/// The name, with #2, #3, ... appended if it is taken.
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

std::string listed(const std::vector<std::string>& names, std::size_t most) {
    std::vector<std::string> quoted;
    for (const std::string& name : names) {
        if (quoted.size() == most) break;
        quoted.push_back("'" + name + "'");
    }
    const std::size_t others = names.size() - quoted.size();
    return joined(quoted) + (others == 0 ? "" : " and " + std::to_string(others) + " more");
}

ObstacleNames::ObstacleNames(const std::vector<Mesh>& files) {
    for (const Mesh& file : files) {
        const std::string& name = file.origin.file;
        std::error_code isGone;  // the current folder: the name is then taken as it is
        const Path absolute = std::filesystem::absolute(name, isGone);
        files_.push_back(name.empty() ? Path() : (isGone ? Path(name) : absolute).lexically_normal());
    }
    labelFiles();
    std::set<std::string> taken;
    for (std::size_t f = 0; f < files.size(); ++f) {
        const std::string stem = files_[f].empty() ? "obstacle" : files_[f].stem().string();
        for (const clearway::Component& component : componentsOf(files[f])) {
            const std::string bare = component.name.empty() ? stem : component.name;
            const std::string ofOne = files.size() == 1 ? bare : labels_[f] + "/" + bare;
            components_.push_back({unique(taken, bare == stem ? labels_[f] : ofOne), bare, f});
        }
    }
}

void ObstacleNames::labelFiles() {
    std::map<std::string, std::vector<std::size_t>> namesakes;
    for (std::size_t f = 0; f < files_.size(); ++f) namesakes[files_[f].stem().string()].push_back(f);
    labels_.assign(files_.size(), "obstacle");
    for (const auto& [stem, members] : namesakes) {
        if (stem.empty()) continue;
        std::vector<Path> paths;
        for (const std::size_t f : members) paths.push_back(files_[f]);
        const std::vector<std::string> labels = labelsOf(paths);
        for (std::size_t i = 0; i < members.size(); ++i) labels_[members[i]] = labels[i];
    }
}

std::vector<std::size_t> ObstacleNames::filesCalled(const std::string& name) const {
    const auto depth = static_cast<int>(std::count(name.begin(), name.end(), '/')) + 1;
    std::vector<std::size_t> found;
    for (std::size_t f = 0; f < files_.size(); ++f) {
        if (files_[f].empty()) continue;
        if (tailOf(files_[f], depth, false) == name || tailOf(files_[f], depth, true) == name) {
            found.push_back(f);
        }
    }
    return found;
}

std::string ObstacleNames::insteadOf(const std::string& rule, const std::string& name) const {
    std::vector<std::string> pieces;
    boost::split(pieces, name, boost::is_any_of(","));
    const auto isName = [&](const std::string& piece) {
        return std::any_of(components_.begin(), components_.end(),
                           [&](const Component& component) { return component.bare == piece; });
    };
    if (rule == "--part" && pieces.size() > 1 && std::all_of(pieces.begin(), pieces.end(), isName))
        return " (for several parts repeat " + rule + ")";
    std::vector<std::string> same, near;
    for (const Component& component : components_) {
        const std::vector<std::string> both = {component.name, component.bare};
        if (boost::iequals(component.bare, name)) same.push_back(component.name);
        if (boost::icontains(component.name, name) || !didYouMean(name, both).empty())
            near.push_back(component.name);
    }
    const std::vector<std::string>& meant = same.empty() ? near : same;
    return meant.empty() ? "" : " (did you mean " + listed(meant, kMostNear) + "?)";
}

std::vector<std::size_t> ObstacleNames::find(const std::string& rule, const std::string& name) const {
    std::vector<std::size_t> found =
        where(components_, [&](const Component& component) { return component.name == name; });
    if (!found.empty()) return found;
    found = where(components_, [&](const Component& component) {
        const bool isFolder = files_.size() > 1 && name.size() < labels_[component.file].size();
        return !isFolder && component.name.compare(0, name.size() + 1, name + "/") == 0;
    });
    const std::vector<std::size_t> called = filesCalled(name);
    if (found.empty() && called.size() == 1) {
        found = where(components_, [&](const Component& component) { return component.file == called[0]; });
    }
    if (!found.empty()) return found;
    if (called.size() > 1) {
        std::vector<std::string> labels;
        for (const std::size_t f : called) labels.push_back(labels_[f]);
        throw ArgumentError(rule + " names '" + name +
                            "', which is the name of several files, expected one of " + listed(labels));
    }
    if (name.find_first_of("*?") != std::string::npos) {
        const std::string pattern =
            boost::replace_all_copy(name, "[", "[[]");  // brackets stand for themselves
        const auto matches = [&](const std::string& text) {
            return fnmatch(pattern.c_str(), text.c_str(), FNM_NOESCAPE) == 0;
        };
        found = where(components_, [&](const Component& component) {
            return matches(component.name) || matches(component.bare);
        });
        if (!found.empty()) return found;
    }
    found = where(components_, [&](const Component& component) { return component.bare == name; });
    if (found.size() == 1) return found;
    const bool isPart = rule == "part" || rule == "--part";
    std::vector<std::string> names;
    for (std::size_t i = 0; i < components_.size(); ++i) {
        if (found.empty() || std::count(found.begin(), found.end(), i) > 0) {
            names.push_back(components_[i].name);
        }
    }
    throw ArgumentError(rule + " names '" + name + "', " +
                        (found.empty()
                             ? (isPart ? "which is no part" : "which is no obstacle") + insteadOf(rule, name)
                             : std::string("which is in several files")) +
                        ", expected one of " + listed(names));
}

}  // namespace clearway
