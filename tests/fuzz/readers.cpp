#include "tests/fuzz/readers.h"

#include <cstdio>
#include <cstdlib>

namespace tact::fuzz {

std::vector<Reader> all_readers() {
    std::vector<Reader> all;
    for (const auto some : {text_readers(), file_readers(), device_readers(), export_readers()}) {
        all.insert(all.end(), some.begin(), some.end());
    }
    return all;
}

void broken(const char* word) {
    std::fprintf(stderr, "broken law: %s\n", word);
    std::abort();
}

}  // namespace tact::fuzz
