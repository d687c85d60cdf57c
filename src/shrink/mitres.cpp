#include "shrink/mitres.h"

#include <algorithm>
#include <cmath>

#include "shrink/nearest_triangle.h"

namespace clearway {
namespace {

constexpr double kLowSliver = 0.02;   ///< of the faces' move: lower triangles take a neighbour's normal,
constexpr double kFlatSliver = 1e-7;  ///< and those that are lower by this share of their longest edge
constexpr int kNormalRounds = 8;      ///< a sliver's neighbour may be a sliver, too
constexpr double kLongestMove =
    100;  ///< times the depth; faces that need more meet like the two sides of a sheet
constexpr double kTooShallow = 0.98;  ///< of the faces' move
constexpr double kShallowWeight =
    100;  ///< a place that is too shallow is so many times as bad as one that is too deep
constexpr int kMostSplits = 4;          ///< of the faces around a vertex that have one place
constexpr std::size_t kMostTried = 24;  ///< faces of a vertex for all pairs of cuts to be tried
constexpr double kAlike = 1e-9;         ///< between the normals of faces in one plane

double angleBetween(const Vector3& a, const Vector3& b) {
    return 2 * std::atan2((a - b).norm(), (a + b).norm());
}

/// On the great circle between two unit vectors that are not opposite.
Vector3 between(const Vector3& a, const Vector3& b, double share) {
    const double angle = angleBetween(a, b);
    if (angle < kAlike) return a;
    return ((std::sin((1 - share) * angle) * a + std::sin(share * angle) * b) / std::sin(angle)).normalized();
}

class Mitres {
  public:
    Mitres(const OrientedSurface& surface, const MitreDepths& depths)
        : surface_(surface),
          depths_(depths),
          widest_(2 * std::acos(std::min(1.0, depths.face / depths.most))),
          chains_(surface.across.size()),
          placeOf_(surface.across.size(), 0) {
        findNormals();
    }

    MovedSurface run() {
        std::vector<bool> isDone(surface_.across.size(), false);
        for (std::uint32_t side = 0; side < isDone.size(); ++side) {
            if (isDone[side]) continue;
            findRing(side);
            moveVertex();
            for (const std::uint32_t corner : ring_) isDone[corner] = true;
        }
        for (std::uint32_t t = 0; t < surface_.triangles.size(); ++t) {
            add({placeOf_[3 * t], placeOf_[3 * t + 1], placeOf_[3 * t + 2]}, 3 * t);
        }
        for (std::uint32_t side = 0; side < surface_.across.size(); ++side) {
            if (side < surface_.across[side]) addStrip(side);
        }
        return std::move(moved_);
    }

  private:
    /// Faces around a vertex, first to last, that have one place.
    struct Cluster {
        std::size_t first, count;  ///< positions in the ring
        Vector3 move;
        double badness;
    };

    /// Between two neighbouring faces of a ring.
    struct Gap {
        std::vector<Vector3> planes;  ///< normals of the bevel between them
        bool isCut = false;
    };

    void findNormals() {
        const std::size_t count = surface_.triangles.size();
        normals_.assign(count, Vector3::Zero());
        std::vector<std::uint32_t> slivers, sides;
        for (std::uint32_t t = 0; t < count; ++t) {
            const auto [a, b, c] = surface_.corners(t);
            const Vector3 normal = (b - a).cross(c - a);
            const std::array<double, 3> lengths = {(b - a).norm(), (c - b).norm(), (a - c).norm()};
            const auto longest = std::max_element(lengths.begin(), lengths.end()) - lengths.begin();
            const double length = lengths[static_cast<std::size_t>(longest)], height = normal.norm() / length;
            if (height > std::max(kLowSliver * depths_.face, kFlatSliver * length)) {
                normals_[t] = normal.normalized();
            } else {
                slivers.push_back(t);
                sides.push_back(3 * t + static_cast<std::uint32_t>(longest));
            }
        }
        for (int round = 0; round < kNormalRounds; ++round) {
            for (std::size_t i = 0; i < slivers.size(); ++i) {
                if (normals_[slivers[i]].isZero())
                    normals_[slivers[i]] = normals_[OrientedSurface::triangleOf(surface_.across[sides[i]])];
            }
        }
    }

    /// Finds the corners around a vertex, each named by the side that leaves it. Gap i is between corners i and i + 1.
    void findRing(std::uint32_t first) {
        ring_.clear();
        std::uint32_t side = first;
        do {
            ring_.push_back(side);
            side = surface_.across[OrientedSurface::previousSide(side)];
        } while (side != first);
    }

    const Vector3& normalAt(std::size_t i) const {
        return normals_[OrientedSurface::triangleOf(ring_[i % ring_.size()])];
    }

    /// The side that ends at the vertex, between corners i and i + 1.
    std::uint32_t gapSide(std::size_t i) const { return OrientedSurface::previousSide(ring_[i]); }

    /// The planes with which a concave edge is bevelled, from the face before it to the one behind it.
    std::vector<Vector3> bevelAt(std::size_t i) const {
        const Vector3 &a = normalAt(i), &b = normalAt(i + 1);
        if (a.isZero() || b.isZero()) return {};
        const std::uint32_t other = surface_.across[gapSide(i)];
        const Vector3 apex = surface_.vertices[surface_.to(OrientedSurface::nextSide(other))] -
                             surface_.vertices[surface_.from(other)];
        if (a.dot(apex) <= 0) return {};  // convex
        const int planes = static_cast<int>(std::ceil(angleBetween(a, b) / widest_)) - 1;
        std::vector<Vector3> found;
        for (int k = 1; k <= planes; ++k) found.push_back(between(a, b, double(k) / (planes + 1)));
        return found;
    }

    void moveVertex() {
        vertex_ = surface_.from(ring_[0]);
        const std::size_t count = ring_.size();
        gaps_.assign(count, {});
        for (std::size_t i = 0; i < count; ++i) {
            gaps_[i].planes = bevelAt(i);
            gaps_[i].isCut = !gaps_[i].planes.empty();
        }
        clusters_.clear();
        const auto cut = std::find_if(gaps_.begin(), gaps_.end(), [](const Gap& gap) { return gap.isCut; });
        if (cut == gaps_.end()) {
            clusters_.push_back(clusterOf(0, count));
        } else {
            const auto start = static_cast<std::size_t>(cut - gaps_.begin()) + 1;
            for (std::size_t i = 0, from = 0; i < count; ++i) {
                if (!gaps_[(start + i) % count].isCut) continue;
                clusters_.push_back(clusterOf(start + from, i + 1 - from));
                from = i + 1;
            }
        }
        for (int k = 0; k < kMostSplits && splitWorst(); ++k) {
        }
        takePlaces();
    }

    bool isWholeRing(std::size_t first, std::size_t count) const {
        return count == ring_.size() && !gaps_[(first + count - 1) % ring_.size()].isCut;
    }

    /// The normals of the faces, and across each cut those of the next plane.
    std::vector<Vector3> planesOf(std::size_t first, std::size_t count) const {
        std::vector<Vector3> planes;
        const auto take = [&](const Vector3& normal) {
            const auto isAlike = [&](const Vector3& other) { return (other - normal).norm() <= kAlike; };
            if (!normal.isZero() && std::none_of(planes.begin(), planes.end(), isAlike))
                planes.push_back(normal);
        };
        for (std::size_t i = 0; i < count; ++i) take(normalAt(first + i));
        if (!isWholeRing(first, count)) {
            const std::size_t size = ring_.size();
            const Gap &before = gaps_[(first + size - 1) % size], &after = gaps_[(first + count - 1) % size];
            take(before.planes.empty() ? normalAt(first + size - 1) : before.planes.back());
            take(after.planes.empty() ? normalAt(first + count) : after.planes.front());
        }
        return planes;
    }

    Vector3 moveBy(const std::vector<Vector3>& planes) const {
        if (planes.empty()) return Vector3::Zero();
        if (const auto move = shortestMove(planes, depths_.face)) return *move;
        Vector3 mean = Vector3::Zero();
        for (const Vector3& plane : planes) mean += plane;
        return -depths_.face / static_cast<double>(planes.size()) * mean;
    }

    Cluster clusterOf(std::size_t first, std::size_t count) const {
        Cluster cluster{first % ring_.size(), count, moveBy(planesOf(first, count)), 0};
        cluster.badness = badnessOf(cluster);
        return cluster;
    }

    /// By how much the place is too deep below the cluster's own faces, or too shallow below any face of the ring.
    double badnessOf(const Cluster& cluster) const {
        const Vector3 place = surface_.vertices[vertex_] + cluster.move;
        const bool isFar = cluster.move.norm() > depths_.most;
        double worst = 0;
        for (std::size_t i = 0; i < ring_.size(); ++i) {
            const std::uint32_t triangle = OrientedSurface::triangleOf(ring_[i]);
            const Vector3& normal = normals_[triangle];
            if (normal.isZero()) continue;
            const double distance = distanceTo(place, triangle);
            const bool isOwn = (i + ring_.size() - cluster.first) % ring_.size() < cluster.count;
            if (isOwn && isFar && !isNearAnother(place, normal, i))
                worst = std::max(worst, distance - depths_.most);
            const double height = -normal.dot(cluster.move);
            const double depth = height < 0 && distance < 2 * depths_.face ? -distance : distance;
            worst = std::max(worst, kShallowWeight * (kTooShallow * depths_.face - depth));
        }
        return worst;
    }

    /// Whether the place is near enough to another face of the ring in the same plane.
    bool isNearAnother(const Vector3& place, const Vector3& normal, std::size_t except) const {
        for (std::size_t i = 0; i < ring_.size(); ++i) {
            if (i == except || (normalAt(i) - normal).norm() > kAlike) continue;
            if (distanceTo(place, OrientedSurface::triangleOf(ring_[i])) <= depths_.most) return true;
        }
        return false;
    }

    double distanceTo(const Vector3& point, std::uint32_t triangle) const {
        return distanceToTriangle(point, surface_.corners(triangle));
    }

    /// Splits the worst cluster where that helps most. Returns false when there is nothing to gain.
    bool splitWorst() {
        const auto worst =
            std::max_element(clusters_.begin(), clusters_.end(),
                             [](const Cluster& a, const Cluster& b) { return a.badness < b.badness; });
        if (worst->badness <= 0 || ring_.size() < 2) return false;
        const Cluster cluster = *worst;
        const std::size_t size = ring_.size();
        std::vector<Cluster> best;
        double least = cluster.badness;
        const auto tryCuts = [&](std::size_t first, std::size_t count, std::size_t at) {
            std::vector<std::size_t> cut;
            for (const std::size_t gap : {(first + at - 1) % size, (first + count - 1) % size}) {
                if (!gaps_[gap].isCut) cut.push_back(gap);
                gaps_[gap].isCut = true;
            }
            const Cluster one = clusterOf(first, at), two = clusterOf(first + at, count - at);
            const double badness = std::max(one.badness, two.badness);
            if (badness < least) {
                least = badness;
                best = {one, two};
            }
            for (const std::size_t gap : cut) gaps_[gap].isCut = false;
        };
        const std::size_t starts =
            isWholeRing(cluster.first, cluster.count) && size <= kMostTried ? size - 1 : 1;
        for (std::size_t start = 0; start < starts; ++start) {
            for (std::size_t at = 1; start + at < cluster.count; ++at)
                tryCuts(cluster.first + start, cluster.count, at);
        }
        if (best.empty()) return false;
        for (const Cluster& half : best) gaps_[(half.first + half.count - 1) % size].isCut = true;
        *worst = best[0];
        clusters_.insert(worst + 1, best[1]);
        return true;
    }

    std::uint32_t addPlace(const Vector3& move) {
        moved_.places.push_back({vertex_, move});
        return static_cast<std::uint32_t>(moved_.places.size()) - 1;
    }

    void add(const std::array<std::uint32_t, 3>& places, std::uint32_t side) {
        if (places[0] == places[1] || places[1] == places[2] || places[2] == places[0]) return;
        moved_.triangles.push_back({places, side});
    }

    /// Gives the corners their places, each cut edge's end the places across it, and the vertex the patch between them.
    void takePlaces() {
        std::vector<std::uint32_t> own(clusters_.size()), around;
        for (std::size_t k = 0; k < clusters_.size(); ++k) {
            own[k] = addPlace(clusters_[k].move);
            for (std::size_t i = 0; i < clusters_[k].count; ++i)
                placeOf_[ring_[(clusters_[k].first + i) % ring_.size()]] = own[k];
        }
        for (std::size_t k = 0; k < clusters_.size(); ++k) {
            const std::size_t last = (clusters_[k].first + clusters_[k].count - 1) % ring_.size();
            around.push_back(own[k]);
            if (!gaps_[last].isCut) continue;
            std::vector<std::uint32_t>& chain = chains_[gapSide(last)];
            chain = {own[k]};
            for (std::size_t i = 1; i < gaps_[last].planes.size(); ++i)
                chain.push_back(addPlace(moveBy({gaps_[last].planes[i - 1], gaps_[last].planes[i]})));
            around.insert(around.end(), chain.begin() + 1, chain.end());
            chain.push_back(own[(k + 1) % own.size()]);
        }
        addPatch(around);
    }

    void addPatch(const std::vector<std::uint32_t>& around) {
        const std::size_t count = around.size();
        if (count < 3) return;
        if (count == 3) return add({around[0], around[1], around[2]}, ring_[0]);
        Vector3 mean = Vector3::Zero();
        for (const std::uint32_t place : around) mean += moved_.places[place].move.normalized();
        const std::uint32_t middle = addPlace(depths_.face * mean.normalized());
        for (std::size_t i = 0; i < count; ++i) add({middle, around[i], around[(i + 1) % count]}, ring_[0]);
    }

    /// The strip between the two faces at an edge, with the places at each of its ends.
    void addStrip(std::uint32_t side) {
        const std::uint32_t back = surface_.across[side];
        const auto placesAt = [&](const std::vector<std::uint32_t>& chain, std::uint32_t corner) {
            return chain.empty() ? std::vector<std::uint32_t>{placeOf_[corner]} : chain;
        };
        // Each chain leads from the face whose side ends at the vertex to the next one.
        const std::vector<std::uint32_t> head = placesAt(chains_[side], OrientedSurface::nextSide(side));
        std::vector<std::uint32_t> tail = placesAt(chains_[back], side);
        std::reverse(tail.begin(), tail.end());
        std::size_t h = 0, t = 0;
        while (h + 1 < head.size() || t + 1 < tail.size()) {
            const bool isTail =
                h + 1 == head.size() ||
                (t + 1 < tail.size() && (t + 1) * (head.size() - 1) <= (h + 1) * (tail.size() - 1));
            if (isTail) {
                add({head[h], tail[t], tail[t + 1]}, side);
                ++t;
            } else {
                add({head[h], tail[t], head[h + 1]}, side);
                ++h;
            }
        }
    }

    const OrientedSurface& surface_;
    const MitreDepths depths_;
    const double widest_;  ///< turn of a concave edge that needs no bevel
    std::vector<Vector3> normals_;
    std::vector<std::vector<std::uint32_t>>
        chains_;  ///< for each side the places at its end, from face to face; empty: one place
    std::vector<std::uint32_t> placeOf_;  ///< of each corner, named by the side that leaves it
    MovedSurface moved_;

    std::uint32_t vertex_ = 0;  ///< the one that moves
    std::vector<std::uint32_t> ring_;
    std::vector<Gap> gaps_;
    std::vector<Cluster> clusters_;
};

}  // namespace

MovedSurface mitred(const OrientedSurface& surface, const MitreDepths& depths) {
    return Mitres(surface, depths).run();
}

/// At the shortest move one to three planes are just kept, which decide it.
std::optional<Vector3> shortestMove(const std::vector<Vector3>& normals, double depth) {
    const std::size_t count = normals.size();
    const auto isKept = [&](const Vector3& move) {
        return std::all_of(normals.begin(), normals.end(),
                           [&](const Vector3& normal) { return normal.dot(move) <= -(1 - kAlike) * depth; });
    };
    double least = kLongestMove * depth;
    for (const Vector3& normal : normals) {
        if (isKept(-depth * normal)) return -depth * normal;
    }
    for (std::size_t i = 0; i < count; ++i) {
        for (std::size_t k = i + 1; k < count; ++k) {
            const Vector3 sum = normals[i] + normals[k];
            const Vector3 move = -2 * depth / sum.squaredNorm() * sum;
            if (move.norm() < least && isKept(move)) return move;
        }
    }
    std::optional<Vector3> shortest;
    for (std::size_t i = 0; i < count; ++i) {
        for (std::size_t j = i + 1; j < count; ++j) {
            for (std::size_t k = j + 1; k < count; ++k) {
                const Vector3 across = (normals[j] - normals[i]).cross(normals[k] - normals[i]);
                const Vector3 move = -depth / across.dot(normals[i]) * across;
                if (!(move.norm() < least) || !isKept(move)) continue;
                least = move.norm();
                shortest = move;
            }
        }
    }
    return shortest;
}

}  // namespace clearway
