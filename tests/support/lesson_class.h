// The program giving a lesson, its numbers waited for.
#pragma once

#include <optional>

#include "app/lesson/lesson.h"
#include "app/window/app.h"
#include "tests/support/program.h"

namespace tact {

struct Class : ProgramWithStages {
    Class() : ProgramWithStages(short_patterns(3)) {}

    LessonState& lesson() { return app.lesson; }

    void begin(const char* path) {
        start_lesson(lesson_context(app), app.lesson, bundled_lesson(path), {});
        settle();
    }

    // Until the numbers of the lesson as it is are there: while it is edited, older ones show.
    void wait_for_numbers() {
        [[maybe_unused]] const auto until = end_of_patience();
        const auto arrived = [this] {
            const auto& answered = app.lesson.answered;
            return answered && answered->with_pairs && answered->of == app.lesson.shown;
        };
        while (!arrived()) {
            REQUIRE(std::chrono::steady_clock::now() < until);
            std::this_thread::sleep_for(std::chrono::milliseconds(2));
            frame();
        }
        settle();
    }

    // The first step that asks something, or something of that kind.
    void go_to_question(std::optional<QuestionKind> kind = {}) {
        for (std::size_t k = 0; k < app.lesson.lesson->steps.size(); ++k) {
            const auto& question = app.lesson.lesson->steps[k].question;
            if (!question || (kind && question->kind != *kind)) continue;
            go_to_step(lesson_context(app), app.lesson, k);
            return settle();
        }
        FAIL("the lesson asks nothing");
    }
};

}  // namespace tact
