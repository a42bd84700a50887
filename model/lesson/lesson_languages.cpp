#include "model/lesson/lesson_languages.h"

#include <algorithm>
#include <cassert>
#include <cctype>
#include <set>
#include <utility>

#include "model/lesson/lesson_numbers.h"
#include "model/text/utf8.h"

namespace tact {

namespace {

// A text of a step, in the first language and in the others.
struct TextOfStep {
    const char* name;
    std::string& (*in_first)(LessonStep&);  // requires a question if is_asked
    std::string StepWords::*in_other;
    bool is_asked;  // it belongs to the question
};

constexpr auto kTexts = std::to_array<TextOfStep>(
    {{"title", [](LessonStep& s) -> std::string& { return s.title; }, &StepWords::title, false},
     {"text", [](LessonStep& s) -> std::string& { return s.text; }, &StepWords::text, false},
     {"note", [](LessonStep& s) -> std::string& { return s.note; }, &StepWords::note, false},
     {"what is asked", [](LessonStep& s) -> std::string& { return s.question->ask; },
      &StepWords::ask, true},
     {"what is said with the answer",
      [](LessonStep& s) -> std::string& { return s.question->reveal; }, &StepWords::reveal, true}});

template <class Words>
void tidy(std::vector<Words>& words) {
    while (!words.empty() && words.back() == Words{}) words.pop_back();
}

void tidy(StepWords& words) {
    while (!words.options.empty() && words.options.back().empty()) words.options.pop_back();
}

// The step as shown in a further language.
LessonStep shown_step(LessonStep step, std::size_t further) {
    const StepWords words = further < step.words.size() ? step.words[further] : StepWords{};
    for (const TextOfStep& text : kTexts) {
        const std::string& translated = words.*text.in_other;
        if (!translated.empty() && (!text.is_asked || step.question)) {
            text.in_first(step) = translated;
        }
    }
    if (step.question) {
        auto& options = step.question->options;
        for (std::size_t k = 0; k < std::min(options.size(), words.options.size()); ++k) {
            if (!words.options[k].empty()) options[k] = words.options[k];
        }
    }
    step.words.clear();
    return step;
}

// Equal lines at the beginning and at the end belong together; those in between are new.
void follow_options(const std::vector<std::string>& before, const std::vector<std::string>& after,
                    std::vector<std::string>& translated) {
    if (before.size() == after.size()) return;
    const std::size_t least = std::min(before.size(), after.size());
    std::size_t head = 0;
    while (head < least && before[head] == after[head]) ++head;
    std::size_t foot = 0;
    while (foot < least - head &&
           before[before.size() - 1 - foot] == after[after.size() - 1 - foot]) {
        ++foot;
    }
    translated.resize(before.size());
    std::vector<std::string> moved(after.size());
    for (std::size_t k = 0; k < head; ++k) moved[k] = translated[k];
    for (std::size_t k = 1; k <= foot; ++k) {
        moved[after.size() - k] = translated[before.size() - k];
    }
    translated = std::move(moved);
}

std::vector<std::string> options_of(const LessonStep& step) {
    return step.question ? step.question->options : std::vector<std::string>{};
}

// Takes texts written in a further language; the first language's texts stay unchanged.
void keep_words(const LessonStep& stored, const LessonStep& shown, LessonStep after,
                std::size_t further, LessonStep& result) {
    result.words.resize(std::max(result.words.size(), further + 1));
    StepWords& words = result.words[further];
    LessonStep first = stored;
    LessonStep before = shown;
    for (const TextOfStep& text : kTexts) {
        if (text.is_asked && !after.question) continue;
        const std::string now = text.in_first(after);
        const bool had_it = !text.is_asked || stored.question;
        if (!had_it) continue;  // a new question belongs to the first language
        if (now != text.in_first(before)) words.*text.in_other = now;
        text.in_first(result) = text.in_first(first);
    }
    if (!after.question || !stored.question) return;
    const std::vector<std::string> was = options_of(before);
    const std::vector<std::string>& now = after.question->options;
    result.question->options = options_of(stored);  // the first language determines their number
    words.options.resize(was.size());
    for (std::size_t k = 0; k < was.size(); ++k) {
        const std::string line = k < now.size() ? now[k] : std::string();
        if (line != was[k]) words.options[k] = line;
    }
}

std::set<std::string> numbers_in(const std::string& text) {
    const auto all = placeholders_in(text);
    return {all.begin(), all.end()};
}

std::string braced(const std::set<std::string>& numbers) {
    std::string text;
    for (const std::string& number : numbers) text += (text.empty() ? "{" : ", {") + number + "}";
    return text.empty() ? "none" : text;
}

std::string listed(const std::vector<std::string>& names) {
    std::string text = names[0];
    for (std::size_t k = 1; k < names.size(); ++k) {
        text += (k + 1 == names.size() ? " and " : ", ") + names[k];
    }
    return text;
}

struct Translated {
    std::string name;
    std::string first;
    std::string other;
};

std::vector<Translated> texts_in(const LessonStep& step, std::size_t further) {
    const StepWords words = further < step.words.size() ? step.words[further] : StepWords{};
    LessonStep first = step;
    std::vector<Translated> texts;
    for (const TextOfStep& text : kTexts) {
        if (text.is_asked && !step.question) continue;
        texts.push_back({text.name, text.in_first(first), words.*text.in_other});
    }
    const std::vector<std::string> options = options_of(step);
    for (std::size_t k = 0; k < options.size(); ++k) {
        texts.push_back({"option " + std::to_string(k + 1), options[k],
                         k < words.options.size() ? words.options[k] : std::string()});
    }
    return texts;
}

void add_lacks(const std::string& where, const std::string& language,
               const std::vector<Translated>& texts, std::vector<std::string>& lacks) {
    std::vector<std::string> missing;
    for (const Translated& text : texts) {
        if (!text.first.empty() && text.other.empty()) missing.push_back(text.name);
    }
    if (!missing.empty())
        lacks.push_back(where + listed(missing) + (missing.size() == 1 ? " lacks " : " lack ") +
                        language);
    for (const Translated& text : texts) {
        if (text.other.empty()) continue;
        const auto wanted = numbers_in(text.first);
        const auto found = numbers_in(text.other);
        if (wanted == found) continue;
        lacks.push_back(where + text.name + " in " + language + " has the numbers " +
                        braced(found) + ", the first language " + braced(wanted));
    }
}

}  // namespace

bool is_language_code(std::string_view code) {
    constexpr std::size_t kMost = 35;
    const auto is_letter = [](char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; };
    const auto first_end = std::ranges::find(code, '-');
    const auto letters = first_end - code.begin();
    if (code.size() > kMost || letters < 2 || letters > 3) return false;
    if (!std::all_of(code.begin(), first_end, is_letter) || code.ends_with('-')) return false;
    return std::all_of(first_end, code.end(), [](char c) {
        return c == '-' || std::isalnum(static_cast<unsigned char>(c)) != 0;
    });
}

std::string language_name(std::string_view code) {
    const auto* found = std::ranges::find(kNamedLanguages, code, &NamedLanguage::code);
    return found == kNamedLanguages.end() ? std::string(code) : found->name;
}

std::size_t language_place(const Lesson& lesson, std::string_view code) {
    const auto found = std::ranges::find(lesson.languages, code);
    return found == lesson.languages.end()
               ? 0
               : static_cast<std::size_t>(found - lesson.languages.begin());
}

std::shared_ptr<const Lesson> in_language(const std::shared_ptr<const Lesson>& lesson,
                                          std::size_t place) {
    if (!lesson || place == 0) return lesson;
    assert(place < lesson->languages.size() && "a language that the lesson has");
    Lesson shown = *lesson;
    const LessonWords words =
        place - 1 < shown.words.size() ? shown.words[place - 1] : LessonWords{};
    if (!words.name.empty()) shown.name = words.name;
    if (!words.about.empty()) shown.about = words.about;
    for (LessonStep& step : shown.steps) step = shown_step(std::move(step), place - 1);
    shown.words.clear();
    shown.languages = {lesson->languages[place]};
    return std::make_shared<const Lesson>(std::move(shown));
}

LessonStep with_words(const LessonStep& step, const LessonStep& shown, const LessonStep& after,
                      std::size_t place) {
    LessonStep result = after;
    result.words = step.words;
    if (place == 0) {
        for (StepWords& words : result.words) {
            follow_options(options_of(step), options_of(after), words.options);
        }
    } else {
        keep_words(step, shown, after, place - 1, result);
    }
    for (StepWords& words : result.words) tidy(words);
    tidy(result.words);
    return result;
}

Lesson with_words(Lesson lesson, const LessonWords& after, std::size_t place) {
    if (place == 0) {
        lesson.name = after.name;
        lesson.about = after.about;
        return lesson;
    }
    if (lesson.words.size() < place) lesson.words.resize(place);
    LessonWords& words = lesson.words[place - 1];
    const auto written = [](const std::string& first, const std::string& was,
                            const std::string& now) {
        return now == (was.empty() ? first : was) ? was : now;
    };
    words.name = written(lesson.name, words.name, after.name);
    words.about = written(lesson.about, words.about, after.about);
    tidy(lesson.words);
    return lesson;
}

Lesson with_language(Lesson lesson, const std::string& code) {
    if (lesson.languages.empty()) lesson.languages = {"en"};
    if (std::ranges::find(lesson.languages, code) == lesson.languages.end() &&
        lesson.languages.size() < limits::kMaxLanguages) {
        lesson.languages.push_back(code);
    }
    return lesson;
}

Lesson without_language(Lesson lesson, std::size_t place) {
    if (place == 0 || place >= lesson.languages.size()) return lesson;
    const auto remove = [place](auto& words) {
        if (place - 1 < words.size()) {
            words.erase(words.begin() + static_cast<std::ptrdiff_t>(place - 1));
        }
        tidy(words);
    };
    lesson.languages.erase(lesson.languages.begin() + static_cast<std::ptrdiff_t>(place));
    remove(lesson.words);
    for (LessonStep& step : lesson.steps) remove(step.words);
    return lesson;
}

std::vector<std::string> translation_lacks(const Lesson& lesson) {
    std::vector<std::string> lacks;
    for (std::size_t k = 1; k < lesson.languages.size(); ++k) {
        const std::string language = language_name(lesson.languages[k]);
        const LessonWords words = k - 1 < lesson.words.size() ? lesson.words[k - 1] : LessonWords{};
        add_lacks("The lesson: ", language,
                  {{"name", lesson.name, words.name}, {"about", lesson.about, words.about}}, lacks);
        for (std::size_t step = 0; step < lesson.steps.size(); ++step) {
            add_lacks("Step " + std::to_string(step + 1) + ", " +
                          in_quotes(lesson.steps[step].title) + ": ",
                      language, texts_in(lesson.steps[step], k - 1), lacks);
        }
    }
    return lacks;
}

}  // namespace tact
