// The one traversal: depth first through pairs of volumes, the nearer child first. A visitor says which
// bounds it can drop, takes the near pairs of triangles, and says when it has its answer.
//
// A visitor has
//   float dropFrom() const   query units: pairs of volumes at least this far apart are of no interest
//   bool done() const        whether the traversal may stop
// and the members that TakeNear asks for.
#include "hwy/highway.h"
#include "kernels/rss_lower_bound-inl.h"
#include "query/leaf_pairs-inl.h"
#include "query/pair_query.h"
#include "query/queries.h"

#if defined(CLEARWAY_QUERY_TRAVERSE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef CLEARWAY_QUERY_TRAVERSE_INL_H_
#undef CLEARWAY_QUERY_TRAVERSE_INL_H_
#else
#define CLEARWAY_QUERY_TRAVERSE_INL_H_
#endif

HWY_BEFORE_NAMESPACE();
namespace clearway {
namespace HWY_NAMESPACE {

/// The environment is opened first unless the part's volume is larger by this factor. Measured: among the
/// volumes' lengths, areas and products of both, WideNode::size visits the fewest nodes, 10 to 20 % fewer
/// than lengths.
constexpr float kOpenPartRatio = 1.22f;

/// Carries one lane's volume into the frame and unit of the other tree.
template <int kWidth>
HWY_INLINE CarriedRss CarryVolume(const Carry& carry, const WideNode<kWidth>& node, int lane) {
    const hn::CappedTag<float, 4> d;
    CarriedRss carried;
    for (size_t i = 0; i < 4; i += hn::Lanes(d)) {
        const auto column = [&](int k) HWY_ATTR { return hn::Load(d, carry.columns[k] + i); };
        const auto rotated = [&](const float(&rows)[3][kWidth]) HWY_ATTR {
            auto sum = hn::Mul(column(2), hn::Set(d, rows[2][lane]));
            sum = hn::MulAdd(column(1), hn::Set(d, rows[1][lane]), sum);
            return hn::MulAdd(column(0), hn::Set(d, rows[0][lane]), sum);
        };
        const auto centre =
            hn::MulAdd(rotated(node.centre), hn::Set(d, carry.ratio), hn::Load(d, carry.translation + i));
        hn::StoreU(centre, d, carried.centre + i);
        hn::StoreU(rotated(node.axis0), d, carried.axis0 + i);
        hn::StoreU(rotated(node.axis1), d, carried.axis1 + i);
    }
    carried.halfLength0 = node.halfLength0[lane] * carry.ratio;
    carried.halfLength1 = node.halfLength1[lane] * carry.ratio;
    carried.radius = node.radius[lane] * carry.ratio;
    return carried;
}

/// A volume: its node, its lane there and its child.
template <int kWidth>
struct Volume {
    HWY_INLINE Volume(const FlatTree& tree, VolumeReference reference)
        : node(tree.nodes<kWidth>()[reference / kWidth]),
          lane(int(reference % kWidth)),
          child(node.child[lane]) {}
    const WideNode<kWidth>& node;
    int lane;
    std::int32_t child;
    HWY_INLINE bool isLeaf() const { return child < 0; }
    HWY_INLINE LeafReference leaf() const { return LeafReference(~child); }
};

/// The result of opening one volume of a pair: bounds between the volume's children and the other volume.
template <int kWidth>
struct Opening {
    alignas(64) float bounds[kWidth];
    NearChildren near;
    StackEntry entry;
    VolumeReference opened;
    bool openPart;
};

/// Whether to open the part's volume rather than the environment's.
template <int kWidth>
HWY_INLINE bool OpensPart(const PairQuery& query, const Volume<kWidth>& a, const Volume<kWidth>& b) {
    return b.isLeaf() ||
           (!a.isLeaf() && a.node.size[a.lane] * query.partLeafToQuery >
                               kOpenPartRatio * b.node.size[b.lane] * query.environmentLeafToQuery);
}

/// Opens one volume of the pair and bounds the distances of its children from the other volume.
template <int kWidth, bool kIsExact>
HWY_INLINE void Open(const PairQuery& query, const StackEntry& entry, const Volume<kWidth>& a,
                     const Volume<kWidth>& b, float dropFrom, Opening<kWidth>& opening) {
    const bool openPart = OpensPart(query, a, b);
    const Carry& carry = openPart ? query.environmentToPart : query.partToEnvironment;
    const std::int32_t opened = openPart ? a.child : b.child;
    const WideNode<kWidth>& node = (openPart ? *query.part : *query.environment).nodes<kWidth>()[opened];
    const Volume<kWidth>& other = openPart ? b : a;
    const CarriedRss one = CarryVolume(carry, other.node, other.lane);
    opening.near =
        RssLowerBounds<kWidth, kIsExact>(one, node, carry.slack, carry.toQueryUnit, dropFrom, opening.bounds);
    opening.entry = entry;
    opening.opened = VolumeReference(opened) * kWidth;
    opening.openPart = openPart;
}

/// Pushes the near children, the nearest last. Negative bounds are kept, because they tell which overlap is
/// deepest.
template <int kWidth>
HWY_INLINE void PushNear(const Opening<kWidth>& opening, Pile<StackEntry>& stack) {
    const std::size_t base = stack.size();
    for (std::uint32_t left = opening.near.lanes; left != 0; left &= left - 1) {
        const std::uint32_t lane = LowestBit(left);
        const VolumeReference child = opening.opened + lane;
        const float bound = opening.bounds[lane];
        const StackEntry added = opening.openPart ? StackEntry{bound, child, opening.entry.environment}
                                                  : StackEntry{bound, opening.entry.part, child};
        stack.push(added);
        std::size_t place = stack.size() - 1;
        for (; place > base && stack[place - 1].bound < bound; --place) stack[place] = stack[place - 1];
        stack[place] = added;
    }
}

/// Traverses both trees until the visitor is done or no pair of volumes is left. kIsExact: as in RssLowerBounds.
template <int kWidth, bool kIsExact = kWidth == 2, class Visitor>
HWY_INLINE void Traverse(const PairQuery& query, Workspace::State& state, Visitor& visitor) {
    const FlatTree& part = *query.part;
    const FlatTree& environment = *query.environment;
    Pile<StackEntry>& stack = state.stack;
    stack.clear();
    stack.push({-hwy::HighestValue<float>(), 0, 0});

    // Neither popping 2, 3 or 4 pairs at once, for the processor to bound them side by side, nor prefetching
    // pushed children gained anything when measured: arithmetic is the limit.
    Opening<kWidth> opening;
    LeafPairs leaves;
    WaitingPairs waiting;
    while (!stack.empty() && !visitor.done()) {
        const StackEntry entry = stack.pop();
        if (entry.bound >= visitor.dropFrom()) continue;
        const Volume<kWidth> a(part, entry.part), b(environment, entry.environment);
        if (a.isLeaf() && b.isLeaf()) {
            const Leaf partLeaf = part.leaf(a.leaf()), environmentLeaf = environment.leaf(b.leaf());
            leaves.meet(query, partLeaf, environmentLeaf, entry.bound, visitor.dropFrom());
            state.counters.triangleTests += std::uint64_t(leaves.total());
            state.counters.triangleLanes += std::uint64_t(leaves.lanes());
            leaves.visit(waiting, visitor);
        } else {
            Open<kWidth, kIsExact>(query, entry, a, b, visitor.dropFrom(), opening);
            ++state.counters.nodeVisits;
            state.counters.volumeTests += opening.near.children;
            PushNear(opening, stack);
        }
    }
    if (!visitor.done() && waiting.count > 0) waiting.take(visitor);
    state.counters.kernelPairs += waiting.kernelPairs + leaves.kernelPairs();
    state.counters.kernelLanes += waiting.kernelLanes + leaves.kernelLanes();
}

}  // namespace HWY_NAMESPACE
}  // namespace clearway
HWY_AFTER_NAMESPACE();

#endif
