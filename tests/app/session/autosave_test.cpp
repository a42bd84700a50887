#include "app/session/session.h"

#include <doctest/doctest.h>
#include <unistd.h>

#include <fstream>

#include "model/io/set/load.h"
#include "model/io/set/set_file.h"
#include "model/text/atomic_file.h"

namespace autosave_test {

using namespace tact;
namespace fs = std::filesystem;

namespace {

// A state folder and a folder with the person's own files.
struct Places {
    fs::path root;
    fs::path state;
    fs::path own;

    Places() {
        std::string name = (fs::temp_directory_path() / "autosave-test-XXXXXX").string();
        REQUIRE(mkdtemp(name.data()) != nullptr);
        root = fs::canonical(name);
        state = root / "state";
        own = root / "own";
        fs::create_directories(own / "measured");
    }
    ~Places() {
        std::error_code none;
        fs::remove_all(root, none);
    }
    Places(const Places&) = delete;
    Places& operator=(const Places&) = delete;
};

Document one_pattern(double amplitude_g) {
    Document document;
    document.set.name = "one";
    Vibration vibration;
    vibration.name = "buzz";
    document.set.vibrations.push_back(vibration);
    std::get<Pattern>(document.set.vibrations[0].source).amplitude_g = amplitude_g;
    return document;
}

double amplitude_of(const PatternSet& set) {
    return std::get<Pattern>(set.vibrations.at(0).source).amplitude_g;
}

// A document as it is after it was stored: nothing unsaved.
Document stored(const Places& places, double amplitude_g) {
    Document document = one_pattern(amplitude_g);
    document.path = places.own / "one.tactspace.json";
    REQUIRE(write_set_file(document.path, document.set));
    document.saved = document.set;
    return document;
}

// Three samples of 16 bits at 10 kHz, one channel.
void write_wave(const fs::path& path) {
    constexpr std::string_view kBytes(
        "RIFF\x2a\0\0\0WAVEfmt \x10\0\0\0\1\0\1\0\x10\x27\0\0\x20\x4e\0\0\2\0\x10\0"
        "data\6\0\0\0\0\0\0\x40\0\xc0",
        50);
    std::ofstream(path, std::ios::binary) << kBytes;
}

void edit(Document& document, double amplitude_g) {
    std::get<Pattern>(document.set.vibrations.at(0).source).amplitude_g = amplitude_g;
}

}  // namespace

TEST_CASE("autosave: closing without saving loses nothing, and the document is still unsaved") {
    const Places places;
    {
        Session session = open_session(places.state);
        Document document = stored(places, 1.0);
        edit(document, 2.5);
        REQUIRE(autosave(session, document));
        REQUIRE(close_session(session));
    }
    Session session = open_session(places.state);
    const Restored restored = restore(session);
    REQUIRE(restored.document.has_value());
    CHECK(amplitude_of(restored.document->set) == 2.5);
    CHECK(amplitude_of(restored.document->saved) == 1.0);
    CHECK(restored.document->path == places.own / "one.tactspace.json");
    CHECK_FALSE(restored.is_error);
    CHECK(restored.remark.find("one.tactspace.json") != std::string::npos);
    CHECK(restored.remark.find("crash") == std::string::npos);
}

TEST_CASE("autosave: a path of any bytes comes back as it was, from settings too") {
    const Places places;
    Document document = stored(places, 1.0);
    document.path = places.own / "na\xefve 100%.tactspace.json";
    REQUIRE(write_set_file(document.path, document.set));
    {
        Session session = open_session(places.state);
        remember_file(session, document.path);
        session.document = document.path;
        edit(document, 2.5);
        REQUIRE(autosave(session, document));
        REQUIRE(close_session(session));
    }
    Session session = open_session(places.state);
    CHECK(session.document == document.path);
    REQUIRE(session.recent_files.size() == 1);
    CHECK(session.recent_files[0] == document.path);
    const Restored restored = restore(session);
    REQUIRE(restored.document.has_value());
    CHECK(restored.document->path == document.path);
    CHECK(amplitude_of(restored.document->saved) == 1.0);
}

TEST_CASE("autosave: what is kept is for this user alone, whatever was open to others before") {
    const Places places;
    fs::create_directories(places.state / "studies" / "one");
    std::ofstream(places.state / "studies" / "one" / "answers.jsonl") << "{}";
    Session session = open_session(places.state);
    REQUIRE(autosave(session, one_pattern(2.0)));
    REQUIRE(write_session(session));
    const auto is_private = [](const fs::path& path) {
        return (fs::status(path).permissions() & (fs::perms::group_all | fs::perms::others_all)) ==
               fs::perms::none;
    };
    CHECK(is_private(places.state));
    CHECK(is_private(session.autosave));
    CHECK(is_private(places.state / "session.json"));
    CHECK(is_private(places.state / "studies"));
    CHECK(is_private(places.state / "studies" / "one" / "answers.jsonl"));
    const auto aside = set_autosave_aside(session);
    REQUIRE(aside);
    CHECK(is_private(*aside));
}

TEST_CASE("autosave: whatever is written into the kept folder during a run is private at once") {
    const Places places;
    const Session session = open_session(places.state);
    const auto mode_of = [](const fs::path& path) { return fs::status(path).permissions(); };
    constexpr auto kOwner = fs::perms::owner_read | fs::perms::owner_write;
    const fs::path folder = places.state / "studies" / "new";
    REQUIRE(make_folder(folder));
    CHECK(mode_of(folder) == fs::perms::owner_all);
    CHECK(mode_of(places.state / "running") == kOwner);
    REQUIRE(write_atomically(folder / "whole", "x"));
    CHECK(mode_of(folder / "whole") == kOwner);
    REQUIRE(open_alone(folder / "log", true));
    CHECK(mode_of(folder / "log") == kOwner);
    // Beside it, what the umask says: the folder is of the same kind, and another one.
    REQUIRE(write_atomically(places.state.string() + " beside", "x"));
    CHECK(mode_of_new(places.state.string() + " beside", 0666) == 0666);
    CHECK(mode_of_new(places.state / "a" / ".." / ".." / "b", 0666) == 0666);
    CHECK(mode_of_new(places.state / "a" / "b" / "c", 0666) == 0600);
}

TEST_CASE("autosave: after a crash the remark says so") {
    const Places places;
    {
        const Session session = open_session(places.state);
        REQUIRE(autosave(session, one_pattern(2.0)));
    }
    Session session = open_session(places.state);
    const Restored restored = restore(session);
    REQUIRE(restored.document.has_value());
    CHECK(restored.document->path.empty());
    CHECK(restored.remark.find("crash") != std::string::npos);
}

TEST_CASE("autosave: once saved, the file on the disk is what comes back") {
    const Places places;
    {
        Session session = open_session(places.state);
        Document document = stored(places, 1.0);
        edit(document, 2.0);
        REQUIRE(autosave(session, document));
        document = stored(places, 3.0);
        REQUIRE(autosave(session, document));
        CHECK_FALSE(fs::exists(session.autosave));
        session.document = document.path;
        REQUIRE(close_session(session));
    }
    Session session = open_session(places.state);
    const Restored restored = restore(session);
    REQUIRE(restored.document.has_value());
    CHECK(amplitude_of(restored.document->set) == 3.0);
    CHECK(restored.document->set == restored.document->saved);
    CHECK(restored.remark.empty());
}

TEST_CASE("autosave: with nothing open before, nothing is restored and nothing is said") {
    const Places places;
    Session session = open_session(places.state);
    const Restored restored = restore(session);
    CHECK_FALSE(restored.document.has_value());
    CHECK(restored.remark.empty());
}

TEST_CASE("autosave: a document whose file is gone is an error in words, not a crash") {
    const Places places;
    Session session = open_session(places.state);
    session.document = places.own / "gone.tactspace.json";
    const Restored restored = restore(session);
    CHECK_FALSE(restored.document.has_value());
    CHECK(restored.is_error);
    CHECK(restored.remark.find("gone.tactspace.json") != std::string::npos);
}

TEST_CASE("autosave: unsaved changes of a document whose file is gone come back") {
    const Places places;
    Session session = open_session(places.state);
    Document document = stored(places, 1.0);
    edit(document, 2.0);
    REQUIRE(autosave(session, document));
    fs::remove(document.path);
    const Restored restored = restore(session);
    REQUIRE(restored.document.has_value());
    CHECK(amplitude_of(restored.document->set) == 2.0);
    CHECK_FALSE(restored.document->set == restored.document->saved);
}

TEST_CASE("autosave: a start with another file moves unsaved changes to a set of their own") {
    const Places places;
    Session session = open_session(places.state);
    REQUIRE(autosave(session, one_pattern(2.0)));
    const auto first = set_autosave_aside(session);
    REQUIRE(first);
    CHECK_FALSE(fs::exists(session.autosave));
    const std::string name = first->filename().string();
    CHECK(name.starts_with("recovered-20"));
    CHECK(name.ends_with(".tactspace.json"));
    CHECK(name.size() == std::string("recovered-20260131-235959.tactspace.json").size());
    CHECK(session.recent_files.at(0) == *first);
    const auto loaded = load_set(*first);
    REQUIRE(loaded);
    CHECK(amplitude_of(loaded->set) == 2.0);

    // Within the same second, the name of the first is taken.
    REQUIRE(autosave(session, one_pattern(3.0)));
    const auto second = set_autosave_aside(session);
    REQUIRE(second);
    CHECK(*second != *first);
    CHECK(amplitude_of(load_set(*first)->set) == 2.0);
    CHECK(amplitude_of(load_set(*second)->set) == 3.0);

    const auto nothing = set_autosave_aside(session);
    REQUIRE(nothing);
    CHECK(nothing->empty());
}

TEST_CASE("autosave: recordings are found again from wherever the autosave lies") {
    const Places places;
    write_wave(places.own / "measured" / "buzz.wav");
    Session session = open_session(places.state);
    Document document;
    document.path = places.own / "one.tactspace.json";
    std::ofstream(document.path) << R"({"tactspace": 1, "name": "one", "patterns":
        [{"name": "buzz", "waveform": "measured/buzz.wav", "scale_g": 2.0}]})";
    const auto opened = load_set(document.path);
    REQUIRE(opened);
    document.set = document.saved = opened->set;
    document.set.name = "renamed";
    REQUIRE(autosave(session, document));

    const Restored restored = restore(session);
    REQUIRE_MESSAGE(restored.document.has_value(), restored.remark);
    CHECK(restored.document->set.name == "renamed");
    CHECK(restored.document->set.vibrations == restored.document->saved.vibrations);

    const auto aside = set_autosave_aside(session);
    REQUIRE(aside);
    const auto loaded = load_set(*aside);
    REQUIRE(loaded);
    CHECK(waveform_of(loaded->set.vibrations.at(0)) == waveform_of(document.set.vibrations.at(0)));
}

TEST_CASE("autosave: one that cannot be read is kept aside and never in the way again") {
    for (const char* damage :
         {"", "{\"format\": 1", "[1]", "{\"format\": 1, \"path\": 3, \"set\": \"\"}",
          "{\"format\": 1, \"path\": \"\", \"set\": \"no set\"}"}) {
        const Places places;
        Session session = open_session(places.state);
        std::ofstream(session.autosave) << damage;
        const Restored restored = restore(session);
        CHECK_FALSE(restored.document.has_value());
        CHECK(restored.is_error);
        CHECK(restored.remark.find("recovered-") != std::string::npos);
        CHECK_FALSE(fs::exists(session.autosave));
        CHECK(restore(session).remark.empty());
    }
}

TEST_CASE("autosave: changes of a second instance that died are found by the next first one") {
    const Places places;
    Session first = open_session(places.state);
    {
        Session second = open_session(places.state);
        REQUIRE_FALSE(second.is_first);
        REQUIRE(autosave(second, one_pattern(4.0)));
        REQUIRE(close_session(second));  // closing never asks; dying leaves the same files
    }
    Session third = open_session(places.state);
    REQUIRE(autosave(third, one_pattern(5.0)));
    REQUIRE(close_session(first));

    Session next = open_session(places.state);
    REQUIRE(next.is_first);
    REQUIRE(next.recovered.size() == 1);  // the third still runs
    CHECK(amplitude_of(load_set(next.recovered[0])->set) == 4.0);
    CHECK(next.recent_files.at(0) == next.recovered[0]);
    CHECK(fs::exists(third.autosave));
    CHECK_FALSE(restore(next).document.has_value());
}

TEST_CASE("autosave: a disk that refuses is an error in words, and the old autosave stays") {
    const Places places;
    Session session = open_session(places.state);
    session.autosave = places.state / "no such folder" / "autosave.json";
    const auto kept = autosave(session, one_pattern(1.0));
    REQUIRE_FALSE(kept);
    CHECK(kept.error().message.find("autosave.json") != std::string::npos);
}

}  // namespace autosave_test
