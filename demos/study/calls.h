// The calls of a planner (the states and motions that it asks about, in order), their answers, and files of
// both.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace clearway::study {

enum class CallKind {
    kState,          ///< ValidityChecker::isValid
    kClearance,      ///< ValidityChecker::isValid that also returns the clearance
    kMotion,         ///< MotionValidator::checkMotion
    kForwardMotion,  ///< MotionValidator::checkMotion that also returns the last valid state
};

/// A call with its states, each given by the real numbers that make up the state in OMPL's space.
struct Call {
    CallKind kind = CallKind::kState;
    std::vector<double> from;
    std::vector<double> to;  ///< empty for a call about one state
};

/// Consecutive calls.
using CallBlock = std::vector<Call>;

/// How to sample a run's calls: blocks are drawn evenly from all calls and kept in the run's order. Within a
/// block, a replay begins each query but the first with the planner's own warm start.
struct CallSampling {
    std::size_t blocks = 32;
    std::size_t callsPerBlock = 32;
    std::uint64_t seed = 1;
};

/// The answer to a call. kUndecided: no invalid pose of the motion was found, but not all of it is certified.
enum class CallAnswer : char { kNo = 'n', kYes = 'y', kUndecided = 'u' };

using Answers = std::vector<std::vector<CallAnswer>>;  ///< one list for each block

/// One call a line, its kind and its reals with 17 digits; an empty line ends a block.
std::string callsText(const std::vector<CallBlock>& blocks);

/// Writes a text of calls. Removes the file of answers to the calls that the file held before. Throws
/// std::runtime_error when the file cannot be written.
void writeCalls(const std::string& callsText, const std::string& file);

/// Throws std::runtime_error when the file cannot be read, and std::invalid_argument, naming the file and the
/// line, when a line is wrong.
std::vector<CallBlock> readCalls(const std::string& file);

/// The file of the answers, beside the file of the calls.
std::string answersFile(const std::string& callsFile);

/// Writes a line for each block, with a character for each call.
void writeAnswers(const Answers& answers, const std::string& file);
Answers readAnswers(const std::string& file);

}  // namespace clearway::study
