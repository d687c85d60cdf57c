#include "support/motion_judge.h"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <optional>
#include <vector>

#include "support/motion_samples.h"

namespace clearway::testing {
namespace {

namespace ob = ompl::base;
using planning::MotionVerdict;
using planning::ProfilePoint;

/// Compares what is said of one motion with its poses.
class MotionJudge {
  public:
    MotionJudge(const CrowdedScene& scene, const OtherValidators& others, const HardMotion& motion)
        : scene_(scene), others_(others), motion_(motion), samples_(scene, motion) {}

    MotionTally judge(int poses, Random& random) {
        answers_.emplace_back("scene's", *scene_.validator, scene_, motion_);
        answers_.emplace_back("reversed", others_.reversed, scene_, motion_);
        const bool isThird = random.below(2) == 0;
        answers_.emplace_back(isThird ? "by callbacks" : "by clearance",
                              isThird ? others_.byCallbacks : others_.byClearance, scene_, motion_);
        floor_ = chooseFloor(random);
        scene_.limit.begin();
        isKept_ = scene_.validator->keepsClearance(motion_.s1.get(), motion_.s2.get(), floor_);
        isFloorStopped_ = scene_.limit.isReached();

        double until = isKept_ ? 1 : 0;
        for (const MotionAnswers& answer : answers_) until = std::max(until, answer.certified());
        samples_.take(poses, until);
        for (const MotionAnswers& answer : answers_) {
            BOOST_TEST_CONTEXT("validator " << answer.name) {
                checkCertified(answer);
                checkClearance(answer);
                checkBlocked(answer);
                checkProfile(answer);
                checkProfileWidth(answer);
            }
        }
        checkAgreement();
        checkFloor();
        return count();
    }

  private:
    const MotionAnswers& own() const { return answers_[0]; }

    void checkCertified(const MotionAnswers& answer) const {
        for (const double until : {answer.lastValid, answer.report().certifiedTime, answer.certified()}) {
            if (until == 0) continue;
            const MotionSample worst = samples_.worst(until);
            BOOST_TEST(worst.isValid, "certified until " << until << ", not valid at " << worst.time);
        }
    }

    /// How far the bounds of a clearance may be apart, by the contract of reports.
    double widthAt(double clearance) const {
        return std::max(
            {0.01 * clearance, std::min(0.1 * clearance, 1e-3 * scene_.diagonal), own().leastInterval});
    }

    void checkClearance(const MotionAnswers& answer) {
        const planning::MotionReport& report = answer.report();
        if (report.verdict != MotionVerdict::kValid) return;
        BOOST_TEST(report.certifiedTime == 1);
        BOOST_TEST(report.blockedTime == 1);
        BOOST_TEST(report.lowerClearance > 0);
        BOOST_TEST(report.lowerClearance <= report.upperClearance);
        const MotionSample worst = samples_.worst(1);
        BOOST_TEST(report.lowerClearance <= worst.clearance + scene_.rounding, "at " << worst.time);
        if (!std::isfinite(report.upperClearance)) return;
        const double closest = samples_.look(report.closestTime).clearance;
        BOOST_TEST(std::abs(closest - report.upperClearance) <= scene_.rounding);
        const double width = report.upperClearance - report.lowerClearance;
        if (width <= widthAt(report.upperClearance) + scene_.rounding) return;
        BOOST_TEST(samples_.isSomewhereAtZoneBorder(),
                   "from " << report.lowerClearance << " to " << report.upperClearance);
        ++atBorder_;
    }

    void checkBlocked(const MotionAnswers& answer) {
        const planning::MotionReport& report = answer.report();
        if (report.verdict == MotionVerdict::kValid) return;
        BOOST_TEST(report.blockedTime >= report.certifiedTime);
        const MotionSample blocked = samples_.look(report.blockedTime);
        if (report.verdict == MotionVerdict::kUndecided) {
            const bool isSure = !answer.isStopped && !scene_.hasZones();
            if (isSure) BOOST_TEST(report.upperClearance <= answer.leastInterval);
            return;
        }
        const ob::State* state = samples_.stateAt(report.blockedTime);
        BOOST_TEST(!blocked.isValid, "at " << report.blockedTime);
        const bool leavesBounds = report.whyInvalid.kind == WhyInvalid::Kind::kOutOfBounds;
        BOOST_TEST(leavesBounds == !scene_.si->satisfiesBounds(state));
        BOOST_TEST((report.whyInvalid.kind == scene_.checker->whyInvalid(state).kind));
        if (!leavesBounds) BOOST_TEST(report.upperClearance <= scene_.rounding);
        checkLastValid(answer, scene_.checker->pose(state));
    }

    /// The last valid pose is near what blocks, or too near to contact or to a zone's border to tell how the motion
    /// goes on.
    void checkLastValid(const MotionAnswers& answer, const Pose& X_environmentBlocked) {
        const bool isForward = answer.forward == MotionVerdict::kInvalid && answer.lastValid > 0;
        // s2 may be far from the end of the interpolation.
        if (!isForward || answer.report().blockedTime == 1 || answer.isStopped) return;
        if (samples_.look(answer.lastValid).clearance <= answer.leastInterval) return;
        if (samples_.isAtZoneBorder(answer.lastValid)) return;
        const double most = ((answer.name == "by clearance" ? 200 : 100) + 2) * answer.leastInterval;
        if (answer.report().certifiedTime >= answer.lastValid) {
            // A report names what blocks to within one least interval.
            const Pose X_environmentLast = scene_.checker->pose(samples_.stateAt(answer.lastValid));
            BOOST_TEST(scene_.scene.part.displacement(X_environmentLast, X_environmentBlocked) <= most);
        } else {
            // A report that gave up earlier names a pose that may be far behind the first one in contact.
            BOOST_TEST(leastClearanceAfter(answer.lastValid, most, answer.leastInterval) <=
                       answer.leastInterval);
        }
    }

    /// Poses are looked at no farther than a step from each other, up to this displacement after a time.
    double leastClearanceAfter(double time, double displacement, double step) {
        const double travel =
            planning::displacementBound(*scene_.space, scene_.scene.part)(motion_.s1.get(), motion_.s2.get());
        double least = samples_.look(time).clearance;
        for (double moved = step; moved <= displacement; moved += step) {
            least = std::min(least, samples_.look(std::min(time + moved / travel, kJustBeforeEnd)).clearance);
        }
        return least;
    }

    void checkProfile(const MotionAnswers& answer) {
        const std::vector<ProfilePoint>& points = answer.profile.points;
        if (points.empty()) return;
        BOOST_TEST(points.front().time == 0);
        BOOST_TEST(points.back().time == 1);
        for (std::size_t k = 0; k < points.size(); ++k) {
            const ProfilePoint& here = points[k];
            if (k > 0 && !(points[k - 1].time < here.time)) BOOST_ERROR("no order at " << here.time);
            const MotionSample sample = samples_.look(here.time);
            if ((here.clearance > 0) != sample.isValid) BOOST_ERROR("another verdict at " << here.time);
            const bool isInBounds = scene_.si->satisfiesBounds(samples_.stateAt(here.time));
            const bool isMore = here.clearance > sample.clearance + scene_.rounding;
            if (isInBounds && isMore) BOOST_ERROR("more clearance at " << here.time);
        }
        for (const MotionSample& sample : samples_.all()) {
            const auto next =
                std::upper_bound(points.begin(), points.end(), sample.time,
                                 [](double time, const ProfilePoint& point) { return time < point.time; });
            const double certain = (next - 1)->lowerToNext;
            const bool isLess = sample.clearance + scene_.rounding < certain;
            if (isLess || (certain > 0 && !sample.isValid)) {
                BOOST_ERROR("less clearance than the profile's " << certain << " at " << sample.time);
            }
        }
    }

    /// How closely a profile promises to follow the clearance, where it is not a contact zone that counts.
    void checkProfileWidth(const MotionAnswers& answer) const {
        const std::vector<ProfilePoint>& points = answer.profile.points;
        const bool isPromised = !answer.isStopped && !scene_.hasZones() && answer.name != "by clearance";
        if (points.empty() || !isPromised) return;
        const double travel =
            planning::displacementBound(*scene_.space, scene_.scene.part)(motion_.s1.get(), motion_.s2.get());
        for (std::size_t k = 0; k + 1 < points.size(); ++k) {
            const ProfilePoint &here = points[k], &next = points[k + 1];
            if (next.time > answer.report().certifiedTime) break;
            const double way = travel * (next.time - here.time),
                         least = std::min(here.clearance, next.clearance);
            const double promised =
                std::min({0.8 * least, least - 1e-3 * scene_.diagonal, answer.report().lowerClearance});
            const bool isClose =
                here.lowerToNext >= promised - scene_.rounding || way <= answer.leastInterval;
            if (!isClose)
                BOOST_ERROR("only " << here.lowerToNext << " of " << least << " from " << here.time);
            if (way > std::max(0.0201 * scene_.diagonal, 0.101 * least))
                BOOST_ERROR("no point for long after " << here.time);
        }
    }

    void checkAgreement() {
        for (const MotionAnswers& one : answers_) {
            for (const MotionAnswers& other : answers_) {
                const bool isContradiction =
                    one.says(MotionVerdict::kValid) && other.says(MotionVerdict::kInvalid);
                BOOST_TEST(!isContradiction, one.name << " against " << other.name);
            }
            const bool isFar = one.report().verdict == MotionVerdict::kValid &&
                               one.report().lowerClearance > one.leastInterval;
            const bool isCertified =
                one.check == MotionVerdict::kValid && one.forward == MotionVerdict::kValid;
            if (!isFar || one.isStopped || isCertified) continue;
            // A motion farther than a least interval from contact can be certified, but for the border of a zone: what is
            // ignored on one side of it may be in contact.
            BOOST_TEST(samples_.isSomewhereAtZoneBorder(), one.name);
        }
    }

    double chooseFloor(Random& random) const {
        const planning::MotionReport& report = own().report();
        const double share = random.below(2) == 0 ? random.uniform(0.1, 0.9) : random.uniform(1, 2);
        const bool isKnown = report.verdict == MotionVerdict::kValid && std::isfinite(report.upperClearance);
        const double wanted = share * (isKnown ? report.lowerClearance : 0.01 * scene_.diagonal);
        return std::min(wanted, scene_.mostClearance);
    }

    void checkFloor() {
        const planning::MotionReport& report = own().report();
        if (isKept_) {
            const MotionSample worst = samples_.worst(1);
            BOOST_TEST(worst.isValid, "floor " << floor_ << ", not valid at " << worst.time);
            BOOST_TEST(worst.clearance > floor_ - scene_.rounding, "at " << worst.time);
            BOOST_TEST((report.verdict != MotionVerdict::kInvalid));
        } else if (report.verdict == MotionVerdict::kValid) {
            if (!isFloorStopped_) BOOST_TEST(report.lowerClearance <= floor_ + own().leastInterval);
        }
    }

    MotionTally count() {
        MotionTally tally;
        const planning::MotionReport& report = own().report();
        const bool isValid = own().says(MotionVerdict::kValid),
                   isInvalid = own().says(MotionVerdict::kInvalid);
        ++(isValid ? tally.valid : isInvalid ? tally.invalid : tally.undecided);
        const WhyInvalid::Kind kind = report.whyInvalid.kind;
        tally.enclosed = report.verdict == MotionVerdict::kInvalid && kind == WhyInvalid::Kind::kInSolid;
        tally.outOfBounds = kind == WhyInvalid::Kind::kOutOfBounds && report.certifiedTime > 0;
        if (!isValid) return tally;
        const auto crosses = [](const std::optional<planning::TimeSpan>& contact) {
            return contact && (contact->first > 0 || contact->last < 1);
        };
        tally.crossing = crosses(report.startContact) || crosses(report.goalContact);
        tally.atBorder = atBorder_ > 0;
        tally.kept = isKept_;
        tally.lost = !isKept_;
        tally.otherValid = answers_.back().says(MotionVerdict::kValid);
        const Pose X_worldEnd = scene_.checker->pose(motion_.s2.get());
        const Pose X_worldLast = scene_.checker->pose(samples_.stateAt(kJustBeforeEnd));
        tally.turnLeftOut = (X_worldEnd.rotation - X_worldLast.rotation).norm() > 1e-12;
        return tally;
    }

    const CrowdedScene& scene_;
    const OtherValidators& others_;
    const HardMotion& motion_;
    MotionSamples samples_;
    std::vector<MotionAnswers> answers_;
    double floor_ = 0;
    bool isKept_ = false, isFloorStopped_ = false;
    int atBorder_ = 0;
};

}  // namespace

MotionTally& MotionTally::operator+=(const MotionTally& o) {
    valid += o.valid, invalid += o.invalid, undecided += o.undecided, kept += o.kept, lost += o.lost;
    crossing += o.crossing, atBorder += o.atBorder, enclosed += o.enclosed;
    outOfBounds += o.outOfBounds, turnLeftOut += o.turnLeftOut, otherValid += o.otherValid;
    return *this;
}

std::ostream& operator<<(std::ostream& to, const MotionTally& tally) {
    return to << tally.valid << " valid (" << tally.crossing << " across a zone's border, " << tally.atBorder
              << " at one, " << tally.turnLeftOut << " with a turn left out, " << tally.kept
              << " keep a floor, " << tally.lost << " do not, " << tally.otherValid
              << " the other way, too), " << tally.invalid << " invalid (" << tally.enclosed << " by solids, "
              << tally.outOfBounds << " out of bounds), " << tally.undecided << " undecided";
}

MotionTally judgeMotion(const CrowdedScene& scene, const OtherValidators& others, const HardMotion& motion,
                        int poses, Random& random) {
    return MotionJudge(scene, others, motion).judge(poses, random);
}

}  // namespace clearway::testing
