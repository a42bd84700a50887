#include "model/algebra/chosen_notes.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "model/text/numbers.h"

namespace tact {

namespace {

constexpr double kSameStep = 1e-6;  // of a step: rounding of times

std::size_t steps_within(const Pattern& pattern) {
    return static_cast<std::size_t>(
        std::ceil(pattern.duration_s / pattern.rhythm.unit_s - kSameStep));
}

Error too_many_steps() {
    return Error{"A rhythm has at most " + grouped_digits(kMaxRhythmSteps) + " steps."};
}

// The text with at least that many steps: a shorter one is written out to the pattern's end, and
// rests follow.
Expected<std::string> with_room(const Pattern& pattern, std::size_t steps) {
    const std::string& text = pattern.rhythm.text;
    if (steps <= text.size()) return text;
    const std::size_t within = steps_within(pattern);
    if (std::max(steps, within) > kMaxRhythmSteps) return too_many_steps();
    std::string all = text;
    while (all.size() < within) all += text;
    all.resize(std::max(within, text.size()));
    if (all.size() < steps) all.resize(steps, '-');
    return all;
}

NoteSteps note_at_step(std::string_view text, std::size_t onset) {
    NoteSteps note{onset, onset};
    while (note.last + 1 < text.size() && text[note.last + 1] == '=') ++note.last;
    return note;
}

void rest(std::string& text, const NoteSteps& steps) {
    std::fill(text.begin() + static_cast<std::ptrdiff_t>(steps.first),
              text.begin() + static_cast<std::ptrdiff_t>(steps.last) + 1, '-');
}

// A note that begins before these steps and was held beyond them ends before them.
void end_at(std::string& text, std::size_t from) {
    for (; from < text.size() && text[from] == '='; ++from) text[from] = '-';
}

NotesEdit with_text(const Pattern& pattern, std::string text, ChosenNotes chosen) {
    NotesEdit edit{pattern, std::move(chosen)};
    edit.pattern.rhythm.text = std::move(text);
    return edit;
}

// The chosen notes with what `change` makes of their kinds.
template <class Change>
Expected<NotesEdit> with_kinds(const Pattern& pattern, const ChosenNotes& chosen, Change change) {
    if (chosen.empty()) return NotesEdit{pattern, chosen};
    Expected<std::string> text = with_room(pattern, chosen.onsets.back() + 1);
    if (!text) return text.error();
    std::vector<NoteKind> kinds;
    for (const std::size_t onset : chosen.onsets) {
        char& mark = (*text)[onset];
        kinds.push_back(change(kind_of(pattern.rhythm, mark)));
        mark = 'x';  // its letter is free where no other note has it
    }
    NotesEdit edit = with_text(pattern, *text, chosen);
    Rhythm& rhythm = edit.pattern.rhythm;
    for (std::size_t k = 0; k < kinds.size(); ++k) {
        const auto mark = mark_for(rhythm, kinds[k]);
        if (!mark) return Error{"A rhythm has at most 26 kinds of notes, A to Z."};
        rhythm.text[chosen.onsets[k]] = *mark;
    }
    std::erase_if(rhythm.kinds, [&rhythm](const auto& kind) {
        return rhythm.text.find(kind.first) == std::string::npos;
    });
    return edit;
}

// The strength, as a whole number of ninths where it is one but for rounding.
double in_ninths(double velocity) {
    const double ninths = std::round(9.0 * velocity);
    return std::abs(9.0 * velocity - ninths) < 1e-9 ? ninths / 9.0 : velocity;
}

}  // namespace

std::vector<NoteSteps> steps_of_notes(const Pattern& pattern) {
    std::vector<NoteSteps> all;
    const double unit_s = pattern.rhythm.unit_s;
    if (pattern.rhythm.text.empty()) return all;
    for (const Note& note : notes(pattern.rhythm, pattern.duration_s)) {
        const auto first = static_cast<std::size_t>(std::llround(note.onset_s / unit_s));
        const double steps = std::ceil(note.length_s / unit_s - kSameStep);
        all.push_back({first, first + static_cast<std::size_t>(std::max(1.0, steps)) - 1});
    }
    return all;
}

ChosenNotes notes_within(const Pattern& pattern, const NoteSteps& span) {
    ChosenNotes chosen{{}, span};
    for (const NoteSteps& note : steps_of_notes(pattern)) {
        if (note.first <= span.last && note.last >= span.first) chosen.onsets.push_back(note.first);
    }
    return chosen;
}

namespace {

ChosenNotes from_first_to_last(const Pattern& pattern, std::vector<std::size_t> onsets) {
    ChosenNotes chosen{std::move(onsets), {}};
    if (chosen.empty()) return chosen;
    chosen.span = {chosen.onsets.front(), chosen.onsets.back()};
    for (const NoteSteps& note : steps_of_notes(pattern)) {
        if (note.first == chosen.onsets.back()) chosen.span.last = note.last;
    }
    return chosen;
}

}  // namespace

ChosenNotes with_toggled(const Pattern& pattern, const ChosenNotes& chosen, std::size_t onset) {
    std::vector<std::size_t> onsets = chosen.onsets;
    const auto place = std::ranges::lower_bound(onsets, onset);
    if (place != onsets.end() && *place == onset) {
        onsets.erase(place);
    } else {
        onsets.insert(place, onset);
    }
    return from_first_to_last(pattern, std::move(onsets));
}

ChosenNotes kept_choice(const Pattern& pattern, const ChosenNotes& chosen) {
    if (chosen.empty()) return {};
    const std::vector<NoteSteps> all = steps_of_notes(pattern);
    ChosenNotes kept{{}, chosen.span};
    for (const std::size_t onset : chosen.onsets) {
        if (std::ranges::binary_search(all, onset, {}, &NoteSteps::first)) {
            kept.onsets.push_back(onset);
        }
    }
    if (kept.onsets == chosen.onsets) return kept;
    return from_first_to_last(pattern, std::move(kept.onsets));
}

std::string copied_notes(const Pattern& pattern, const ChosenNotes& chosen) {
    if (chosen.empty()) return {};
    // A box may cut a note at its start: the copy has it from there on.
    const std::size_t first = std::min(chosen.span.first, chosen.onsets.front());
    std::string text(chosen.span.last + 1 - first, '-');
    for (const NoteSteps& note : steps_of_notes(pattern)) {
        if (!std::ranges::binary_search(chosen.onsets, note.first)) continue;
        const std::string& own = pattern.rhythm.text;
        text[note.first - first] = own[note.first % own.size()];
        for (std::size_t k = note.first + 1; k <= std::min(note.last, chosen.span.last); ++k) {
            text[k - first] = '=';
        }
    }
    return text;
}

Expected<NotesEdit> with_notes_moved(const Pattern& pattern, const ChosenNotes& chosen,
                                     std::ptrdiff_t steps) {
    if (chosen.empty()) return NotesEdit{pattern, chosen};
    Expected<std::string> room = with_room(pattern, chosen.onsets.back() + 1);
    if (!room) return room.error();
    const std::string before = *room;
    std::string text = before;
    std::size_t last = 0;
    for (const std::size_t onset : chosen.onsets) {
        const NoteSteps note = note_at_step(before, onset);
        last = std::max(last, note.last);
        rest(text, note);
    }
    const auto first = static_cast<std::ptrdiff_t>(chosen.onsets.front());
    const std::size_t heard = std::max(steps_within(pattern), last + 1);
    const auto end = static_cast<std::ptrdiff_t>(std::min(text.size(), heard));
    const std::ptrdiff_t by =
        std::clamp(steps, -first, end - 1 - static_cast<std::ptrdiff_t>(last));
    const auto moved = [by, end](std::size_t step) {
        const std::ptrdiff_t to = static_cast<std::ptrdiff_t>(step) + by;
        return static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(to, 0, end - 1));
    };
    ChosenNotes then{{}, {moved(chosen.span.first), moved(chosen.span.last)}};
    for (const std::size_t onset : chosen.onsets) {
        const NoteSteps note = note_at_step(before, onset);
        text = with_note(std::move(text), moved(note.first), moved(note.last));
        text[moved(note.first)] = before[onset];
        then.onsets.push_back(moved(onset));
    }
    return with_text(pattern, std::move(text), std::move(then));
}

Expected<NotesEdit> with_notes_stronger(const Pattern& pattern, const ChosenNotes& chosen,
                                        int ninths) {
    if (ninths == 0) return NotesEdit{pattern, chosen};
    return with_kinds(pattern, chosen, [ninths](NoteKind kind) {
        kind.velocity = in_ninths(std::clamp(kind.velocity + ninths / 9.0, 1.0 / 9.0, 1.0));
        return kind;
    });
}

Expected<NotesEdit> with_notes_changed(const Pattern& pattern, const ChosenNotes& chosen,
                                       double by_velocity, double by_pitch) {
    return with_kinds(pattern, chosen, [&](NoteKind kind) {
        const auto within = [](Range range, double value) {
            return std::clamp(value, range.low, range.high);
        };
        kind.velocity = in_ninths(within(limits::kVelocity, kind.velocity + by_velocity));
        kind.pitch = within(limits::kPitch, kind.pitch * by_pitch);
        return kind;
    });
}

Expected<NotesEdit> with_notes_held(const Pattern& pattern, const ChosenNotes& chosen,
                                    std::size_t steps) {
    assert(steps > 0);
    if (chosen.empty()) return NotesEdit{pattern, chosen};
    Expected<std::string> text = with_room(pattern, chosen.onsets.back() + 1);
    if (!text) return text.error();
    for (const std::size_t onset : chosen.onsets) {
        const char mark = (*text)[onset];
        rest(*text, note_at_step(*text, onset));
        (*text)[onset] = mark;
        for (std::size_t k = onset + 1;
             k < std::min(onset + steps, text->size()) && (*text)[k] == '-'; ++k) {
            (*text)[k] = '=';
        }
    }
    NotesEdit edit = with_text(pattern, *text, chosen);
    edit.chosen = from_first_to_last(edit.pattern, chosen.onsets);
    return edit;
}

Expected<NotesEdit> without_notes(const Pattern& pattern, const ChosenNotes& chosen) {
    if (chosen.empty()) return NotesEdit{pattern, chosen};
    Expected<std::string> text = with_room(pattern, chosen.onsets.back() + 1);
    if (!text) return text.error();
    for (const std::size_t onset : chosen.onsets) rest(*text, note_at_step(*text, onset));
    return with_text(pattern, *text, {});
}

Expected<NotesEdit> with_notes_pasted(const Pattern& pattern, std::size_t at,
                                      std::string_view text) {
    assert(rhythm_fault(text).empty() && !text.empty());
    constexpr std::size_t kSteps = 16;
    NotesEdit edit{pattern, {}};
    Rhythm& rhythm = edit.pattern.rhythm;
    if (rhythm.text.empty()) {
        rhythm.text = std::string(kSteps, '-');
        rhythm.unit_s = pattern.duration_s / kSteps;
    }
    const std::size_t end = at + text.size();
    const double needed_s = static_cast<double>(end) * rhythm.unit_s;
    if (needed_s > limits::kDurationS.high * (1.0 + kSameStep)) {
        return Error{"The pattern would become " + significant_digits(needed_s, 4) +
                     " s long; the longest lasts " +
                     significant_digits(limits::kDurationS.high, 4) + " s."};
    }
    Expected<std::string> room = with_room(edit.pattern, end);
    if (!room) return room.error();
    room->replace(at, text.size(), text);
    end_at(*room, end);
    rhythm.text = *room;
    if (needed_s > edit.pattern.duration_s + kSameStep * rhythm.unit_s) {
        edit.pattern = with_duration(edit.pattern, std::min(needed_s, limits::kDurationS.high));
    }
    for (const std::size_t onset : onsets(text)) edit.chosen.onsets.push_back(at + onset);
    edit.chosen.span = {at, end - 1};
    return edit;
}

Expected<NotesEdit> with_notes_repeated(const Pattern& pattern, const ChosenNotes& chosen,
                                        int times) {
    NotesEdit edit{pattern, chosen};
    const std::string copy = copied_notes(pattern, chosen);
    for (int k = 1; k < times && !copy.empty(); ++k) {
        Expected<NotesEdit> more = with_notes_pasted(edit.pattern, edit.chosen.span.last + 1, copy);
        if (!more) return more.error();
        edit = std::move(*more);
    }
    return edit;
}

}  // namespace tact
