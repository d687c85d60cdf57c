// Help beyond the subcommands' own: topics, versions, completion of words in a shell, and pages for man.
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

/// A page for man, as `clearway --man` and `clearway SUBCOMMAND --man` print it.
struct ManPage {
    std::string name;                                       ///< "clearway-plan"
    std::string usage;                                      ///< "clearway plan PROBLEM.cfg [options]"
    std::string purpose;                                    ///< its first sentence stands beside the name
    std::string heading;                                    ///< of the rows: "OPTIONS"
    std::vector<std::pair<std::string, std::string>> rows;  ///< words to type, and what they do
};

/// Prints the page to standard output, in the macros of man(7).
void printManPage(const ManPage& page);

}  // namespace clearway::cli
