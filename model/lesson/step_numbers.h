// The numbers of a lesson's steps, described (model/text/described.h), in the order of files.
#pragma once

#include "model/lesson/lesson.h"
#include "model/text/described.h"

namespace tact {

namespace numbers {

// clang-format off
inline constexpr Number kStepAt{.key = "at_s", .label = "Playhead", .format = "%.4g s",
    .range = limits::kLessonTimeS, .slider = {0.0, 1.0}, .help = "Where the playhead begins."};
inline constexpr Number kStepSpeed{.key = "speed", .label = "Speed", .format = "%.3g x",
    .range = limits::kLessonSpeed, .slider = limits::kLessonSpeed,
    .help = "Speed of the playhead; 0: it stands still."};
inline constexpr Number kStepFrom =
    kStepAt.as("from_s", "From", "Beginning of the time axes; 0 as their end: the whole pattern.");
inline constexpr Number kStepTo = kStepAt.as("to_s", "To", "End of the time axes.");
inline constexpr Number kCameraYaw{.key = "yaw_rad", .label = "Yaw", .format = "%.3g rad",
    .range = limits::kLessonAngleRad, .slider = {-3.15, 3.15},
    .help = "Turn of the map to the side.", .kept = Kept::always};
inline constexpr Number kCameraPitch =
    kCameraYaw.as("pitch_rad", "Pitch", "Turn of the map up or down.");
inline constexpr Number kCameraZoom{.key = "zoom", .label = "Zoom", .format = "%.3g x",
    .range = limits::kLessonZoom, .slider = {0.5, 4.0}, .logarithmic = true,
    .help = "How near the map is.", .kept = Kept::always};
// clang-format on

}  // namespace numbers

template <class Visit>
void describe(Of<LessonCamera>, Visit&& visit) {
    visit(numbers::kCameraYaw, &LessonCamera::yaw_rad);
    visit(numbers::kCameraPitch, &LessonCamera::pitch_rad);
    visit(numbers::kCameraZoom, &LessonCamera::zoom);
}

// Its texts, which are of several languages, and its question: model/io/lesson.
template <class Visit>
void describe(Of<LessonStep>, Visit&& visit) {
    visit(numbers::kStepAt, &LessonStep::at_s);
    visit(numbers::kStepSpeed, &LessonStep::speed);
    visit(numbers::kStepFrom, &LessonStep::from_s);
    visit(numbers::kStepTo, &LessonStep::to_s);
    visit("camera", &LessonStep::camera);
}

}  // namespace tact
