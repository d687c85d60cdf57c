// What the subcommands share in reading their arguments: long options, positional arguments, --help, strict
// numbers.
#pragma once

#include <boost/program_options/options_description.hpp>
#include <boost/program_options/variables_map.hpp>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "program/cli/subcommands.h"

namespace clearway::cli {

/// What a subcommand takes. Options that carry a value are declared as strings (optionValue) and read as
/// numbers through Options, so that every wrong number is refused in the same words.
struct CommandLine {
    std::string usage;    ///< "clearway info MESH [options]"
    std::string purpose;  ///< printed under the usage by --help
    /// Names of the positional arguments; the last ones may be left out when they stand in brackets:
    /// "[IN.path]"; the last one takes all that follow when it ends with dots: "[PROBLEM.cfg...]", read by
    /// Options::texts.
    std::vector<std::string> positional;
    boost::program_options::options_description options{"Options", 110};
};

/// A string value that --help shows under the given name: ("seed", optionValue("N"), "...").
boost::program_options::typed_value<std::string>* optionValue(const char* shownAs);

/// The same for an option that may be given several times, to be read by Options::texts.
boost::program_options::typed_value<std::vector<std::string>>* optionValues(const char* shownAs);

/// The arguments as given. Every getter throws std::invalid_argument, naming the option, its value and what
/// was expected, when the value is wrong, and naming the option when it was not given.
class Options {
  public:
    Options(boost::program_options::variables_map values, std::string usage)
        : values_(std::move(values)), usage_(std::move(usage)) {}

    bool has(const std::string& name) const { return values_.count(name) > 0; }
    /// A positional argument or the value of an option. Never empty.
    std::string text(const std::string& name) const;
    /// All values of an option declared with optionValues, in order; empty when it was not given.
    std::vector<std::string> texts(const std::string& name) const;
    /// Throws when the file the option wants written is one of those to be read, by whatever path.
    void requireOtherFile(const std::string& name, const std::vector<std::string>& inputs) const;
    std::int64_t integer(const std::string& name, std::int64_t least, std::int64_t most) const;
    double positive(const std::string& name) const;     ///< finite, > 0
    double nonNegative(const std::string& name) const;  ///< finite, >= 0

  private:
    double number(const std::string& name, const char* expected) const;
    [[noreturn]] void refuse(const std::string& name, const char* expected) const;
    boost::program_options::variables_map values_;
    std::string usage_;
};

/// The options given, or nothing when --help was among them and the help has been printed.
/// Throws std::invalid_argument for an unknown or repeated option, a missing value, and too few or too many
/// positional arguments.
std::optional<Options> parse(const CommandLine& commandLine, const Arguments& arguments);

}  // namespace clearway::cli
