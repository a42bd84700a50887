// The numbers of a lesson, computed in the background: quick ones first, then those of pairs.

#include <utility>

#include "app/lesson/lesson.h"

namespace tact {

namespace {

std::optional<LessonAnswered> answer_lesson(const LessonAsked& asked, std::stop_token stop,
                                            std::atomic<float>& progress) {
    LessonAnswered answered{asked.lesson, asked.with_pairs,
                            lesson_answers(*asked.lesson, stop, asked.with_pairs)};
    progress = 1.0F;
    if (stop.stop_requested()) return std::nullopt;
    return answered;
}

}  // namespace

void follow_lesson(const Ui& ui, LessonState& state) {
    if (auto answered = state.job.latest()) state.answered = std::move(answered);
    if (!has_jobs(ui) || !state.shown) return;
    const bool has_quick = state.answered && state.answered->of == state.shown;
    state.job.want(LessonAsked{state.shown, has_quick}, answer_lesson, ui.wake);
}

// Numbers of a lesson that is being edited stay until the new ones are ready.
const LessonAnswers* answers_of(const LessonState& state) {
    if (!state.answered || (state.answered->of != state.shown && !state.editing)) return nullptr;
    return &state.answered->answers;
}

}  // namespace tact
