// Help beyond the subcommands' own: topics, versions, and completion of words in a shell.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace clearway::cli {

std::vector<std::string> topicNames();
const char* topicNamed(const std::string& name);  ///< null without such a topic

/// Names and versions of the libraries that the program uses.
std::vector<std::pair<std::string, std::string>> libraryVersions();

/// For bash: completes subcommands, their options, and files.
std::string completionScript(const std::vector<std::string>& subcommands);

}  // namespace clearway::cli
