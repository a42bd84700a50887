#include "model/dissimilarity/number_mark.h"

#include <algorithm>
#include <charconv>

namespace tact {

namespace {

struct Flag {
    bool NumberMark::*is;
    const char* word;  // empty: not of a quantity of people
    const char* phrase;
    const char* sentence;
};

constexpr Flag kFlags[] = {
    {&NumberMark::synthetic, "synthetic", "of synthetic ratings",
     "SYNTHETIC: nobody was asked for some or all of these"},
    {&NumberMark::rehearsal, "rehearsal", "of a rehearsal", "REHEARSAL: nothing was felt"},
    {&NumberMark::synthetic_model, "", "by a model trained on synthetic ratings",
     "SYNTHETIC: the model was trained on synthetic ratings"},
    {&NumberMark::synthetic_patterns, "", "of synthetic patterns",
     "SYNTHETIC: some or all of these patterns were measured by nobody"},
    {&NumberMark::uncalibrated, "", "uncalibrated",
     "UNCALIBRATED: what full scale is in g was guessed"},
    {&NumberMark::stale, "stale", "of patterns that have changed",
     "CHANGED: some or all of these patterns are others than those that were felt"}};

constexpr std::string_view kLeftOut = "EXCLUDED: ";

std::string joined(const std::vector<std::string>& parts, const char* between) {
    std::string text;
    for (const std::string& part : parts) text += (text.empty() ? "" : between) + part;
    return text;
}

std::size_t number_after(std::string_view text, std::string_view what) {
    const std::size_t at = text.find(what);
    std::size_t number = 0;
    if (at == text.npos) return number;
    text.remove_prefix(at + what.size());
    std::from_chars(text.data(), text.data() + text.size(), number);
    return number;
}

// As versions before November 2026 wrote it.
NumberMark earlier_mark_in(std::string_view corner) {
    NumberMark mark;
    mark.synthetic_model = corner.find("fitted to ratings that nobody gave") != corner.npos;
    mark.synthetic = corner.starts_with("SYNTHETIC") && !mark.synthetic_model;
    return mark;
}

}  // namespace

NumberMark operator|(NumberMark a, const NumberMark& b) {
    for (const Flag& flag : kFlags) a.*flag.is = a.*flag.is || b.*flag.is;
    a.left_out = std::max(a.left_out, b.left_out);
    a.rehearsals = std::max(a.rehearsals, b.rehearsals);
    return a;
}

std::string words_of(const NumberMark& mark) {
    std::vector<std::string> words;
    for (const Flag& flag : kFlags) {
        if (mark.*flag.is && *flag.word != '\0') words.emplace_back(flag.word);
    }
    return joined(words, ", ");
}

std::string left_out_text(const NumberMark& mark) {
    if (mark.left_out == 0) return {};
    std::string text = std::to_string(mark.left_out) +
                       (mark.left_out == 1 ? " participant left out" : " participants left out");
    if (mark.rehearsals == 0) return text;
    return text + ", " + std::to_string(mark.rehearsals) +
           (mark.rehearsals == 1 ? " rehearsal among them" : " rehearsals among them");
}

std::string phrase_of(const NumberMark& mark) {
    std::vector<std::string> phrases;
    for (const Flag& flag : kFlags) {
        if (mark.*flag.is) phrases.emplace_back(flag.phrase);
    }
    if (mark.left_out > 0) phrases.push_back(left_out_text(mark));
    return joined(phrases, ", ");
}

std::vector<std::string> sentences_of(const NumberMark& mark) {
    std::vector<std::string> sentences;
    for (const Flag& flag : kFlags) {
        if (mark.*flag.is) sentences.emplace_back(flag.sentence);
    }
    if (mark.left_out > 0) sentences.push_back(std::string(kLeftOut) + left_out_text(mark));
    return sentences;
}

std::string corner_text(const NumberMark& mark) { return joined(sentences_of(mark), "; "); }

NumberMark mark_in(std::string_view corner) {
    NumberMark mark;
    for (const Flag& flag : kFlags) mark.*flag.is = corner.find(flag.sentence) != corner.npos;
    mark.left_out = number_after(corner, kLeftOut);
    if (mark.left_out > 0) mark.rehearsals = number_after(corner, " left out, ");
    return mark == NumberMark{} ? earlier_mark_in(corner) : mark;
}

}  // namespace tact
