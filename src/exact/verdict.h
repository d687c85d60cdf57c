// Answers of arithmetic that knows its own error.
#pragma once

namespace clearway {

/// open: not decided with the digits at hand.
enum class Verdict { no, yes, open };

inline Verdict both(Verdict a, Verdict b) {
    if (a == Verdict::no || b == Verdict::no) return Verdict::no;
    return a == Verdict::yes && b == Verdict::yes ? Verdict::yes : Verdict::open;
}

inline Verdict opposite(Verdict a) {
    return a == Verdict::open ? a : a == Verdict::yes ? Verdict::no : Verdict::yes;
}

}  // namespace clearway
