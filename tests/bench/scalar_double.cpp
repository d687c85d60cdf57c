#include "bench/scalar_double.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "model/model_data.h"
#include "query/pair_query.h"
#include "query/refine.h"

namespace clearway::testing {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// A share of |t| plus both radii. A rotation's defect of 1e-12, and its transpose used as its inverse, move
/// points by less than 6e-12 of these lengths; some hundred roundings move them by 1e-14.
constexpr double kVolumeMargin = 1e-11;

/// In u64 M: a moved corner is off by 8, a slab gap by 13.
constexpr double kSlabRoundoffs = 32;

constexpr int kMostProjections = 4;

/// A stored volume in double, in query units. Its axes are orthonormal only to float accuracy; the bounds
/// here do not rely on that.
struct Volume {
    Vector3 centre, axis0, axis1;
    double half0, half1, radius;
};

template <int kWidth>
Volume volumeOf(const WideNode<kWidth>& node, int lane, double toQuery) {
    const auto row = [&](const float(&rows)[3][kWidth]) {
        return Vector3(rows[0][lane], rows[1][lane], rows[2][lane]);
    };
    return {row(node.centre) * toQuery,
            row(node.axis0),
            row(node.axis1),
            double(node.halfLength0[lane]) * toQuery,
            double(node.halfLength1[lane]) * toQuery,
            double(node.radius[lane]) * toQuery};
}

Volume moved(const Volume& volume, const Matrix3& rotation, const Vector3& translation) {
    Volume result = volume;
    result.centre = rotation * volume.centre + translation;
    result.axis0 = rotation * volume.axis0;
    result.axis1 = rotation * volume.axis1;
    return result;
}

Vector3 nearOn(const Volume& rectangle, const Vector3& x) {
    const Vector3 w = x - rectangle.centre;
    const double along0 = std::min(std::max(w.dot(rectangle.axis0), -rectangle.half0), rectangle.half0),
                 along1 = std::min(std::max(w.dot(rectangle.axis1), -rectangle.half1), rectangle.half1);
    return rectangle.centre + along0 * rectangle.axis0 + along1 * rectangle.axis1;
}

double supportAlong(const Vector3& v, const Volume& rectangle) {
    return std::abs(v.dot(rectangle.axis0)) * rectangle.half0 +
           std::abs(v.dot(rectangle.axis1)) * rectangle.half1;
}

/// The gap between two rectangles along v: a lower bound of their distance for any v, except for rounding.
double gapAlong(const Vector3& v, const Volume& a, const Volume& b) {
    const double length = v.norm();
    if (!(length > 0)) return -kInfinity;
    return (std::abs(v.dot(b.centre - a.centre)) - supportAlong(v, a) - supportAlong(v, b)) / length;
}

/// The largest support gap along the differences that alternating projections between two rectangles pass through.
struct ProjectedGap {
    double gap = -kInfinity;
    bool isEnough = false;  ///< as large as was asked for, or nearly the length of a difference
};

/// share: of a difference's length, which is then nearly the distance.
ProjectedGap projectedGap(const Volume& a, const Volume& b, double enough, double share) {
    ProjectedGap found;
    Vector3 onA = a.centre;
    for (int i = 0; i < kMostProjections && !found.isEnough; ++i) {
        const Vector3 onB = nearOn(b, onA);
        onA = nearOn(a, onB);
        const Vector3 v = onB - onA;
        found.gap = std::max(found.gap, gapAlong(v, a, b));
        found.isEnough = found.gap >= enough || found.gap >= share * v.norm();
    }
    return found;
}

/// A lower bound of the two volumes' distance, except for rounding.
double cheapGap(const Volume& a, const Volume& b, double enough) {
    const double radii = a.radius + b.radius;
    return projectedGap(a, b, enough + radii, 0.99).gap - radii;
}

/// The shortest difference over all pairs of edges of two rectangles, and all corners with the other face.
Vector3 shortestDifference(const Volume& a, const Volume& b) {
    Matrix3 axes;
    axes << a.axis0, a.axis1, a.axis0.cross(a.axis1);
    const Matrix3 toA =
        axes.transpose();  // nearly: the axes are orthonormal to float, and any difference gives a true bound
    const Vector3 centre = toA * (b.centre - a.centre), sides[2] = {toA * b.axis0, toA * b.axis1};
    const double halvesA[2] = {a.half0, a.half1}, halvesB[2] = {b.half0, b.half1};
    const auto clamped = [](double x, double half) { return std::min(std::max(x, -half), half); };
    Vector3 shortest = centre;
    double leastSquared = centre.squaredNorm();
    // Takes a difference, and says whether it is the shortest of all: then the support gap along it is its length.
    const auto isShortest = [&](const Vector3& v) {
        const double squared = v.squaredNorm();
        if (squared >= leastSquared) return false;
        leastSquared = squared;
        shortest = v;
        const double reach = std::abs(v[0]) * a.half0 + std::abs(v[1]) * a.half1 +
                             std::abs(v.dot(sides[0])) * b.half0 + std::abs(v.dot(sides[1])) * b.half1;
        return std::abs(v.dot(centre)) - reach >= (1 - 1e-9) * squared;
    };
    for (int own = 0; own < 2; ++own) {
        const int other = 1 - own;
        for (int along = 0; along < 2; ++along) {
            const Vector3 &direction = sides[along], &across = sides[1 - along];
            const double cosine = direction[own], sineSquared = 1 - cosine * cosine;
            const double inverse = sineSquared > 1e-12 ? 1 / sineSquared : 0;
            for (const double signB : {-1.0, 1.0}) {
                const Vector3 middle = centre + signB * halvesB[1 - along] * across;
                for (const double signA : {-1.0, 1.0}) {
                    // Either edge must reach beyond the other one, as seen from that one's rectangle: else a face is nearer.
                    const double beyondA =
                        signA * middle[other] + std::abs(direction[other]) * halvesB[along];
                    if (beyondA < halvesA[other]) continue;
                    Vector3 w = middle;
                    w[other] -= signA * halvesA[other];
                    if (std::abs(across[own]) * halvesA[own] < signB * w.dot(across)) continue;
                    const double onB = w.dot(direction);
                    const double first = clamped((w[own] - cosine * onB) * inverse, halvesA[own]);
                    const double t = clamped(first * cosine - onB, halvesB[along]);
                    w[own] -= clamped(t * cosine + w[own], halvesA[own]);
                    if (isShortest(w + t * direction)) return axes * shortest;
                }
            }
        }
    }
    for (const double sign0 : {-1.0, 1.0}) {
        for (const double sign1 : {-1.0, 1.0}) {
            const Vector3 cornerB = centre + sign0 * b.half0 * sides[0] + sign1 * b.half1 * sides[1];
            if (isShortest({cornerB[0] - clamped(cornerB[0], a.half0),
                            cornerB[1] - clamped(cornerB[1], a.half1), cornerB[2]}))
                return axes * shortest;
            const Vector3 fromB = Vector3(sign0 * a.half0, sign1 * a.half1, 0) - centre;
            if (isShortest(clamped(fromB.dot(sides[0]), b.half0) * sides[0] +
                           clamped(fromB.dot(sides[1]), b.half1) * sides[1] - fromB))
                return axes * shortest;
        }
    }
    return axes * shortest;
}

/// The two volumes' distance, except for rounding, or a lower bound of it that is enough.
double exactGap(const Volume& a, const Volume& b, double enough) {
    const double radii = a.radius + b.radius;
    const ProjectedGap projected = projectedGap(a, b, enough + radii, 1 - 1e-9);
    if (projected.isEnough) return projected.gap - radii;
    return std::max(projected.gap, gapAlong(shortestDifference(a, b), a, b)) - radii;
}

/// The bound that the library, too, takes between volumes of trees of this width.
template <int kWidth>
double volumeGap(const Volume& a, const Volume& b, double enough) {
    return kWidth == 2 ? exactGap(a, b, enough) : cheapGap(a, b, enough);
}

/// Two volumes, numbered node * kWidth + lane, and a proved bound of their distance.
struct Entry {
    double bound;
    VolumeReference part, environment;
};

using Corners = std::array<Vector3, 3>;

double slabGap(const Vector3& v, const Corners& a, const Corners& b) {
    const double a0 = v.dot(a[0]), a1 = v.dot(a[1]), a2 = v.dot(a[2]), b0 = v.dot(b[0]), b1 = v.dot(b[1]),
                 b2 = v.dot(b[2]);
    const double forth = std::min({b0, b1, b2}) - std::max({a0, a1, a2}),
                 back = std::min({a0, a1, a2}) - std::max({b0, b1, b2});
    const double length = v.norm();
    return length > 0 ? std::max(forth, back) / length : -kInfinity;
}

/// True if one of three slabs proves a distance of at least `apart`.
bool slabsProve(const Corners& a, const Corners& b, double apart) {
    const Vector3 between = (b[0] + b[1] + b[2]) - (a[0] + a[1] + a[2]);
    if (slabGap(between, a, b) >= apart) return true;
    for (const Corners* t : {&a, &b}) {
        const Vector3 normal = ((*t)[1] - (*t)[0]).cross((*t)[2] - (*t)[0]);
        if (slabGap(normal, a, b) >= apart) return true;
    }
    return false;
}

/// One pose, prepared for volumes. The resolution of pairs needs more.
struct Placed {
    PairQuery query;
    Matrix3 rotation;
    Vector3 between;  ///< from the environment tree's origin to the part tree's, query units
    double margin;    ///< taken from every bound of volumes

    Placed(const FlatTree& part, const FlatTree& environment, const Pose& pose)
        : query(preparePairQuery(part, environment, pose)), rotation(pose.rotation) {
        between = (pose * part.origin - environment.origin) * query.perMeshUnit;
        const double reach = between.norm() + double(part.radius) * query.partLeafToQuery +
                             double(environment.radius) * query.environmentLeafToQuery;
        margin = kVolumeMargin * reach + query.offsetSlack;
    }

    template <int kWidth>
    Volume partVolume(VolumeReference at) const {
        return volumeOf(query.part->nodes<kWidth>()[at / kWidth], int(at % kWidth), query.partLeafToQuery);
    }
    template <int kWidth>
    Volume environmentVolume(VolumeReference at) const {
        return volumeOf(query.environment->nodes<kWidth>()[at / kWidth], int(at % kWidth),
                        query.environmentLeafToQuery);
    }
    Volume toEnvironment(const Volume& ofPart) const { return moved(ofPart, rotation, between); }
    Volume toPart(const Volume& ofEnvironment) const {
        const Matrix3 back = rotation.transpose();
        return moved(ofEnvironment, back, -(back * between));
    }
};

template <int kWidth>
class Search {
    using Node = WideNode<kWidth>;

  public:
    Search(const FlatTree& part, const FlatTree& environment, const Pose& pose, std::vector<Entry>& stack)
        : part_(part), environment_(environment), placed_(part, environment, pose), stack_(stack) {}

    void resolve(const TrianglesAt& triangles) {
        const ResolvedPair pair = resolvePair(placed_.query, triangles);
        ++counters_.refinedPairs;
        leastLower_ = std::min(leastLower_, pair.lower);
        if (pair.upper < nearest_.upper) {
            nearest_ = pair;
            triangles_ = {triangles.part, triangles.environment, pair.feature};
        }
    }

    void run() {
        stack_.assign(1, {-kInfinity, 0, 0});
        while (!stack_.empty() && nearest_.upper > 0) {
            const Entry entry = stack_.back();
            stack_.pop_back();
            if (entry.bound >= nearest_.upper) continue;
            const Node& a = part_.template nodes<kWidth>()[entry.part / kWidth];
            const Node& b = environment_.template nodes<kWidth>()[entry.environment / kWidth];
            const int laneA = int(entry.part % kWidth), laneB = int(entry.environment % kWidth);
            if (a.child[laneA] < 0 && b.child[laneB] < 0) {
                meet(part_.leaf(LeafReference(~a.child[laneA])),
                     environment_.leaf(LeafReference(~b.child[laneB])));
                continue;
            }
            const bool partIsLarger = double(a.size[laneA]) * placed_.query.partLeafToQuery >
                                      double(b.size[laneB]) * placed_.query.environmentLeafToQuery;
            if (b.child[laneB] < 0 || (a.child[laneA] >= 0 && partIsLarger)) {
                openPart(entry, a.child[laneA]);
            } else {
                openEnvironment(entry, b.child[laneB]);
            }
        }
    }

    Answer answer() const {
        Answer result;
        const double toMesh = 1 / placed_.query.perMeshUnit;
        Vector3 between;
        for (int k = 0; k < 3; ++k) between[k] = nearest_.pointOnEnvironment[k] - nearest_.pointOnPart[k];
        result.value = nearest_.upper > 0 ? between.norm() * toMesh : 0;
        // Every dropped pair has a bound of at least the least upper bound.
        result.lower = std::min(leastLower_, nearest_.upper) * toMesh;
        result.upper = nearest_.upper * toMesh;
        result.counters = counters_;
        return result;
    }

    const TrianglesAt& triangles() const { return triangles_; }

  private:
    void openPart(const Entry& entry, std::int32_t opened) {
        const Volume other = placed_.toPart(placed_.template environmentVolume<kWidth>(entry.environment));
        push(part_, opened, other, placed_.query.partLeafToQuery, [&](double bound, VolumeReference child) {
            return Entry{bound, child, entry.environment};
        });
    }

    void openEnvironment(const Entry& entry, std::int32_t opened) {
        const Volume other = placed_.toEnvironment(placed_.template partVolume<kWidth>(entry.part));
        push(environment_, opened, other, placed_.query.environmentLeafToQuery,
             [&](double bound, VolumeReference child) {
                 return Entry{bound, entry.part, child};
             });
    }

    /// Pushes the near children of the opened node, the nearest last.
    template <class MakeEntry>
    void push(const FlatTree& tree, std::int32_t opened, const Volume& other, double toQuery,
              const MakeEntry& makeEntry) {
        const Node& node = tree.template nodes<kWidth>()[opened];
        const std::size_t base = stack_.size();
        ++counters_.nodeVisits;
        for (int lane = 0; lane < kWidth && node.child[lane] != kNoChild; ++lane) {
            ++counters_.volumeTests;
            const double enough = nearest_.upper + placed_.margin;
            const double bound =
                volumeGap<kWidth>(volumeOf(node, lane, toQuery), other, enough) - placed_.margin;
            if (bound >= nearest_.upper) continue;
            stack_.push_back(makeEntry(bound, VolumeReference(opened * kWidth + lane)));
        }
        std::sort(stack_.begin() + std::ptrdiff_t(base), stack_.end(),
                  [](const Entry& a, const Entry& b) { return a.bound > b.bound; });
    }

    void meet(const Leaf& a, const Leaf& b) {
        const PairQuery& query = placed_.query;
        const Vector3 translation(query.t[0], query.t[1], query.t[2]);
        for (std::uint32_t i = 0; i < a.triangleCount; ++i) {
            Corners onPart = part_.corners({a.at, i});
            for (Vector3& corner : onPart) corner = placed_.rotation * corner + translation;
            for (std::uint32_t j = 0; j < b.triangleCount; ++j) {
                ++counters_.triangleTests;
                const double slack = kSlabRoundoffs * kUnitRoundoffDouble * query.largestCoordinate;
                const double apart = (nearest_.upper + slack) / query.perMeshUnit;
                if (!slabsProve(onPart, environment_.corners({b.at, j}), apart)) {
                    resolve({{a.at, i}, {b.at, j}});
                }
                if (nearest_.upper == 0) return;
            }
        }
    }

    static ResolvedPair nothingYet() {
        ResolvedPair pair{};
        pair.upper = kInfinity;
        return pair;
    }

    const FlatTree& part_;
    const FlatTree& environment_;
    Placed placed_;
    std::vector<Entry>& stack_;
    ResolvedPair nearest_ = nothingYet();
    TrianglesAt triangles_;
    double leastLower_ = kInfinity;
    QueryCounters counters_;
};

}  // namespace

struct ScalarDouble::Data {
    Model part, environment;
    std::vector<Entry> stack;
    std::optional<TrianglesAt> warmStart;
};

ScalarDouble::ScalarDouble(const Model& part, const Model& environment)
    : data_(new Data{part, environment, {}, {}}) {}

ScalarDouble::~ScalarDouble() = default;

void ScalarDouble::forgetWarmStart() {
    data_->warmStart.reset();
}

Answer ScalarDouble::distance(const Pose& X_environmentPart) {
    return withNodeWidth(treeOf(data_->part).nodeWidth, [&](auto width) {
        Search<width> search(treeOf(data_->part), treeOf(data_->environment), X_environmentPart,
                             data_->stack);
        if (data_->warmStart) search.resolve(*data_->warmStart);
        search.run();
        data_->warmStart = search.triangles();
        return search.answer();
    });
}

Answer ScalarDouble::rootBound(const Pose& X_environmentPart) const {
    const Placed placed(treeOf(data_->part), treeOf(data_->environment), X_environmentPart);
    const double bound = withNodeWidth(treeOf(data_->part).nodeWidth, [&](auto width) {
        return volumeGap<width>(placed.toEnvironment(placed.template partVolume<width>(0)),
                                placed.template environmentVolume<width>(0), kInfinity) -
               placed.margin;
    });
    Answer answer;
    answer.lower = answer.value = std::max(0.0, bound) / placed.query.perMeshUnit;
    answer.upper = kInfinity;
    return answer;
}

}  // namespace clearway::testing
