// One program, the same bits whatever the C library takes the processor for.
#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>

#include "tests/support/run_program.h"

namespace instruction_set_test {

namespace {

// The GNU C library then takes its functions for processors without these.
constexpr const char* kOldProcessor =
    "export GLIBC_TUNABLES=glibc.cpu.hwcaps=-FMA,-FMA4,-AVX2,-AVX,-AVX512F,-SSE4_1 "
    "TACTSPACE_SIMD=baseline";

std::string answer_of(const std::vector<std::string>& arguments, const char* processor) {
    const Ran ran = run_program(arguments, processor);
    REQUIRE_MESSAGE(ran.exit_code == 0, ran.err);
    REQUIRE(ran.out.size() > 100);
    return ran.out;
}

void check_same(const std::vector<std::string>& arguments) {
    CHECK(answer_of(arguments, ":") == answer_of(arguments, kOldProcessor));
}

std::string set(const char* name) {
    return std::string(tact::kAssetsDir) + "/sets/" + name + ".tactspace.json";
}

}  // namespace

// Not a test: what one thinks of the processor, said by a process of its own. Argument by argument
// at run time, as compilers know the sines of constants.
TEST_CASE("instruction set probe" * doctest::skip()) {
    std::uint64_t number = 0;
    for (int k = 0; k < 100'000; ++k) {
        volatile const double x = 0.01 * k;
        for (const double value : {std::sin(x), std::exp(-x / 100.0), std::pow(x + 1.0, 0.37)}) {
            std::uint64_t bits = 0;
            std::memcpy(&bits, &value, sizeof bits);
            number = number * 1'099'511'628'211U + bits;
        }
    }
    MESSAGE("last digits " << number);
}

TEST_CASE("instruction set: every metric and the map are the same on a processor without FMA" *
          doctest::test_suite("long")) {
    const auto probe = [](const std::string& processor) {
        const std::string tests = std::filesystem::read_symlink("/proc/self/exe").string();
        const std::string command = processor + "; '" + tests + "' -ns -tc='instruction set probe'";
        return run_program({}, command + " | grep 'last digits'; exit 0").out;
    };
    REQUIRE(probe(":").find("last digits") != std::string::npos);
    if (probe(":") == probe(kOldProcessor)) {
        MESSAGE("the C library has no other functions for another processor: nothing is compared");
        return;
    }
    const std::string twelve = set("pm_2023_twelve");
    for (const char* metric : {"nc", "oc", "rmse", "msm", "mtm", "st-sim", "spqi", "bands"}) {
        CAPTURE(metric);
        check_same({"predict", twelve, "--metric", metric, "--json"});
    }
    const std::string eight = set("park_choi_2011_am_5hz");
    check_same({"predict", eight, "--metric", "van-rossum", "--json"});
    check_same({"predict", eight, "--json"});
    check_same({"space", eight, "--json"});
}

}  // namespace instruction_set_test
