#include "problem/state_lines.h"

#include <stdexcept>

#include "core/number.h"
#include "core/text.h"

namespace clearway {

std::vector<NumberLine> readNumberLines(const std::string& file, const char* expected) {
    std::vector<NumberLine> found;
    int lineNumber = 0;
    for (const std::string& text : readLines(file, expected)) {
        ++lineNumber;
        NumberLine line{lineNumber, {}};
        const std::vector<std::string_view> given = words(text);
        if (given.empty() || given[0][0] == '#') continue;
        for (const std::string_view word : given) {
            const std::optional<double> number = parseNumber(word);
            if (!number) {
                throw std::invalid_argument(place(file, lineNumber) + quote(word) +
                                            " is there, expected a finite number");
            }
            line.numbers.push_back(*number);
        }
        found.push_back(std::move(line));
    }
    if (found.empty()) throw std::invalid_argument(file + ": no line with numbers, expected " + expected);
    return found;
}

Rotation quaternionAt(const NumberLine& line, std::size_t position, const std::string& file) {
    const double* q = line.numbers.data() + position;
    const std::optional<Rotation> rotation = normalized(Rotation(q[3], q[0], q[1], q[2]));
    if (!rotation) {
        throw std::invalid_argument(place(file, line.line) +
                                    "the quaternion is 0 0 0 0, expected one of length above 0");
    }
    return *rotation;
}

}  // namespace clearway
