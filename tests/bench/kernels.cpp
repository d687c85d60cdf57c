// Times kernels that test pairs of triangles, as tables 1 to 4 of R. Ytterlid's thesis do: each of n triangles
// against each of n others, and a call tests one triangle against the next `input size` others.
//   benchmarks kernels --question distance [--triangles 3000,5000,10000] [--out DIR] ...      see --help
// Ends with exit code 1 when an answer is wrong, and with 2 when the benchmark cannot run.
#include <algorithm>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <limits>
#include <sstream>

#include "bench/pair_kernels.h"
#include "bench/pinned.h"
#include "bench/series.h"
#include "bench/task_options.h"
#include "kernels/rounding.h"
#include "support/processor_time.h"
#include "support/random_meshes.h"
#include "support/triangle_distance.h"

namespace clearway::testing::kernels {

// Triangles have their centres in a cube of side 1, and their corners in a cube around the centre.
constexpr double kHalfSide = 0.5;
constexpr double kHalfSize = 0.25;

// Answers further off than these are wrong; lengths, for triangles as above.
constexpr double kFloatTolerance = 1e-5;
constexpr double kDoubleTolerance = 1e-12;

/// Pairs further apart than this may not stay open. The direction between two points at a distance D is off by
/// u32 / D, so a slab across it shows a gap if D is well above the root of u32, 2.4e-4.
constexpr double kOpenTolerance = 1e-3;

/// Numbers as all kernels want them: every coordinate is a float.
struct TriangleSet {
    int count;
    int stride;
    std::vector<double> numbers;        ///< 9 a triangle
    std::vector<float> numbersInFloat;  ///< these in float
    std::vector<float> rows;            ///< 9 rows, each with kPadding entries more than triangles

    const double* at(int i) const { return numbers.data() + 9 * i; }
    LongTriangle longAt(int i) const {
        LongTriangle t;
        for (int k = 0; k < 3; ++k)
            t[std::size_t(k)] = LongVector(at(i)[3 * k], at(i)[3 * k + 1], at(i)[3 * k + 2]);
        return t;
    }
};

TriangleSet drawnSet(Random& random, int count) {
    TriangleSet set;
    set.count = count;
    set.stride = count + kPadding;
    set.rows.assign(std::size_t(9 * set.stride), 0);
    for (int i = 0; i < count; ++i) {
        const Vector3 centre = random.inBox(kHalfSide);
        for (int k = 0; k < 3; ++k) {
            const Vector3 corner = centre + random.inBox(kHalfSize);
            for (int axis = 0; axis < 3; ++axis) {
                const auto x = static_cast<float>(corner[axis]);
                set.numbers.push_back(x);
                set.numbersInFloat.push_back(x);
                set.rows[std::size_t((3 * k + axis) * set.stride + i)] = x;
            }
        }
    }
    return set;
}

/// The truth about a pair.
struct Truth {
    double distance;
    double gap;  ///< the widest slab between the triangles; negative if they touch
};

double slab(const LongVector& v, const LongTriangle& a, const LongTriangle& b) {
    long double lowA = INFINITY, highA = -INFINITY, lowB = INFINITY, highB = -INFINITY;
    for (int k = 0; k < 3; ++k) {
        const long double onA = v.dot(a[std::size_t(k)]), onB = v.dot(b[std::size_t(k)]);
        lowA = std::min(lowA, onA);
        highA = std::max(highA, onA);
        lowB = std::min(lowB, onB);
        highB = std::max(highB, onB);
    }
    return double(std::max(lowB - highA, lowA - highB) / v.norm());
}

/// By the oracle, in long double. Throws std::logic_error if the oracle contradicts the slabs.
Truth truthOf(const LongTriangle& a, const LongTriangle& b) {
    const auto edge = [](const LongTriangle& t, std::size_t k) -> LongVector {
        return t[(k + 1) % 3] - t[k];
    };
    double gap = std::max(slab(edge(a, 0).cross(edge(a, 1)), a, b), slab(edge(b, 0).cross(edge(b, 1)), a, b));
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) gap = std::max(gap, slab(edge(a, i).cross(edge(b, j)), a, b));
    }
    const auto distance = double(triangleDistance(a, b).distance);
    if (distance < gap - kDoubleTolerance || (gap < -kDoubleTolerance && distance > kDoubleTolerance)) {
        throw std::logic_error("the oracle says a distance of " + std::to_string(distance) +
                               ", but the widest slab is " + std::to_string(gap));
    }
    return {gap < -kDoubleTolerance ? 0 : distance, gap};
}

struct Choices {
    std::string question = "collides";
    std::vector<int> triangles = {3000, 5000, 10000};
    int trianglesBySize = 1000;
    std::vector<int> inputSizes = {1, 2, 4, 8, 16, 128, 1024};
    int repetitions = 3;
    int checkedPairs = 30000;
    std::uint64_t seed = 1;
    int cpu = -1;
    std::string out;

    bool isDistance() const { return question == "distance"; }
};

/// A contender's times and answers for n x n pairs and one input size.
struct Measured {
    std::vector<double> seconds;  ///< of processor time, a repetition each
    int open = 0;                 ///< checked pairs that double is to decide
    int differing = 0;            ///< other checked verdicts on contact that are not the truth
    int wrong = 0;                ///< checked answers further off than the tolerance
    double largestError = 0;      ///< of a checked distance
};

class Bench {
  public:
    Bench(const Choices& choices, int count) : choices_(choices) {
        Random random(choices.seed);
        a_ = drawnSet(random, count);
        b_ = drawnSet(random, count);
        const double radius = std::sqrt(3.0) * (kHalfSide + kHalfSize);
        slack_ = slackOf(kTriangleSlack, 2 * radius, 0);
        touches_.resize(std::size_t(b_.stride));
        distances_.resize(std::size_t(b_.stride));
        distancesInDouble_.resize(std::size_t(b_.stride));
        // Rows and columns of a grid over all pairs. Odd steps meet every lane of a register.
        const double side = std::sqrt(double(choices.checkedPairs));
        step_ = std::max(1, int(count / side)) | 1;
        for (int i = 0; i < count; i += step_) {
            for (int j = 0; j < count; j += step_) truths_.push_back(truthOf(a_.longAt(i), b_.longAt(j)));
        }
    }

    /// A part of a pass that counts as nothing.
    void leadIn(const PairContender& contender, int inputSize) {
        for (int i = 0; i < (a_.count + 9) / 10; ++i) runRow(contender, inputSize, i);
    }

    void pass(const PairContender& contender, int inputSize, Measured& measured) {
        const double begin = processorSeconds();
        for (int i = 0; i < a_.count; ++i) runRow(contender, inputSize, i);
        measured.seconds.push_back(processorSeconds() - begin);
    }

    /// Compares the answers of the grid with the truth.
    void check(const PairContender& contender, int inputSize, Measured& measured) {
        const double tolerance = contender.isInDouble ? kDoubleTolerance : kFloatTolerance;
        auto truth = truths_.begin();
        for (int i = 0; i < a_.count; i += step_) {
            // Answers that a kernel does not write must not be taken for its own.
            std::fill(touches_.begin(), touches_.end(), -1);
            std::fill(distances_.begin(), distances_.end(), NAN);
            std::fill(distancesInDouble_.begin(), distancesInDouble_.end(), NAN);
            runRow(contender, inputSize, i);
            for (int j = 0; j < b_.count; j += step_, ++truth) {
                const bool isTouching = touches(contender, j);
                const bool isWritten = choices_.isDistance() || touches_[std::size_t(j)] >= 0;
                if (isTouching && isWritten && contender.leavesOpen) {
                    ++measured.open;
                    measured.wrong += truth->gap > kOpenTolerance;
                    continue;
                }
                measured.differing += isTouching != (truth->gap <= 0);
                bool isRight = isWritten && (isTouching ? truth->gap <= tolerance : truth->gap >= -tolerance);
                if (choices_.isDistance()) {
                    const double error = std::abs(distance(contender, j) - truth->distance);
                    measured.largestError = std::max(measured.largestError, error);
                    isRight = isRight && error <= tolerance;
                }
                measured.wrong += !isRight;
            }
        }
    }

    std::int64_t pairs() const { return std::int64_t(a_.count) * b_.count; }
    std::size_t checked() const { return truths_.size(); }

    double touchingShare() const {
        const auto touching =
            std::count_if(truths_.begin(), truths_.end(), [](const Truth& t) { return t.gap <= 0; });
        return double(touching) / double(checked());
    }

  private:
    void runRow(const PairContender& contender, int inputSize, int i) {
        const PairKernel kernel = choices_.isDistance() ? contender.distance : contender.collides;
        PairsOfCall pairs;
        pairs.a = a_.at(i);
        pairs.aInFloat = a_.numbersInFloat.data() + 9 * i;
        pairs.stride = b_.stride;
        pairs.slack = slack_;
        for (int first = 0; first < b_.count; first += inputSize) {
            pairs.b = b_.at(first);
            pairs.rows = b_.rows.data() + first;
            pairs.count = std::min(inputSize, b_.count - first);
            kernel(pairs,
                   {touches_.data() + first, distances_.data() + first, distancesInDouble_.data() + first});
        }
    }

    double distance(const PairContender& contender, int j) const {
        return contender.isInDouble ? distancesInDouble_[std::size_t(j)] : double(distances_[std::size_t(j)]);
    }

    bool touches(const PairContender& contender, int j) const {
        return choices_.isDistance() ? distance(contender, j) == 0 : touches_[std::size_t(j)] != 0;
    }

    const Choices& choices_;
    TriangleSet a_, b_;
    float slack_;
    std::vector<std::int32_t> touches_;
    std::vector<float> distances_;
    std::vector<double> distancesInDouble_;
    int step_;
    std::vector<Truth> truths_;
};

std::vector<PairContender> allContenders() {
    std::vector<PairContender> all;
    for (const auto& some :
         {scalarContenders(), handWrittenContenders(), ispcContenders(), clearwayContenders()}) {
        all.insert(all.end(), some.begin(), some.end());
    }
    return all;
}

/// Measures all contenders in turns, and appends their rows to the table. Returns the number of wrong answers.
std::int64_t measure(const Choices& choices, int count, int inputSize, int repetitions, Bench& bench,
                     std::string& table) {
    const std::vector<PairContender> contenders = allContenders();
    std::vector<Measured> measured(contenders.size());
    const auto inTurns = [&](const auto& work) {
        for (std::size_t i = 0; i < contenders.size(); ++i) {
            if (contenders[i].missing.empty()) work(contenders[i], measured[i]);
        }
    };
    inTurns([&](const PairContender& contender, Measured& of) {
        bench.check(contender, inputSize, of);
        bench.leadIn(contender, inputSize);
    });
    for (int repetition = 0; repetition < repetitions; ++repetition) {
        inTurns([&](const PairContender& contender, Measured& of) { bench.pass(contender, inputSize, of); });
    }
    std::int64_t wrong = 0;
    std::ostringstream rows;
    rows << std::setprecision(6);
    for (std::size_t i = 0; i < contenders.size(); ++i) {
        const PairContender& contender = contenders[i];
        const Measured& of = measured[i];
        rows << choices.question << ',' << count << ',' << inputSize << ',' << contender.name << ','
             << contender.test << ',' << contender.instructionSet << ','
             << (contender.missing.empty() ? "measured" : contender.missing) << ',';
        if (contender.missing.empty()) {
            const auto [low, high] = std::minmax_element(of.seconds.begin(), of.seconds.end());
            rows << median(of.seconds) << ',' << *low << ',' << *high << ',' << of.seconds.size() << ','
                 << 1e9 * median(of.seconds) / double(bench.pairs()) << ',' << bench.touchingShare() << ','
                 << bench.checked() << ',' << of.open << ',' << of.differing << ',';
            if (choices.isDistance()) rows << of.largestError;
            rows << ',' << of.wrong;
        } else {
            rows << ",,,,,,,,,,";
        }
        rows << '\n';
        wrong += of.wrong;
    }
    std::cout << rows.str() << std::flush;
    table += rows.str();
    return wrong;
}

cli::Reader numbers(std::vector<int>& to) {
    return [&to](const std::string& value) {
        to.clear();
        for (const std::string& word : splitAtCommas(value))
            to.push_back(int(cli::integerFrom(word, 1, 1000000)));
    };
}

int run(int count, char** words) {
    Choices choices;
    cli::CommandLine line("benchmarks kernels [options]",
                          "Times kernels that test pairs of triangles, in turns.");
    line.option("--question NAME", "collides or distance [collides]", [&](const std::string& value) {
        choices.question = cli::oneOf(value, {"collides", "distance"});
    });
    line.option("--triangles LIST",
                "triangles in each set, in calls of the last input size [3000,5000,10000]",
                numbers(choices.triangles));
    line.option("--triangles-by-size N", "triangles in each set for all input sizes [1000]",
                cli::integer<int>(choices.trianglesBySize, 1, 1000000));
    line.option("--input-sizes LIST", "pairs in a call [1,2,4,8,16,128,1024]", numbers(choices.inputSizes));
    line.option("--repetitions N", "passes that count; two at most of more than 3000 triangles [3]",
                cli::integer<int>(choices.repetitions, 1, 1000));
    line.option("--checked N", "pairs whose answers are compared with the oracle's, about [30000]",
                cli::integer<int>(choices.checkedPairs, 1, 100000000));
    line.option("--seed N", "of the triangles [1]", cli::integer<std::uint64_t>(choices.seed, 0, 1000000000));
    line.option("--cpu N", "the processor that all work keeps to [any]",
                cli::integer<int>(choices.cpu, 0, 100000));
    line.option("--out DIR", "folder for kernels.csv", cli::folder(choices.out));
    if (!line.parse({words + 1, words + count})) return 0;

    std::string table =
        "question,triangles,input_size,contender,test,instruction_set,status,seconds,seconds_least,seconds_"
        "largest,"
        "repetitions,ns_a_pair,touching_share,checked,open,differing,largest_error,wrong\n";
    std::cout << table;
    std::int64_t wrong = 0;
    runPinned(choices.cpu, [&] {
        const auto measureSet = [&](int triangles, const std::vector<int>& inputSizes, int repetitions) {
            Bench bench(choices, triangles);
            for (const int size : inputSizes) {
                wrong += measure(choices, triangles, size, repetitions, bench, table);
            }
        };
        measureSet(choices.trianglesBySize, choices.inputSizes, choices.repetitions);
        for (const int triangles : choices.triangles) {
            const int repetitions =
                triangles <= 3000 ? choices.repetitions : std::min(choices.repetitions, 2);
            measureSet(triangles, {choices.inputSizes.back()}, repetitions);
        }
    });
    writeTable(choices.out, "kernels.csv", table);
    if (wrong > 0) std::cerr << "benchmarks kernels: " << wrong << " answers are wrong\n";
    return wrong == 0 ? 0 : 1;
}

}  // namespace clearway::testing::kernels
