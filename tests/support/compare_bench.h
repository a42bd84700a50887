// The program with ratings to compare with, whose jobs are waited for.
#pragma once

#include <algorithm>
#include <chrono>
#include <string>
#include <thread>

#include "app/compare/compare.h"
#include "app/document/editing.h"
#include "app/map/map.h"
#include "tests/support/program.h"
#include "tests/support/temporary_folder.h"

namespace tact {

inline constexpr std::size_t kRatedPatterns = 6;

// A square of ratings of p1 .. p6 that no metric gives.
inline std::string square_csv() {
    std::string text;
    for (std::size_t i = 1; i <= kRatedPatterns; ++i) text += ",p" + std::to_string(i);
    for (std::size_t i = 1; i <= kRatedPatterns; ++i) {
        text += "\np" + std::to_string(i);
        for (std::size_t j = 1; j <= kRatedPatterns; ++j) {
            const std::size_t low = std::min(i, j);
            const std::size_t high = std::max(i, j);
            text += "," + std::to_string(i == j ? 0 : (7 * low + 5 * high * high) % 23 + 1);
        }
    }
    return text + "\n";
}

struct CompareBench {
    TemporaryFolder folder;
    Program program;

    explicit CompareBench(const PatternSet& set = short_patterns(kRatedPatterns)) : program(set) {
        begin_jobs(program.app);
        request_maps(program.app.ui, program.app.work, program.app.shown_map, program.app.rendered);
        if (set.vibrations.size() >= 2) program.wait_for_exact_map();
    }

    void load(const std::string& text, const std::string& name = "people.csv") {
        const auto file = folder.write(name, text);
        const auto loaded = read_ratings({&file, 1}, RatingScale::guess);
        App& app = program.app;
        if (loaded) take_ratings(app.ui, app.work, app.layout, file, *loaded);
        if (!loaded) complain(app.ui, loaded.error().message);
        program.settle();
    }

    // Frames until the comparison on screen is that of the map on screen.
    void wait_for_comparison() {
        program.wait_for_exact_map();
        wait_until([this] {
            return !shown_comparison(program.app.work, program.app.shown_map, program.app.comparing)
                        .is_stale;
        });
    }

    void wait_for_difference() {
        wait_until([this] {
            const App& app = program.app;
            const auto pair = chosen_pair(app.work, app.shown_map);
            return app.comparing.difference && pair &&
                   app.comparing.difference->request.map == app.shown_map.transition.shown &&
                   app.comparing.difference->request.a == pair->current &&
                   app.comparing.difference->request.b == pair->partner;
        });
    }

    template <class Condition>
    void wait_until(Condition condition) {
        const auto until = std::chrono::steady_clock::now() + std::chrono::seconds(120);
        while (!condition()) {
            REQUIRE(std::chrono::steady_clock::now() < until);
            std::this_thread::sleep_for(std::chrono::milliseconds(2));
            program.frame();
        }
        program.settle();
    }
};

}  // namespace tact
