#include "torture/repeat.h"

#include <cmath>
#include <ios>
#include <ostream>

#include "support/oracle.h"

namespace clearway::testing {
namespace {

bool complains(const PosedMeshes& posed, std::uint64_t choices) {
    return !checkCase(posed, choices).complaints.empty();
}

/// x rounded to a mantissa of `bits` bits.
double rounded(double x, int bits) {
    if (x == 0 || bits == 0) return 0;
    int exponent = 0;
    const double mantissa = std::frexp(x, &exponent);
    return std::ldexp(std::nearbyint(std::ldexp(mantissa, bits)), exponent - bits);
}

class Shrinking {
  public:
    Shrinking(PosedMeshes& posed, std::uint64_t choices) : posed_(posed), choices_(choices) {}

    void dropTriangles(Mesh& mesh) {
        for (std::size_t i = mesh.triangles.size(); i-- > 0 && mesh.triangles.size() > 1;) {
            const TriangleIndices dropped = mesh.triangles[i];
            mesh.triangles.erase(mesh.triangles.begin() + std::ptrdiff_t(i));
            if (!complains(posed_, choices_)) {
                mesh.triangles.insert(mesh.triangles.begin() + std::ptrdiff_t(i), dropped);
            }
        }
    }

    void takePoseAway() {
        const Pose before = posed_.pose;
        for (const Pose& simpler : {Pose{}, Pose{Matrix3::Identity(), before.translation},
                                    Pose{before.rotation, Vector3::Zero()}}) {
            posed_.pose = simpler;
            if (complains(posed_, choices_)) return;
        }
        posed_.pose = before;
    }

    void round(Vector3& point) {
        for (double& x : point) {
            const double before = x;
            for (const int bits : {0, 2, 4, 8, 16, 24, 32, 40}) {
                x = rounded(before, bits);
                if (x == before || complains(posed_, choices_)) break;
                x = before;
            }
        }
    }

  private:
    PosedMeshes& posed_;
    std::uint64_t choices_;
};

void printMesh(std::ostream& out, const char* name, const Mesh& mesh) {
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        out << "  " << name << " {";
        for (const Vector3& p : cornersOf(mesh, i)) {
            out << "Vector3(" << p.x() << ", " << p.y() << ", " << p.z() << "), ";
        }
        out << "}\n";
    }
}

}  // namespace

PosedMeshes smallest(const PosedMeshes& posed, std::uint64_t choices) {
    PosedMeshes shrunk = posed;
    Shrinking shrinking(shrunk, choices);
    shrinking.dropTriangles(shrunk.part);
    shrinking.dropTriangles(shrunk.environment);
    shrinking.takePoseAway();
    shrinking.round(shrunk.pose.translation);
    for (Vector3& p : shrunk.part.vertices) shrinking.round(p);
    for (Vector3& p : shrunk.environment.vertices) shrinking.round(p);
    return shrunk;
}

void printPose(std::ostream& out, const Pose& pose) {
    const auto flags = out.flags();
    out << std::hexfloat;
    out << "  rotation, row by row {";
    for (int k = 0; k < 9; ++k) out << pose.rotation(k / 3, k % 3) << ", ";
    const Vector3& t = pose.translation;
    out << "}\n  translation {" << t.x() << ", " << t.y() << ", " << t.z() << "}\n";
    out.flags(flags);
}

void printRepeat(std::ostream& out, const PosedMeshes& posed, std::uint64_t choices) {
    for (const std::string& complaint : checkCase(posed, choices).complaints)
        out << "  " << complaint << '\n';
    const auto flags = out.flags();
    out << std::hexfloat;
    printMesh(out, "part       ", posed.part);
    printMesh(out, "environment", posed.environment);
    out.flags(flags);
    printPose(out, posed.pose);
    out << "  choices " << choices << '\n';
}

}  // namespace clearway::testing
