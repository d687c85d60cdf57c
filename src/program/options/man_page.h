// Pages for man, as `clearway --man` and `clearway SUBCOMMAND --man` print them.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace clearway::cli {

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
