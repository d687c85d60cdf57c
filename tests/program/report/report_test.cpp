#include "program/report/report.h"

#include <boost/test/unit_test.hpp>
#include <nlohmann/json.hpp>

#include "clearway/planning/check_path.h"
#include "core/json.h"
#include "support/temporary_folder.h"
#include "support/window_scene.h"

namespace clearway::testing {

using namespace report;

namespace {

struct Written {
    TemporaryFolder folder;
    WindowScene window = windowScene();
    WrittenReport report;
    std::string page;

    explicit Written(const std::string& title) {
        const std::vector<PartState> path = {window.problem.start, window.problem.start};
        const auto audit = planning::checkPath(window.problem, window.scene, path).audit;
        ReportInput input{title, "fine", window.partMesh, window.wallMesh, window.scene, path, audit, {}};
        input.tables = {{"Figures", {}, {{"time", "3 </script> s"}, {"part", "Tr\xe4ger"}}, {}},
                        segmentTable(audit, path, 1)};
        report = writeReport(input, folder.file("out.html"));
        page = readText(folder.file("out.html"));
    }
    std::size_t count(const std::string& text) const {
        std::size_t found = 0;
        for (auto at = page.find(text); at != std::string::npos; at = page.find(text, at + 1)) ++found;
        return found;
    }
    Json data() const {
        const std::string opening = "<script id=\"data\" type=\"application/json\">";
        const auto begin = page.find(opening) + opening.size();
        return Json::parse(page.substr(begin, page.find("</script>", begin) - begin));
    }
};

}  // namespace

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

BOOST_AUTO_TEST_CASE(names_and_figures_cannot_break_the_page) {
    const Written written("</title><script>alert(1)</script>");
    BOOST_TEST(written.count("<script>alert") == 0u);
    BOOST_TEST(written.count("</script>") == 3u);  // the page's own scripts
    BOOST_TEST(written.count("3 \\u003c/script> s") == 1u);
    const Json rows = written.data()["tables"][0]["rows"];
    BOOST_TEST(rows[0][1].get<std::string>() == "3 </script> s");
    BOOST_TEST(rows[1][1].get<std::string>() == "Träger");  // the bytes came in as Latin-1
}

BOOST_AUTO_TEST_CASE(a_folder_that_is_not_there_is_told_by_name) {
    const Written written("A path");
    const planning::PathAudit audit;
    const std::vector<PartState> path = {written.window.problem.start};
    const ReportInput input{
        "", "", written.window.partMesh, written.window.wallMesh, written.window.scene, path, audit, {}};
    BOOST_CHECK_EXCEPTION(writeReport(input, written.folder.file("nowhere/out.html")), std::runtime_error,
                          [](const std::exception& error) {
                              return std::string(error.what()).find("nowhere/out.html") != std::string::npos;
                          });
}

}  // namespace clearway::testing
