#include "program/cli/command_line.h"

#include <algorithm>
#include <boost/program_options/errors.hpp>
#include <boost/program_options/parsers.hpp>
#include <boost/program_options/positional_options.hpp>
#include <filesystem>
#include <iostream>
#include <stdexcept>

#include "core/number.h"

namespace clearway::cli {

namespace po = boost::program_options;

namespace {

/// Names and values exactly as declared: no short options, so that "-1" is a value, and no guessed
/// abbreviations.
constexpr int kStyle = po::command_line_style::allow_long | po::command_line_style::long_allow_adjacent |
                       po::command_line_style::long_allow_next;

bool isHelp(const std::string& argument) {
    return argument == "--help" || argument == "-h";
}

bool takesAll(const CommandLine& commandLine) {
    return !commandLine.positional.empty() && commandLine.positional.back().find("...") != std::string::npos;
}

void requirePositional(const CommandLine& commandLine, const Arguments& given) {
    const auto& expected = commandLine.positional;
    if (given.size() > expected.size() && !takesAll(commandLine)) {
        throw std::invalid_argument("unexpected argument '" + given[expected.size()] +
                                    "', expected: " + commandLine.usage);
    }
    if (given.size() < expected.size() && expected[given.size()][0] != '[') {
        throw std::invalid_argument(commandLine.positional[given.size()] +
                                    " is missing, expected: " + commandLine.usage);
    }
}

po::variables_map parseStrictly(const CommandLine& commandLine, const Arguments& arguments) {
    po::options_description all;
    all.add(commandLine.options);
    all.add_options()("positional", po::value<Arguments>());
    po::positional_options_description positional;
    positional.add("positional", -1);

    po::variables_map values;
    po::store(po::command_line_parser(arguments).options(all).positional(positional).style(kStyle).run(),
              values);
    const Arguments given = values.count("positional") ? values["positional"].as<Arguments>() : Arguments{};
    requirePositional(commandLine, given);
    for (std::size_t i = 0; i < given.size(); ++i) {
        const std::string& name = commandLine.positional[std::min(i, commandLine.positional.size() - 1)];
        if (given[i].empty()) {
            throw std::invalid_argument(name + " is '', expected: " + commandLine.usage);
        }
        if (takesAll(commandLine) && i + 1 >= commandLine.positional.size()) {
            const Arguments rest(given.begin() + static_cast<std::ptrdiff_t>(i), given.end());
            values.insert({name, po::variable_value(rest, false)});
            break;
        }
        values.insert({name, po::variable_value(given[i], false)});
    }
    return values;
}

}  // namespace

po::typed_value<std::string>* optionValue(const char* shownAs) {
    return po::value<std::string>()->value_name(shownAs);
}

po::typed_value<std::vector<std::string>>* optionValues(const char* shownAs) {
    return po::value<std::vector<std::string>>()->value_name(shownAs)->composing();
}

std::string Options::text(const std::string& name) const {
    if (!has(name)) throw std::invalid_argument("--" + name + " is missing, expected: " + usage_);
    const std::string value = values_[name].as<std::string>();
    if (value.empty()) throw std::invalid_argument("--" + name + " is '', expected a value");
    return value;
}

std::vector<std::string> Options::texts(const std::string& name) const {
    return has(name) ? values_[name].as<std::vector<std::string>>() : std::vector<std::string>();
}

void Options::requireOtherFile(const std::string& name, const std::vector<std::string>& inputs) const {
    const std::string file = text(name);
    for (const std::string& input : inputs) {
        std::error_code ignored;  // files that do not exist are no input to lose
        if (!std::filesystem::equivalent(file, input, ignored)) continue;
        throw std::invalid_argument("--" + name + " is '" + file + "', the input file '" + input +
                                    "', expected another file to write");
    }
}

std::int64_t Options::integer(const std::string& name, std::int64_t least, std::int64_t most) const {
    const std::optional<std::int64_t> value = parseInteger(text(name));
    if (!value || *value < least || *value > most) {
        throw std::invalid_argument("--" + name + " is '" + text(name) + "', expected an integer from " +
                                    std::to_string(least) + " to " + std::to_string(most));
    }
    return *value;
}

double Options::number(const std::string& name, const char* expected) const {
    const std::optional<double> value = parseNumber(text(name));
    if (!value) refuse(name, expected);
    return *value;
}

double Options::positive(const std::string& name) const {
    constexpr const char* kExpected = "a number above 0";
    const double value = number(name, kExpected);
    if (!(value > 0)) refuse(name, kExpected);
    return value;
}

double Options::nonNegative(const std::string& name) const {
    constexpr const char* kExpected = "a number of at least 0";
    const double value = number(name, kExpected);
    if (!(value >= 0)) refuse(name, kExpected);
    return value;
}

void Options::refuse(const std::string& name, const char* expected) const {
    throw std::invalid_argument("--" + name + " is '" + text(name) + "', expected " + expected);
}

std::optional<Options> parse(const CommandLine& commandLine, const Arguments& arguments) {
    if (std::any_of(arguments.begin(), arguments.end(), isHelp)) {
        std::cout << "Usage: " << commandLine.usage << "\n\n" << commandLine.purpose << "\n";
        if (!commandLine.options.options().empty()) std::cout << "\n" << commandLine.options;
        return std::nullopt;
    }
    try {
        return Options(parseStrictly(commandLine, arguments), commandLine.usage);
    } catch (const po::error& error) {
        throw std::invalid_argument(std::string(error.what()) + ", expected: " + commandLine.usage);
    }
}

}  // namespace clearway::cli
