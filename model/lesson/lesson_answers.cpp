#include <algorithm>
#include <cmath>

#include "model/lesson/lesson_lacks.h"
#include "model/lesson/lesson_numbers.h"
#include "model/lesson/lesson_pairs.h"
#include "model/lesson/number_words.h"
#include "model/set/pattern_set.h"
#include "model/set/set_ratings.h"
#include "model/study/ratings.h"
#include "model/text/numbers.h"
#include "model/textbook/textbook.h"

namespace tact {

namespace {

bool has_placeholder(const Lesson& lesson, std::initializer_list<const char*> beginnings) {
    for (const LessonStep& step : lesson.steps) {
        for (const std::string& text : texts_of(step)) {
            for (const std::string& placeholder : placeholders_in(text)) {
                for (const char* beginning : beginnings) {
                    if (placeholder.starts_with(beginning)) return true;
                }
            }
        }
    }
    return false;
}

bool asks_for_maps(const Lesson& lesson) { return has_placeholder(lesson, {"stress", "k", "rho"}); }

bool asks_for_pairs(const Lesson& lesson) {
    for (const LessonStep& step : lesson.steps) {
        const auto& question = step.question;
        if (question && !question->pairs.empty()) return true;
        if (question && question->kind == QuestionKind::place) return true;
    }
    return has_placeholder(lesson, {"nc", "oc", "pm"}) || asks_for_maps(lesson);
}

std::string language_of(const Lesson& lesson) {
    return lesson.languages.empty() ? std::string() : lesson.languages.front();
}

std::string pair_name(const Lesson& lesson, const PatternPair& pair) {
    return pair.a + number_in(" and ", language_of(lesson)) + pair.b;
}

// Indices of the smallest, or of the largest, of some numbers; several if they are equal.
std::vector<std::size_t> extreme_places(const std::vector<double>& values, bool least) {
    const double best =
        least ? *std::ranges::min_element(values) : *std::ranges::max_element(values);
    std::vector<std::size_t> places;
    for (std::size_t k = 0; k < values.size(); ++k) {
        if (values[k] == best) places.push_back(k);
    }
    return places;
}

std::vector<double> of_pairs(const PatternSet& set, const std::vector<PatternPair>& pairs,
                             const Dissimilarity& matrix) {
    std::vector<double> values;
    for (const PatternPair& pair : pairs) {
        values.push_back(
            matrix(place_named(set, pair.a).value(), place_named(set, pair.b).value()));
    }
    return values;
}

std::string chosen_text(const std::vector<std::string>& options,
                        const std::vector<std::size_t>& places) {
    std::string text;
    for (const std::size_t place : places) text += (text.empty() ? "" : "; ") + options[place];
    return text.empty() ? "none" : text;
}

// People's answer on the same pairs, if the set has ratings of all of them.
std::string people_text(const PatternSet& set, const LessonQuestion& question,
                        const std::vector<std::string>& options) {
    const auto mean = people_of(set);
    if (!mean) return {};
    const auto study = study_of(set);
    const std::vector<double> values = of_pairs(set, question.pairs, *mean);
    if (std::ranges::any_of(values, [](double v) { return !std::isfinite(v); })) return {};
    const bool least = question.kind == QuestionKind::closest;
    const NumberMark mark = mark_of(*study);
    return std::string(mark.synthetic ? "Simulated people" : "People") +
           (mark.stale ? ", before patterns were edited: " : ": ") +
           chosen_text(options, extreme_places(values, least)) + ".";
}

QuestionAnswer answer_of_pairs(const Lesson& lesson, const LessonQuestion& question,
                               const LessonPairs& pairs) {
    QuestionAnswer answer;
    for (const PatternPair& pair : question.pairs) {
        answer.options.push_back(pair_name(lesson, pair));
    }
    if (!pairs.prediction || question.pairs.empty()) return answer;
    const std::vector<double> pm = of_pairs(lesson.set, question.pairs, pairs.prediction->pm);
    answer.right = extreme_places(pm, question.kind == QuestionKind::closest);
    for (std::size_t k = 0; k < pm.size(); ++k) {
        answer.model += (k == 0 ? "PM: " : ", ") + answer.options[k] + " " + plain_digits(pm[k], 3);
    }
    answer.model += ".";
    answer.people = people_text(lesson.set, question, answer.options);
    return answer;
}

// The nearest neighbour among the others; of many, only the nearest ones are options.
QuestionAnswer answer_of_place(const Lesson& lesson, const LessonStep& step,
                               const LessonPairs& pairs) {
    QuestionAnswer answer;
    const auto placed = place_named(lesson.set, step.pattern);
    if (!pairs.prediction || !placed) return answer;
    const auto pm = [&](std::size_t k) { return pairs.prediction->pm(*placed, k); };
    std::vector<std::size_t> others;
    for (std::size_t k = 0; k < lesson.set.vibrations.size(); ++k) {
        if (k != *placed) others.push_back(k);
    }
    if (others.empty()) return answer;
    std::ranges::stable_sort(others, {}, pm);
    if (others.size() > limits::kMaxOptions) others.resize(limits::kMaxOptions);
    const double least = pm(others.front());
    const auto name = [&](std::size_t k) { return lesson.set.vibrations[k].name; };
    answer.model = "PM to " + name(others.front()) + " is " + plain_digits(least, 3);
    if (others.size() > 1) {
        answer.model += ", to " + name(others[1]) + " " + plain_digits(pm(others[1]), 3);
    }
    answer.model += ".";
    std::ranges::sort(others);  // in the order of the set, which reveals nothing
    for (const std::size_t k : others) {
        if (pm(k) == least) answer.right.push_back(answer.options.size());
        answer.options.push_back(name(k));
    }
    return answer;
}

QuestionAnswer answer_of_receptors(const Lesson& lesson, const LessonStep& step,
                                   const LessonPairs& pairs) {
    QuestionAnswer answer;
    const CodedPattern& coded = pairs.coded[place_named(lesson.set, step.pattern).value()];
    for (const Receptor receptor : kReceptors) answer.options.emplace_back(traits(receptor).name);
    for (const Receptor receptor : kReceptors) {
        const std::string word = std::string("spikes | ") + traits(receptor).name + " | ";
        const std::string count = value_of(word + step.pattern, lesson.set, pairs);
        if (coded.firing[index_of(receptor)] == Firing::fires) {
            answer.right.push_back(index_of(receptor));
        }
        answer.model += std::string(index_of(receptor) == 0 ? "Impulses under the probe: " : ", ") +
                        traits(receptor).name + " " + count;
    }
    answer.model += ".";
    // A remark if an answer is right by the model, but hardly by anatomy; the lesson may say so
    // itself.
    constexpr std::string_view kFound = "ruffini found";
    const bool is_said = step.question->reveal.find(kFound) != std::string::npos;
    if (!is_said && coded.firing[index_of(Receptor::ruffini)] == Firing::fires) {
        answer.model += " " + sentence_of(*fact_named(kFound));
    }
    return answer;
}

QuestionAnswer answer_of(const Lesson& lesson, const LessonStep& step, const LessonPairs& pairs) {
    if (!step.question) return {};
    const LessonQuestion& question = *step.question;
    const bool lacks_pattern = question.kind == QuestionKind::receptors && step.pattern.empty();
    const bool is_own = question.kind == QuestionKind::choice;
    if (!is_own && (lacks_pattern || !has_its_patterns(step, lesson.set))) return {};
    switch (question.kind) {
        case QuestionKind::choice:
            return {question.options, {question.answer}, {}, {}};
        case QuestionKind::receptors:
            return answer_of_receptors(lesson, step, pairs);
        case QuestionKind::place:
            return answer_of_place(lesson, step, pairs);
        case QuestionKind::closest:
        case QuestionKind::farthest:
            break;
    }
    return answer_of_pairs(lesson, question, pairs);
}

}  // namespace

LessonPairs lesson_pairs(const Lesson& lesson, std::stop_token stop, bool with_pairs) {
    LessonPairs pairs;
    const std::vector<Waveform> waveforms = own_waveforms(lesson.set);
    for (const Waveform& waveform : waveforms) {
        if (stop.stop_requested()) return pairs;
        const Waveform whole = padded(waveform, longest_samples(lesson.set));
        CodedPattern coded{
            neural_coding_stages(whole, lesson.set.model.coding, KeepLayers::none, {stop, {}})};
        coded.firing = firing_of(coded.stages, lesson.set.model.coding);
        pairs.coded.push_back(std::move(coded));
    }
    if (!with_pairs || !asks_for_pairs(lesson) || waveforms.size() < 2) return pairs;
    PredictOptions options;
    options.stop = stop;
    pairs.prediction = predict(waveforms, lesson.set.model, options);
    const bool with_maps = !stop.stop_requested() && asks_for_maps(lesson);
    if (with_maps) pairs.maps = lesson_maps(lesson.set, *pairs.prediction, stop);
    return pairs;
}

std::string pair_text(const std::string& word, const LessonPairs& pairs, std::size_t a,
                      std::size_t b) {
    if (!pairs.prediction) return "\u2026";
    const Prediction& prediction = *pairs.prediction;
    if (word == "nc") return plain_digits(prediction.nc(a, b), 3);
    if (word == "oc") return plain_digits(prediction.oc(a, b), 3);
    const double pm = prediction.pm(a, b);
    if (word == "pm") return plain_digits(pm, 3);
    const auto below =
        std::ranges::count_if(prediction.pm.condensed, [pm](double other) { return other < pm; });
    return std::to_string(below + 1) + " of " + std::to_string(prediction.pm.condensed.size());
}

LessonAnswers lesson_answers(const Lesson& lesson, std::stop_token stop, bool with_pairs) {
    LessonAnswers answers;
    const LessonPairs pairs = lesson_pairs(lesson, stop, with_pairs);
    if (stop.stop_requested()) return answers;
    const std::string language = language_of(lesson);
    for (const LessonStep& step : lesson.steps) {
        for (const std::string& text : texts_of(step)) {
            for (const std::string& placeholder : placeholders_in(text)) {
                if (answers.numbers.contains(placeholder)) continue;
                if (!placeholder_fault(placeholder, lesson.set).empty()) continue;
                answers.numbers[placeholder] =
                    number_in(value_of(placeholder, lesson.set, pairs), language);
            }
        }
        answers.questions.push_back(answer_of(lesson, step, pairs));
    }
    return answers;
}

}  // namespace tact
