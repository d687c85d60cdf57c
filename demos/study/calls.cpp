#include "demos/study/calls.h"

#include <filesystem>
#include <ostream>
#include <stdexcept>

#include "core/number.h"
#include "core/replace_file.h"
#include "core/text.h"

namespace clearway::study {
namespace {

struct NamedKind {
    CallKind kind;
    const char* name;
    std::size_t states;
};

constexpr NamedKind kKinds[] = {{CallKind::kState, "state", 1},
                                {CallKind::kClearance, "clearance", 1},
                                {CallKind::kMotion, "motion", 2},
                                {CallKind::kForwardMotion, "forward", 2}};

const NamedKind& rowOf(CallKind kind) {
    for (const NamedKind& row : kKinds) {
        if (row.kind == kind) return row;
    }
    throw std::logic_error("a kind of call is not in the table");
}

Call parseCall(const std::vector<std::string_view>& parts, const std::string& where) {
    for (const NamedKind& row : kKinds) {
        if (parts[0] != row.name) continue;
        const std::size_t reals = parts.size() - 1, each = reals / row.states;
        if (reals == 0 || reals % row.states != 0) break;
        Call call{row.kind, {}, {}};
        for (std::size_t i = 0; i < reals; ++i) {
            const auto number = parseNumber(parts[i + 1]);
            if (!number) throw std::invalid_argument(where + quote(parts[i + 1]) + ", expected a number");
            (i < each ? call.from : call.to).push_back(*number);
        }
        return call;
    }
    throw std::invalid_argument(where + quote(parts[0]) + ", expected a kind of call and its states");
}

}  // namespace

std::string answersFile(const std::string& callsFile) {
    return callsFile + ".answers";
}

std::string callsText(const std::vector<CallBlock>& blocks) {
    std::string text;
    for (const CallBlock& block : blocks) {
        for (const Call& call : block) {
            text += rowOf(call.kind).name;
            for (const double real : call.from) text += " " + formatNumber(real);
            for (const double real : call.to) text += " " + formatNumber(real);
            text += "\n";
        }
        text += "\n";
    }
    return text;
}

void writeCalls(const std::string& callsText, const std::string& file) {
    std::error_code ignored;
    std::filesystem::remove(answersFile(file), ignored);
    replaceFile(file, [&](std::ostream& out) { out << callsText; });
}

std::vector<CallBlock> readCalls(const std::string& file) {
    std::vector<CallBlock> blocks;
    CallBlock block;
    int number = 0;
    for (const std::string& line : readLines(file, "recorded calls")) {
        ++number;
        const std::vector<std::string_view> parts = words(line);
        if (!parts.empty()) {
            block.push_back(parseCall(parts, place(file, number)));
        } else if (!block.empty()) {
            blocks.push_back(std::move(block));
            block.clear();
        }
    }
    if (!block.empty()) blocks.push_back(block);
    return blocks;
}

void writeAnswers(const Answers& answers, const std::string& file) {
    replaceFile(file, [&](std::ostream& out) {
        for (const auto& block : answers) {
            for (const CallAnswer answer : block) out << static_cast<char>(answer);
            out << "\n";
        }
    });
}

Answers readAnswers(const std::string& file) {
    Answers answers;
    int number = 0;
    for (const std::string& line : readLines(file, "answers of recorded calls")) {
        ++number;
        if (line.find_first_not_of("nyu") != std::string::npos) {
            throw std::invalid_argument(place(file, number) + quote(line) +
                                        ", expected the letters n, y and u");
        }
        answers.emplace_back();
        for (const char c : line) answers.back().push_back(static_cast<CallAnswer>(c));
    }
    return answers;
}

}  // namespace clearway::study
