// Lists of formats in the words of the interface are kept by hand: each has them all.
#include <doctest/doctest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "app/python/help.h"
#include "app/window/window.h"
#include "assets/assets.h"
#include "model/io/formats/write_effect.h"
#include "tests/support/format_words.h"
#include "tests/support/temporary_folder.h"

namespace format_words_test {

using namespace tact;

namespace {

const std::vector<std::string> kNone;

std::string words_of(std::string_view name) {
    const auto command = std::ranges::find(commands(), name, &Command::name);
    REQUIRE(command != commands().end());
    return command->words;
}

}  // namespace

TEST_CASE("words of formats: a list that lacks a format is told from one that has them all") {
    CHECK(read_formats_missing_in("").size() > 5);
    const std::vector<std::string> missing = read_formats_missing_in(
        "AHAP, the .haptic, HJIF, .haps, .hla, Android's XML, those of browsers, Pulsar presets");
    CHECK(missing == std::vector<std::string>{"he"});
}

TEST_CASE("words of formats: manual, palette and Python name every format that is read") {
    const std::string chapter(asset("manual/formats.html"));
    const std::size_t from = chapter.find("<p>Read: ");
    const std::size_t to = chapter.find("They become patterns", from);
    REQUIRE(to != chapter.npos);
    CHECK(read_formats_missing_in(chapter.substr(from, to - from)) == kNone);
    CHECK(read_formats_missing_in(words_of("Open...")) == kNone);
    CHECK(read_formats_missing_in(help::kReadSet) == kNone);
}

TEST_CASE("words of formats: palette and Python name every format that is written") {
    const std::string words = " " + words_of("Export vibrations...") + " ";
    for (const TargetTraits& target : target_formats()) {
        const std::string key = target.key;
        CAPTURE(key);
        CHECK(contains(words, " " + key.substr(0, key.find('-')) + " "));
        CHECK(contains(help::kExport, "\"" + key + "\""));
    }
}

}  // namespace format_words_test
