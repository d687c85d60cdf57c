// Files of recorded calls, and of what they answered.
#pragma once

#include <string>
#include <vector>

#include "program/study/calls.h"
#include "program/study/replayer.h"

namespace clearway::study {

/// One call a line, its kind and its reals with 17 digits; an empty line ends a block. The answers to what
/// the file held before are taken away. Throws std::runtime_error when it cannot be written.
void writeCalls(const std::vector<CallBlock>& blocks, const std::string& file);

/// Throws std::runtime_error when it cannot be read, std::invalid_argument naming the file and the line that
/// is wrong.
std::vector<CallBlock> readCalls(const std::string& file);

using Answers = std::vector<std::vector<CallAnswer>>;  ///< of each block's calls

/// Beside the file of the calls.
std::string answersFile(const std::string& callsFile);

/// A line a block, a character a call.
void writeAnswers(const Answers& answers, const std::string& file);
Answers readAnswers(const std::string& file);

}  // namespace clearway::study
