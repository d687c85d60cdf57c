#include "planning/improve/least_twist.h"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <limits>

namespace clearway::planning {
namespace {

using Column = Eigen::Matrix<double, 7, 1>;
constexpr Eigen::Index kMostPassive = 7;  // more columns than rows depend on each other
using Passive = Eigen::Matrix<double, 7, Eigen::Dynamic, 0, 7, kMostPassive>;
using Weights = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kMostPassive, 1>;

constexpr double kTolerance = 1e-12;  ///< of columns of about unit length
constexpr int kMostAdditions = 200;

/// The columns with positive weights in a problem of non-negative least squares whose target is the last unit vector.
class PassiveSet {
  public:
    explicit PassiveSet(const std::vector<Column>& columns) : columns_(columns) {}

    Column residual() const {
        Column left = Column::Unit(6);
        for (std::size_t k = 0; k < members_.size(); ++k)
            left -= weights_[Eigen::Index(k)] * columns_[members_[k]];
        return left;
    }

    bool isFull() const { return Eigen::Index(members_.size()) == kMostPassive; }

    /// Adds a column with weight 0, then moves to the least squares of the set, dropping columns whose weights would become negative.
    void add(std::size_t column) {
        members_.push_back(column);
        weights_.conservativeResize(Eigen::Index(members_.size()));
        weights_[weights_.size() - 1] = 0;
        while (!members_.empty()) {
            const Weights wanted = solve();
            double share = 1;
            for (Eigen::Index k = 0; k < wanted.size(); ++k) {
                if (wanted[k] <= 0) share = std::min(share, weights_[k] / (weights_[k] - wanted[k]));
            }
            if (!(share >= 0)) share = 0;
            const bool isWhole = (wanted.array() > 0).all();
            weights_ += (isWhole ? 1.0 : share) * (wanted - weights_);
            if (isWhole) return;
            drop(wanted);
        }
    }

    bool holds(std::size_t column) const {
        return std::find(members_.begin(), members_.end(), column) != members_.end();
    }

  private:
    Weights solve() const {
        Passive matrix(7, Eigen::Index(members_.size()));
        for (std::size_t k = 0; k < members_.size(); ++k) matrix.col(Eigen::Index(k)) = columns_[members_[k]];
        return matrix.colPivHouseholderQr().solve(Column::Unit(6));
    }

    /// Drops the columns whose weights have come to 0 on the way to the wanted ones: at least the one that came there first.
    void drop(const Weights& wanted) {
        std::size_t kept = 0;
        double least = std::numeric_limits<double>::infinity();
        for (Eigen::Index k = 0; k < wanted.size(); ++k) {
            if (wanted[k] <= 0) least = std::min(least, weights_[k]);
        }
        for (std::size_t k = 0; k < members_.size(); ++k) {
            const auto i = Eigen::Index(k);
            if (wanted[i] <= 0 && weights_[i] <= std::max(least, kTolerance)) continue;
            members_[kept] = members_[k];
            weights_[Eigen::Index(kept++)] = weights_[i];
        }
        members_.resize(kept);
        weights_.conservativeResize(Eigen::Index(kept));
    }

    const std::vector<Column>& columns_;
    std::vector<std::size_t> members_;
    Weights weights_;
};

}  // namespace

std::optional<Twist> leastTwist(const std::vector<TwistBound>& bounds) {
    double scale = 0;
    for (const TwistBound& bound : bounds) scale = std::max(scale, std::abs(bound.least));
    if (!(scale > 0)) return Twist::Zero();
    std::vector<Column> columns(bounds.size());
    for (std::size_t i = 0; i < bounds.size(); ++i) columns[i] << bounds[i].row, bounds[i].least / scale;
    PassiveSet passive(columns);
    Column residual = passive.residual();
    for (int round = 0; round < kMostAdditions && !passive.isFull(); ++round) {
        std::size_t best = columns.size();
        double steepest = kTolerance;
        for (std::size_t i = 0; i < columns.size(); ++i) {
            const double slope = columns[i].dot(residual);
            if (slope > steepest && !passive.holds(i)) {
                steepest = slope;
                best = i;
            }
        }
        if (best == columns.size()) break;
        passive.add(best);
        residual = passive.residual();
    }
    if (!(residual[6] > kTolerance)) return std::nullopt;
    return Twist(residual.head<6>() * (-scale / residual[6]));
}

}  // namespace clearway::planning
