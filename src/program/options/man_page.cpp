#include "program/options/man_page.h"

#include <algorithm>
#include <boost/algorithm/string/case_conv.hpp>
#include <boost/algorithm/string/replace.hpp>
#include <iostream>

namespace clearway::cli {

namespace {

/// The text for man: a hyphen is a minus, a line that begins with a dot is no macro.
std::string roff(std::string text) {
    boost::replace_all(text, "\\", "\\e");
    boost::replace_all(text, "-", "\\-");
    boost::replace_all(text, "\n.", "\n\\&.");
    return text;
}

/// Without its full stop, on one line.
std::string firstSentence(std::string text) {
    std::replace(text.begin(), text.end(), '\n', ' ');
    const std::size_t end = text.find(". ");
    text = text.substr(0, end);
    if (!text.empty() && text.back() == '.') text.pop_back();
    return text;
}

}  // namespace

void printManPage(const ManPage& page) {
    std::cout << ".TH " << boost::to_upper_copy(page.name) << " 1 \"\" \"clearway\"\n"
              << ".SH NAME\n"
              << roff(page.name) << " \\- " << roff(firstSentence(page.purpose)) << "\n"
              << ".SH SYNOPSIS\n"
              << roff(page.usage) << "\n"
              << ".SH DESCRIPTION\n"
              << roff(page.purpose) << "\n";
    if (!page.rows.empty()) std::cout << ".SH " << page.heading << "\n";
    for (const auto& [words, help] : page.rows)
        std::cout << ".TP\n.B " << roff(words) << "\n" << roff(help) << "\n";
    std::cout
        << ".SH EXIT STATUS\n0: done; 1: the answer is no; 2: bad input or usage, with one line on standard "
           "error.\n";
}

}  // namespace clearway::cli
