#include "app/manual/manual.h"

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <string>
#include <thread>

#include "app/window/window.h"
#include "tests/support/program.h"
#include "tests/support/temporary_folder.h"

namespace open_manual_test {

using namespace tact;
namespace fs = std::filesystem;

namespace {

// A variable of the environment for the time of a test.
struct Variable {
    const char* name;
    std::optional<std::string> before;

    Variable(const char* which, const std::string& value) : name(which) {
        if (const char* was = std::getenv(which)) before = was;
        ::setenv(name, value.c_str(), 1);
    }
    ~Variable() {
        if (before) ::setenv(name, before->c_str(), 1);
        if (!before) ::unsetenv(name);
    }
    Variable(const Variable&) = delete;
    Variable& operator=(const Variable&) = delete;
};

// A home with a browser that only notes what it is given, and a program that makes a manual.
struct Desktop {
    TemporaryFolder folder;
    Variable cache{"XDG_CACHE_HOME", (folder.path / "cache").string()};
    Variable path{"PATH", (folder.path / "bin").string() + ":/usr/bin:/bin"};
    fs::path program = script("prefix/bin/tactspace", "echo made >>\"$0.made\"; echo page >\"$3\"");

    fs::path script(const char* name, const std::string& lines) const {
        const fs::path file = folder.write(name, "#!/bin/sh\n" + lines + "\n");
        fs::permissions(file, fs::perms::owner_all);
        return file;
    }
    void install_browser() const {
        script("bin/xdg-open",
               "echo \"$1\" >\"$0.new\"; mv \"$0.new\" \"" + opened().string() + "\"");
    }
    fs::path opened() const { return folder.path / "opened"; }
    int times_made() const {
        return static_cast<int>(bytes_of(program.string() + ".made").size() / 5);
    }
    // Frames until the browser was given a page.
    std::string page_opened(Program& program_shown) const {
        const auto until = end_of_patience();
        while (!fs::exists(opened())) {
            REQUIRE(std::chrono::steady_clock::now() < until);
            std::this_thread::sleep_for(std::chrono::milliseconds(2));
            program_shown.frame();
        }
        std::string page = bytes_of(opened());
        fs::remove(opened());
        return page.substr(0, page.find('\n'));
    }
};

struct ProgramWithManual : Program {
    explicit ProgramWithManual(const Desktop& desktop) : Program(short_patterns(2)) {
        app.manual.program = desktop.program;
    }
};

}  // namespace

TEST_CASE("manual: F1 lists the keys, F1 again makes the manual and opens it, once a version") {
    const Desktop desktop;
    desktop.install_browser();
    ProgramWithManual program(desktop);
    program.press_key(key::kF1);
    CHECK(program.app.ui.dialog == kKeysDialog);
    CHECK(program.shows("button:manual"));
    program.press_key(key::kF1);
    CHECK(program.app.ui.dialog == kNoDialog);
    CHECK(desktop.page_opened(program) == kept_manual());
    CHECK(contains(program.app.ui.status.text, kept_manual().string()));
    CHECK(bytes_of(kept_manual()) == "page\n");
    CHECK(desktop.times_made() == 1);
    program.press_key(key::kF1);
    program.press_key(key::kEnter);
    CHECK(desktop.page_opened(program) == kept_manual());
    CHECK(desktop.times_made() == 1);
}

TEST_CASE("manual: an installed page is opened as it is, by the button") {
    const Desktop desktop;
    desktop.install_browser();
    const auto page = desktop.folder.write("prefix/share/doc/tactspace/manual.html", "page");
    ProgramWithManual program(desktop);
    program.press_key(key::kF1);
    program.click("button:manual");
    CHECK(desktop.page_opened(program) == page);
    CHECK(desktop.times_made() == 0);
}

TEST_CASE("manual: without a browser the line at the foot says where the page is") {
    const Desktop desktop;
    const Variable nowhere("PATH", (desktop.folder.path / "empty").string());
    const auto page = desktop.folder.write("prefix/share/doc/tactspace/manual.html", "page");
    ProgramWithManual program(desktop);
    for (const Command& command : commands()) {
        if (std::string_view(command.name) == "Manual") carry_out(program.app, command);
    }
    CHECK(contains(program.app.ui.status.text, page.string()));
    CHECK(program.app.ui.status.is_error);
}

TEST_CASE("manual: one that cannot be made is said, and a program that is none starts nothing") {
    const Desktop desktop;
    desktop.script("prefix/bin/tactspace", "exit 1");
    ProgramWithManual program(desktop);
    open_manual(program.app.ui, program.app.manual);
    const auto until = end_of_patience();
    while (!program.app.ui.status.is_error) {
        REQUIRE(std::chrono::steady_clock::now() < until);
        program.frame();
    }
    CHECK(program.app.ui.status.text.starts_with("The manual could not be made: "));
    program.app.manual.program.clear();
    open_manual(program.app.ui, program.app.manual);
    CHECK(contains(program.app.ui.status.text, "tactspace manual --out"));
}

}  // namespace open_manual_test
