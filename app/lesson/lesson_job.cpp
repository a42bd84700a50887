// The numbers of a lesson, computed in the background: quick ones first, then those of pairs.

#include <utility>

#include "app/lesson/lesson.h"

namespace tact {

void make_lesson_job(const Ui& ui, LessonState& state) {
    state.job.begin(
        JobPolicy::supersede,
        [](const LessonAsked& asked, std::stop_token stop,
           std::atomic<float>& progress) -> std::optional<LessonAnswered> {
            LessonAnswered answered{asked.lesson, asked.with_pairs,
                                    lesson_answers(*asked.lesson, stop, asked.with_pairs)};
            progress = 1.0F;
            if (stop.stop_requested()) return std::nullopt;
            return answered;
        },
        ui.wake);
    if (state.step && state.shown) state.job.ask({state.shown});
}

void follow_lesson(LessonState& state) {
    if (!state.job.has_begun()) return;
    auto answered = state.job.latest();
    if (!answered || answered == state.answered) return;
    state.answered = std::move(answered);
    if (!state.answered->with_pairs && state.answered->of == state.shown) {
        state.job.ask({state.shown, true});
    }
}

// Numbers of a lesson that is being edited stay until the new ones are ready.
const LessonAnswers* answers_of(const LessonState& state) {
    if (!state.answered || (state.answered->of != state.shown && !state.editing)) return nullptr;
    return &state.answered->answers;
}

}  // namespace tact
