// Every step of every lesson that comes with the program, as a class would see it.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "tests/support/lesson_class.h"

namespace tact {

// The tour first.
inline std::vector<const char*> bundled_lesson_paths() {
    std::vector<const char*> paths{kTourLesson};
    for (const BundledLesson& lesson : kBundledLessons) paths.push_back(lesson.path);
    return paths;
}

inline const char* edge_name(DockSide side) {
    constexpr std::array<const char*, 4> kNames{"right", "bottom", "left", "top"};
    return kNames[static_cast<std::size_t>(side)];
}

struct LessonScreen {
    ImVec2 size;
    float scale = 1.0F;  // of text
    bool presented = true;
};

// One lesson, its numbers and stages there.
struct LessonWalk : Class {
    explicit LessonWalk(const char* path) {
        app.ui.motion = false;
        begin(path);
        wait_for_numbers();
    }

    void show_on(const LessonScreen& screen) {
        if (screen.presented != lesson().presenting) {
            toggle_presenting(lesson_context(app), lesson());
        }
        resize(screen.size, screen.scale);
    }

    void show_step(std::size_t k, DockSide side) {
        lesson().dock = side;
        go_to_step(lesson_context(app), lesson(), k);
        settle();
        if (shows_map(lesson().lesson->steps[k])) {
            wait_for_exact_map();
        } else {
            wait_for_stages();
        }
        settle();
    }
};

}  // namespace tact
