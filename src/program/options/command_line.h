// The command line: the program's subcommands and exit codes, and options that are declared and read in one
// line.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace clearway::cli {

using Arguments = std::vector<std::string>;  ///< the words after the subcommand's name

/// Exit codes of the program. Every subcommand returns one of the first two. When it throws, runProgram() prints
/// the message as one line on stderr and returns kBadInput.
constexpr int kDone = 0;
constexpr int kAnswerIsNo = 1;  ///< no path found, path not valid
constexpr int kBadInput = 2;

struct Subcommand {
    const char* name;
    const char* purpose;  ///< one line for --help
    int (*run)(const Arguments& arguments);
};

// The subcommands: one file each, one row each in the table of main.cpp.
int init(const Arguments& arguments);
int info(const Arguments& arguments);
int query(const Arguments& arguments);
int plan(const Arguments& arguments);
int check(const Arguments& arguments);
int bench(const Arguments& arguments);
int render(const Arguments& arguments);

/// From now on the first Ctrl-C (SIGINT, SIGTERM) ends the current work, not the program: finished work is
/// still written. The second Ctrl-C has its usual effect: it ends the program at once, with exit code 130 in a shell.
void heedInterrupts();
bool isInterrupted();

/// The exception that a Reader throws for a wrong value. what: the expected value ("a number above 0").
struct Expected {
    std::string what;
};

/// Takes the value of an option or argument. Never called with an empty value.
using Reader = std::function<void(const std::string& value)>;

// Read a finite number from the text. They throw Expected.
double number(const std::string& text, const std::string& expected = "a number");
double positiveNumber(const std::string& text);
double nonNegativeNumber(const std::string& text);
std::int64_t integerFrom(const std::string& text, std::int64_t least, std::int64_t most);

/// Returns the text if it is one of the names. Throws Expected otherwise.
std::string oneOf(const std::string& text, const std::vector<std::string>& names);

// Readers that store a value. `to` may be a std::optional, which then tells whether the option was given.
Reader to(std::string& text);
Reader input(std::string& file);  ///< stores the name; - is standard input
Reader appendedTo(std::vector<std::string>& texts);
Reader folder(std::string& to);  ///< an existing folder or a new name

template <class To>
Reader positive(To& to) {
    return [&to](const std::string& value) { to = positiveNumber(value); };
}

template <class To>
Reader nonNegative(To& to) {
    return [&to](const std::string& value) { to = nonNegativeNumber(value); };
}

/// Stores whole numbers from `least` to `most`. Integer: the type to store.
template <class Integer, class To>
Reader integer(To& to, std::int64_t least, std::int64_t most) {
    return [&to, least, most](const std::string& value) {
        to = static_cast<Integer>(integerFrom(value, least, most));
    };
}

/// Declares the options and arguments of a subcommand, with a Reader for the values of each.
class CommandLine {
  public:
    enum class Count { kOptional, kRequired, kRepeatable };

    /// usage: "clearway info MESH [options]".  purpose: --help prints it below the usage.
    CommandLine(std::string usage, std::string purpose);

    /// Declares a positional argument: "PROBLEM.cfg". Brackets make it optional: "[IN.path]". Dots make it
    /// take all words that follow: "[PROBLEM.cfg...]"; `read` is then called once for each word.
    void argument(const std::string& name, Reader read);

    /// declaration: "--seed N".  help: a text that ends with the default in brackets.
    void option(const std::string& declaration, const std::string& help, Reader read,
                Count count = Count::kOptional);
    void flag(const std::string& name, const std::string& help, bool& to) {
        option(name, help, [&to](const std::string&) { to = true; });
    }

    /// Forbids that both options are given.
    void exclude(const std::string& a, const std::string& b) { excluded_.push_back({a, b}); }

    /// Prints the help and returns false when --help is among the arguments; so it does with a page for man when the one
    /// word is --man, and with the options' names, one a line, for --list-options. Otherwise first checks which
    /// options and arguments are given, then reads their values in the order of declaration. Throws
    /// std::invalid_argument that names the option or argument, its value and what was expected.
    bool parse(const Arguments& arguments);

  private:
    struct Declared {
        std::string name;   ///< "--seed" or "PROBLEM.cfg"
        std::string shown;  ///< "--seed N"
        std::string help;
        Reader read;
        Count count;
        Arguments values{};
    };

    void printHelp() const;
    void printManPage() const;
    void takeWords(const Arguments& words);
    void takePositional(const Arguments& words);
    void requireCounts() const;
    const Declared& named(const std::string& name) const;
    [[noreturn]] void refuse(const std::string& fault) const;

    std::string usage_, purpose_;
    std::vector<Declared> options_, arguments_;
    std::vector<std::pair<std::string, std::string>> excluded_;
};

}  // namespace clearway::cli
