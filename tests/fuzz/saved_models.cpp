// Saved models, as whole files and as payloads under a fitting header, are refused with a message that names
// the file, or loaded to a tree that any query can search.
#include <stdexcept>

#include "clearway/model.h"
#include "clearway/query.h"
#include "clearway/targets.h"
#include "core/archive.h"
#include "core/hash.h"
#include "fuzz/bytes.h"
#include "support/random_meshes.h"
#include "support/temporary_folder.h"

namespace clearway::testing {
namespace {

constexpr std::size_t kHeader = 48;    ///< bytes: magic, version, byte order mark, key, payload bytes, hash
constexpr std::size_t kUnhashed = 24;  ///< bytes of the header before the key

std::string saved(const Model& model) {
    const TemporaryFolder folder;
    model.save(folder.file("model"));
    return readText(folder.file("model"));
}

Model smallModel(int nodeWidth) {
    BuildOptions options;
    options.nodeWidth = nodeWidth;
    options.leafSize = 2;
    options.threads = 1;
    return Model::build(box({1, 2, 3}), options);
}

/// The hash detects damage. With a right hash, the other checks must find the fault.
std::string withHeader(std::string_view payload) {
    static const std::string model = saved(smallModel(8));
    constexpr std::uint64_t kKey = 7;
    Hash hash;
    hash.add(kKey);
    hash.add(payload.data(), payload.size());
    std::string file = model.substr(0, kUnhashed);
    for (const std::uint64_t field : {kKey, std::uint64_t(payload.size()), hash.value()}) {
        file.append(reinterpret_cast<const char*>(&field), sizeof field);
    }
    return file.append(payload);
}

void ask(const Model& part, const Model& environment) {
    Workspace workspace;
    for (const Vector3& shift : {Vector3(0, 0, 0), Vector3(5, 1, 0)}) {
        try {
            const Pose X_environmentPart{Matrix3::Identity(), shift};
            distance(part, environment, X_environmentPart, {}, workspace);
            collides(part, environment, X_environmentPart, workspace);
            isWithin(part, environment, X_environmentPart, 1, workspace);
        } catch (const std::invalid_argument&) {  // node widths, sizes and reaches that do not fit each other
        }
    }
}

}  // namespace

void fuzzOne(std::string_view input) {
    static const TemporaryFolder folder;
    static const Model others[] = {smallModel(2), smallModel(8)};
    const bool isWhole = !input.empty() && input[0] % 8 == 7;
    const std::string_view rest = input.empty() ? input : input.substr(1);
    const std::string file = folder.write("model.clearway", isWhole ? std::string(rest) : withHeader(rest));
    try {
        const Model model = Model::load(file);
        for (const std::string& target : availableTargets()) {
            useTarget(target);
            for (const Model& other : others) {
                ask(model, other);
                ask(other, model);
            }
        }
    } catch (const std::runtime_error& error) {
        require(std::string(error.what()).find(file) == 0,
                std::string("a refusal names the file: ") + error.what());
    }
}

std::vector<std::string> seeds() {
    std::vector<std::string> result;
    for (const int width : nodeWidths()) {
        const std::string file = saved(smallModel(width));
        result.push_back('\0' + file.substr(kHeader));
        result.push_back('\7' + file);
    }
    return result;
}

}  // namespace clearway::testing
