// Judges FCL's continuous check, as OMPL.app sets it up, on the random motions that test certified motions;
// the oracle decides which of them collide. The scenes have no margin, because FCL knows none.
//   benchmarks fcl_continuous MOTIONS SEED [OUT.csv]
#include <ompl/base/DiscreteMotionValidator.h>
#include <ompl/util/Console.h>

#include <iostream>

#include "bench/fcl_planning.h"
#include "core/clock.h"
#include "core/number.h"
#include "core/replace_file.h"
#include "support/random_motion.h"

namespace clearway::testing::fcl_continuous {

namespace ob = ompl::base;

constexpr int kPoses = 200;  ///< poses along each motion; a search between them follows
constexpr int kJudged = 5;   ///< the oracle judges this many of these poses, the closest ones

/// One way to check motions, and its results.
struct Checked {
    std::string name;
    const ob::MotionValidator* validator = nullptr;
    int missed = 0;       ///< colliding motions called valid
    int falseAlarms = 0;  ///< certified motions called invalid
    double seconds = 0;
};

struct Tally {
    int colliding = 0, certified = 0, open = 0;  ///< open: neither colliding nor certified
};

void ask(Checked& checked, const RandomMotion& motion, bool isColliding, bool isCertified) {
    const auto begin = Clock::now();
    const bool isValid = checked.validator->checkMotion(motion.s1.get(), motion.s2.get());
    checked.seconds += secondsSince(begin);
    checked.missed += isValid && isColliding;
    checked.falseAlarms += !isValid && isCertified;
}

std::string judge(const MotionScene& scene, int motions, std::uint64_t seed) {
    // FCL gets a space information of its own, so that its checker judges the end states.
    const auto si = std::make_shared<ob::SpaceInformation>(scene.space);
    const auto meshes = makeFclMeshes(scene.partMesh, scene.environmentMesh);
    si->setStateValidityChecker(std::make_shared<FclValidityChecker>(si, meshes));
    const FclContinuousValidator continuous(si, meshes);
    const ob::DiscreteMotionValidator discrete(scene.si);
    std::vector<Checked> all = {{"FCL continuous", &continuous},
                                {"OMPL discrete at 1 %", &discrete},
                                {"clearway certified", scene.validator.get()}};
    Tally tally;
    for (int i = 0; i < motions; ++i) {
        Random random(seed + static_cast<std::uint64_t>(i));
        const RandomMotion motion(scene, random);
        const ob::State *s1 = motion.s1.get(), *s2 = motion.s2.get();
        if (!scene.checker->isValid(s1) || !scene.si->satisfiesBounds(s2)) continue;
        const bool isCertified = scene.close->checkMotion(s1, s2);
        const bool isColliding = scene.leastTrueClearance(s1, s2, 1, kPoses, kJudged) <= 0;
        ++(isColliding ? tally.colliding : isCertified ? tally.certified : tally.open);
        for (Checked& checked : all) ask(checked, motion, isColliding, isCertified);
    }
    std::string rows;
    for (const Checked& checked : all) {
        rows += scene.name + (scene.kind == Space::kSe2 ? " SE(2)," : ",") + checked.name + "," +
                std::to_string(tally.colliding) + "," + std::to_string(checked.missed) + "," +
                std::to_string(tally.certified) + "," + std::to_string(checked.falseAlarms) + "," +
                std::to_string(tally.open) + "," +
                shortNumber(checked.seconds / (tally.colliding + tally.certified + tally.open) * 1e6) + "\n";
    }
    if (all.back().missed > 0) throw std::logic_error("clearway called a colliding motion valid:\n" + rows);
    return rows;
}

int run(int count, char** words) {
    if (count < 3) {
        std::cerr << "usage: benchmarks fcl_continuous MOTIONS SEED [OUT.csv]\n";
        return 2;
    }
    ompl::msg::noOutputHandler();
    const auto motions = static_cast<int>(parseInteger(words[1]).value());
    const auto seed = static_cast<std::uint64_t>(parseInteger(words[2]).value());
    std::string table =
        "scene,checked_by,colliding,of_these_called_valid,certified,of_these_called_invalid,open,us_a_"
        "motion\n";
    std::cout << table;
    for (const auto& scene : motionScenes()) {
        if (scene->scene.largestMargin() > 0) continue;
        const std::string rows = judge(*scene, motions, seed);
        std::cout << rows << std::flush;
        table += rows;
    }
    if (count > 3) replaceFile(words[3], [&](std::ostream& out) { out << table; });
    return 0;
}

}  // namespace clearway::testing::fcl_continuous
