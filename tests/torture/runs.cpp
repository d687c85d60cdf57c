#include "torture/runs.h"

#include <algorithm>
#include <chrono>
#include <iostream>
#include <memory>

#include "bench/peer.h"
#include "torture/repeat.h"

namespace clearway::testing {
namespace {

constexpr int kRound = 20;  ///< cases of a family before the next family's turn

/// The seed of one case. Any case can be drawn again without the cases before it.
std::uint64_t seedOf(std::uint64_t seed, const std::string& family, std::uint64_t number) {
    std::uint64_t hash = seed;
    for (const char c : family) hash = Random(hash ^ static_cast<unsigned char>(c)).bits();
    return Random(hash ^ number).bits();
}

/// The families whose names were given; all if none was.
template <typename Family>
std::vector<Family> chosen(const std::vector<Family>& all, const std::vector<std::string>& names) {
    if (names.empty()) return all;
    std::vector<Family> result;
    for (const Family& family : all) {
        if (std::find(names.begin(), names.end(), family.name) != names.end()) result.push_back(family);
    }
    return result;
}

/// Says when a group of families has had enough cases, and prints progress.
class Progress {
  public:
    Progress(const char* what, std::uint64_t most, double minutes)
        : what_(what), most_(most), seconds_(60 * minutes) {}

    bool isOver() const { return seconds_ > 0 ? elapsed() >= seconds_ : done_ >= most_; }

    void step(std::uint64_t violations) {
        ++done_;
        const double now = elapsed();
        if (now < nextLine_) return;
        nextLine_ = now + 10;
        std::cerr << what_ << ' ' << done_;
        if (seconds_ == 0) std::cerr << " of " << most_;
        std::cerr << ", " << violations << " violations, " << static_cast<int>(now) << " s\n";
    }

  private:
    double elapsed() const {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    }

    const char* what_;
    std::uint64_t most_, done_ = 0;
    double seconds_, nextLine_ = 10;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// Calls tryOne(family, number) with the families in turn until the progress is over.
template <typename TryOne>
void inTurns(std::size_t families, Progress& progress, const TryOne& tryOne) {
    if (families == 0) return;
    for (std::uint64_t round = 0; !progress.isOver(); ++round) {
        for (std::size_t f = 0; f < families; ++f) {
            for (std::uint64_t i = 0; i < kRound && !progress.isOver(); ++i) tryOne(f, round * kRound + i);
        }
    }
}

/// FCL's trees of two meshes: RSS for distances, OBBRSS for collisions.
class FclTrees {
  public:
    FclTrees(const Mesh& part, const Mesh& environment)
        : distances_(makeFclRss(part, environment)), collisions_(makeFclObbRss(part, environment)) {}

    void ask(const Pose& pose, double truth, double sceneSize, FclFigures& figures) const {
        figures.add(distances_.distance(pose).value, collisions_.collides(pose).value != 0, truth, sceneSize);
    }

  private:
    Peer distances_, collisions_;
};

/// True if FCL's products of lengths neither overflow nor vanish at these sizes.
bool isOrdinary(double largestCoordinate) {
    return largestCoordinate > 1e-60 && largestCoordinate < 1e60;
}

class PairRun {
  public:
    explicit PairRun(const TortureOptions& options)
        : options_(options), families_(chosen(pairFamilies(), options.families)) {
        for (const PairFamily& family : families_) {
            figures_.emplace_back();
            figures_.back().family = family.name;
        }
    }

    std::vector<PairFigures> run() {
        Progress progress("pairs", options_.pairs, options_.minutes / 2);
        inTurns(families_.size(), progress, [&](std::size_t f, std::uint64_t number) {
            tryOne(families_[f], figures_[f], number);
            progress.step(violations_);
        });
        return figures_;
    }

  private:
    void tryOne(const PairFamily& family, PairFigures& figures, std::uint64_t number) {
        const std::uint64_t seed = seedOf(options_.seed, family.name, number);
        Random random(seed);
        const PosedMeshes posed = family.make(random);
        const CheckedCase checked = checkCase(posed, seed);
        figures.add(checked);
        if (options_.withFcl && !checked.isRefused && isOrdinary(checked.lengths.largest)) {
            const FclTrees fcl(posed.part, posed.environment);
            fcl.ask(posed.pose, static_cast<double>(checked.truth), checked.lengths.scene, figures.fcl);
        }
        if (checked.complaints.empty()) return;
        ++violations_;
        if (figures.violations > 1) return;  // one violation per family is enough
        std::cout << "violation: family " << family.name << ", seed " << options_.seed << ", number "
                  << number << '\n';
        printRepeat(std::cout, smallest(posed, seed), seed);
        std::cout.flush();
    }

    const TortureOptions& options_;
    std::vector<PairFamily> families_;
    std::vector<PairFigures> figures_;
    std::uint64_t violations_ = 0;
};

class MeshRun {
  public:
    explicit MeshRun(const TortureOptions& options) : options_(options) {
        for (const MeshFamily& family : chosen(meshFamilies(), options.families)) {
            checks_.push_back(std::make_unique<MeshCheck>(family));
            fcl_.emplace_back(family.part, family.environment);
            figures_.emplace_back();
            figures_.back().family = family.name;
        }
    }

    std::vector<MeshFigures> run() {
        Progress progress("poses", options_.poses, options_.minutes / 2);
        inTurns(checks_.size(), progress, [&](std::size_t f, std::uint64_t number) {
            tryOne(f, number);
            progress.step(violations_);
        });
        return figures_;
    }

  private:
    void tryOne(std::size_t f, std::uint64_t number) {
        MeshCheck& check = *checks_[f];
        Random random(seedOf(options_.seed, check.family().name, number));
        const Pose pose = check.draw(random);
        const CheckedPose checked = check.check(pose, random);
        figures_[f].add(checked, check.sceneSize());
        if (options_.withFcl) fcl_[f].ask(pose, checked.distance, check.sceneSize(), figures_[f].fcl);
        if (checked.complaints.empty()) return;
        ++violations_;
        if (figures_[f].violations > 1) return;
        std::cout << "violation: meshes " << check.family().name << ", seed " << options_.seed << ", number "
                  << number << '\n';
        for (const std::string& complaint : checked.complaints) std::cout << "  " << complaint << '\n';
        printPose(std::cout, pose);
        std::cout.flush();
    }

    const TortureOptions& options_;
    std::vector<std::unique_ptr<MeshCheck>> checks_;
    std::vector<FclTrees> fcl_;
    std::vector<MeshFigures> figures_;
    std::uint64_t violations_ = 0;
};

}  // namespace

std::vector<PairFigures> runPairs(const TortureOptions& options) {
    if (options.pairs == 0 && options.minutes == 0) return {};
    return PairRun(options).run();
}

std::vector<MeshFigures> runMeshes(const TortureOptions& options) {
    if (options.poses == 0 && options.minutes == 0) return {};
    return MeshRun(options).run();
}

}  // namespace clearway::testing
