// What differs between the versions of OMPL that this is built with, 1.5.2 to 2.0: all of it is here.
#pragma once

#include <ompl/config.h>
#include <ompl/geometric/PathSimplifier.h>

#include <string>

#if OMPL_VERSION_VALUE < 1005000
#error "clearway needs OMPL 1.5 or later"
#endif

namespace clearway::planning {

/// "1.5.2". OMPL_VERSION is an empty text in Debian 12.
inline std::string omplVersion() {
    return std::to_string(OMPL_MAJOR_VERSION) + "." + std::to_string(OMPL_MINOR_VERSION) + "." +
           std::to_string(OMPL_PATCH_VERSION);
}

/// Short cuts between random points of the path. OMPL calls it by another name from 1.7 on.
inline void shortcutPath(ompl::geometric::PathSimplifier& simplifier, ompl::geometric::PathGeometric& path,
                         unsigned int mostSteps, unsigned int mostEmptySteps) {
#if OMPL_VERSION_VALUE >= 1007000
    simplifier.partialShortcutPath(path, mostSteps, mostEmptySteps);
#else
    simplifier.shortcutPath(path, mostSteps, mostEmptySteps);
#endif
}

}  // namespace clearway::planning
