#include "torture/pair_check.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>

#include "clearway/model.h"
#include "model/model_data.h"
#include "query/queries.h"
#include "support/query_cases.h"
#include "support/triangle_distance.h"

namespace clearway::testing {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

using Apart = Eigen::Matrix<long double, 3, 1>;

/// One case given to the library, with its true answer.
class Check {
  public:
    Check(const PosedMeshes& posed, CheckedCase& checked)
        : posed_(posed),
          checked_(checked),
          truth_(exactDistance(posed)),
          part_(built(posed.part)),
          environment_(built(posed.environment)) {
        checked.truth = truth_.rounded();
        checked.allowedWidth = defaultWidth(checked.lengths);
        roundoff_ = kUnitRoundoff * checked.lengths.largest;
    }

    void checkDistance() {
        const DistanceResult result = distance(part_, environment_, posed_.pose, {}, workspace_);
        checked_.ofDistance = stageOf(result.counters);
        checked_.error = std::abs(result.distance - checked_.truth);
        checked_.width = static_cast<long double>(result.upper) - result.lower;
        checkInterval(result, checked_.allowedWidth, "distance");
        checkWitnesses(result);
        checkWithin(result.lower, "lower");
        checkWithin(result.upper, "upper");
    }

    void checkCollides() {
        const bool says = collides(part_, environment_, posed_.pose, workspace_);
        checked_.ofCollides = stageOf(workspace_.counters());
        require(says == truth_.isZero(),
                [&] { return std::string("collides is ") + (says ? "true" : "false"); });
    }

    /// Asks isWithin at zero, at the true distance, at the doubles on either side of it, and at distances
    /// farther from it.
    void checkVerdicts(Random& random) {
        const auto near = static_cast<double>(checked_.truth);
        for (const double d : {near, std::nextafter(near, 0.0), std::nextafter(near, kInfinity)}) {
            checkWithin(d, "the truth or a double beside it");
            checked_.ofWithin.push_back(stageOf(workspace_.counters()));
        }
        if (random.below(2) == 0) workspace_.forgetWarmStart();
        const double farther = std::ldexp(random.uniform(-1, 1), -random.below(50));
        checkWithin(near * (1 + farther), "near the truth");
        if (random.below(4) == 0) checkWithin(0, "zero");
    }

    void checkOptions(Random& random) {
        if (random.below(2) == 0) workspace_.forgetWarmStart();
        DistanceOptions options;
        if (random.below(2) == 0) options.relativeError = std::pow(10.0, -random.uniform(0, 14));
        if (random.below(2) == 0) {
            options.absoluteError = checked_.lengths.scene * std::pow(10.0, -random.uniform(0, 14));
        }
        if (random.below(2) == 0) {
            const double off =
                random.below(2) == 0 ? 0 : std::ldexp(random.uniform(-1, 1), -random.below(50));
            options.cap = static_cast<double>(checked_.truth) * (1 + off);
        }
        const DistanceResult result = distance(part_, environment_, posed_.pose, options, workspace_);
        const double width =
            std::max({checked_.allowedWidth, options.absoluteError, options.relativeError * result.lower});
        const auto described = [&] {
            std::ostringstream text;
            text << std::hexfloat << "distance with relativeError " << options.relativeError
                 << ", absoluteError " << options.absoluteError << ", cap "
                 << options.cap.value_or(kInfinity);
            return text.str();
        };
        if (result.upper != kInfinity) return checkInterval(result, width, described());
        require(options.cap && result.lower >= *options.cap && truth_.compare(*options.cap) >= 0 &&
                    truth_.compare(result.lower) >= 0 && result.distance == kInfinity && !result.witness,
                [&] { return described() + " says farther than the cap, lower " + shown(result.lower); });
    }

    void checkFinish() {
        if (posed_.part.triangles.size() != 1 || posed_.environment.triangles.size() != 1) return;
        const PairQuery query = preparePairQuery(treeOf(part_), treeOf(environment_), posed_.pose);
        const ResolvedPair pair = resolvePair(query, {});
        Apart apart;
        for (int k = 0; k < 3; ++k) {
            apart[k] = static_cast<long double>(pair.pointOnEnvironment[k]) - pair.pointOnPart[k];
        }
        const long double unit = std::ldexp(1.0L, query.unitExponent);
        const long double answer = pair.contact == Verdict::yes ? 0 : apart.norm() * unit;
        checked_.finish = {true, std::abs(answer - checked_.truth),
                           (static_cast<long double>(pair.upper) - pair.lower) * unit};
        require(pair.contact == Verdict::open || (pair.contact == Verdict::yes) == truth_.isZero(),
                [&] { return "the double finish mistakes contact, " + shown(answer); });
        require(truth_.compare(pair.lower * double(unit)) >= 0 &&
                    (pair.contact == Verdict::yes || truth_.compare(pair.upper * double(unit)) <= 0),
                [&] {
                    return "the double finish says [" + shown(pair.lower * unit) + ", " +
                           shown(pair.upper * unit) + "]";
                });
        const CaseLengths& lengths = checked_.lengths;
        const long double roundoffs =
            checked_.finish.error / (kUnitRoundoff * (lengths.largest + lengths.edge));
        require(lengths.flattest < kRegularFlatness || roundoffs <= kFinishRoundoffs, [&] {
            return "the double finish says " + shown(answer) + ", off by " + shown(roundoffs) +
                   " u64 (M + L)";
        });
    }

  private:
    static Model built(const Mesh& mesh) {
        BuildOptions options;
        options.threads = 1;
        return Model::build(mesh, options);
    }

    static std::string shown(long double value) {
        std::ostringstream text;
        text.precision(21);
        text << value << std::hexfloat << " (" << static_cast<double>(value) << ")";
        return text.str();
    }

    template <typename Describe>
    void require(bool holds, const Describe& describe) {
        if (!holds) checked_.complaints.push_back(describe() + "; the truth is " + shown(checked_.truth));
    }

    void checkWithin(double d, const char* what) {
        const bool says = isWithin(part_, environment_, posed_.pose, d, workspace_);
        require(says == (truth_.compare(d) <= 0),
                [&] { return "isWithin(" + shown(d) + ") at " + what + " is " + (says ? "true" : "false"); });
    }

    void checkInterval(const DistanceResult& result, double width, const std::string& what) {
        const bool holdsTruth = truth_.compare(result.lower) >= 0 && truth_.compare(result.upper) <= 0;
        const auto interval = [&] {
            return what + " says [" + shown(result.lower) + ", " + shown(result.upper) + "], allowed width " +
                   shown(width);
        };
        require(holdsTruth && result.lower >= 0, [&] { return interval() + ", which misses the truth"; });
        require(static_cast<long double>(result.upper) - result.lower <= width,
                [&] { return interval() + ", too wide"; });
        require(result.collides() == truth_.isZero(), [&] { return interval() + ", contact is mistaken"; });
    }

    void checkWitnesses(const DistanceResult& result) {
        const auto count = [](const Mesh& mesh) { return std::int64_t(mesh.triangles.size()); };
        const bool areNamed = result.witness && result.witness->partTriangle >= 0 &&
                              result.witness->partTriangle < count(posed_.part) &&
                              result.witness->environmentTriangle >= 0 &&
                              result.witness->environmentTriangle < count(posed_.environment);
        require(areNamed, [] { return std::string("a triangle's id is out of range"); });
        if (!areNamed) return;
        const double reach = (result.collides() ? 16 : 8) * roundoff_;
        const auto i = std::size_t(result.witness->partTriangle),
                   j = std::size_t(result.witness->environmentTriangle);
        require(isNear(result.witness->pointOnPart, moved(posed_.pose, cornersOf(posed_.part, i)), reach) ||
                    exactlyFromPart(posed_, i, result.witness->pointOnPart).compare(reach) <= 0,
                [&] { return std::string("the part's witness is off its triangle"); });
        require(isNear(result.witness->pointOnEnvironment, toLong(cornersOf(posed_.environment, j)), reach) ||
                    exactlyFromEnvironment(posed_, j, result.witness->pointOnEnvironment).compare(reach) <= 0,
                [&] { return std::string("the environment's witness is off its triangle"); });
        const Apart between = result.witness->pointOnPart.cast<long double>() -
                              result.witness->pointOnEnvironment.cast<long double>();
        const long double apart = between.norm(), little = 0x1p-51L * apart + 0x1p-1072L;
        const auto described = [&] {
            return "witnesses " + shown(apart) + " apart, distance " + shown(result.distance) + ", lower " +
                   shown(result.lower) + ", upper " + shown(result.upper);
        };
        require(result.collides() ? apart == 0 : std::abs(apart - result.distance) <= little, described);
        require(apart + little >= result.lower - 16 * roundoff_ && result.upper >= apart - little &&
                    result.upper <= apart + little + 16 * roundoff_,
                described);
    }

    /// True if the point is certainly within reach of the triangle; false proves nothing.
    bool isNear(const Vector3& point, const LongTriangle& triangle, double reach) const {
        const LongVector p = point.cast<long double>();
        return (closestOnTriangle(p, triangle) - p).norm() + 0x1p-4L * roundoff_ <= reach;
    }

    const PosedMeshes& posed_;
    CheckedCase& checked_;
    const ExactDistance truth_;
    const Model part_, environment_;
    Workspace workspace_;
    double roundoff_;
};

}  // namespace

Stage stageOf(const QueryCounters& counters) {
    if (counters.exactPairs > 0) return Stage::kExact;
    if (counters.doubleDoublePairs > 0) return Stage::kDoubleDouble;
    return counters.refinedPairs > 0 ? Stage::kDouble : Stage::kFloat;
}

double defaultWidth(const CaseLengths& lengths) {
    return 1e-12 * lengths.scene + 32 * kUnitRoundoff * lengths.largest;
}

/// True if the sizes, or a size and the distance between the meshes, differ by about 2^60 or more, within a
/// few powers of two.
bool mayBeRefused(const CaseLengths& lengths) {
    return lengths.leastSize * 0x1p57 < lengths.largest;
}

CheckedCase checkCase(const PosedMeshes& posed, std::uint64_t choices) {
    CheckedCase checked;
    checked.lengths = lengthsOf(posed);
    Random random(choices);
    try {
        Check check(posed, checked);
        // Before or after other queries have left a warm start.
        if (random.below(2) == 0) check.checkCollides();
        check.checkDistance();
        check.checkCollides();
        check.checkVerdicts(random);
        if (random.below(4) == 0) check.checkOptions(random);
        check.checkFinish();
    } catch (const std::invalid_argument& error) {
        checked.isRefused = mayBeRefused(checked.lengths);
        if (!checked.isRefused) checked.complaints.push_back(std::string("refused: ") + error.what());
    }
    return checked;
}

}  // namespace clearway::testing
