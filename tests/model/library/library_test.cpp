// A folder as a library: what is in it, what is kept of it, and what a change costs.
#include <doctest/doctest.h>

#include <chrono>
#include <numbers>

#include "model/io/recordings/wave_file.h"
#include "model/io/set/set_file.h"
#include "model/library/library.h"
#include "model/library/library_folder.h"
#include "model/library/like.h"
#include "model/text/atomic_file.h"
#include "tests/support/temporary_folder.h"

namespace library_test {

using namespace tact;
namespace fs = std::filesystem;

namespace {

constexpr const char* kPulse = R"({"name": "Heartbeat", "description": "two soft beats",
 "tags": ["calm", "alive"], "duration": 300,
 "continuousPattern": {"amplitude": [{"time": 0, "value": 0.5}, {"time": 300, "value": 0.5}],
 "frequency": [{"time": 0, "value": 0.5}, {"time": 300, "value": 0.5}]}, "discretePattern": []})";

std::string android(int ms, int amplitude) {
    return "<vibration-effect><waveform-effect><waveform-entry durationMs=\"" + std::to_string(ms) +
           "\" amplitude=\"" + std::to_string(amplitude) +
           "\"/></waveform-effect></vibration-effect>";
}

Vibration called(const char* name, const Pattern& pattern) {
    Vibration vibration;
    vibration.name = name;
    vibration.source = pattern;
    return vibration;
}

// Effects of three formats, a recording, a set, a file that is broken, and one of no known kind.
struct Shelf {
    TemporaryFolder folder;

    Shelf() {
        fs::create_directories(folder.path / "phone" / "calls");
        folder.write("LICENSE", "\n  MIT License\n\nCopyright\n");
        folder.write("readme.md", "not a vibration");
        folder.write("heartbeat.json", kPulse);
        folder.write("phone/buzz.xml", android(200, 255));
        folder.write("phone/calls/ring.xml", android(400, 100));
        folder.write("phone/LICENSE.txt", "Apache License 2.0");
        folder.write("broken.ahap", "{\"Version\": 1, \"Pattern\": [");
        Pattern hum;
        hum.amplitude_g = 0.7;
        hum.carriers[0].frequency_hz = 80.0;
        hum.duration_s = 0.5;
        REQUIRE(write_wave_file(folder.path / "hum.wav", render(hum)));
        PatternSet set;
        set.vibrations.push_back(called("of a set", hum));
        REQUIRE(write_set_file(folder.path / "mine.tactspace.json", set));
    }

    Library open(const LibraryOptions& options = {}) const {
        auto library = open_library(folder.path, options);
        REQUIRE_MESSAGE(library, (library ? "" : library.error().message));
        return *std::move(library);
    }
};

const LibraryEntry& named(const Library& library, const std::string& name) {
    for (const LibraryEntry& entry : library.entries) {
        if (entry.name == name) return entry;
    }
    FAIL("no entry is called " << name);
    return library.entries.front();
}

std::vector<std::string> names(const Library& library, const std::vector<std::size_t>& places) {
    std::vector<std::string> all;
    for (const std::size_t place : places) all.push_back(library.entries[place].name);
    return all;
}

std::vector<std::string> search(const Library& library, std::string_view words) {
    return names(library, found_by_words(library, words));
}

}  // namespace

TEST_CASE("library: all formats of all folders, with what they say of themselves") {
    const Shelf shelf;
    const Library library = shelf.open();
    CHECK(search(library, "") ==
          std::vector<std::string>{"heartbeat", "hum", "of a set", "buzz", "ring"});
    const LibraryEntry& beat = named(library, "heartbeat");
    CHECK(beat.note.find("two soft beats") != std::string::npos);
    CHECK(beat.effect.format == "pulsar");
    CHECK(beat.duration_s == doctest::Approx(0.3));
    CHECK(file_of(library, beat).licence == "MIT License");
    CHECK(file_of(library, named(library, "ring")).licence == "Apache License 2.0");
    CHECK(file_of(library, named(library, "ring")).path == "phone/calls/ring.xml");
    const LibraryEntry& hum = named(library, "hum");
    CHECK(hum.recording);
    CHECK(hum.peak_g == doctest::Approx(0.7).epsilon(1e-3));
    CHECK(hum.mean_hz == doctest::Approx(80.0).epsilon(1e-3));
    std::vector<std::string> refused;
    for (const LibraryFile& file : library.files) {
        if (!file.left_out.empty()) refused.push_back(file.path);
    }
    CHECK(refused == std::vector<std::string>{"broken.ahap"});
}

TEST_CASE(
    "library: an effect that is called like a licence is an effect, and two licences say nothing") {
    const TemporaryFolder folder;
    for (const char* name : {"license.xml", "license_plate.xml", "licensed.xml"})
        folder.write(name, android(100, 100));
    folder.write("COPYING", "GPL");
    folder.write("LICENSE-MIT", "MIT");
    const auto library = open_library(folder.path);
    REQUIRE(library);
    CHECK(search(*library, "") == std::vector<std::string>{"license", "license_plate", "licensed"});
    CHECK(search(*library, "gpl").empty());
    CHECK(search(*library, "mit").empty());
    fs::remove(folder.path / "COPYING");
    const auto again = open_library(folder.path);
    REQUIRE(again);
    CHECK(search(*again, "mit").size() == 3);
}

TEST_CASE("library: every word has to be somewhere, in either case") {
    const Shelf shelf;
    const Library library = shelf.open();
    CHECK(search(library, "CALM") == std::vector<std::string>{"heartbeat"});
    CHECK(search(library, "soft alive pulsar") == std::vector<std::string>{"heartbeat"});
    CHECK(search(library, "soft apache").empty());
    CHECK(search(library, "phone/ apache") == std::vector<std::string>{"buzz", "ring"});
    CHECK(search(library, "  ").size() == library.entries.size());
}

TEST_CASE("library: what is kept gives the same, and only what changed is read") {
    const Shelf shelf;
    const Library first = shelf.open();
    CHECK(first.files_read == first.files.size());
    REQUIRE(fs::exists(shelf.folder.path / kLibraryFile));
    const Library again = shelf.open();
    CHECK(again.files_read == 0);
    CHECK(again.entries == first.entries);
    CHECK(again.files == first.files);

    shelf.folder.write("phone/buzz.xml", android(250, 255));
    const fs::path buzz = shelf.folder.path / "phone" / "buzz.xml";
    // A clock may stand still between two writes.
    fs::last_write_time(buzz, fs::last_write_time(buzz) + std::chrono::seconds(2));
    fs::remove(shelf.folder.path / "hum.wav");
    shelf.folder.write("phone/new.xml", android(50, 200));
    const Library changed = shelf.open();
    CHECK(changed.files_read == 2);
    CHECK(search(changed, "") ==
          std::vector<std::string>{"heartbeat", "of a set", "buzz", "new", "ring"});
    CHECK(named(changed, "buzz").duration_s == doctest::Approx(0.25));
    CHECK(shelf.open({.read_all = true}).entries == changed.entries);

    // A licence counts although the file itself is as it was.
    shelf.folder.write("phone/LICENSE.txt", "BSD");
    CHECK(file_of(changed, named(shelf.open(), "buzz")).licence == "Apache License 2.0");
    const Library licensed = shelf.open();
    CHECK(file_of(licensed, named(licensed, "buzz")).licence == "BSD");
    CHECK(licensed.files_read == 0);
}

TEST_CASE("library: an index that is damaged, old or not to be kept costs time and no entry") {
    const Shelf shelf;
    const Library whole = shelf.open({.keep = false});
    CHECK_FALSE(fs::exists(shelf.folder.path / kLibraryFile));
    shelf.open();
    const std::string good = *read_text_file(shelf.folder.path / kLibraryFile);
    std::string old = good;
    old.replace(old.find("\"version\":1"), 11, "\"version\":0");
    std::string negative = good;
    negative.replace(negative.find("\"duration_s\":"), 13, "\"duration_s\":-");
    for (const std::string& bad :
         {std::string("{"), std::string(), old, negative, good.substr(0, good.size() / 2)}) {
        shelf.folder.write(kLibraryFile, bad);
        const Library library = shelf.open();
        CHECK(library.entries == whole.entries);
        CHECK(library.files_read == library.files.size());
        REQUIRE(library.remarks.size() == 1);
        CHECK(library.remarks[0].find("all files were read again") != std::string::npos);
        CHECK(*read_text_file(shelf.folder.path / kLibraryFile) == good);
    }
}

TEST_CASE("library: a folder is asked for, and reading can be stopped") {
    const TemporaryFolder folder;
    folder.write("a.xml", android(100, 100));
    CHECK_FALSE(open_library(folder.path / "a.xml"));
    CHECK_FALSE(open_library(folder.path / "not there"));
    std::stop_source source;
    source.request_stop();
    CHECK_FALSE(open_library(folder.path, {.stop = source.get_token()}));
    CHECK_FALSE(fs::exists(folder.path / kLibraryFile));
    const auto library = open_library(folder.path);
    REQUIRE(library);
    const auto one = vibration_of(*library, library->entries[0]);
    REQUIRE(one);
    CHECK(entry_of(*one).peak_g == library->entries[0].peak_g);
    folder.write("a.xml", "<nothing/>");
    CHECK_FALSE(vibration_of(*library, library->entries[0]));
}

TEST_CASE("library: of a drawn shape the nearest is the one that has it") {
    const TemporaryFolder folder;
    const auto ramp = [](double from, double to) {
        Pattern pattern;
        pattern.amplitude_g = 1.0;
        pattern.duration_s = 0.4;
        pattern.amplitude_curve = {{0.0, from}, {0.4, to}};
        return pattern;
    };
    PatternSet set;
    set.vibrations = {called("rises", ramp(0.0, 1.0)), called("falls", ramp(1.0, 0.0)),
                      called("stays", ramp(1.0, 1.0))};
    REQUIRE(write_set_file(folder.path / "ramps.tactspace.json", set));
    const auto library = open_library(folder.path);
    REQUIRE(library);
    const auto nearest = [&](const std::vector<double>& drawn) {
        const auto shape = shape_through(drawn);
        REQUIRE(shape);
        const auto& entries = library->entries;
        return std::ranges::min_element(
                   entries, {},
                   [&](const LibraryEntry& entry) { return shape_difference(*shape, entry.shape); })
            ->name;
    };
    CHECK(nearest({0.0, 3.0}) == "rises");
    CHECK(nearest({1.0, 0.5, 0.0}) == "falls");
    CHECK(nearest({2.0, 2.0}) == "stays");
    CHECK_FALSE(shape_through({1.0}));
    CHECK_FALSE(shape_through({0.0, 0.0}));
    CHECK_FALSE(shape_through({-1.0, 1.0}));
    CHECK(shape_difference(*shape_through({0.0, 1.0}), *shape_through({0.0, 7.0})) == 0.0);
}

TEST_CASE("library: like itself nothing is, and what an export cannot hold is left out") {
    const Shelf shelf;
    const Library library = shelf.open();
    std::vector<std::size_t> all(library.entries.size());
    for (std::size_t k = 0; k < all.size(); ++k) all[k] = k;
    auto wanted = vibration_of(library, named(library, "buzz"));
    REQUIRE(wanted);
    const auto like = most_alike(library, {*wanted, all, {}, {}});
    REQUIRE_MESSAGE(like, (like ? "" : like.error().message));
    REQUIRE(like->hits.size() == library.entries.size());
    CHECK(library.entries[like->hits[0].entry].name == "buzz");
    CHECK(like->hits[0].nc == 0.0);
    CHECK(like->hits[0].oc == 0.0);
    CHECK_FALSE(like->exported);

    const auto target = export_target_named("android-xml");
    REQUIRE(target);
    const auto there = most_alike(library, {*wanted, all, *target, {}});
    REQUIRE_MESSAGE(there, (there ? "" : there.error().message));
    CHECK(names(library, there->not_held) == std::vector<std::string>{"hum"});
    REQUIRE(there->exported);
    // It is in the library, too: what comes back of both is the same.
    const auto& first = there->hits.front();
    CHECK(library.entries[first.entry].name == "buzz");
    CHECK(first.pm == there->exported->pm);
    CHECK(first.nc == there->exported->nc);
}

TEST_CASE("library: what is gone by then is told, and the others are compared") {
    const Shelf shelf;
    const Library library = shelf.open();
    auto wanted = vibration_of(library, named(library, "buzz"));
    REQUIRE(wanted);
    fs::remove(shelf.folder.path / "heartbeat.json");
    const auto like = most_alike(library, {*wanted, found_by_words(library, ""), {}, {}});
    REQUIRE(like);
    CHECK(like->hits.size() == library.entries.size() - 1);
    REQUIRE(like->unread.size() == 1);
    CHECK(like->unread[0].find("heartbeat.json") != std::string::npos);
}

}  // namespace library_test
