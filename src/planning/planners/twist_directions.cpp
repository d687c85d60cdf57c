#include "planning/planners/twist_directions.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <optional>

#include "planning/improve/least_twist.h"

namespace clearway::planning {
namespace {

/// How far ahead the gaps stay open, as shares of half the diagonal of the part's box; a gap is the last one.
constexpr std::array<double, 4> kLookAheads = {2, 0.5, 0.1, 0.02};
constexpr int kRandomDirections = 10, kRefinements = 3;
constexpr double kLikeDirection = 0.98;  ///< cosine of twists that count as one
constexpr double kLeastLeft = 0.3;       ///< of a direction, when contacts have turned it aside

}  // namespace

/// Each direction of a first set is turned aside by the contacts until it leaves the gaps open for a length ahead.
TwistDirections directionsAlong(const std::vector<ContactRow>& rows, const Matrix3& axes,
                                const PartMoves& moves, double play, ompl::RNG& random) {
    Eigen::Matrix<double, 6, 6> sum = Eigen::Matrix<double, 6, 6>::Zero();
    for (const ContactRow& row : rows) sum += row.row * row.row.transpose();
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 6, 6>> spread(sum);
    std::vector<Twist> wanted;
    for (int k = 0; k < 6; ++k) wanted.push_back(spread.eigenvectors().col(k));
    for (int k = 0; k < 6; ++k) wanted.push_back(Twist::Unit(k));
    for (int k = 0; k < 3; ++k) {
        wanted.push_back((Twist() << axes.col(k), Vector3::Zero()).finished());
        wanted.push_back((Twist() << Vector3::Zero(), axes.col(k)).finished());
    }
    for (int k = 0; k < kRandomDirections; ++k) {
        Twist drawn;
        for (int i = 0; i < 6; ++i) drawn[i] = random.gaussian01();
        wanted.push_back(drawn);
    }
    TwistDirections directions;
    std::vector<TwistBound> bounds(rows.size());
    std::vector<double> aheads;
    for (const double share : kLookAheads) aheads.push_back(share * moves.radius());
    aheads.push_back(play);
    const auto keep = [&](const Twist& found, std::vector<Twist>& kept) {
        for (const std::vector<Twist>* known : {&directions.open, &directions.late}) {
            for (const Twist& each : *known) {
                if (each.dot(found) > kLikeDirection) return;
            }
        }
        kept.push_back(found);
    };
    for (Twist each : wanted) {
        if (moves.isPlanar()) each(2) = each(3) = each(4) = 0;
        if (!(each.norm() > 1e-6)) continue;
        each.normalize();
        for (const double sign : {1.0, -1.0}) {
            for (const double ahead : aheads) {
                Twist direction = sign * each;
                bool isOpen = true;
                for (int k = 0; k < kRefinements && isOpen; ++k) {
                    for (std::size_t i = 0; i < rows.size(); ++i) {
                        bounds[i] = {rows[i].row,
                                     -std::max(0.0, rows[i].gap) / ahead - rows[i].row.dot(direction)};
                    }
                    const std::optional<Twist> aside = leastTwist(bounds);
                    isOpen = aside && (direction + *aside).norm() > kLeastLeft;
                    if (isOpen) direction = (direction + *aside).normalized();
                }
                if (isOpen) keep(direction, ahead == play ? directions.late : directions.open);
            }
        }
    }
    return directions;
}

}  // namespace clearway::planning
