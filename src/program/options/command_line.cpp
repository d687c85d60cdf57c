#include "program/options/command_line.h"

#include <fmt/format.h>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <iostream>
#include <optional>
#include <sstream>
#include <stdexcept>

#include "core/number.h"
#include "core/text.h"
#include "program/options/help.h"

namespace clearway::cli {

namespace {

constexpr std::size_t kHelpColumn = 28, kHelpWidth = 110;

volatile std::sig_atomic_t interrupted = 0;

bool isFlag(const std::string& shown) {
    return shown.find(' ') == std::string::npos;
}

/// Prints one option: its declaration, and beside it the help, broken into lines.
void printOption(const std::string& shown, const std::string& help) {
    std::string line = "  " + shown;
    if (line.size() >= kHelpColumn) {
        std::cout << line << "\n";
        line.clear();
    }
    line.resize(kHelpColumn, ' ');
    std::istringstream words(help);
    for (std::string word; words >> word;) {
        if (line.size() + word.size() >= kHelpWidth) {
            std::cout << line << "\n";
            line.assign(kHelpColumn, ' ');
        }
        line += (line.size() > kHelpColumn ? " " : "") + word;
    }
    std::cout << line << "\n";
}

[[noreturn]] void refuseValue(const std::string& name, const std::string& value) {
    throw std::invalid_argument(name + " is '" + value + "', expected a value");
}

}  // namespace

void heedInterrupts() {
    struct sigaction action = {};
    action.sa_handler = [](int) { interrupted = 1; };
    action.sa_flags = static_cast<int>(SA_RESETHAND);
    sigaction(SIGINT, &action, nullptr);
    sigaction(SIGTERM, &action, nullptr);
}

bool isInterrupted() {
    return interrupted != 0;
}

double number(const std::string& text, const std::string& expected) {
    const std::optional<double> value = parseNumber(text);
    if (!value) throw Expected{expected};
    return *value;
}

double positiveNumber(const std::string& text) {
    const Expected expected{"a number above 0"};
    const double value = number(text, expected.what);
    if (!(value > 0)) throw expected;
    return value;
}

double nonNegativeNumber(const std::string& text) {
    const Expected expected{"a number of at least 0"};
    const double value = number(text, expected.what);
    if (!(value >= 0)) throw expected;
    return value;
}

std::int64_t integerFrom(const std::string& text, std::int64_t least, std::int64_t most) {
    const std::optional<std::int64_t> value = parseInteger(text);
    if (!value || *value < least || *value > most) {
        throw Expected{fmt::format("an integer from {} to {}", least, most)};
    }
    return *value;
}

std::string oneOf(const std::string& text, const std::vector<std::string>& names) {
    if (std::find(names.begin(), names.end(), text) == names.end())
        throw Expected{"one of " + joined(names) + didYouMean(text, names)};
    return text;
}

Reader to(std::string& text) {
    return [&text](const std::string& value) { text = value; };
}

Reader input(std::string& file) {
    return [&file](const std::string& value) { file = value == "-" ? "/dev/stdin" : value; };
}

Reader appendedTo(std::vector<std::string>& texts) {
    return [&texts](const std::string& value) { texts.push_back(value); };
}

Reader folder(std::string& to) {
    return [&to](const std::string& value) {
        std::error_code ignored;
        if (std::filesystem::exists(value, ignored) && !std::filesystem::is_directory(value, ignored)) {
            throw Expected{"a folder or a new name, not a file"};
        }
        to = value;
    };
}

CommandLine::CommandLine(std::string usage, std::string purpose)
    : usage_(std::move(usage)), purpose_(std::move(purpose)) {}

void CommandLine::argument(const std::string& name, Reader read) {
    const Count count = name[0] != '['                          ? Count::kRequired
                        : name.find("...") != std::string::npos ? Count::kRepeatable
                                                                : Count::kOptional;
    arguments_.push_back({name, name, "", std::move(read), count});
}

void CommandLine::option(const std::string& declaration, const std::string& help, Reader read, Count count) {
    options_.push_back(
        {declaration.substr(0, declaration.find(' ')), declaration, help, std::move(read), count});
}

bool CommandLine::parse(const Arguments& words) {
    const auto isHelp = [](const std::string& word) { return word == "--help" || word == "-h"; };
    if (std::any_of(words.begin(), words.end(), isHelp)) return printHelp(), false;
    if (words == Arguments{"--man"}) return printManPage(), false;
    if (words == Arguments{"--list-options"}) {
        for (const Declared& option : options_) std::cout << option.name << "\n";
        return false;
    }
    takeWords(words);
    requireCounts();
    for (const auto* all : {&arguments_, &options_}) {
        for (const Declared& declared : *all) {
            for (const std::string& value : declared.values) {
                try {
                    declared.read(value);
                } catch (const Expected& expected) {
                    throw std::invalid_argument(declared.name + " is '" + value + "', expected " +
                                                expected.what);
                }
            }
        }
    }
    return true;
}

void CommandLine::printHelp() const {
    std::cout << "Usage: " << usage_ << "\n\n" << purpose_ << "\n";
    if (!options_.empty()) std::cout << "\nOptions:\n";
    for (const Declared& option : options_) printOption(option.shown, option.help);
}

/// The usage begins with "clearway SUBCOMMAND", or with another program.
void CommandLine::printManPage() const {
    std::istringstream usage(usage_);
    std::string program, subcommand;
    usage >> program >> subcommand;
    if (program == "clearway") program += "-" + subcommand;
    ManPage page{program, usage_, purpose_, "OPTIONS", {}};
    for (const Declared& option : options_) page.rows.emplace_back(option.shown, option.help);
    cli::printManPage(page);
}

/// Tells options, their values and positional arguments apart. After the word -- all words are arguments.
void CommandLine::takeWords(const Arguments& words) {
    Arguments positional;
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (words[i] == "--") {
            positional.insert(positional.end(), words.begin() + std::ptrdiff_t(i) + 1, words.end());
            break;
        }
        if (words[i].compare(0, 2, "--") != 0) {
            positional.push_back(words[i]);
            continue;
        }
        const std::size_t equals = words[i].find('=');
        const auto option = std::find_if(
            options_.begin(), options_.end(),
            [name = words[i].substr(0, equals)](const Declared& one) { return one.name == name; });
        if (option == options_.end()) {
            refuse("unknown option '" + words[i] + "'" +
                   didYouMean(words[i].substr(0, equals), namesOf(options_)));
        }
        if (isFlag(option->shown)) {
            if (equals != std::string::npos) refuse(words[i] + " gives a value to an option that takes none");
            option->values.push_back("yes");
        } else if (equals != std::string::npos) {
            option->values.push_back(words[i].substr(equals + 1));
        } else {
            if (i + 1 == words.size()) refuse(option->name + " has no value");
            const std::string& value = words[++i];
            // An option's name is no value: "--path --time 3" lacks the value of --path.
            if (value.compare(0, 2, "--") == 0) refuseValue(option->name, value);
            option->values.push_back(value);
        }
    }
    takePositional(positional);
}

void CommandLine::takePositional(const Arguments& words) {
    for (std::size_t i = 0; i < words.size(); ++i) {
        const bool isLast = i + 1 >= arguments_.size();
        if (arguments_.empty() || (i >= arguments_.size() && arguments_.back().count != Count::kRepeatable)) {
            refuse("unexpected argument '" + words[i] + "'");
        }
        Declared& argument = isLast ? arguments_.back() : arguments_[i];
        if (words[i].empty()) refuse(argument.name + " is ''");
        argument.values.push_back(words[i]);
    }
}

void CommandLine::requireCounts() const {
    for (const auto* all : {&arguments_, &options_}) {
        for (const Declared& declared : *all) {
            if (declared.values.empty() && declared.count == Count::kRequired) {
                refuse(declared.name + " is missing");
            }
            if (declared.values.size() > 1 && declared.count != Count::kRepeatable) {
                refuse(declared.name + " is given more than once");
            }
            for (const std::string& value : declared.values) {
                if (value.empty()) refuseValue(declared.name, value);
            }
        }
    }
    for (const auto& [a, b] : excluded_) {
        if (named(a).values.empty() || named(b).values.empty()) continue;
        throw std::invalid_argument(a + " and " + b + " are both given, expected one of them");
    }
}

const CommandLine::Declared& CommandLine::named(const std::string& name) const {
    return *std::find_if(options_.begin(), options_.end(),
                         [&](const Declared& option) { return option.name == name; });
}

void CommandLine::refuse(const std::string& fault) const {
    throw std::invalid_argument(fault + ", expected: " + usage_);
}

}  // namespace clearway::cli
