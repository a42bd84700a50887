// What participants' files say, read and evaluated in the background.
#pragma once

#include <atomic>
#include <optional>
#include <stop_token>

#include "app/study/study_state.h"

namespace tact {

// The work of the job. Nothing when stopped.
std::optional<StudyAnswers> read_answers(const StudyQuestion& question, std::stop_token stop,
                                         std::atomic<float>& progress);

}  // namespace tact
