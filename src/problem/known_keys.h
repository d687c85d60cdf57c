// The sections and keys of problem files, and what becomes of others.
#pragma once

#include <string>

#include "clearway/problem.h"
#include "problem/config.h"

namespace clearway {

/// Judges keys that nothing has read. In a file with a section [clearway] they are errors, because such a file may
/// mean them to decide something. OMPL.app ignores keys that it does not know, so in its files they are only warned of.
void judgeUnread(const std::string& file, bool isClearways, const ConfigValues& values, Problem& problem);

/// Judges sections of other names. One that is nearly a known name is an error in any file: all of its keys would be
/// lost.
void judgeSections(const std::string& file, const ConfigFile& config, Problem& problem);

}  // namespace clearway
