#include "planning/improve/kept_clearance.h"

#include <algorithm>
#include <utility>

namespace clearway::planning {
namespace {

namespace og = ompl::geometric;

constexpr double kLeastKept = 1e-6;  ///< of the most

/// Asks about the motions in turn, those first that failed last.
class Keeping {
  public:
    Keeping(const og::PathGeometric& path, const MotionValidator& validator,
            const std::function<bool()>& isSpent)
        : path_(path), validator_(validator), isSpent_(isSpent) {}

    bool operator()(double clearance) {
        const auto motions = static_cast<unsigned int>(path_.getStateCount()) - 1;
        for (unsigned int k = 0; k < motions; ++k) {
            const unsigned int i = (tightest_ + k) % motions;
            if (validator_.keepsClearance(path_.getState(i), path_.getState(i + 1), clearance, isSpent_))
                continue;
            tightest_ = i;
            return false;
        }
        return true;
    }

    bool isSpent() const { return isSpent_ && isSpent_(); }

  private:
    const og::PathGeometric& path_;
    const MotionValidator& validator_;
    const std::function<bool()>& isSpent_;
    unsigned int tightest_ = 0;
};

}  // namespace

double keptClearance(const og::PathGeometric& path, const MotionValidator& validator,
                     const KeptClearanceOptions& options) {
    double least = options.least, most = options.most;
    if (path.getStateCount() < 2) return least;
    Keeping allKeep(path, validator, options.isSpent);
    double next = options.expected > least ? std::min(options.expected, most) : most;
    for (double step = options.share; next < most && allKeep(next); step *= 2) {
        least = next;
        next = std::min(most, (1 + step) * least);
    }
    if (next < most) most = std::exchange(next, 0.5 * next);
    const double smallest = std::max(least, kLeastKept * most);
    for (; next > smallest && !allKeep.isSpent(); next *= 0.5) {
        if (allKeep(next)) {
            least = next;
            break;
        }
        most = next;
    }
    while (least > 0 && most - least > options.share * most && !allKeep.isSpent()) {
        const double middle = 0.5 * (least + most);
        (allKeep(middle) ? least : most) = middle;
    }
    return least;
}

}  // namespace clearway::planning
