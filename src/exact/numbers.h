// Shared by all arithmetic that knows its own error: verdicts, bounds of a length, and vectors of such
// numbers.
#pragma once

namespace clearway {

/// Answer to a yes-or-no question. open: the digits at hand do not decide it.
enum class Verdict { no, yes, open };

inline Verdict both(Verdict a, Verdict b) {
    if (a == Verdict::no || b == Verdict::no) return Verdict::no;
    return a == Verdict::yes && b == Verdict::yes ? Verdict::yes : Verdict::open;
}

inline Verdict opposite(Verdict a) {
    return a == Verdict::open ? a : a == Verdict::yes ? Verdict::no : Verdict::yes;
}

/// lower <= a length <= upper.
struct LengthBounds {
    double lower;
    double upper;
};

/// A vector of any numbers that can be added and multiplied.
template <class Number>
struct Triple {
    Number x, y, z;
    Triple operator-(const Triple& b) const { return {x - b.x, y - b.y, z - b.z}; }
    Number dot(const Triple& b) const { return x * b.x + y * b.y + z * b.z; }
    Triple cross(const Triple& b) const { return {y * b.z - z * b.y, z * b.x - x * b.z, x * b.y - y * b.x}; }
};

}  // namespace clearway
