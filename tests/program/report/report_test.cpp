#include "program/report/report.h"

#include <boost/test/unit_test.hpp>
#include <nlohmann/json.hpp>
#include <sstream>

#include "clearway/planning/check_path.h"
#include "core/json.h"
#include "support/temporary_folder.h"
#include "support/window_scene.h"
#include "support/words.h"

namespace clearway::testing {
BOOST_AUTO_TEST_SUITE(report_test)

using namespace report;

struct Written {
    TemporaryFolder folder;
    WindowScene window = windowScene();
    WrittenReport report;
    std::string page;

    explicit Written(const std::string& title, const std::string& unit = "") {
        const std::vector<PartState> path = {window.problem.start, window.problem.start};
        window.scene.unit = unit;
        const auto audit = planning::checkPath(window.problem, window.scene, path).audit;
        ReportInput input{title, "fine", window.partMesh, window.wallMesh, window.scene, path, audit,
                          {},    unit};
        input.tables = {{"Figures", {}, {{"time", "3 </script> s"}, {"part", "Tr\xe4ger"}}, {}},
                        segmentTable(audit, path, window.scene)};
        report = writeReport(input, folder.file("out.html"));
        page = readText(folder.file("out.html"));
    }
    std::size_t count(const std::string& text) const {
        std::size_t found = 0;
        for (auto at = page.find(text); at != std::string::npos; at = page.find(text, at + 1)) ++found;
        return found;
    }
    FloatJson data() const {
        const std::string opening = "<script id=\"data\" type=\"application/json\">";
        const auto begin = page.find(opening) + opening.size();
        return FloatJson::parse(page.substr(begin, page.find("</script>", begin) - begin));
    }
};

BOOST_AUTO_TEST_CASE(a_page_is_whole_and_asks_for_no_other_file) {
    const Written written("A path");
    BOOST_TEST(written.page.size() == written.report.bytes);
    BOOST_TEST(written.page.find("{{") == std::string::npos);
    BOOST_TEST(written.count("<title>A path</title>") == 1u);
    BOOST_TEST(written.page.substr(written.page.size() - 8) == "</html>\n");
    for (const char* reference : {"src=", "href=", "url(", "@import"})
        BOOST_TEST(written.count(reference) == 0u, reference);
    BOOST_TEST(written.folder.names().size() == 1u);
}

BOOST_AUTO_TEST_CASE(a_page_says_what_it_shows_of_the_meshes) {
    const Written written("A path");
    BOOST_TEST(written.report.environmentTriangles == written.window.wallMesh.triangles.size());
    BOOST_TEST(written.count("The environment is drawn with all of its 432 triangles") == 1u);
    BOOST_TEST(written.count("MIT licence") == 1u);
}

BOOST_AUTO_TEST_CASE(lengths_carry_the_unit_and_without_one_nothing_is_assumed) {
    const Written millimetres("A path", "mm"), unknown("A path");
    BOOST_TEST(millimetres.data()["unit"].get<std::string>() == "mm");
    BOOST_TEST(millimetres.count("mm of its place") == 2u);
    BOOST_TEST(millimetres.data()["tables"][1]["header"][3].get<std::string>() == "clearance [mm]");
    BOOST_TEST(unknown.data()["unit"].get<std::string>().empty());
    BOOST_TEST(unknown.data()["tables"][1]["header"][3].get<std::string>() == "clearance");
    BOOST_TEST(unknown.count("which the problem does not name") == 1u);
}

BOOST_AUTO_TEST_CASE(a_page_knows_every_obstacle_and_how_near_the_part_comes) {
    const FloatJson data = Written("A path").data(), objects = data["environment"]["objects"];
    BOOST_TEST_REQUIRE(objects.size() == 4u);
    std::size_t triangles = 0;
    double least = 1e300;
    for (const FloatJson& object : objects) {
        triangles += object["triangles"].get<std::size_t>();
        least = std::min(least, object["clearance"].get<double>());
    }
    BOOST_TEST(objects[0]["name"].get<std::string>() == "below");
    BOOST_TEST(triangles == 432u);
    BOOST_TEST(least == data["frames"][0]["clearance"].get<double>(), boost::test_tools::tolerance(1e-6));
}

BOOST_AUTO_TEST_CASE(poses_and_points_can_be_copied_with_all_digits) {
    const Written written("A path");
    const FloatJson frame = written.data()["frames"][0];
    std::istringstream pose(frame["pose"].get<std::string>());
    const PartState& start = written.window.problem.start;
    double x, y, z, qx, qy, qz, qw;
    pose >> x >> y >> z >> qx >> qy >> qz >> qw;
    BOOST_TEST((Vector3(x, y, z) == start.position));
    BOOST_TEST(std::abs(Eigen::Quaterniond(qw, qx, qy, qz).dot(Eigen::Quaterniond(start.rotation))) == 1,
               boost::test_tools::tolerance(1e-15));
    BOOST_TEST(frame["triangles"].size() == 2u);
    BOOST_TEST(frame["points"][1].get<std::string>().size() > 10u);
    BOOST_TEST(!frame.contains("trouble"));
}

BOOST_AUTO_TEST_CASE(names_and_figures_cannot_break_the_page) {
    const Written written("</title><script>alert(1)</script>");
    BOOST_TEST(written.count("<script>alert") == 0u);
    BOOST_TEST(written.count("</script>") == 3u);  // the page's own scripts
    BOOST_TEST(written.count("3 \\u003c/script> s") == 1u);
    const FloatJson rows = written.data()["tables"][0]["rows"];
    BOOST_TEST(rows[0][1].get<std::string>() == "3 </script> s");
    BOOST_TEST(rows[1][1].get<std::string>() == "Träger");  // the bytes came in as Latin-1
}

BOOST_AUTO_TEST_CASE(a_folder_that_is_not_there_is_told_by_name) {
    const Written written("A path");
    const planning::PathAudit audit;
    const std::vector<PartState> path = {written.window.problem.start};
    const ReportInput input{
        "", "", written.window.partMesh, written.window.wallMesh, written.window.scene, path, audit, {}};
    requireRefusedBy<std::runtime_error>([&] { writeReport(input, written.folder.file("nowhere/out.html")); },
                                         {"nowhere/out.html"});
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::testing
