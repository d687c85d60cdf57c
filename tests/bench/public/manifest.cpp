#include "bench/public/manifest.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>

#include "core/json.h"

namespace clearway::testing::public_problems {
namespace {

namespace fs = std::filesystem;

constexpr auto isAny = [](const auto&) { return true; };
constexpr auto isFilled = [](const auto& value) { return !value.empty(); };

/// An object of a manifest. Its errors say where it stands.
class Fields {
  public:
    Fields(std::string where, const Json& object, const std::set<std::string>& known)
        : where_(std::move(where)), object_(object) {
        for (const auto& [key, value] : object.items()) {
            if (known.count(key) == 0) refuse(key, "no such key");
        }
    }

    bool has(const std::string& key) const { return object_.contains(key); }

    /// The value, which must fit a condition as well as its type.
    template <typename Value, typename IsFit>
    Value get(const std::string& key, const std::string& expected, const IsFit& isFit) const {
        try {
            const auto value = object_.at(key).get<Value>();
            if (isFit(value)) return value;
        } catch (const Json::exception&) {  // refused below
        }
        refuse(key, expected);
    }

    std::string text(const std::string& key, const std::string& expected) const {
        return get<std::string>(key, expected, isFilled);
    }

    std::vector<std::string> texts(const std::string& key) const {
        if (!has(key)) return {};
        return get<std::vector<std::string>>(key, "a list of texts", isAny);
    }

    double positive(const std::string& key) const {
        return get<double>(key, "a number above 0", [](double value) { return value > 0; });
    }

    [[noreturn]] void refuse(const std::string& key, const std::string& expected) const {
        throw std::invalid_argument(where_ + ": " + key + " is " +
                                    (has(key) ? object_.at(key).dump() : "missing") + ", expected " +
                                    expected);
    }

  private:
    std::string where_;
    const Json& object_;
};

/// Reads x y z qx qy qz qw, as in path files, or x y z and angles about x, y and z in half turns, applied in this order, as
/// in PPL's queries.
PartState readState(const Fields& fields, const std::string& key) {
    using Turn = Eigen::AngleAxisd;
    const auto n = fields.get<std::vector<double>>(
        key, "x, y, z and a quaternion x, y, z, w other than 0, or x, y, z and three angles",
        [](const auto& all) {
            return all.size() == 6 ||
                   (all.size() == 7 && Eigen::Map<const Eigen::Vector4d>(&all[3]).norm() > 0);
        });
    PartState state;
    state.position = {n[0], n[1], n[2]};
    if (n.size() == 7)
        state.rotation = Eigen::Quaterniond(n[6], n[3], n[4], n[5]).normalized();
    else
        state.rotation = Turn(M_PI * n[5], Vector3::UnitZ()) * Turn(M_PI * n[4], Vector3::UnitY()) *
                         Turn(M_PI * n[3], Vector3::UnitX());
    return state;
}

std::vector<PlacedMesh> readWorld(const Fields& fields, bool isPpl) {
    if (!isPpl) return {{fields.text("world", "a mesh file")}};
    std::vector<PlacedMesh> world;
    const auto isWhole = [](const auto& all) {
        return !all.empty() &&
               std::all_of(all.begin(), all.end(), [](const auto& mesh) { return mesh.size() == 4; });
    };
    for (const auto& mesh :
         fields.get<std::vector<std::vector<Json>>>("world", "a list of [\"FILE\", x, y, z]", isWhole)) {
        const auto number = [&](std::size_t i) { return mesh[i].get<double>(); };
        world.push_back({mesh[0].get<std::string>(), {number(1), number(2), number(3)}});
    }
    return world;
}

/// Reads what a problem file of clearway's would say.
void readProblemOf(const Fields& fields, ListedProblem& listed) {
    Problem& problem = listed.problem;
    const auto reading = fields.get<std::string>(
        "reading", "stored, omplapp or ppl",
        [](const std::string& text) { return text == "stored" || text == "omplapp" || text == "ppl"; });
    listed.isPpl = reading == "ppl";
    problem.meshes.asOmplApp = reading == "omplapp";
    problem.start = readState(fields, "start");
    if (fields.get<Json>("goal", "a pose or \"outside\"", isAny) == "outside")
        problem.outside = Outside{};
    else
        problem.goal = readState(fields, "goal");
    if (fields.has("volume")) {
        const auto n = fields.get<std::vector<double>>(
            "volume", "the least x, y, z and the largest x, y, z", [](const auto& all) {
                return all.size() == 6 && all[0] < all[3] && all[1] < all[4] && all[2] < all[5];
            });
        problem.volume = Box(Vector3(n[0], n[1], n[2]), Vector3(n[3], n[4], n[5]));
    }
    listed.hasWalls = fields.has("walls") && fields.get<bool>("walls", "true or false", isAny);
    if (listed.hasWalls && !(listed.isPpl && problem.volume))
        fields.refuse("walls", "it only with the reading ppl and a volume");
    if (fields.has("overlap")) problem.rules.overlap.common = fields.positive("overlap");
}

ListedProblem readListed(const std::string& file, const Json& object) {
    std::set<std::string> known = {"name", "robot", "world", "paths", "published", "seconds", "clearance"};
    const bool hasConfig = object.contains("config");
    if (hasConfig)
        known.insert("config");
    else
        known.insert({"reading", "start", "goal", "volume", "walls", "overlap"});
    const Fields fields(file + ": " + object.value("name", "a problem"), object, known);
    ListedProblem listed;
    listed.name = fields.text("name", "SOURCE/NAME");
    listed.paths = fields.texts("paths");
    if (fields.has("published")) fields.text("published", "a text");
    for (const char* figure : {"seconds", "clearance"}) {
        if (fields.has(figure)) fields.positive(figure);
    }
    if (hasConfig)
        listed.config = fields.text("config", "a problem file");
    else
        readProblemOf(fields, listed);
    if (hasConfig && !fields.has("robot") && !fields.has("world")) return listed;
    listed.robot = fields.text("robot", "a mesh file");
    listed.world = readWorld(fields, listed.isPpl);
    return listed;
}

Manifest manifestOf(const std::string& file, const Json& json) {
    const Fields fields(file, json, {"repository", "commit", "licence", "problems", "assemblies"});
    Manifest manifest;
    manifest.folder = fs::path(file).stem().string();
    manifest.repository = fields.get<std::string>(
        "repository", "https://...", [](const std::string& text) { return text.rfind("https://", 0) == 0; });
    manifest.commit = fields.get<std::string>("commit", "40 hexadecimal digits", [](const std::string& text) {
        return text.size() == 40 && text.find_first_not_of("0123456789abcdef") == std::string::npos;
    });
    manifest.licence = fields.text("licence", "the licence's name, or that none is stated");
    manifest.assemblies = fields.texts("assemblies");
    if (fields.has("problems") || manifest.assemblies.empty()) {
        for (const Json& object : fields.get<std::vector<Json>>("problems", "a list of problems", isFilled))
            manifest.problems.push_back(readListed(file, object));
    }
    return manifest;
}

}  // namespace

Manifest readManifest(const std::string& file) {
    try {
        return manifestOf(file, Json::parse(std::ifstream(file)));
    } catch (const Json::exception& error) {
        throw std::invalid_argument(file + ": " + error.what());
    }
}

std::vector<Manifest> readManifests() {
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(CLEARWAY_DATA_DIR "/problems"))
        if (entry.path().extension() == ".json") files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    std::vector<Manifest> manifests;
    for (const fs::path& file : files) manifests.push_back(readManifest(file.string()));
    return manifests;
}

}  // namespace clearway::testing::public_problems
