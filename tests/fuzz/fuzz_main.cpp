// The fuzzed reader is that of TACTSPACE_READER. With TACTSPACE_SEEDS, a folder, the seeds and the
// dictionaries of all readers are written into it instead, and with neither their names are listed.
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "tests/fuzz/readers.h"

namespace {

using namespace tact::fuzz;

bool (*read_bytes)(std::string_view) = nullptr;

void write_seeds(const std::filesystem::path& folder) {
    for (const Reader& reader : all_readers()) {
        const auto place = folder / reader.name;
        std::filesystem::create_directories(place);
        int number = 0;
        for (const std::string& seed : reader.seeds()) {
            std::ofstream(place / ("seed_" + std::to_string(number++)), std::ios::binary) << seed;
        }
        std::ofstream words(folder / (std::string(reader.name) + ".dict"));
        for (const std::string& word : reader.words) {
            words << '"';
            for (const char c : word) {
                if (c == '"' || c == '\\') words << '\\';
                words << c;
            }
            words << "\"\n";
        }
    }
}

}  // namespace

extern "C" int LLVMFuzzerInitialize(int*, char***) {
    if (const char* folder = std::getenv("TACTSPACE_SEEDS")) {
        write_seeds(folder);
        std::exit(0);
    }
    const char* name = std::getenv("TACTSPACE_READER");
    for (const Reader& reader : all_readers()) {
        if (name == nullptr) std::puts(reader.name);
        if (name != nullptr && std::string(name) == reader.name) read_bytes = reader.read;
    }
    if (read_bytes == nullptr) std::exit(name == nullptr ? 0 : 1);
    return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    read_bytes({reinterpret_cast<const char*>(data), size});
    return 0;
}
