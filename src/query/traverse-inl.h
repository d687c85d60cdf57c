// The one traversal: depth first through pairs of volumes, the nearer child first. A visitor says which
// bounds it can drop, takes the pairs of leaves, and says when it has its answer.
//
// A visitor has
//   bool drops(float bound) const    a pair of volumes whose distance is at least bound (query units) is of
//   no interest void leaves(float bound, const Leaf& part, const Leaf& environment) bool done() const
#include "hwy/highway.h"
#include "kernels/rss_lower_bound-inl.h"
#include "query/pair_query.h"
#include "query/workspace_state.h"

#if defined(CLEARWAY_QUERY_TRAVERSE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef CLEARWAY_QUERY_TRAVERSE_INL_H_
#undef CLEARWAY_QUERY_TRAVERSE_INL_H_
#else
#define CLEARWAY_QUERY_TRAVERSE_INL_H_
#endif

HWY_BEFORE_NAMESPACE();
namespace clearway {
namespace HWY_NAMESPACE {

/// The environment is opened first unless the part is longer by this factor. Source: measured, 1 to 2 is
/// flat.
constexpr float kOpenPartRatio = 1.5f;

/// R v.
HWY_INLINE void Rotate(const float* R, const float* v, float* out) {
    for (int row = 0; row < 3; ++row)
        out[row] = R[3 * row] * v[0] + R[3 * row + 1] * v[1] + R[3 * row + 2] * v[2];
}

template <int kWidth>
HWY_INLINE CarriedRss CarryVolume(const Carry& carry, const WideNode<kWidth>& node, int lane) {
    const auto gather = [&](const float(&rows)[3][kWidth], float* out) HWY_ATTR {
        for (int k = 0; k < 3; ++k) out[k] = rows[k][lane];
    };
    float centre[3], axis0[3], axis1[3];
    gather(node.centre, centre);
    gather(node.axis0, axis0);
    gather(node.axis1, axis1);

    CarriedRss carried;
    Rotate(carry.rotation, centre, carried.centre);
    Rotate(carry.rotation, axis0, carried.axis0);
    Rotate(carry.rotation, axis1, carried.axis1);
    const float* x = carried.axis0;
    const float* y = carried.axis1;
    for (int k = 0; k < 3; ++k) {
        carried.centre[k] = carried.centre[k] * carry.ratio + carry.translation[k];
        carried.axis2[k] = x[(k + 1) % 3] * y[(k + 2) % 3] - x[(k + 2) % 3] * y[(k + 1) % 3];
    }
    carried.halfLength0 = node.halfLength0[lane] * carry.ratio;
    carried.halfLength1 = node.halfLength1[lane] * carry.ratio;
    carried.radius = node.radius[lane] * carry.ratio;
    return carried;
}

/// A volume's node, lane and child.
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
};

template <int kWidth, class Visitor>
HWY_INLINE void Traverse(const PairQuery& query, Workspace::State& state, Visitor& visitor) {
    const FlatTree& part = *query.part;
    const FlatTree& environment = *query.environment;
    Pile<StackEntry>& stack = state.stack;
    stack.clear();
    stack.push({-hwy::HighestValue<float>(), 0, 0});

    while (!stack.empty() && !visitor.done()) {
        const StackEntry entry = stack.pop();
        if (visitor.drops(entry.bound)) continue;
        const Volume<kWidth> a(part, entry.part), b(environment, entry.environment);
        if (a.isLeaf() && b.isLeaf()) {
            visitor.leaves(entry.bound, part.leaves[~a.child], environment.leaves[~b.child]);
            continue;
        }
        const bool openPart = b.isLeaf() || (!a.isLeaf() && a.node.length[a.lane] * query.partLeafToQuery >
                                                                kOpenPartRatio * b.node.length[b.lane] *
                                                                    query.environmentLeafToQuery);
        const Carry& carry = openPart ? query.environmentToPart : query.partToEnvironment;
        const std::int32_t opened = openPart ? a.child : b.child;
        const WideNode<kWidth>& node = (openPart ? part : environment).nodes<kWidth>()[opened];
        const CarriedRss one =
            openPart ? CarryVolume(carry, b.node, b.lane) : CarryVolume(carry, a.node, a.lane);

        HWY_ALIGN float bounds[kWidth];
        RssLowerBounds(one, node, carry.slack, bounds);
        ++state.counters.nodeVisits;

        // Negative bounds stay as they are: they tell which overlap is deepest. Insertion keeps the least on
        // top.
        const std::size_t base = stack.size();
        for (int lane = 0; lane < kWidth && node.child[lane] != kNoChild; ++lane) {
            ++state.counters.volumeTests;
            const float bound = bounds[lane] * carry.toQueryUnit;
            if (visitor.drops(bound)) continue;
            const VolumeReference child = VolumeReference(opened) * kWidth + VolumeReference(lane);
            stack.push(openPart ? StackEntry{bound, child, entry.environment}
                                : StackEntry{bound, entry.part, child});
            const StackEntry added = stack[stack.size() - 1];
            std::size_t place = stack.size() - 1;
            for (; place > base && stack[place - 1].bound < bound; --place) stack[place] = stack[place - 1];
            stack[place] = added;
        }
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace clearway
HWY_AFTER_NAMESPACE();

#endif
