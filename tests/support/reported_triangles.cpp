// Triangle pairs as stated in bug reports of other libraries, and a few whose distance is obvious.
#include "support/hard_triangles.h"

namespace clearway::testing {

std::vector<KnownPair> knownTrianglePairs() {
    std::vector<KnownPair> pairs;
    const auto add = [&](const char* name, const Triangle& a, const Triangle& b, double distance) {
        pairs.push_back({name, {a, b}, distance});
    };
    add("PQP issue 4",
        {Vector3(8000.0000000000036, 6817.7672478170962, 571.00166381103077),
         Vector3(7500.0000000000009, 6817.7672478170962, 571.00166381103077),
         Vector3(7500.0000000000009, 6327.6345143037688, 571.00166381103077)},
        {Vector3(8000.0000000000009, 6327.6345143037670, 88.336618780016408),
         Vector3(7500.0, 6327.6345143037670, 88.336618780016408),
         Vector3(7500.0, 6327.6345143037670, 1015.9309593449836)},
        1.8189894035458565e-12);
    add("benardp/contours issue 1",
        {Vector3(12.3015, -0.253368, 5.49101), Vector3(18.6765, -2.55337, 4.91756),
         Vector3(12.3015, -2.55337, 4.91756)},
        {Vector3(-11.9885, -0.253368, 5.49101), Vector3(1.61448, -0.253368, 5.49101),
         Vector3(1.61448, -2.55337, 4.91756)},
        10.68702);
    add("ConvexBodyProximityQueries.jl issue 17",
        {Vector3(-0.37579435, 0.014414025, 0.3265663), Vector3(-0.37263185, 0.0108978925, 0.36118037),
         Vector3(-0.35647663, 0.03625821, 0.34328437)},
        {Vector3(0.23884095, -1.6477574, 0.116889484), Vector3(0.26891768, -1.6353351, 0.10821109),
         Vector3(0.26338503, -1.6657706, 0.10510237)},
        1.7844533437800496);
    const Vector3 point(1.10000002, -7.9000001, 16.5879993), doubled(-0.569999993, -8.10000038, 16.6070004);
    add("parry issue 76", {point, point, point},
        {Vector3(2.27699995, -7.9000001, 16.3180008), doubled, doubled}, 0.17147826590144152);
    add("geogram issue 10",
        {Vector3(1898.68, 775, 1158.48), Vector3(2000, 775, 1166.7), Vector3(1898.68, 675, 1148.6)},
        {Vector3(1966.41, 675, 1163.79), Vector3(1971.63, 675, 1166.95), Vector3(1967.56, 684.554, 1166.67)},
        42.989017651687853);
    const Triangle flat = {Vector3(0, 0, 0), Vector3(4, 0, 0), Vector3(0, 4, 0)};
    add("vertex over the face", flat, {Vector3(1, 1, 0.5), Vector3(1, 9, 3), Vector3(9, 1, 3)}, 0.5);
    add("crossing edges", flat, {Vector3(2, -3, 2), Vector3(2, 3, 2), Vector3(2, 0, 9)}, 2);
    add("edge beside edge", flat, {Vector3(1, -3, 4), Vector3(9, -3, 4), Vector3(5, -9, 4)}, 5);
    add("vertex to vertex", flat, {Vector3(6, -3, 6), Vector3(7, -4, 9), Vector3(9, -3, 7)}, 7);
    add("coplanar", flat, {Vector3(-3, 1, 0), Vector3(-3, 2, 0), Vector3(-9, 1, 0)}, 3);
    return pairs;
}

}  // namespace clearway::testing
