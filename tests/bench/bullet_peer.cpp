#include <BulletCollision/CollisionShapes/btTriangleIndexVertexArray.h>
#include <BulletCollision/Gimpact/btGImpactShape.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkEpa2.h>

#include <chrono>
#include <memory>

#include "bench/peer.h"

namespace clearway::testing {
namespace {

/// A mesh with GImpact's tree. Bullet keeps pointers to the corners and to the triangles.
class BulletMesh {
  public:
    explicit BulletMesh(const Mesh& mesh) {
        for (const Vector3& v : mesh.vertices) {
            for (int axis = 0; axis < 3; ++axis) corners_.push_back(static_cast<btScalar>(v[axis]));
        }
        for (const TriangleIndices& t : mesh.triangles) indices_.insert(indices_.end(), t.begin(), t.end());
        arrays_ = std::make_unique<btTriangleIndexVertexArray>(
            static_cast<int>(mesh.triangles.size()), indices_.data(), static_cast<int>(3 * sizeof(int)),
            static_cast<int>(mesh.vertices.size()), corners_.data(), static_cast<int>(3 * sizeof(btScalar)));
        shape_ = std::make_unique<btGImpactMeshShapePart>(arrays_.get(), 0);
        shape_->setMargin(0);
        shape_->updateBound();      // builds the tree
        shape_->lockChildShapes();  // lets getPrimitiveTriangle read the arrays
    }

    const btGImpactQuantizedBvh& tree() const { return *shape_->getBoxSet(); }

    btPrimitiveTriangle triangle(int index) const {
        btPrimitiveTriangle triangle;
        shape_->getPrimitiveTriangle(index, triangle);
        return triangle;
    }

    std::size_t bytes() const {
        return static_cast<std::size_t>(tree().getNodeCount()) * sizeof(BT_QUANTIZED_BVH_NODE) +
               corners_.size() * sizeof(btScalar) + indices_.size() * sizeof(int);
    }

  private:
    std::vector<btScalar> corners_;
    std::vector<int> indices_;
    std::unique_ptr<btTriangleIndexVertexArray> arrays_;
    std::unique_ptr<btGImpactMeshShapePart> shape_;
};

struct BulletTrees {
    BulletMesh part;
    BulletMesh environment;
};

btTransform placedAt(const Pose& pose) {
    const Matrix3& R = pose.rotation;
    const Vector3& p = pose.translation;
    const auto row = [](const auto& v) {
        return btVector3(static_cast<btScalar>(v[0]), static_cast<btScalar>(v[1]),
                         static_cast<btScalar>(v[2]));
    };
    btMatrix3x3 basis;
    for (int i = 0; i < 3; ++i) basis[i] = row(R.row(i));
    return btTransform(basis, row(p));
}

/// GImpact's own contact of two triangles calls some pairs colliding that lie behind each other's planes without touching, so
/// Bullet's GJK decides.
bool touch(const btPrimitiveTriangle& a, const btPrimitiveTriangle& b) {
    btTriangleShapeEx shapeA(a.m_vertices[0], a.m_vertices[1], a.m_vertices[2]);
    btTriangleShapeEx shapeB(b.m_vertices[0], b.m_vertices[1], b.m_vertices[2]);
    shapeA.setMargin(0);
    shapeB.setMargin(0);
    const btTransform& identity = btTransform::getIdentity();
    btGjkEpaSolver2::sResults results;
    return !btGjkEpaSolver2::Distance(&shapeA, identity, &shapeB, identity, b.m_vertices[0] - a.m_vertices[0],
                                      results);
}

/// GImpact gathers all pairs of overlapping boxes before the first test of triangles: it has no search that ends earlier.
bool collidesBy(const BulletTrees& trees, const btTransform& X_environmentPart) {
    btPairSet pairs;
    btGImpactQuantizedBvh::find_collision(&trees.part.tree(), X_environmentPart, &trees.environment.tree(),
                                          btTransform::getIdentity(), pairs);
    for (int i = 0; i < pairs.size(); ++i) {
        btPrimitiveTriangle a = trees.part.triangle(pairs[i].m_index1);
        btPrimitiveTriangle b = trees.environment.triangle(pairs[i].m_index2);
        a.applyTransform(X_environmentPart);
        a.buildTriPlane();
        b.buildTriPlane();
        if (a.overlap_test_conservative(b) && touch(a, b)) return true;
    }
    return false;
}

}  // namespace

Peer makeBullet(const Mesh& part, const Mesh& environment) {
    Peer peer;
    peer.name = "Bullet";
    const auto start = std::chrono::steady_clock::now();
    const auto trees = std::make_shared<BulletTrees>(BulletTrees{BulletMesh(part), BulletMesh(environment)});
    peer.buildSeconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    peer.bytes = trees->part.bytes() + trees->environment.bytes();
    peer.collides = [trees](const Pose& X_environmentPart) {
        Answer answer;
        answer.value = collidesBy(*trees, placedAt(X_environmentPart));
        return answer;
    };
    return peer;
}

}  // namespace clearway::testing
