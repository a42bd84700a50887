#include "model/text/names.h"

#include <doctest/doctest.h>

#include <set>

#include "model/text/utf8.h"

namespace file_stem_test {

using namespace tact;

TEST_CASE("file stem: a usual name is itself, and what file systems refuse becomes a dash") {
    CHECK(file_stem("L-4-full synthetic") == "L-4-full synthetic");
    CHECK(file_stem("\u9707\u52a8 1") == "\u9707\u52a8 1");
    CHECK(file_stem("../../evil") == "-..-..-evil");
    CHECK(file_stem("a\nb\x7F:c") == "a-b--c");
    CHECK(file_stem("") == "-");
    CHECK(file_stem(".hidden") == "-.hidden");
    CHECK(file_stem("caf\xE9") == "caf\uFFFD");
}

TEST_CASE("file stem: a long name is cut between characters, and stays unlike others") {
    std::set<std::string> stems;
    for (const std::string letter : {"x", "\u00e9", "\u0416", "\u6f22", "\U0001f600"}) {
        for (std::size_t begin = 0; begin < 4; ++begin) {
            for (const char* end : {"1", "2"}) {
                std::string name(begin, 'a');
                for (int k = 0; k < 200; ++k) name += letter;
                const std::string stem = file_stem(name + end);
                CHECK(stem.size() <= kLongestStem);
                CHECK(stem.size() > kLongestStem - 4);
                CHECK_FALSE(first_invalid_utf8(stem));
                CHECK(stems.insert(stem).second);
            }
        }
    }
    CHECK(file_stem(std::string(kLongestStem, 'x')) == std::string(kLongestStem, 'x'));
}

}  // namespace file_stem_test
