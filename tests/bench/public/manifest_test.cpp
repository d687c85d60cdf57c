// The manifests of public problems are whole, and pose what they say. No test needs a checkout of anybody's.
#include "bench/public/manifest.h"

#include <boost/test/unit_test.hpp>
#include <filesystem>
#include <set>

#include "bench/public/checkouts.h"
#include "support/temporary_folder.h"
#include "support/words.h"

BOOST_AUTO_TEST_SUITE(manifest_test)

using namespace clearway::testing;
using namespace clearway::testing::public_problems;
using clearway::Box;
using clearway::Problem;
using clearway::Vector3;

const std::string kManifest =
    R"({"repository": "https://a.org/b", "commit": "0123456789abcdef0123456789abcdef01234567", "licence": "MIT",
"problems": [{"name": "r/p", "reading": "ppl", "robot": "part.g", "world": [["part.g", 5, 0, 0], ["part.g", -5, 0, 0]],
"start": [1, 2, 3, 0.5, 0, 1], "goal": [0, 4, 0, 0, 0, 0, 2], "volume": [-9, -9, -9, 9, 9, 9], "walls": true,
"paths": ["none.path"], "seconds": 2.5}]})";
const std::string kTetrahedron = "1 4 4 12\n1 4\n1 1 1 2 1 1\n1 2 1 1 1 3\n1 3 -2\n1 2 -4\n1 4 -3\n2 3 -4\n";

BOOST_AUTO_TEST_CASE(every_manifest_can_be_read_and_no_name_stands_twice) {
    std::set<std::string> names;
    for (const Manifest& manifest : readManifests()) {
        for (const ListedProblem& listed : manifest.problems) BOOST_TEST(names.insert(listed.name).second);
    }
    BOOST_TEST(!names.empty());
}

BOOST_AUTO_TEST_CASE(a_manifest_that_lacks_something_is_refused_by_problem_and_key) {
    const TemporaryFolder folder;
    const auto refused = [&](const std::string& from, const std::string& to, std::vector<std::string> words) {
        std::string text = kManifest;
        const std::string file = folder.write("r.json", text.replace(text.find(from), from.size(), to));
        words.push_back(file);
        requireRefusedBy([&] { readManifest(file); }, words);
    };
    refused("\"MIT\"", "\"\"", {"licence"});
    refused("\"licence\"", "\"license\"", {"license", "no such key"});
    refused("01234567\"", "0123456\"", {"commit", "40 hexadecimal digits"});
    refused("\"ppl\"", "\"byu\"", {"r/p: reading is \"byu\"", "stored, omplapp or ppl"});
    refused("\"start\": [1, 2, 3, 0.5, 0, 1],", "", {"r/p: start is missing", "three angles"});
    refused("\"start\": [1, ", "\"start\": [", {"r/p: start is [2,"});
    refused("[\"part.g\", 5, 0, 0]", "\"part.g\"", {"r/p: world", "[\"FILE\", x, y, z]"});
    refused("0, 0, 0, 2]", "0, 0, 0, 0]", {"r/p: goal", "other than 0"});
    refused("[-9, -9, -9, 9", "[9, -9, -9, 9", {"r/p: volume"});
    refused("2.5", "-2.5", {"r/p: seconds is -2.5"});
    refused("\"ppl\"", "\"stored\"", {"r/p: walls"});
    refused("\"reading\": \"ppl\"", "\"config\": \"a.cfg\"", {"r/p: start", "no such key"});
    refused("}]}", "}]", {"parse"});
}

BOOST_AUTO_TEST_CASE(a_problem_is_posed_from_a_checkout_as_its_manifest_says) {
    const TemporaryFolder folder;
    const std::vector<Manifest> manifests = {readManifest(folder.write("r.json", kManifest)),
                                             readManifest(folder.write("absent.json", kManifest))};
    std::filesystem::create_directory(folder.file("r"));
    folder.write("r/part.g", kTetrahedron);
    const PublicProblems found = findPublicProblems(manifests, folder.path(), folder.file("converted"));
    BOOST_TEST_REQUIRE(found.skipped.size() == 1u);
    BOOST_TEST(holds(found.skipped[0], "absent", "https://a.org/b", "0123456789abcdef"));
    BOOST_TEST_REQUIRE(found.puzzles.size() == 1u);
    BOOST_TEST(found.puzzles[0].paths.empty());

    const Problem problem = clearway::readProblem(found.puzzles[0].file);
    const Vector3 mean(1.25, 1.25, 1.5);  // of the tetrahedron's vertices
    const Box part = boundingBox(loadPart(problem));
    BOOST_TEST((part.min() - (Vector3(1, 1, 1) - mean)).norm() < 1e-12);
    BOOST_TEST((part.max() - (Vector3(2, 2, 3) - mean)).norm() < 1e-12);
    const clearway::Mesh environment = loadEnvironment(problem);
    BOOST_TEST(environment.triangles.size() == 4u + 4 + 12);  // the last ones are the walls
    BOOST_TEST((boundingBox(environment).min() == Vector3(-9, -9, -9)));
    BOOST_TEST((boundingBox(environment).max() == Vector3(9, 9, 9)));
    // Half a turn about z follows a quarter turn about x.
    const clearway::Pose start = poseOf(problem.start);
    BOOST_TEST((start.translation == Vector3(1, 2, 3)));
    BOOST_TEST((start.rotation * Vector3::UnitY() - Vector3::UnitZ()).norm() < 1e-12);
    BOOST_TEST((start.rotation * Vector3::UnitX() + Vector3::UnitX()).norm() < 1e-12);
    BOOST_TEST((poseOf(problem.goal).rotation.isIdentity(1e-12)));
}

BOOST_AUTO_TEST_SUITE_END()
