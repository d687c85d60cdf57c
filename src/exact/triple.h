#pragma once

namespace clearway {

/// A vector of numbers that know sums and products.
template <class Number>
struct Triple {
    Number x, y, z;
    Triple operator-(const Triple& b) const { return {x - b.x, y - b.y, z - b.z}; }
    Number dot(const Triple& b) const { return x * b.x + y * b.y + z * b.z; }
    Triple cross(const Triple& b) const { return {y * b.z - z * b.y, z * b.x - x * b.z, x * b.y - y * b.x}; }
};

}  // namespace clearway
