#include "torture/pair_families.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "support/triangle_distance.h"

namespace clearway::testing {
namespace {

double largestCoordinate(const TrianglePair& pair) {
    double largest = 0;
    for (const Triangle* triangle : {&pair.a, &pair.b}) {
        for (const Vector3& p : *triangle) largest = std::max(largest, p.cwiseAbs().maxCoeff());
    }
    return largest;
}

double longestEdge(const TrianglePair& pair) {
    double longest = 0;
    for (const Triangle* triangle : {&pair.a, &pair.b}) {
        for (int k = 0; k < 3; ++k) {
            longest = std::max(longest, ((*triangle)[(k + 1) % 3] - (*triangle)[k]).norm());
        }
    }
    return longest;
}

void shift(Triangle& triangle, const Vector3& by) {
    for (Vector3& p : triangle) p += by;
}

/// One of the 24 turns that carry the axes to the axes.
Matrix3 quarterTurn(Random& random) {
    Matrix3 turn = Matrix3::Zero();
    const int first = random.below(3), second = (first + 1 + random.below(2)) % 3;
    const Vector3 x = (random.below(2) == 0 ? 1 : -1) * Vector3::Unit(first),
                  y = (random.below(2) == 0 ? 1 : -1) * Vector3::Unit(second);
    turn.col(0) = x;
    turn.col(1) = y;
    turn.col(2) = x.cross(y);
    return turn;
}

/// Draws from the named families of hard_triangles.h.
class Known {
  public:
    explicit Known(std::vector<std::string> names) {
        for (const std::string& name : names) {
            bool found = false;
            for (const TriangleFamily& family : hardTriangleFamilies()) {
                if (family.name != name) continue;
                families_.push_back(family);
                found = true;
            }
            if (!found) throw std::logic_error("there is no family '" + name + "'");
        }
    }
    TrianglePair operator()(Random& random) const {
        return families_[random.below(int(families_.size()))].make(random);
    }

  private:
    std::vector<TriangleFamily> families_;
};

Triangle anyTriangle(Random& random, double halfSide) {
    const Vector3 a = random.inBox(halfSide), b = random.inBox(halfSide);
    return {a, b, random.inBox(halfSide)};
}

/// Height over longest edge, from 1 down to the least that doubles can tell from 0.
double anyFlatness(Random& random) {
    return std::pow(10.0, -random.uniform(0, random.below(4) == 0 ? 16 : 9));
}

/// The third corner at `along` of the edge between the others, beside it by `flatness` of its length.
Triangle flatTriangle(Random& random, double along, double flatness) {
    Triangle triangle = anyTriangle(random, 500);
    const Vector3 edge = triangle[1] - triangle[0];
    const Vector3 side = edge.cross(random.direction()).normalized() * edge.norm() * flatness;
    triangle[2] = triangle[0] + along * edge + side;
    std::rotate(triangle.begin(), triangle.begin() + random.below(3), triangle.end());
    return triangle;
}

/// Needles have their short side at one end; caps have their third corner over the middle.
TrianglePair flatPair(Random& random, bool areNeedles) {
    const auto flat = [&] {
        const double along = areNeedles ? random.uniform(0, 1e-3) : random.uniform(0.2, 0.8);
        return flatTriangle(random, along, anyFlatness(random));
    };
    TrianglePair pair{flat(), flat()};
    if (random.below(4) == 0) pair.b = anyTriangle(random, 500);
    if (random.below(3) > 0) {  // through or beside each other
        const auto within = [&](const Triangle& t) {
            const double s = random.uniform(0, 1);
            return Vector3(t[0] + s * (t[1] - t[0]) + random.uniform(0, 1 - s) * (t[2] - t[0]));
        };
        shift(pair.b, within(pair.a) - within(pair.b));
    }
    return random.below(2) == 0 ? broughtNear(random, pair) : pair;
}

TrianglePair sometimesNear(Random& random, const TrianglePair& pair) {
    return random.below(2) == 0 ? broughtNear(random, pair) : pair;
}

PosedMeshes scaledAnyhow(Random& random, const TrianglePair& pair) {
    PosedMeshes posed = posedAnyhow(random, pair);
    const int most = random.below(8) == 0 ? 950 : 60;
    const double factor = std::ldexp(1.0, random.below(2 * most + 1) - most);
    posed.part = scaledBy(posed.part, factor);
    posed.environment = scaledBy(posed.environment, factor);
    posed.pose.translation *= factor;
    return posed;
}

/// Moves the pair far from the origin of the environment, of the part, or of both.
PosedMeshes farAway(Random& random, const TrianglePair& pair) {
    const double away = std::pow(10.0, random.uniform(3, 9)), partAway = std::pow(10.0, random.uniform(3, 9));
    TrianglePair moved = pair;
    Pose pose;
    if (random.below(2) == 0) pose.rotation = random.rotation();
    const int kind = random.below(3);
    if (kind != 1) {
        const Vector3 offset = away * random.direction();
        shift(moved.a, offset);
        shift(moved.b, offset);
    }
    pose.translation = moved.a[0];
    if (kind != 0) pose.translation -= pose.rotation * (partAway * random.direction());
    const Pose back = inverse(pose);
    return {meshOf({back * moved.a[0], back * moved.a[1], back * moved.a[2]}), meshOf(moved.b), pose};
}

/// Puts the small triangle somewhere at the large one's border, face or corner; one in four lies in the large
/// one's plane.
TrianglePair unequalPair(Random& random) {
    const double ratio = std::pow(10.0, random.uniform(2, 9));
    TrianglePair pair{anyTriangle(random, 0.5 * ratio), anyTriangle(random, 0.5)};
    const int kind = random.below(4);
    const double s = kind == 0 ? 0 : random.uniform(0, 1), t = kind == 1 ? 0 : random.uniform(0, 1 - s);
    const Vector3 u = pair.a[1] - pair.a[0], v = pair.a[2] - pair.a[0];
    const Vector3 place = pair.a[0] + s * u + t * v;
    if (kind == 3) {
        for (Vector3& p : pair.b) p = (1 / ratio) * (random.uniform(-1, 1) * u + random.uniform(-1, 1) * v);
    }
    shift(pair.b, place + random.uniform(0, 2) * random.direction());
    if (random.below(2) == 0) std::swap(pair.a, pair.b);
    return sometimesNear(random, pair);
}

/// Moves a corner by one or two doubles.
TrianglePair nudged(Random& random, TrianglePair pair) {
    double& coordinate = pair.b[random.below(3)][random.below(3)];
    for (int i = random.below(2); i >= 0; --i) {
        coordinate = std::nextafter(coordinate, random.below(2) == 0 ? -1e300 : 1e300);
    }
    return pair;
}

TrianglePair degeneratePair(Random& random) {
    static const Known segmentsAndPoints({"zero-area segments", "points", "one zero-length edge"});
    if (random.below(2) == 0) return sometimesNear(random, segmentsAndPoints(random));
    TrianglePair pair = touchingPair(random);
    for (Triangle* triangle : {&pair.a, &pair.b}) {
        const int kind = random.below(4), kept = random.below(3);
        if (kind == 1) (*triangle)[(kept + 1) % 3] = (*triangle)[kept];
        if (kind == 2) {  // three corners in a row: the middle of the other two is a double
            (*triangle)[kept] = 0.5 * ((*triangle)[(kept + 1) % 3] + (*triangle)[(kept + 2) % 3]);
        }
        if (kind == 3) triangle->fill((*triangle)[kept]);
    }
    return pair;
}

PosedMeshes cluster(Random& random) {
    static const Known any({"random", "one edge of each along x", "crossing edges", "coplanar turned",
                            "shared edge", "needles", "zero-area segments", "identical", "parallel plates"});
    PosedMeshes posed = posedAnyhow(random, any(random));
    const Pose back = inverse(posed.pose);
    for (int more = random.below(3); more > 0; --more) {
        const TrianglePair pair =
            random.below(2) == 0 ? touchingPair(random) : broughtNear(random, any(random));
        posed.part = joined(posed.part, transformed(meshOf(pair.a), back));
        posed.environment = joined(posed.environment, meshOf(pair.b));
    }
    return posed;
}

using PairDraw = std::function<TrianglePair(Random&)>;

PairFamily anyhow(const std::string& name, const PairDraw& draw) {
    return {name, [draw](Random& random) { return posedAnyhow(random, draw(random)); }};
}

}  // namespace

PosedMeshes posedAnyhow(Random& random, const TrianglePair& pair) {
    const double size = largestCoordinate(pair);
    const int kind = random.below(4);
    Pose pose;
    if (kind == 1) pose.translation = random.inBox(size);
    if (kind == 2) {
        pose.rotation = quarterTurn(random);
        const double unit = size > 0 ? std::ldexp(1.0, std::ilogb(size) - 4) : 1;
        for (double& t : pose.translation) t = unit * (random.below(65) - 32);
    }
    if (kind == 3) pose = random.pose(size);
    const Pose back = inverse(pose);
    return {meshOf({back * pair.a[0], back * pair.a[1], back * pair.a[2]}), meshOf(pair.b), pose};
}

TrianglePair broughtNear(Random& random, const TrianglePair& pair) {
    const TriangleDistance closest = triangleDistance(toLong(pair.a), toLong(pair.b));
    if (!(closest.distance > 0)) return pair;
    const double gap = longestEdge(pair) * std::ldexp(random.uniform(1, 2), -10 - random.below(47));
    const LongVector way =
        (closest.pointOnA - closest.pointOnB) * (1 - static_cast<long double>(gap) / closest.distance);
    TrianglePair near = pair;
    shift(near.b, way.cast<double>());
    return near;
}

TrianglePair touchingPair(Random& random) {
    const auto grid = [&] {
        const int reach = random.below(2) == 0 ? 8 : 1000;
        return Vector3(4.0 * (random.below(2 * reach + 1) - reach),
                       4.0 * (random.below(2 * reach + 1) - reach),
                       4.0 * (random.below(2 * reach + 1) - reach));
    };
    TrianglePair pair{{grid(), grid(), grid()}, {grid(), grid(), grid()}};
    Triangle &a = pair.a, &b = pair.b;
    const int i = random.below(5), j = random.below(5 - i);
    const Vector3 within = 0.25 * (i * a[0] + j * a[1] + (4 - i - j) * a[2]);
    const Vector3 normal = (a[1] - a[0]).cross(a[2] - a[0]);
    switch (random.below(8)) {
        case 0:  // a corner on the face, an edge or a corner; the rest anywhere
            b[random.below(3)] = within;
            break;
        case 1:  // as case 0, but the rest on one side of the face
            b[0] = within;
            for (int k = 1; k < 3; ++k) {
                if ((b[k] - within).dot(normal) < 0) b[k] = 2 * within - b[k];
            }
            break;
        case 2:  // an edge through the face
            b[1] = 2 * within - b[0];
            break;
        case 3:  // a common edge
            b[1] = a[0];
            b[0] = a[1];
            break;
        case 4:  // an edge on part of an edge
            b[0] = 0.25 * (a[0] + 3 * a[1]);
            b[1] = a[1] + (a[1] - a[0]);
            break;
        case 5:  // in the same plane, with a corner inside the other
            b[0] = within;
            b[1] = within + (random.below(7) - 3) * (a[1] - a[0]);
            b[2] = within + (random.below(7) - 3) * (a[2] - a[0]) + (random.below(3) - 1) * (a[1] - a[0]);
            break;
        case 6:  // edges crossing at their middles
            b[0] = 0.5 * (a[0] + a[1]) + 0.5 * (b[2] - a[2]);
            b[1] = 0.5 * (a[0] + a[1]) - 0.5 * (b[2] - a[2]);
            break;
        default:
            b = a;
            std::rotate(b.begin(), b.begin() + random.below(3), b.end());
    }
    if (random.below(2) == 0) std::swap(a, b);
    return pair;
}

std::vector<PairFamily> pairFamilies() {
    const Known random({"random"}), grid({"integer grid", "signed zeros and denormals"}),
        knownNeedles({"needles"}), knownCaps({"caps"}), knownUnequal({"mixed sizes"}),
        farOff({"far from the origin"}),
        parallel({"edges that lie on each other but for a roundoff", "one edge of each along x",
                  "parallel plates", "standing plate", "nearly parallel edges", "exactly parallel edges"}),
        coplanar({"coplanar apart", "coplanar nested", "coplanar edge touch", "coplanar turned",
                  "nearly coplanar", "corner in the other's plane"}),
        near({"random", "one edge of each along x", "standing plate", "vertex over face", "crossing edges",
              "vertex to vertex", "vertex to edge", "nearly parallel edges", "needles",
              "vertex over a small cell"}),
        touching({"crossing plates", "axis-aligned piercing", "shared vertex", "shared edge", "T-junction",
                  "identical"}),
        any({"random", "parallel plates", "crossing plates", "vertex over face", "crossing edges",
             "coplanar turned", "shared vertex", "shared edge", "T-junction", "needles", "identical"});
    return {
        anyhow("random", random),
        anyhow("needle",
               [knownNeedles](Random& r) { return r.below(3) == 0 ? knownNeedles(r) : flatPair(r, true); }),
        anyhow("cap", [knownCaps](Random& r) { return r.below(3) == 0 ? knownCaps(r) : flatPair(r, false); }),
        anyhow("parallel", [parallel](Random& r) { return sometimesNear(r, parallel(r)); }),
        anyhow("coplanar", [coplanar](Random& r) { return sometimesNear(r, coplanar(r)); }),
        anyhow("near-touch", [near](Random& r) { return broughtNear(r, near(r)); }),
        anyhow("touch",
               [touching](Random& r) {
                   const TrianglePair pair = r.below(4) == 0 ? touching(r) : touchingPair(r);
                   return r.below(3) == 0 ? nudged(r, pair) : pair;
               }),
        {"offset",
         [any, farOff](Random& r) {
             return r.below(4) == 0 ? posedAnyhow(r, farOff(r)) : farAway(r, sometimesNear(r, any(r)));
         }},
        {"scale", [any](Random& r) { return scaledAnyhow(r, sometimesNear(r, any(r))); }},
        anyhow("mixed-size",
               [knownUnequal](Random& r) { return r.below(4) == 0 ? knownUnequal(r) : unequalPair(r); }),
        anyhow("degenerate", degeneratePair),
        anyhow("grid", grid),
        {"cluster", cluster}};
}

}  // namespace clearway::testing
