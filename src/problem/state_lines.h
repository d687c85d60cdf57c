// Files of one state or pose a line: numbers between white space; blank lines and lines that begin with #
// left out.
#pragma once

#include <string>
#include <vector>

#include "problem/rotation.h"

namespace clearway {

struct NumberLine {
    int line = 0;  ///< counted from 1
    std::vector<double> numbers;
};

/// Throws std::runtime_error when the file cannot be read, std::invalid_argument naming the line when
/// something in it is no finite number, and naming the file when no line holds any. expected: "a path file",
/// for the messages.
std::vector<NumberLine> readNumberLines(const std::string& file, const char* expected);

/// The quaternion (qx qy qz qw) from the given position in the line, scaled to unit length. Throws
/// std::invalid_argument naming the line when its length is 0.
Rotation quaternionAt(const NumberLine& line, std::size_t position, const std::string& file);

}  // namespace clearway
