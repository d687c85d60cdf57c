#include <BulletCollision/CollisionShapes/btTriangleIndexVertexArray.h>
#include <BulletCollision/Gimpact/btGImpactShape.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkEpa2.h>

#include <chrono>
#include <memory>

#include "bench/peer.h"

namespace clearway::testing {
namespace {

/// A mesh in Bullet's form, with GImpact's tree of boxes. Bullet keeps pointers to the corners and to the triangles.
class BulletMesh {
  public:
    explicit BulletMesh(const Mesh& mesh) {
        for (const Vector3& v : mesh.vertices) corners_.insert(corners_.end(), {v.x(), v.y(), v.z()});
        for (const TriangleIndices& t : mesh.triangles) indices_.insert(indices_.end(), t.begin(), t.end());
        arrays_ = std::make_unique<btTriangleIndexVertexArray>(
            int(mesh.triangles.size()), indices_.data(), 3 * int(sizeof(int)), int(mesh.vertices.size()),
            corners_.data(), 3 * int(sizeof(btScalar)));
        shape_ = std::make_unique<btGImpactMeshShapePart>(arrays_.get(), 0);
        shape_->setMargin(0);
        shape_->updateBound();      // builds the tree
        shape_->lockChildShapes();  // queries read the arrays
    }

    const btGImpactQuantizedBvh& tree() const { return *shape_->getBoxSet(); }

    btPrimitiveTriangle triangle(int index) const {
        btPrimitiveTriangle triangle;
        shape_->getPrimitiveTriangle(index, triangle);
        return triangle;
    }

  private:
    std::vector<btScalar> corners_;
    std::vector<int> indices_;
    std::unique_ptr<btTriangleIndexVertexArray> arrays_;
    std::unique_ptr<btGImpactMeshShapePart> shape_;
};

struct Trees {
    BulletMesh part;
    BulletMesh environment;
};

btTransform placedAt(const Pose& pose) {
    const Matrix3& R = pose.rotation;
    const Vector3& p = pose.translation;
    return btTransform(
        btMatrix3x3(R(0, 0), R(0, 1), R(0, 2), R(1, 0), R(1, 1), R(1, 2), R(2, 0), R(2, 1), R(2, 2)),
        btVector3(p.x(), p.y(), p.z()));
}

/// By GJK, because the clipping that GImpact itself would do takes some triangles that touch for apart.
bool doTouch(const btPrimitiveTriangle& a, const btPrimitiveTriangle& b) {
    btTriangleShapeEx one(a.m_vertices[0], a.m_vertices[1], a.m_vertices[2]);
    btTriangleShapeEx other(b.m_vertices[0], b.m_vertices[1], b.m_vertices[2]);
    one.setMargin(0);
    other.setMargin(0);
    btGjkEpaSolver2::sResults results;
    const btTransform& here = btTransform::getIdentity();
    return !btGjkEpaSolver2::Distance(&one, here, &other, here, b.m_vertices[0] - a.m_vertices[0], results);
}

bool doCollide(const Trees& trees, const btTransform& X_environmentPart) {
    btPairSet pairs;  // of triangles whose boxes meet: Bullet finds all of them before any is tested
    btGImpactQuantizedBvh::find_collision(&trees.part.tree(), X_environmentPart, &trees.environment.tree(),
                                          btTransform::getIdentity(), pairs);
    for (int i = 0; i < pairs.size(); ++i) {
        btPrimitiveTriangle a = trees.part.triangle(pairs[i].m_index1);
        btPrimitiveTriangle b = trees.environment.triangle(pairs[i].m_index2);
        a.applyTransform(X_environmentPart);
        a.buildTriPlane();
        b.buildTriPlane();
        if (a.overlap_test_conservative(b) && doTouch(a, b)) return true;
    }
    return false;
}

}  // namespace

Peer makeBullet(const Mesh& part, const Mesh& environment) {
    Peer peer;
    peer.name = "Bullet";
    const auto start = std::chrono::steady_clock::now();
    const auto trees = std::make_shared<Trees>(Trees{BulletMesh(part), BulletMesh(environment)});
    peer.buildSeconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    peer.collides = [trees](const Pose& X_environmentPart) {
        Answer answer;
        answer.value = doCollide(*trees, placedAt(X_environmentPart));
        return answer;
    };
    return peer;
}

}  // namespace clearway::testing
