// Parts that touch or are pressed in where they are assembled: the overlap that the program advises, pasted, brings each out.
#include "program/cli/run_program.h"
#include "support/assembled_problems.h"

namespace clearway::testing {
BOOST_AUTO_TEST_SUITE(touching_test)

BOOST_AUTO_TEST_CASE(the_advised_overlap_brings_each_touching_part_out) {
    for (const AssembledProblem& problem : touchingProblems()) {
        BOOST_TEST_CONTEXT(problem.name) {
            const TemporaryFolder folder;
            writeAssembledProblem(problem, folder.path());
            const std::string file = problem.name + ".cfg";
            const Outcome refused = runIn(folder, "plan " + file + " --path o.path");
            BOOST_TEST(refused.code == 2);
            BOOST_TEST(holds(refused.err, "overlap = X"), refused.err);
            const Outcome lifted = runIn(folder, "info " + file + " --lift");
            BOOST_REQUIRE(lifted.code == 0);
            const std::string least = row(lifted, "frees the start"), first = row(lifted, "to try first");
            writeAssembledProblem(problem, folder.path(), least + "\n");
            BOOST_TEST(holds(row(runIn(folder, "info " + file), "at the start"), "valid"));
            writeAssembledProblem(problem, folder.path(), first + "\n");
            const Outcome planned = runIn(folder, "plan " + file + " --path o.path --quick");
            BOOST_TEST(planned.code == 0, planned.out << planned.err);
            const auto checked = factsOf(folder, "check " + file + " o.path");
            BOOST_TEST(checked["audit"]["verdict"] == "valid");
            for (const auto& overlap : checked["overlaps"])
                BOOST_TEST(overlap["depth"]["lower"].get<double>() <=
                           checked["obstacles"][0]["overlap"].get<double>());
        }
    }
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::testing
