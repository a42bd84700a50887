// The program without a screen: its real frames, found and clicked by the names of its widgets.
#pragma once

#include <doctest/doctest.h>

#include <chrono>
#include <functional>
#include <map>
#include <sstream>
#include <string>
#include <thread>

#include "app/document/editing.h"
#include "app/document/workspace.h"
#include "app/map/map.h"
#include "app/window/window.h"
#include "tests/support/headless_window.h"
#include "tests/support/patience.h"

namespace tact {

// Short patterns: the laws of the interface hold for any, and DTW is quadratic. They have the looks
// that opening would give them.
inline PatternSet short_patterns(std::size_t count) {
    PatternSet set;
    set.name = "test";
    set.duration_s = 0.1;
    for (std::size_t k = 0; k < count; ++k) {
        Pattern pattern;
        pattern.duration_s = 0.1;
        pattern.carriers[0].frequency_hz = 60.0 + 50.0 * static_cast<double>(k % 5);
        pattern.modulation.frequency_hz = 10.0 * static_cast<double>(k % 3);
        Vibration vibration;
        vibration.name = "p" + std::to_string(k + 1);
        vibration.source = pattern;
        set.vibrations.push_back(vibration);
    }
    give_looks(set);
    return set;
}

// Rooms may ask in the background from now on; for the map, once something changes or asks for it.
inline void begin_jobs(App& app) {
    app.ui.wake = [] {};
    app.shown_map.maps_asked = app.work.revision;
}

struct Place {
    ImVec2 min, max;
    std::string value;

    ImVec2 middle() const { return (min + max) * 0.5F; }
};

struct Program {
    HeadlessWindow window;
    App app = make_app();
    std::map<std::string, Place> places;  // of the last frame that noted them
    std::function<void()> after_frame;    // what a test looks at each time

    explicit Program(const PatternSet& set) {
        ImGuiIO& io = ImGui::GetIO();
        io.DisplaySize = {1600.0F, 1000.0F};
        io.Fonts->Clear();
        PatternSet opened = set;
        give_looks(opened);  // as opening a document does
        app.work.document.open({opened, {}, opened});
        // Any name but none: the frame then notes where things are, and nothing is written.
        app.ui.rects.file = "/dev/null/no such file";
        make_theme(app);
        settle();
    }

    void frame() {
        window.frame([this] {
            draw_frame(app, window.input.pressed, window.now_s);
            read_places();
        });
        if (after_frame) after_frame();
    }

    void settle() {
        while (pending(window.input)) frame();
        for (int k = 0; k < 4; ++k) frame();
    }

    const Place& at(const std::string& name) const {
        const auto found = places.find(name);
        REQUIRE_MESSAGE(found != places.end(), "nothing on screen is called " << name);
        return found->second;
    }
    bool shows(const std::string& name) const { return places.contains(name); }

    void click(const std::string& name) {
        window.click(at(name).middle());
        settle();
    }

    void drag(ImVec2 from, ImVec2 to, int steps) {
        window.move(from);
        window.button(true);
        settle();
        for (int k = 1; k <= steps; ++k) {
            window.move(from + (to - from) * (static_cast<float>(k) / static_cast<float>(steps)));
            settle();
        }
        window.button(false);
        settle();
    }

    void press(char32_t sign, bool ctrl = false, bool shift = false) {
        const bool letter = sign >= 'a' && sign <= 'z';
        press_key(static_cast<int>(letter ? sign - 'a' + 'A' : sign), ctrl, shift, sign);
    }

    void press_key(int code, bool ctrl = false, bool shift = false, char32_t sign = 0) {
        const auto modifier = [this](int which, bool down) {
            push(window.input, {window.now_s, KeyChange{which, down, false, 0}});
        };
        if (ctrl) modifier(key::kLeftControl, true);
        if (shift) modifier(key::kLeftShift, true);
        window.press(code, sign);
        if (shift) modifier(key::kLeftShift, false);
        if (ctrl) modifier(key::kLeftControl, false);
        settle();
    }

    void type(const std::string& text) {
        window.type(text);
        settle();
    }

    // As on a screen of this size, with text of this size.
    void resize(ImVec2 size, float scale) {
        ImGui::GetIO().DisplaySize = size;
        ImGui::GetIO().Fonts->Clear();
        app.ui.text_scale = scale;
        make_theme(app);
        settle();
    }

    // Lets jobs begin, and waits for the exact map.
    void compute_map() {
        begin_jobs(app);
        request_maps(app.ui, app.work, app.shown_map, app.rendered);
        wait_for_exact_map();
        // The first map may come out of a ring: its points are on their way for a moment.
        constexpr double kEaseS = 0.2;
        while (app.ui.time_s - app.shown_map.transition.since_s < kEaseS) frame();
    }

    // Frames until the map on screen is the exact one of the document.
    void wait_for_exact_map() {
        [[maybe_unused]] const auto until = end_of_patience();  // checks may be off
        while (map_state(app.work, app.shown_map) != MapState::exact) {
            REQUIRE(std::chrono::steady_clock::now() < until);
            std::this_thread::sleep_for(std::chrono::milliseconds(2));
            frame();
        }
    }

    // Draws frames until the stages on screen are those of the present patterns; lets jobs begin.
    void wait_for_stages() {
        if (!has_jobs(app.ui)) begin_jobs(app);
        [[maybe_unused]] const auto until = end_of_patience();  // checks may be off
        const auto arrived = [this] {
            const Physiology& physiology = app.physiology;
            if (!physiology.stages || physiology.stages != physiology.stages_job.current())
                return false;
            if (app.work.selection.pinned.empty()) return true;
            return physiology.pinned_stages &&
                   physiology.pinned_stages == physiology.pinned_job.current();
        };
        do {
            REQUIRE(std::chrono::steady_clock::now() < until);
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
            frame();
        } while (!arrived());
        settle();
    }

    // Frames until what was to be read is in the document, or refused.
    void wait_for_opening() {
        [[maybe_unused]] const auto until = end_of_patience();  // checks may be off
        while (app.opening.asked) {
            REQUIRE(std::chrono::steady_clock::now() < until);
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
            frame();
        }
        settle();
    }

    void hover(ImVec2 at) {
        window.move(at);
        settle();
    }

    const Pattern& pattern(std::size_t index) const {
        return std::get<Pattern>(app.work.document.set.vibrations[index].source);
    }

  private:
    std::string read_;  // what `places` were read from

    void read_places() {
        if (app.ui.rects.file.empty() || app.ui.rects.written == read_) return;
        read_ = app.ui.rects.written;
        places.clear();
        std::istringstream lines(read_);
        for (std::string line; std::getline(lines, line);) {
            std::istringstream cells(line);
            std::string name;
            Place place;
            std::getline(cells, name, '\t');
            cells >> place.min.x >> place.min.y >> place.max.x >> place.max.y;
            cells.get();
            std::getline(cells, place.value);
            places[name] = place;
        }
    }
};

// With jobs, and the stages of the current pattern on screen.
struct ProgramWithStages : Program {
    explicit ProgramWithStages(const PatternSet& set) : Program(set) { wait_for_stages(); }
};

}  // namespace tact
