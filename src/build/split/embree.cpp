// Embree's builder as a general split: Embree builds a tree over the triangles' boxes, which is then copied.
#if CLEARWAY_EMBREE_MAJOR >= 4
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

#include <tbb/task_arena.h>

#include <memory>
#include <new>
#include <stdexcept>
#include <string>
#include <utility>

#include "build/general_splits.h"
#include "core/parallel.h"
#include "tree/normalisation.h"

namespace clearway {

namespace {

/// A node of the tree that Embree builds in its own memory.
struct Node {
    Node* children[2];  ///< null for a leaf
    std::uint32_t firstTriangle;
    std::uint32_t triangleCount;
};

struct ReleaseDevice {
    void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
};
struct ReleaseBvh {
    void operator()(RTCBVH bvh) const { rtcReleaseBVH(bvh); }
};
using Device = std::unique_ptr<RTCDeviceTy, ReleaseDevice>;
using Bvh = std::unique_ptr<RTCBVHTy, ReleaseBvh>;

[[noreturn]] void fail(const std::string& what, RTCDevice device) {
    throw std::runtime_error(what + ": Embree reports error " +
                             std::to_string(static_cast<int>(rtcGetDeviceError(device))));
}

/// The one device of the process: making a device takes longer than building a small tree. The device itself
/// is not limited to one thread, because Embree would then limit all of oneTBB, including the rest of the
/// build and the caller's own work.
RTCDevice device() {
    static const Device shared(rtcNewDevice("set_affinity=0"));
    if (shared == nullptr) fail("Embree cannot be started", nullptr);
    return shared.get();
}

/// The triangles' boxes, in coordinates that floats can hold.
std::vector<RTCBuildPrimitive> boxesOf(const CleanMesh& mesh, const std::vector<std::uint32_t>& triangles) {
    const Normalisation normalised = normalisationOf(mesh.vertices);
    std::vector<RTCBuildPrimitive> boxes(triangles.size());
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        Eigen::AlignedBox3f box;
        for (const std::uint32_t vertex : mesh.triangles[triangles[i]])
            box.extend(normalised(mesh.vertices[vertex]).cast<float>());
        RTCBuildPrimitive& stored = boxes[i];
        stored.lower_x = box.min().x();
        stored.lower_y = box.min().y();
        stored.lower_z = box.min().z();
        stored.upper_x = box.max().x();
        stored.upper_y = box.max().y();
        stored.upper_z = box.max().z();
        stored.geomID = 0;
        stored.primID = triangles[i];
    }
    return boxes;
}

Node* newNode(RTCThreadLocalAllocator allocator) {
    return new (rtcThreadLocalAlloc(allocator, sizeof(Node), alignof(Node))) Node{};
}

void* createNode(RTCThreadLocalAllocator allocator, unsigned, void*) {
    return newNode(allocator);
}

void setChildren(void* node, void** children, unsigned count, void*) {
    for (unsigned i = 0; i < count; ++i)
        static_cast<Node*>(node)->children[i] = static_cast<Node*>(children[i]);
}

void ignoreBounds(void*, const RTCBounds**, unsigned, void*) {}

/// Makes a leaf. The builder sorts its primitives in place, so a leaf's primitives are a run of them.
void* createLeaf(RTCThreadLocalAllocator allocator, const RTCBuildPrimitive* first, std::size_t count,
                 void* allPrimitives) {
    Node* leaf = newNode(allocator);
    leaf->firstTriangle =
        static_cast<std::uint32_t>(first - static_cast<const RTCBuildPrimitive*>(allPrimitives));
    leaf->triangleCount = static_cast<std::uint32_t>(count);
    return leaf;
}

const Node* build(RTCBVH bvh, std::vector<RTCBuildPrimitive>& boxes, std::size_t largestGroup) {
    RTCBuildArguments arguments = rtcDefaultBuildArguments();
    arguments.maxDepth = 64;
    arguments.minLeafSize = static_cast<unsigned>(largestGroup);  // groups are what the leaf split is for
    arguments.maxLeafSize = static_cast<unsigned>(largestGroup);
    arguments.bvh = bvh;
    arguments.primitives = boxes.data();
    arguments.primitiveCount = boxes.size();
    arguments.primitiveArrayCapacity = boxes.size();
    arguments.createNode = createNode;
    arguments.setNodeChildren = setChildren;
    arguments.setNodeBounds = ignoreBounds;
    arguments.createLeaf = createLeaf;
    arguments.userPtr = boxes.data();
    mayShareWork();  // remembers that this process uses TBB, which Embree does
    tbb::task_arena alone(1);
    const void* root = alone.execute([&] { return rtcBuildBVH(&arguments); });
    if (root == nullptr)
        fail("Embree cannot build a tree of " + std::to_string(boxes.size()) + " boxes", device());
    return static_cast<const Node*>(root);
}

/// Copies the tree depth first; the leaves' triangles follow in that order.
BinaryTree binaryTreeOf(const Node* root, const std::vector<RTCBuildPrimitive>& boxes) {
    struct Pending {
        const Node* source;
        std::size_t node;
    };
    BinaryTree tree;
    tree.order.reserve(boxes.size());
    tree.nodes.emplace_back();
    std::vector<Pending> pending{{root, 0}};
    while (!pending.empty()) {
        const auto [source, index] = pending.back();
        pending.pop_back();
        tree.nodes[index].firstTriangle = static_cast<std::uint32_t>(tree.order.size());
        if (source->children[0] == nullptr) {
            tree.nodes[index].triangleCount = source->triangleCount;
            for (std::uint32_t i = 0; i < source->triangleCount; ++i)
                tree.order.push_back(boxes[source->firstTriangle + i].primID);
            continue;
        }
        const std::size_t left = tree.nodes.size();
        tree.nodes[index].left = static_cast<std::int32_t>(left);
        tree.nodes[index].right = static_cast<std::int32_t>(left + 1);
        tree.nodes.resize(left + 2);
        pending.push_back({source->children[1], left + 1});
        pending.push_back({source->children[0], left});
    }
    for (std::size_t i = tree.nodes.size(); i-- > 0;) {
        BinaryNode& node = tree.nodes[i];
        if (!node.isLeaf())
            node.triangleCount = tree.nodes[node.left].triangleCount + tree.nodes[node.right].triangleCount;
    }
    return tree;
}

}  // namespace

BinaryTree buildByEmbree(const CleanMesh& mesh, std::vector<std::uint32_t> triangles,
                         std::size_t largestGroup) {
    std::vector<RTCBuildPrimitive> boxes = boxesOf(mesh, triangles);
    const Bvh bvh(rtcNewBVH(device()));
    if (bvh == nullptr) fail("Embree cannot make a tree", device());
    return binaryTreeOf(build(bvh.get(), boxes, largestGroup), boxes);
}

}  // namespace clearway
