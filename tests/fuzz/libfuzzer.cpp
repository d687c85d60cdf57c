// The entry point that libFuzzer calls.
#include "fuzz/bytes.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    clearway::testing::fuzzOne({reinterpret_cast<const char*>(data), size});
    return 0;
}
