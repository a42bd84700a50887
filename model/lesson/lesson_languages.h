// A lesson in several languages, beside one set and the same numbers.
//
// The texts of a lesson and its steps are in its first language; `words` of both have those of the
// further ones. A text that one of them lacks is shown in the first.
//
// Source    BCP 47 (RFC 5646): codes of languages; ISO 639-1
// Left out  names of patterns and of receptors, and units, which are names: they stay as they are.
//           A source is one in every language, as its title is.
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "model/lesson/lesson.h"

namespace tact {

struct NamedLanguage {
    const char* code;
    const char* name;
};

// Those that can be chosen in the window; a file may have others.
inline constexpr auto kNamedLanguages = std::to_array<NamedLanguage>({{"en", "English"},
                                                                      {"de", "German"},
                                                                      {"es", "Spanish"},
                                                                      {"fr", "French"},
                                                                      {"it", "Italian"},
                                                                      {"nl", "Dutch"},
                                                                      {"pl", "Polish"},
                                                                      {"pt", "Portuguese"},
                                                                      {"sv", "Swedish"},
                                                                      {"tr", "Turkish"},
                                                                      {"ja", "Japanese"},
                                                                      {"ko", "Korean"},
                                                                      {"zh", "Chinese"}});

// "en", "pt-BR".
bool is_language_code(std::string_view code);

// "German"; of one that is not listed, the code.
std::string language_name(std::string_view code);

// The place of the language among the lesson's; 0, the first, where it has not got it.
std::size_t language_place(const Lesson& lesson, std::string_view code);

// As it is shown in one of its languages: that one is its first, and it has no other.
std::shared_ptr<const Lesson> in_language(const std::shared_ptr<const Lesson>& lesson,
                                          std::size_t place);

// The step after its texts were written on as they are shown in a language. What is not of one
// language (pattern, view, which option is right) is `after`'s; options that were put in or taken
// out in the first language leave the translations of the others where they belong.
LessonStep with_words(const LessonStep& step, const LessonStep& shown, const LessonStep& after,
                      std::size_t place);

// The same of name and about.
Lesson with_words(Lesson lesson, const LessonWords& after, std::size_t place);

// A further language, which nothing is written in yet; a lesson that tells none is in English.
Lesson with_language(Lesson lesson, const std::string& code);

// Without a further language and all that was written in it.
Lesson without_language(Lesson lesson, std::size_t place);

// What is not translated, and translations with other numbers than the first language has:
// sentences without their stop.
std::vector<std::string> translation_lacks(const Lesson& lesson);

}  // namespace tact
