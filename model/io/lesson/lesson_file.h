// The lesson file, `.tactlesson.json`: a set, and steps through it.
//
//     {
//       "tactlesson": 1,                     the format
//       "languages": ["en", "de"],       of its texts, the default first; each text may then be
//                                       {"en": "..", "de": ".."} instead of "..": name,
//                                       about, title, text, note, ask, options, reveal
//       "name": "Gaps", "about": "Five minutes, for beginners",
//       "set": {..}                     as in a set file (model/io/set/set_file.h), or the name of
//                                       a bundled one: "pm_2023_twelve"
//       "draft": true,                   patterns, numbers and options may be missing
//                                       (model/lesson/lesson_lacks.h)
//       "steps": [{
//         "title": "..", "text": "..",  with numbers of the model in braces, as
//                                       model/lesson/lesson_numbers.h lists them
//         "note": "..",                 for the speaker
//         "source": "..",               of statements about the body
//         "pattern": "A",               by its name in the set, and
//         "partner": "B",
//         "view": "brain",              all, vibration, spectrum, filtered, receptors, spikes,
//                                       networks, central, brain, envelope or map
//         "point_at": "grid FA2",       a widget, outlined
//         "at_s": 0.1, "speed": 0.01,   of the playhead; speed 0: it stands still
//         "from_s": 0.0, "to_s": 0.2,   of the time axes
//         "camera": {"yaw_rad": 0.5, "pitch_rad": 0.4, "zoom": 1.0},
//         "question": {
//           "kind": "choice",           or answered by the model: receptors, closest, farthest,
//                                       place (of the step's pattern in the map)
//           "ask": "..", "reveal": "..",
//           "options": ["..", ".."],    for a choice, and
//           "answer": 0,                the right one, from 0
//           "pairs": [["A", "B"]]       for closest and farthest
//         }
//       }]
//     }
//
// Source    format 1: UTF-8 JSON; missing keys take defaults; unknown keys are kept on save.
// Output    errors as "FILE: PLACE: expected ..", PLACE a JSON pointer; syntax by line and column
// Valid     the limits of model/lesson/lesson.h; every named pattern and number exists, except in
//           drafts
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "model/common/expected.h"
#include "model/lesson/lesson.h"

namespace tact {

inline constexpr int kLessonFormat = 1;
inline constexpr const char* kLessonEnding = ".tactlesson.json";

bool is_lesson_file(const std::filesystem::path& path);

Expected<Lesson> read_lesson_file(const std::filesystem::path& path);

// Recordings of its set are read from files relative to `folder`.
Expected<Lesson> parse_lesson(std::string_view text, const std::string& name_for_messages,
                              const std::filesystem::path& folder);

// The bytes of the file, with paths of recordings relative to `folder`, unless that is empty.
std::string print_lesson(const Lesson& lesson, const std::filesystem::path& folder);

// Replaces the file atomically. A lesson that could not be opened again is an Error.
Expected<Done> write_lesson_file(const std::filesystem::path& path, const Lesson& lesson);

}  // namespace tact
