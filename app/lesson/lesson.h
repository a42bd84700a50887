// A lesson under way: it drives the real program through its steps, on a set of its own, and leaves
// document and view as they were.
//
// Input     a lesson; or the tour, which is the first of those that come with the program
// Left out  what the steps look like (lesson_card.h), the whole screen (presenting.h)
#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <map>
#include <memory>
#include <string>

#include "app/document/renaming.h"
#include "app/lesson/lesson_state.h"
#include "app/map/map_state.h"
#include "app/physiology/physiology_state.h"
#include "app/timeline/timeline.h"
#include "app/ui/ui.h"

namespace tact {

// What a lesson drives.
struct LessonHands {
    Ui& ui;
    Workspace& work;
    Layout& layout;
    Timeline& timeline;
    ShownMap& shown_map;
    Physiology& physiology;
};

struct BundledLesson {
    const char* path;  // below assets/
    const char* name;  // that the lesson has itself
};

inline constexpr const char* kTourLesson = "lessons/tour.tactlesson.json";
inline constexpr std::array<BundledLesson, 8> kBundledLessons{{
    {"lessons/thresholds.tactlesson.json", "Thresholds by frequency"},
    {"lessons/pacinian_meissner.tactlesson.json", "Pacinian against Meissner"},
    {"lessons/twins.tactlesson.json", "Amplitude twins, and where they part"},
    {"lessons/beats.tactlesson.json", "Beats and amplitude modulation"},
    {"lessons/gaps.tactlesson.json", "Gaps, and the window of 10 ms"},
    {"lessons/why.tactlesson.json", "Why PM puts these two apart"},
    {"lessons/pipeline.tactlesson.json", "From two patterns to one distance"},
    {"lessons/mds.tactlesson.json", "How a perceptual space is made"},
}};

// One that comes with the program.
std::shared_ptr<const Lesson> bundled_lesson(const char* path);

// What is on screen, to be put back when the lesson is left.
ViewBeforeLesson view_of(const LessonHands& hands);

// Shows the lesson's set in the place of the document, which is kept, and the first step.
void start_lesson(const LessonHands& hands, LessonState& state,
                  std::shared_ptr<const Lesson> lesson, const std::filesystem::path& path);

// One that comes with the program, by its path below assets/.
void start_bundled_lesson(const LessonHands& hands, LessonState& state, const char* path);

// Where it was left, or from the first step.
void start_tour(const LessonHands& hands, LessonState& state);

// A lesson that has begun, and was left before its end another time, asks whether to continue
// there.
void ask_where_to_begin(const LessonHands& hands, LessonState& state);

// Where lessons were left, the one under way among them, as if it were left now.
std::map<std::string, std::size_t> places_left(const LessonState& state);

void open_lesson(const LessonHands& hands, LessonState& state, const std::filesystem::path& path);

void go_to_step(const LessonHands& hands, LessonState& state, std::size_t step);

// It takes the place of the one that is open, in the language that is wanted.
void show_lesson(LessonState& state, std::shared_ptr<const Lesson> lesson);

// From now on, of every lesson that has it.
void choose_language(Ui& ui, LessonState& state, const std::string& code);

// The place of the language that is shown, among the lesson's.
std::size_t shown_language(const LessonState& state);

// The document and the view are again what they were before. What was written and is unsaved goes
// to a file of its own; where it cannot be kept, the lesson stays: false.
bool leave_lesson(const LessonHands& hands, LessonState& state);

// Somebody opened another document meanwhile: the lesson ends, and unsaved changes of the one that
// was kept go to a file of their own.
void follow_document(const LessonHands& hands, LessonState& state);

// Steps name patterns.
void follow_renaming(LessonState& state, const Renaming& renaming);

// Its numbers are made beside the window.
void make_lesson_job(const Ui& ui, LessonState& state);
void follow_lesson(LessonState& state);
const LessonAnswers* answers_of(const LessonState& state);

// The step under way, in the language that is shown; null: none is.
const LessonStep* step_of(const LessonState& state);

std::optional<Stage> stage_of_view(const std::string& view);
bool shows_map(const LessonStep& step);

}  // namespace tact
