// A lesson: a set, and steps through the model's results for its patterns, with texts, questions
// and pointers.
//
// Numbers of the model stand in a text as placeholders in braces: "{nc
// A
// B}" (lesson_numbers.h). Nobody types the values, so that they follow the model.
//
// Left out  its file (model/io/lesson), its display (app/lesson).
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "model/common/units.h"
#include "model/set/pattern_set.h"

namespace tact {

// The part of the program that a step shows: all stages small, one of them large, or the map.
inline constexpr std::array<const char*, 11> kLessonViews{
    "all",      "vibration", "spectrum", "filtered", "receptors", "spikes",
    "networks", "central",   "brain",    "envelope", "map"};

enum class QuestionKind {
    choice,     // the lesson's own options
    receptors,  // the types that fire on the step's pattern
    closest,    // the pair with the smallest PM
    farthest,   // the pair with the largest PM
    place       // the place of the step's pattern in the map, which hides it until the answer
};

inline constexpr std::array<const char*, 5> kQuestionKinds{"choice", "receptors", "closest",
                                                           "farthest", "place"};

struct PatternPair {
    std::string a;
    std::string b;

    bool operator==(const PatternPair&) const = default;
};

struct LessonQuestion {
    QuestionKind kind = QuestionKind::choice;
    std::string ask;
    std::vector<std::string> options;  // of a choice
    std::size_t answer = 0;            // of a choice: the right one
    std::vector<PatternPair> pairs;    // of closest and farthest
    std::string reveal;                // shown with the answer

    bool operator==(const LessonQuestion&) const = default;
};

struct LessonCamera {
    double yaw_rad = 0.0;
    double pitch_rad = 0.0;
    double zoom = 1.0;

    bool operator==(const LessonCamera&) const = default;
};

// A step's texts in a further language; an empty one falls back to the first language's.
struct StepWords {
    std::string title;
    std::string text;
    std::string note;
    std::string ask;
    std::vector<std::string> options;  // may be fewer than the question has
    std::string reveal;

    bool operator==(const StepWords&) const = default;
};

// The same for the lesson as a whole.
struct LessonWords {
    std::string name;
    std::string about;

    bool operator==(const LessonWords&) const = default;
};

struct LessonStep {
    std::string title;
    std::string text;
    std::string note;    // for the speaker
    std::string source;  // of the text's statements about the body
    std::string pattern;
    std::string partner;  // compared with it; empty: none
    std::string view = "all";
    std::string point_at;  // outlines a widget by its name: "grid FA2"
    double at_s = 0.0;     // of the playhead
    double speed = 0.0;    // of the playhead; 0: it stands still
    double from_s = 0.0;   // start of all time axes ...
    double to_s = 0.0;     // ... and their end; both 0: the whole pattern
    std::optional<LessonCamera> camera{};
    std::optional<LessonQuestion> question{};
    std::vector<StepWords> words{};  // in the lesson's further languages, in their order
    std::string unknown_json{};      // unknown keys of the step, its camera and its question, kept
                                     // on save

    bool operator==(const LessonStep&) const = default;
};

namespace limits {
inline constexpr Range kLessonSpeed{0.0, 1.0};
inline constexpr Range kLessonTimeS{0.0, 60.0};
inline constexpr Range kLessonAngleRad{-10.0, 10.0};
inline constexpr Range kLessonZoom{0.1, 40.0};
inline constexpr std::size_t kMaxSteps = 200;
inline constexpr std::size_t kMaxOptions = 9;   // one number key per option
inline constexpr std::size_t kLeastPlaced = 4;  // in a set for placing a pattern in its map
inline constexpr std::size_t kMaxLanguages = 20;
}  // namespace limits

struct Lesson {
    std::string name;
    std::string about;     // audience, duration
    std::string set_name;  // of a bundled set; empty: the lesson's own
    PatternSet set;
    std::vector<LessonStep> steps;
    // Codes of its languages, "en" or "pt-BR" (lesson_languages.h): the first is that of the texts
    // above; empty: the language is unknown.
    std::vector<std::string> languages;
    std::vector<LessonWords> words;  // in the further languages, in their order
    std::string unknown_json;        // unknown keys of the file, kept on save

    bool operator==(const Lesson&) const = default;
};

// The missing part of a step's question, in words that follow "expected"; empty: it can be
// answered, or the step has no question.
std::string question_needs(const LessonStep& step, std::size_t patterns);

// The step's source without references marked as not looked up, a remark for authors: "Helmholtz
// 1863 (not looked up); sin a + sin b" gives "sin a + sin b".
std::string source_for_class(const LessonStep& step);

// Every text of a step that may contain numbers, in order; those of further languages come last.
std::vector<std::string> texts_of(const LessonStep& step);

// A course: an ordered list of lessons; and each student's progress in lessons.

struct Course {
    std::string name;
    std::string about;
    // "beats", a bundled lesson; or a lesson file, relative to the course's.
    std::vector<std::string> lessons;
    std::string unknown_json;  // unknown keys of the file, kept on save

    bool operator==(const Course&) const = default;
};

// An answer of a student before the right one was revealed.
struct GivenAnswer {
    std::string question;
    std::string answer;
    bool right = false;
    std::string at;  // UTC

    bool operator==(const GivenAnswer&) const = default;
};

struct LessonProgress {
    std::size_t reached = 0;                     // number of seen steps, from the first
    std::size_t steps = 0;                       // steps of the lesson
    std::map<std::size_t, GivenAnswer> answers;  // by step, from 0

    bool operator==(const LessonProgress&) const = default;
};

using StudentProgress = std::map<std::string, LessonProgress>;  // by lesson: its file or asset
using ClassProgress = std::map<std::string, StudentProgress>;   // by the student's name

}  // namespace tact
