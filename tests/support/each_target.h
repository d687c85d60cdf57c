// Boost.Test datasets over the instruction sets and the strategies, read from the tables themselves: a new
// row is tested without a change here.
#pragma once

#include <boost/test/data/monomorphic.hpp>
#include <boost/test/data/test_case.hpp>
#include <ostream>
#include <string>
#include <vector>

#include "clearway/build_options.h"
#include "clearway/targets.h"

namespace clearway::testing {

/// Build options that can print themselves.
struct BuildChoice : BuildOptions {
    friend std::ostream& operator<<(std::ostream& out, const BuildChoice& choice) {
        return out << choice.generalSplit << '/' << choice.leafSplit << "/leaf " << choice.leafSize
                   << "/width " << choice.nodeWidth;
    }
};

inline BuildChoice buildChoice(const std::string& generalSplit, const std::string& leafSplit, int leafSize,
                               int nodeWidth) {
    BuildChoice choice;
    choice.generalSplit = generalSplit;
    choice.leafSplit = leafSplit;
    choice.leafSize = leafSize;
    choice.nodeWidth = nodeWidth;
    return choice;
}

/// Every general split with every leaf split and node width, with leaves of up to 4 triangles; and each width
/// with leaves of 1, 8 and 16.
inline std::vector<BuildChoice> everyBuild() {
    std::vector<BuildChoice> choices;
    for (const int width : nodeWidths()) {
        for (const std::string& general : generalSplitNames()) {
            for (const std::string& leaf : leafSplitNames())
                choices.push_back(buildChoice(general, leaf, 4, width));
        }
        for (const int size : {1, 8, 16}) choices.push_back(buildChoice("axis", "none", size, width));
    }
    return choices;
}

/// Use: BOOST_DATA_TEST_CASE(name, eachTarget() * eachBuild(), target, build).
inline auto eachBuild() {
    return boost::unit_test::data::make(everyBuild());
}
inline auto eachTarget() {
    return boost::unit_test::data::make(availableTargets());
}
inline auto eachWidth() {
    return boost::unit_test::data::make(nodeWidths());
}

/// Makes queries run on the named instruction set while this object lives.
class UsingTarget {
  public:
    explicit UsingTarget(const std::string& name) { useTarget(name); }
    ~UsingTarget() { useTarget("best"); }
    UsingTarget(const UsingTarget&) = delete;
    UsingTarget& operator=(const UsingTarget&) = delete;
};

}  // namespace clearway::testing
