// The program as a person at a terminal runs it: arguments in, exit code and both outputs out.
#pragma once

#include <doctest/doctest.h>
#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <future>
#include <string>
#include <string_view>
#include <vector>

#include "tests/support/places.h"

struct Ran {
    int exit_code = 0;  // 128 + signal where one ended it, as shells say it
    std::string out;
    std::string err;
};

inline std::string everything_from(int descriptor) {
    std::string text;
    std::array<char, 65'536> piece{};
    for (ssize_t count = 0; (count = ::read(descriptor, piece.data(), piece.size())) > 0;) {
        text.append(piece.data(), static_cast<std::size_t>(count));
    }
    ::close(descriptor);
    return text;
}

// The environment without a display: no test may open a window on somebody's screen.
inline std::vector<char*> environment_without_display() {
    std::vector<char*> kept;
    for (char** entry = environ; *entry != nullptr; ++entry) {
        const std::string_view text(*entry);
        if (text.starts_with("DISPLAY=") || text.starts_with("WAYLAND_DISPLAY=")) continue;
        kept.push_back(*entry);
    }
    kept.push_back(nullptr);
    return kept;
}

inline std::vector<char*> pointers_to(std::vector<std::string>& texts) {
    std::vector<char*> pointers;
    for (std::string& text : texts) pointers.push_back(text.data());
    pointers.push_back(nullptr);
    return pointers;
}

// `limits` are words of the shell that starts the program, such as "ulimit -f 0". Outputs go
// through pipes, which limits on files do not touch.
inline Ran run_program(const std::vector<std::string>& arguments, const std::string& limits = ":") {
    std::vector<std::string> words{"/bin/sh", "-c", limits + "; exec \"$@\"", "sh", tact::kProgram};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::array<int, 2> out{};
    std::array<int, 2> err{};
    REQUIRE(::pipe2(out.data(), O_CLOEXEC) == 0);
    REQUIRE(::pipe2(err.data(), O_CLOEXEC) == 0);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_adddup2(&actions, out[1], STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&actions, err[1], STDERR_FILENO);
    pid_t process = 0;
    std::vector<char*> environment = environment_without_display();
    REQUIRE(::posix_spawn(&process, "/bin/sh", &actions, nullptr, pointers_to(words).data(),
                          environment.data()) == 0);
    posix_spawn_file_actions_destroy(&actions);
    ::close(out[1]);
    ::close(err[1]);

    Ran ran;
    auto errors = std::async(std::launch::async, everything_from, err[0]);
    ran.out = everything_from(out[0]);
    ran.err = errors.get();
    int status = 0;
    REQUIRE(::waitpid(process, &status, 0) == process);
    ran.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    return ran;
}

// What the program prints when all goes well.
inline std::string output_of(const std::vector<std::string>& arguments) {
    const Ran ran = run_program(arguments);
    REQUIRE_MESSAGE(ran.exit_code == 0, ran.err);
    return ran.out;
}

// The sentence with which the program refuses: the only line it prints, with exit code 1.
inline std::string refusal_of(const std::vector<std::string>& arguments,
                              const std::string& limits = ":") {
    const Ran ran = run_program(arguments, limits);
    CHECK(ran.exit_code == 1);
    CHECK(ran.out == "");
    CHECK_MESSAGE(ran.err.starts_with("tactspace: "), ran.err);
    CHECK_MESSAGE(std::ranges::count(ran.err, '\n') == 1, ran.err);
    CHECK_MESSAGE(ran.err.ends_with('\n'), ran.err);
    return ran.err;
}

// Cells of a CSV text without quotes.
inline std::vector<std::vector<std::string>> cells_of(std::string_view text) {
    std::vector<std::vector<std::string>> rows;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        std::string_view line = text.substr(0, end);
        text.remove_prefix(std::min(end + 1, text.size()));
        std::vector<std::string>& row = rows.emplace_back();
        for (;;) {
            const std::size_t comma = line.find(',');
            row.emplace_back(line.substr(0, comma));
            if (comma == line.npos) break;
            line.remove_prefix(comma + 1);
        }
    }
    return rows;
}

// The upper triangle of a labelled matrix, row by row.
inline std::vector<double> condensed_in(std::string_view csv) {
    const auto rows = cells_of(csv);
    std::vector<double> values;
    for (std::size_t i = 1; i < rows.size(); ++i) {
        REQUIRE(rows[i].size() == rows.size());
        for (std::size_t j = i + 1; j < rows.size(); ++j) values.push_back(std::stod(rows[i][j]));
    }
    return values;
}
