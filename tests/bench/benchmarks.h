// The benchmarks, one file each. words: the benchmark's name and its arguments. Each returns the program's exit code: 1 when an
// answer is wrong, 2 when it is used wrongly; `public` 77, with which a test is skipped, when there is nothing to measure. Each throws
// std::exception when it cannot run.
#pragma once

namespace clearway::testing::anytime_clearance {
int run(int count, char** words);
}
namespace clearway::testing::certified_motions {
int run(int count, char** words);
}
namespace clearway::testing::fcl_continuous {
int run(int count, char** words);
}
namespace clearway::testing::fcl_first_path {
int run(int count, char** words);
}
namespace clearway::testing::fcl_motions {
int run(int count, char** words);
}
namespace clearway::testing::from_files {
int run(int count, char** words);
}
namespace clearway::testing::growth {
int run(int count, char** words);
}
namespace clearway::testing::kernels {
int run(int count, char** words);
}
namespace clearway::testing::ladder {
int run(int count, char** words);
}
namespace clearway::testing::loading {
int run(int count, char** words);
}
namespace clearway::testing::motions {
int run(int count, char** words);
}
namespace clearway::testing::overlaps {
int run(int count, char** words);
}
namespace clearway::testing::plan_success {
int run(int count, char** words);
}
namespace clearway::testing::public_problems {
int run(int count, char** words);
}
namespace clearway::testing::queries {
int run(int count, char** words);
}
namespace clearway::testing::samplers {
int run(int count, char** words);
}
namespace clearway::testing::speed_error {
int run(int count, char** words);
}
namespace clearway::testing::strategies {
int run(int count, char** words);
}
