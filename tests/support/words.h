// Checks of texts and of errors by their words: the thing, its value and what was expected, not whole sentences.
#pragma once

#include <boost/test/unit_test.hpp>
#include <stdexcept>
#include <string>
#include <vector>

namespace clearway::testing {

/// Whether the text holds each of the words.
template <typename... Words>
bool holds(const std::string& text, const Words&... words) {
    return ((text.find(words) != std::string::npos) && ...);
}

/// The message of the error that the call throws; "accepted" if it throws none.
template <typename Error = std::invalid_argument, typename Call>
std::string refusalBy(const Call& call) {
    try {
        call();
    } catch (const Error& error) {
        return error.what();
    }
    return "accepted";
}

/// Checks that the call throws an error whose message holds all the words.
template <typename Error = std::invalid_argument, typename Call>
void requireRefusedBy(const Call& call, const std::vector<std::string>& words) {
    const std::string message = refusalBy<Error>(call);
    for (const std::string& word : words)
        BOOST_TEST(holds(message, word), "no \"" << word << "\" in: " << message);
}

}  // namespace clearway::testing
