// The table of endings of a window while it plays on a controller: the last packet is neutral and
// comes within 100 ms, as tests/devices/rest/rest_table.cpp has it for the command line. Every
// ending meets another kind of controller; a display of its own, Xvfb, and xdotool for the keys.
//
// Left out  SIGKILL, which no program hears (devices/hid/emergency_packet.h)
#include <doctest/doctest.h>
#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <functional>
#include <optional>

#include "devices/hid/hid_device.h"
#include "tests/devices/rest/driven_pads.h"
#include "tests/support/temporary_folder.h"

namespace window_table {

using namespace tact;
using Clock = std::chrono::steady_clock;

namespace {

// With these words, and what it says in a file. What is no part of this test goes without umockdev.
pid_t started(const std::vector<std::string>& words, const std::string& said, int kept_open = -1) {
    const pid_t pid = fork();
    REQUIRE(pid >= 0);
    if (pid > 0) return pid;
    setpgid(0, 0);  // a signal of the terminal's is not meant for this test
    const int file = open(said.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    dup2(file, 1);
    dup2(file, 2);
    if (kept_open >= 0) dup2(kept_open, 3);
    std::vector<char*> pointers;
    for (const std::string& word : words) pointers.push_back(const_cast<char*>(word.c_str()));
    pointers.push_back(nullptr);
    execvp(pointers[0], pointers.data());
    _exit(127);
}

struct Screen {
    pid_t pid = 0;
    std::string name;  // ":99"
};

Screen screen_in(const TemporaryFolder& folder) {
    const std::string told = (folder.path / "display").string();
    const int file = open(told.c_str(), O_RDWR | O_CREAT, 0600);
    Screen screen;
    screen.pid = started({"env", "-u", "LD_PRELOAD", "Xvfb", "-displayfd", "3", "-noreset",
                          "-screen", "0", "1024x768x24", "-nolisten", "tcp"},
                         (folder.path / "xvfb").string(), file);
    close(file);
    REQUIRE(comes_true([&] { return bytes_of(told).ends_with('\n'); }));
    screen.name = ":" + bytes_of(told);
    screen.name.pop_back();
    return screen;
}

// When it was pressed: to start what presses it takes a while.
Clock::time_point press(const std::string& key) {
    const std::string command = "env -u LD_PRELOAD xdotool key " + key;
    CHECK(std::system(command.c_str()) == 0);
    return Clock::now();
}

std::string id_of(const Kind& kind) {
    for (const HidActuator& actuator : hid_actuators()) {
        if (actuator.name == kind.name) return lasting_id(actuator);
    }
    return {};
}

// A window with the controller chosen, which plays over and over.
Process playing(const TemporaryFolder& folder, MockBench& bench, const Kind& kind) {
    const std::string id = id_of(kind);
    REQUIRE(!id.empty());
    folder.write("state/tactspace/session.json",
                 R"({"format": 1, "window_width": 800, "window_height": 600, "device": ")" + id +
                     R"(", "device_choices": [{"id": ")" + id + R"("}]})");
    const std::filesystem::path set =
        folder.write("loop.tactspace.json",
                     R"({"tactspace": 1, "name": "loop", "duration_s": 1, "patterns": [
            {"name": "Hum", "amplitude_g": 1, "carriers": [{"frequency_hz": 150}]},
            {"name": "Low", "amplitude_g": 1, "carriers": [{"frequency_hz": 60}]}]})");
    const std::string places = (folder.path / "rects").string();
    setenv("XDG_STATE_HOME", (folder.path / "state").c_str(), 1);
    setenv("TACTSPACE_WIDGET_RECTS", places.c_str(), 1);
    Process window;
    window.pid =
        started({std::getenv("TACTSPACE_PROGRAM"), set.string()}, (folder.path / "said").string());
    CHECK_MESSAGE(comes_true([&] {
                      return window.has_ended() ||
                             bytes_of(places).find("\nlevel\t") != std::string::npos;
                  }),
                  "there is no level");
    REQUIRE_MESSAGE(!window.has_ended(), bytes_of(folder.path / "said"));
    press("space");
    REQUIRE_MESSAGE(comes_true([&] { return is_driven(bench, kind); }),
                    bytes_of(folder.path / "said"));
    return window;
}

Clock::time_point send(pid_t pid, int signal) {
    const Clock::time_point began = Clock::now();
    kill(pid, signal);
    return began;
}

struct Ending {
    const char* name;
    std::function<Clock::time_point(const Screen&, const Process&)> act;  // when it began
    int wanted;  // the exit code, or minus the signal
};

Ending signalled(const char* name, int signal, int wanted) {
    return {name,
            [signal](const Screen&, const Process& window) { return send(window.pid, signal); },
            wanted};
}

std::vector<Ending> endings() {
    return {{"Ctrl+Q", [](const Screen&, const Process&) { return press("ctrl+q"); }, 0},
            signalled("SIGTERM", SIGTERM, -SIGTERM),
            signalled("SIGABRT", SIGABRT, -SIGABRT),
            {"its display is killed",
             [](const Screen& screen, const Process&) { return send(screen.pid, SIGKILL); }, 1},
            signalled("SIGTSTP", SIGTSTP, -SIGTERM)};
}

Clock::duration time_to_rest(const Ending& ending, const Kind& kind) {
    const TemporaryFolder folder;
    MockBench bench({kind.pad});
    const Screen screen = screen_in(folder);
    setenv("DISPLAY", screen.name.c_str(), 1);
    Process window = playing(folder, bench, kind);
    const Clock::time_point acted = ending.act(screen, window);
    CHECK_MESSAGE(comes_true([&] { return is_at_rest(bench, kind); }), "it is never neutral");
    if (std::string_view(ending.name) == "SIGTSTP") {
        CHECK(comes_true([&] { return window.is_halted(); }));
        CHECK(is_at_rest(bench, kind));
        kill(window.pid, SIGCONT);
        kill(window.pid, SIGTERM);
    }
    CHECK_MESSAGE(comes_true([&] { return window.has_ended(); }), "the program does not end");
    if (!window.has_ended()) kill(window.pid, SIGKILL);
    const int how = window.ended.value_or(0);
    CHECK((WIFSIGNALED(how) ? -WTERMSIG(how) : WEXITSTATUS(how)) == ending.wanted);
    CHECK(is_at_rest(bench, kind));
    kill(screen.pid, SIGTERM);
    waitpid(screen.pid, nullptr, 0);
    return rested_at(bench, kind) - acted;
}

}  // namespace

TEST_CASE("rest: a window that ends leaves its controller at rest within 100 ms") {
    REQUIRE(std::getenv("TACTSPACE_PROGRAM") != nullptr);
    const std::vector<Ending> all = endings();
    for (std::size_t k = 0; k < all.size(); ++k) {
        SUBCASE(all[k].name) {
            const Kind kind = kinds()[k];
            Clock::duration best = Clock::duration::max();
            for (int round = 0; round < kRounds && best > kInTime; ++round) {
                best = std::min(best, time_to_rest(all[k], kind));
            }
            MESSAGE(std::string(all[k].name), ", ", kind.name, " ",
                    std::chrono::duration<double, std::milli>(best).count(), " ms");
            CHECK(best <= kInTime);
        }
    }
}

}  // namespace window_table
