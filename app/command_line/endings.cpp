#include "app/command_line/endings.h"

#include <fcntl.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <cstdio>
#include <iostream>
#include <streambuf>
#include <string>
#include <string_view>

#include "devices/device/crash_signals.h"
#include "model/text/atomic_file.h"
#include "model/text/shown_text.h"

namespace tact {

namespace {

void take_closed_descriptors() {
    for (const int wanted : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
        if (fcntl(wanted, F_GETFD) >= 0) continue;
        // Standard output cannot be written then either, so that results are not lost in silence.
        const int opened = open("/dev/null", wanted == STDERR_FILENO ? O_WRONLY : O_RDONLY);
        if (opened < 0) return;  // there is no /dev: all stays as it was
    }
}

void end_tidily(int signal) {
    remove_unfinished_files();
    constexpr std::string_view kWords =
        "tactspace: stopped before all was done; what was not finished is removed\n";
    [[maybe_unused]] const ssize_t said = write(STDERR_FILENO, kWords.data(), kWords.size());
    raise(signal);  // the handler was for once
}

void answer(int signal, void (*handler)(int), int flags) {
    struct sigaction before {};
    if (sigaction(signal, nullptr, &before) != 0 || !may_be_taken(before)) return;
    struct sigaction action {};
    action.sa_handler = handler;
    action.sa_flags = flags;
    sigemptyset(&action.sa_mask);
    sigaction(signal, &action, nullptr);
}

void answer_signals() {
    constexpr int kOnce = static_cast<int>(SA_RESETHAND | SA_ONSTACK);
    for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGALRM, SIGXCPU}) {
        answer(signal, end_tidily, kOnce);
    }
    // Not ignored: programs that are started from here find them as they are usually.
    for (const int signal : {SIGPIPE, SIGXFSZ})
        answer(
            signal, [](int) {}, SA_RESTART);
}

// Hands text on to another buffer as it is shown to people.
class ShownBuffer final : public std::streambuf {
  public:
    ShownBuffer(std::streambuf* to, bool keeps_lines) : to_(to), keeps_lines_(keeps_lines) {}

  protected:
    int_type overflow(int_type character) override {
        if (character == traits_type::eof()) return 0;
        const char one = traits_type::to_char_type(character);
        return xsputn(&one, 1) == 1 ? character : traits_type::eof();
    }

    std::streamsize xsputn(const char* text, std::streamsize count) override {
        pending_.append(text, static_cast<std::size_t>(count));
        if (!keeps_lines_) return hand_on() ? count : 0;
        if (pending_.ends_with('\n') && !hand_on()) return 0;
        return count;
    }

    int sync() override { return hand_on() && to_->pubsync() == 0 ? 0 : -1; }

  private:
    bool hand_on() {
        const bool ends_line = pending_.ends_with('\n');
        if (ends_line && !keeps_lines_) pending_.pop_back();
        std::string shown = keeps_lines_ ? shown_lines(pending_) : shown_text(pending_);
        if (ends_line && !keeps_lines_) shown += '\n';
        pending_.clear();
        const auto size = static_cast<std::streamsize>(shown.size());
        return to_->sputn(shown.data(), size) == size;
    }

    std::streambuf* to_;
    bool keeps_lines_;
    std::string pending_;
};

// The streams outlive main(), and so do their buffers.
void show_text_only() {
    std::cerr.rdbuf(new ShownBuffer(std::cerr.rdbuf(), false));
    if (isatty(STDOUT_FILENO) == 0) return;
    std::cout.rdbuf(new ShownBuffer(std::cout.rdbuf(), true));
}

}  // namespace

void prepare_endings() {
    take_closed_descriptors();
    answer_signals();
    show_text_only();
}

Expected<Done> flushed_output() {
    std::cout.flush();
    if (std::cout) return Done{};
    return Error{"standard output: cannot be written"};
}

namespace {

// Signals are sent to the process, which has just one exit code.
std::atomic<int> caught{0};

}  // namespace

Interrupt::Interrupt(Interrupted what)
    : what_(what), watch_([this](int signal) { stop_by(signal); }) {}

void Interrupt::stop_by(int signal) {
    int none = 0;
    if (what_ == Interrupted::too_early) caught.compare_exchange_strong(none, signal);
    if (!stop_.request_stop() || is_silent_ || what_ == Interrupted::is_the_end) return;
    // Over what the progress line shows.
    std::fprintf(stderr, "%stactspace: stopping after the running work; once more stops at once\n",
                 isatty(STDERR_FILENO) != 0 ? "\r\033[K" : "");
}

int interrupting_signal() { return caught; }

int interrupted_exit_code() {
    constexpr int kBySignal = 128;
    const int signal = interrupting_signal();
    return signal == 0 ? 0 : kBySignal + signal;
}

}  // namespace tact
