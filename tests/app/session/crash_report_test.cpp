#include "app/session/session.h"

#include <doctest/doctest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <vector>

#include "devices/device/crash_signals.h"
#include "devices/hid/emergency_packet.h"
#include "model/text/atomic_file.h"
#include "tests/support/temporary_folder.h"

namespace tact::crash_report_test {
namespace {

// How a child ended that watched for crashes.
int end_of_child(const std::filesystem::path& file, const std::function<void()>& crash) {
    const pid_t child = fork();
    REQUIRE(child >= 0);
    if (child == 0) {
        std::signal(SIGABRT, SIG_DFL);  // which doctest has for itself
        watch_for_crashes(file);
        crash();
        _exit(0);
    }
    int ended = 0;
    REQUIRE(waitpid(child, &ended, 0) == child);
    return ended;
}

// As UCX does, which comes with MPI.
void take_as_a_library(int signal) {
    struct sigaction action {};
    action.sa_sigaction = [](int, siginfo_t*, void*) { _exit(7); };
    action.sa_flags = SA_SIGINFO;
    sigaction(signal, &action, nullptr);
}

void crash_beside_a_library(const std::filesystem::path& controller, int signal) {
    take_as_a_library(signal);
    EmergencyPacket words(controller);
    words.set(std::vector<std::uint8_t>{'o', 'f', 'f'});
    std::raise(signal);
}

}  // namespace

TEST_CASE("crash report: it tells the signal, the stack and the last 16 commands") {
    const TemporaryFolder folder;
    const auto file = folder.path / "crash.txt";
    const int ended = end_of_child(file, [] {
        note_command("long ago");
        for (int k = 0; k < 15; ++k) note_command("Undo");
        note_command("Redo");
        std::abort();
    });
    CHECK(WIFSIGNALED(ended));
    CHECK(WTERMSIG(ended) == SIGABRT);
    const auto text = read_text_file(file);
    REQUIRE(text);
    CHECK(text->starts_with("tactspace "));
    CHECK(text->find("SIGABRT") != std::string::npos);
    CHECK(text->find("tactspace_tests(") != std::string::npos);
    CHECK(text->find("newest first\n  Redo\n  Undo\n") != std::string::npos);
    CHECK(text->find("long ago") == std::string::npos);
}

TEST_CASE("crash report: a controller is told to be still before it is written") {
    const TemporaryFolder folder;
    const auto file = folder.path / "crash.txt";
    const auto controller = folder.path / "controller";
    REQUIRE(write_atomically(controller, "......"));
    end_of_child(file, [&] {
        EmergencyPacket words(controller);
        words.set(std::vector<std::uint8_t>{'o', 'f', 'f'});
        std::abort();
    });
    CHECK(*read_text_file(controller) == "offoff");
    CHECK(read_text_file(file)->find("SIGABRT") != std::string::npos);
}

TEST_CASE("crash report: a library that took a signal of crashes before does not keep it") {
    if constexpr (kHasSanitizer) return;  // a sanitizer's handler looks the same, and stays
    for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL}) {
        CAPTURE(signal);
        const TemporaryFolder folder;
        const auto controller = folder.path / "controller";
        REQUIRE(write_atomically(controller, "......"));
        const int ended = end_of_child({}, [&] { crash_beside_a_library(controller, signal); });
        CHECK(WIFSIGNALED(ended));
        CHECK(WTERMSIG(ended) == signal);
        CHECK(read_text_file(controller)->starts_with("off"));
    }
    const TemporaryFolder folder;
    const auto file = folder.path / "crash.txt";
    end_of_child({}, [&] {
        take_as_a_library(SIGSEGV);
        watch_for_crashes(file);
        std::raise(SIGSEGV);
    });
    const auto text = read_text_file(file);
    REQUIRE(text);
    CHECK(text->find("SIGSEGV") != std::string::npos);
}

TEST_CASE("crash report: it is told of once, and kept") {
    const TemporaryFolder folder;
    const auto file = folder.path / "crash.txt";
    CHECK_FALSE(take_crash_report(file));
    REQUIRE(write_atomically(file, "first"));
    const auto first = take_crash_report(file);
    REQUIRE(first);
    CHECK(*read_text_file(*first) == "first");
    CHECK_FALSE(take_crash_report(file));
    REQUIRE(write_atomically(file, "second"));
    const auto second = take_crash_report(file);
    REQUIRE(second);
    CHECK(*second != *first);
    CHECK(*read_text_file(*first) == "first");
}

TEST_CASE("crash report: a normal end leaves none") {
    const TemporaryFolder folder;
    const auto file = folder.path / "crash.txt";
    CHECK(end_of_child(file, [] { note_command("Quit"); }) == 0);
    CHECK_FALSE(take_crash_report(file));
}

}  // namespace tact::crash_report_test
