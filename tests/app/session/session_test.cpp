#include "app/session/session.h"

#include <doctest/doctest.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <sstream>

namespace session_test {

using namespace tact;
namespace fs = std::filesystem;

namespace {

struct StateFolder {
    fs::path path;

    StateFolder() {
        std::string name = (fs::temp_directory_path() / "session-test-XXXXXX").string();
        REQUIRE(mkdtemp(name.data()) != nullptr);
        path = name;
    }
    ~StateFolder() {
        std::error_code none;
        fs::remove_all(path, none);
    }
    StateFolder(const StateFolder&) = delete;
    StateFolder& operator=(const StateFolder&) = delete;
};

void write(const fs::path& path, const std::string& text) { std::ofstream(path) << text; }

std::string read(const fs::path& path) {
    std::ostringstream text;
    text << std::ifstream(path).rdbuf();
    return text.str();
}

}  // namespace

TEST_CASE("session: what is set in one run is there in the next") {
    const StateFolder folder;
    {
        Session session = open_session(folder.path);
        CHECK(session.is_first);
        session.layout = {{"left", 0.25}, {"right_split", 0.1 + 0.2}};
        session.theme = "light";
        session.text_scale = 1.25;
        session.window_width = 1234;
        session.window_height = 777;
        session.window_maximised = true;
        session.dismissed_hints = {"space", "editor"};
        session.device = "audio/ALSA/pulse";
        session.device_choices = {{"audio/ALSA/pulse", 2, 4, 0.02}, {"audio/JACK/system", 1, 0, 0}};
        session.full_scale_g = 2.5;
        session.whole_buffer_s = 0.3;
        session.document = "/somewhere/caf\u00e9 \"1\".tactspace.json";
        remember_file(session, "/a.tactspace.json");
        REQUIRE(close_session(session));
    }
    const Session session = open_session(folder.path);
    CHECK(session.remarks.empty());
    CHECK(session.layout ==
          std::map<std::string, double>{{"left", 0.25}, {"right_split", 0.1 + 0.2}});
    CHECK(session.theme == "light");
    CHECK(session.text_scale == 1.25);
    CHECK(session.window_width == 1234);
    CHECK(session.window_height == 777);
    CHECK(session.window_maximised);
    CHECK(session.dismissed_hints == std::set<std::string>{"space", "editor"});
    CHECK(session.device == "audio/ALSA/pulse");
    CHECK(session.device_choices == std::vector<DeviceChoice>{{"audio/ALSA/pulse", 2, 4, 0.02},
                                                              {"audio/JACK/system", 1, 0, 0}});
    CHECK(session.full_scale_g == 2.5);
    CHECK(session.whole_buffer_s == 0.3);
    CHECK(session.document == "/somewhere/caf\u00e9 \"1\".tactspace.json");
    CHECK(session.recent_files == std::vector<fs::path>{"/a.tactspace.json"});
}

TEST_CASE("session: names of files and of devices come back byte for byte") {
    const StateFolder folder;
    const std::string name = "/home/na\xefve\xff%41\x1b";
    {
        Session session = open_session(folder.path);
        session.document = name;
        session.device = "hid/" + name;
        DeviceChoice choice;
        choice.id = "audio/ALSA/" + name;
        choice.calibration = name + ".json";
        session.device_choices = {choice};
        remember_file(session, name);
        REQUIRE(close_session(session));
    }
    Session later = open_session(folder.path);
    CHECK(later.document == name);
    CHECK(later.device == "hid/" + name);
    REQUIRE(later.device_choices.size() == 1);
    CHECK(later.device_choices[0].id == "audio/ALSA/" + name);
    CHECK(later.device_choices[0].calibration == name + ".json");
    CHECK(later.recent_files == std::vector<fs::path>{name});
    (void)close_session(later);
}

TEST_CASE("session: the first start has defaults and nothing to complain about") {
    const StateFolder folder;
    const Session session = open_session(folder.path / "deep" / "tactspace");
    CHECK(session.is_first);
    CHECK_FALSE(session.ended_in_crash);
    CHECK(session.remarks.empty());
    CHECK(session.theme == "dark");
    CHECK(fs::is_directory(folder.path / "deep" / "tactspace"));
}

TEST_CASE("session: damaged settings are kept aside, said, and start afresh") {
    for (const char* damage :
         {"{\"format\": 1, \"theme\": ", "", "[]", "{\"format\": 2}", "\"\xff\""}) {
        const StateFolder folder;
        write(folder.path / "session.json", damage);
        Session session = open_session(folder.path);
        CHECK(session.theme == "dark");
        REQUIRE(session.remarks.size() == 1);
        CHECK(session.remarks[0].find("session-damaged.json") != std::string::npos);
        CHECK(read(folder.path / "session-damaged.json") == damage);
        REQUIRE(close_session(session));
        CHECK(open_session(folder.path).remarks.empty());
    }
}

TEST_CASE("session: a member of the wrong type or out of range costs only itself") {
    const StateFolder folder;
    write(folder.path / "session.json", R"({"format": 1, "theme": 7, "text_scale": 1e300,
        "window_width": -5, "window_height": "tall", "layout": {"left": null, "right": 0.5},
        "recent_files": ["/a", 3, "/b"], "dismissed_hints": {"x": 1}, "document": "/c"})");
    const Session session = open_session(folder.path);
    CHECK(session.theme == "dark");
    CHECK(session.text_scale == 2.0);
    CHECK(session.window_width == 320);
    CHECK(session.window_height == 1000);
    CHECK(session.layout == std::map<std::string, double>{{"right", 0.5}});
    CHECK(session.recent_files == std::vector<fs::path>{"/a", "/b"});
    CHECK(session.dismissed_hints.empty());
    CHECK(session.document == "/c");
    CHECK(session.remarks.empty());
}

TEST_CASE("session: a run that was not closed is known as a crash, a closed one is not") {
    const StateFolder folder;
    { const Session crashed = open_session(folder.path); }
    Session after = open_session(folder.path);
    CHECK(after.ended_in_crash);
    REQUIRE(close_session(after));
    CHECK_FALSE(open_session(folder.path).ended_in_crash);
}

TEST_CASE("session: a second instance reads the settings, writes none and is no crash") {
    const StateFolder folder;
    Session first = open_session(folder.path);
    first.theme = "light";
    first.document = "/open in the first";
    REQUIRE(write_session(first));
    Session second = open_session(folder.path);
    CHECK_FALSE(second.is_first);
    CHECK_FALSE(second.ended_in_crash);
    CHECK(second.theme == "light");
    CHECK(second.document.empty());
    CHECK(second.autosave != first.autosave);
    Session third = open_session(folder.path);
    CHECK(third.autosave != second.autosave);

    second.theme = "dark";
    REQUIRE(close_session(second));
    REQUIRE(close_session(third));
    REQUIRE(close_session(first));
    const Session next = open_session(folder.path);
    CHECK(next.is_first);
    CHECK(next.theme == "light");
    std::size_t locks = 0;
    for (const auto& entry : fs::directory_iterator(folder.path)) {
        locks += entry.path().extension() == ".lock" ? 1 : 0;
    }
    CHECK(locks == 0);
}

TEST_CASE("session: recent files are ten, the last used first, each once, missing ones marked") {
    const StateFolder folder;
    Session session = open_session(folder.path);
    write(folder.path / "there.json", "{}");
    for (int i = 0; i < 15; ++i) remember_file(session, "/nowhere/" + std::to_string(i));
    remember_file(session, folder.path / "x" / ".." / "there.json");
    remember_file(session, "/nowhere/10");
    const std::vector<RecentFile> files = recent_files(session);
    REQUIRE(files.size() == kRecentFiles);
    CHECK(files[0].path == "/nowhere/10");
    CHECK(files[0].missing);
    CHECK(files[1].path == folder.path / "there.json");
    CHECK_FALSE(files[1].missing);
    CHECK(files[2].path == "/nowhere/14");
    CHECK(files[9].path == "/nowhere/6");
}

TEST_CASE("session: without a folder to write to, everything works and nothing is kept") {
    const StateFolder folder;
    write(folder.path / "file", "");
    Session session = open_session(folder.path / "file" / "tactspace");
    CHECK(session.remarks.size() == 1);
    CHECK(session.folder.empty());
    CHECK(write_session(session));
    CHECK(close_session(session));
}

TEST_CASE("session: settings that cannot be written are an error in words") {
    const StateFolder folder;
    Session session = open_session(folder.path);
    fs::create_directory(folder.path / "session.json");
    const auto written = write_session(session);
    REQUIRE_FALSE(written);
    CHECK(written.error().message.find("session.json") != std::string::npos);
}

TEST_CASE("session: the state folder follows XDG_STATE_HOME, then HOME") {
    const auto kept = [](const char* name) {
        const char* value = std::getenv(name);
        return value == nullptr ? std::string() : std::string(value);
    };
    const std::string state = kept("XDG_STATE_HOME");
    const std::string home = kept("HOME");
    setenv("XDG_STATE_HOME", "/x/state", 1);
    CHECK(state_folder() == "/x/state/tactspace");
    unsetenv("XDG_STATE_HOME");
    setenv("HOME", "/home/someone", 1);
    CHECK(state_folder() == "/home/someone/.local/state/tactspace");
    unsetenv("HOME");
    CHECK(state_folder().empty());
    if (!state.empty()) setenv("XDG_STATE_HOME", state.c_str(), 1);
    if (!home.empty()) setenv("HOME", home.c_str(), 1);
}

}  // namespace session_test
