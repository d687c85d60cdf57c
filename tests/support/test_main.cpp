// The main function of every test program. A program holds all test files of a folder. The cases of each file
// form a suite with the file's name, so that `--run_test=NAME` runs NAME_test.cpp alone.
#include <boost/test/tree/traverse.hpp>
#include <boost/test/tree/visitor.hpp>
#include <boost/test/unit_test.hpp>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace {

namespace ut = boost::unit_test;

std::string suiteNameOf(const ut::test_unit& unit) {
    const std::string stem = std::filesystem::path(unit.p_file_name.begin()).stem().string();
    const std::string ending = "_test";
    const bool hasEnding =
        stem.size() > ending.size() && stem.compare(stem.size() - ending.size(), ending.size(), ending) == 0;
    return hasEnding ? stem.substr(0, stem.size() - ending.size()) : stem;
}

/// Collects the cases, and the suites of data-driven cases, that are not inside another suite.
struct TopUnits : ut::test_tree_visitor {
    std::vector<ut::test_unit*> found;

    void visit(const ut::test_case& unit) override { keep(unit); }
    bool test_suite_start(const ut::test_suite& suite) override {
        keep(suite);
        return suite.p_parent_id == ut::INV_TEST_UNIT_ID;  // enter only the master suite
    }

  private:
    void keep(const ut::test_unit& unit) {
        const bool isTop = unit.p_parent_id == ut::framework::master_test_suite().p_id;
        if (isTop) found.push_back(&ut::framework::get(unit.p_id, ut::TUT_ANY));
    }
};

bool groupByFile() {
    ut::master_test_suite_t& master = ut::framework::master_test_suite();
    master.generate();  // data-driven cases exist only from here on
    TopUnits top;
    ut::traverse_test_tree(master, top, true);
    std::map<std::string, ut::test_suite*> suites;
    for (ut::test_unit* unit : top.found) {
        const std::string name = suiteNameOf(*unit);
        ut::test_suite*& suite = suites[name];
        if (suite == nullptr) suite = BOOST_TEST_SUITE(name);
        master.remove(unit->p_id);
        suite->add(unit);
    }
    for (const auto& [name, suite] : suites) master.add(suite);
    return true;
}

}  // namespace

int main(int argc, char** argv) {
    return ut::unit_test_main(&groupByFile, argc, argv);
}
