// A lesson in several languages, with one set and the same numbers.
//
// The texts of a lesson and its steps are in its first language; `words` of both have those of the
// further ones. A missing translation is shown in the first language.
//
// Source    BCP 47 (RFC 5646): codes of languages; ISO 639-1
// Left out  names of patterns and of receptors, and units, which are not translated. A source is
//           the same in every language, as its title is.
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

// Languages offered in the window; a file may have others.
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

// "German"; for a language that is not listed, the code.
std::string language_name(std::string_view code);

// Index of the language among the lesson's; 0, the first, if it does not have it.
std::size_t language_place(const Lesson& lesson, std::string_view code);

// The lesson as shown in one of its languages, which becomes its first and only one.
std::shared_ptr<const Lesson> in_language(const std::shared_ptr<const Lesson>& lesson,
                                          std::size_t place);

// The stored step with edits that were made while a language was shown. Everything but texts
// (pattern, view, the right option) is `after`'s; options added or removed in the first language
// leave the other languages' translations with their options.
LessonStep with_words(const LessonStep& step, const LessonStep& shown, const LessonStep& after,
                      std::size_t place);

// The same for name and description.
Lesson with_words(Lesson lesson, const LessonWords& after, std::size_t place);

// A further language without texts yet; a lesson with an unknown language is in English.
Lesson with_language(Lesson lesson, const std::string& code);

// Removes a further language with all its texts.
Lesson without_language(Lesson lesson, std::size_t place);

// Missing translations, and translations with other numbers than the first language: sentences
// without full stop.
std::vector<std::string> translation_lacks(const Lesson& lesson);

}  // namespace tact
