// Four short patterns to be asked about, with hardly a rest between them.
#pragma once

#include "tests/support/program.h"

namespace tact {

inline PatternSet quick_study() {
    PatternSet set = short_patterns(4);
    set.study.attention_pairs = 1;
    set.study.gap_s = 0.05;
    set.study.rest_s = 0.05;
    return set;
}

// What is on screen is of the files as they are: nothing moves under the mouse any more.
inline bool answers_are_read(const StudyState& studying) {
    return studying.answers && studying.answers->question == studying.asked;
}

// The program with a study in view.
struct StudyWindow : Program {
    using Program::Program;

    // Draws frames until this is on screen, from the present files.
    void wait_for(const std::string& name) {
        const auto until = end_of_patience();
        while (!shows(name) || !answers_are_read(app.studying)) {
            REQUIRE_MESSAGE(std::chrono::steady_clock::now() < until, name);
            std::this_thread::sleep_for(std::chrono::milliseconds(2));
            frame();
        }
        settle();
    }
};

}  // namespace tact
