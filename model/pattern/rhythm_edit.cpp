#include "model/pattern/rhythm_edit.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "model/pattern/pattern.h"

namespace tact {

std::vector<NoteSteps> note_steps(std::string_view text) {
    std::vector<NoteSteps> all;
    for (std::size_t step = 0; step < text.size(); ++step) {
        if (starts_note(text[step])) all.push_back({step, step});
        if (text[step] == '=') all.back().last = step;
    }
    return all;
}

std::string without_note(std::string text, std::size_t k) {
    const std::vector<NoteSteps> all = note_steps(text);
    assert(k < all.size());
    const std::size_t steps = all[k].last + 1 - all[k].first;
    return text.replace(all[k].first, steps, steps, '-');
}

std::string with_note_moved(std::string text, std::size_t k, NotePart part, std::ptrdiff_t steps) {
    const std::vector<NoteSteps> all = note_steps(text);
    assert(k < all.size());
    const auto first = static_cast<std::ptrdiff_t>(all[k].first);
    const auto last = static_cast<std::ptrdiff_t>(all[k].last);
    const std::ptrdiff_t low = k == 0 ? 0 : static_cast<std::ptrdiff_t>(all[k - 1].last) + 1;
    const auto end =
        static_cast<std::ptrdiff_t>(k + 1 < all.size() ? all[k + 1].first : text.size());
    const bool starts = part != NotePart::end;
    const bool ends = part != NotePart::start;
    const std::ptrdiff_t back = starts ? low - first : first - last;
    const std::ptrdiff_t ahead = ends ? end - 1 - last : last - first;
    const std::ptrdiff_t by = std::clamp(steps, back, ahead);
    const char mark = text[all[k].first];
    const auto begin = static_cast<std::size_t>(first + (starts ? by : 0));
    text = with_note(without_note(std::move(text), k), begin,
                     static_cast<std::size_t>(last + (ends ? by : 0)));
    text[begin] = mark;
    return text;
}

double tempo_bpm(double unit_s, int steps_a_beat) { return 60.0 / (steps_a_beat * unit_s); }

double unit_at_tempo(double bpm, int steps_a_beat) { return 60.0 / (steps_a_beat * bpm); }

std::size_t steps_a_bar(const Meter& meter) {
    return static_cast<std::size_t>(meter.steps_a_beat) *
           static_cast<std::size_t>(meter.beats_a_bar);
}

Meter with_step(Meter meter, double from_s, double to_s) {
    const double steps = meter.steps_a_beat * from_s / to_s;
    const double nearest = std::round(steps);
    const bool is_whole = std::abs(steps - nearest) <= 1e-9 * nearest;
    if (is_whole && limits::kStepsABeat.contains(nearest)) {
        meter.steps_a_beat = static_cast<int>(nearest);
    }
    return meter;
}

double length_s(const Rhythm& rhythm) {
    return static_cast<double>(rhythm.text.size()) * rhythm.unit_s;
}

Rhythm refined(const Rhythm& rhythm, std::size_t by) {
    assert(by > 0);
    const double unit_s = rhythm.unit_s / static_cast<double>(by);
    if (rhythm.text.size() * by > kMaxRhythmSteps || unit_s < limits::kRhythmUnitS.low) {
        return rhythm;
    }
    Rhythm fine{{}, unit_s, rhythm.kinds, rhythm.meter};
    for (const char mark : rhythm.text) {
        fine.text += mark;
        fine.text.append(by - 1, mark == '-' ? '-' : '=');
    }
    return fine;
}

Rhythm coarsened(const Rhythm& rhythm, std::size_t by) {
    for (; by > 1; --by) {
        Rhythm coarse{{}, rhythm.unit_s * static_cast<double>(by), rhythm.kinds, rhythm.meter};
        for (std::size_t step = 0; step < rhythm.text.size(); step += by) {
            coarse.text += rhythm.text[step];
        }
        const bool fits = coarse.unit_s <= limits::kRhythmUnitS.high &&
                          rhythm_fault(coarse.text).empty() &&
                          refined(coarse, by).text == rhythm.text;
        if (fits) return coarse;
    }
    return rhythm;
}

}  // namespace tact
