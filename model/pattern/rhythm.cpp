#include "model/pattern/rhythm.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>

#include "model/common/portable.h"
#include "model/text/numbers.h"

namespace tact {

char note_mark(double velocity) {
    const double ninths = std::round(9.0 * velocity);
    return ninths >= 9.0 ? 'x' : static_cast<char>('0' + static_cast<int>(std::max(ninths, 1.0)));
}

NoteKind kind_of(const Rhythm& rhythm, char mark) {
    if (mark >= '1' && mark <= '9') return {(mark - '0') / 9.0, 1.0};
    const auto own = rhythm.kinds.find(mark);
    return own == rhythm.kinds.end() ? NoteKind{} : own->second;
}

std::optional<char> mark_for(Rhythm& rhythm, const NoteKind& kind) {
    for (const char mark : std::string_view("x12345678")) {
        if (kind_of(rhythm, mark) == kind) return mark;
    }
    for (const auto& [mark, own] : rhythm.kinds) {
        if (own == kind) return mark;
    }
    for (char mark = 'A'; mark <= 'Z'; ++mark) {
        if (rhythm.text.find(mark) != std::string::npos) continue;
        rhythm.kinds[mark] = kind;
        return mark;
    }
    return std::nullopt;
}

bool has_pitches(const Rhythm& rhythm) {
    return std::ranges::any_of(rhythm.kinds, [&rhythm](const auto& kind) {
        return kind.second.pitch != 1.0 && rhythm.text.find(kind.first) != std::string::npos;
    });
}

std::optional<std::string> text_with_kinds_of(Rhythm& rhythm, const Rhythm& other) {
    std::string text;
    std::map<char, char> here;  // by the other's letter
    Rhythm both = rhythm;
    for (const char mark : other.text) {
        if (!is_letter(mark)) {
            text += mark;
            continue;
        }
        if (!here.contains(mark)) {
            const auto own = mark_for(both, kind_of(other, mark));
            if (!own) return std::nullopt;
            both.text += *own;  // in use from now on
            here[mark] = *own;
        }
        text += here[mark];
    }
    rhythm.kinds = std::move(both.kinds);
    return text;
}

std::string rhythm_fault(std::string_view text) {
    if (text.size() > kMaxRhythmSteps) {
        return "it has " + grouped_digits(text.size()) + " steps, expected at most " +
               grouped_digits(kMaxRhythmSteps);
    }
    for (std::size_t step = 0; step < text.size(); ++step) {
        const char mark = text[step];
        const auto where = [step] { return "step " + std::to_string(step + 1); };
        if (!starts_note(mark) && mark != '=' && mark != '-') {
            return where() + " is not one of x, 1 to 9, A to Z, = and -";
        }
        const bool holds_a_note = step > 0 && text[step - 1] != '-';
        if (mark == '=' && !holds_a_note) return where() + " is =, which must follow x or =";
    }
    return {};
}

std::vector<Note> notes(const Rhythm& rhythm, double duration_s) {
    assert(rhythm_fault(rhythm.text).empty() && "rhythm text was not checked");
    assert(rhythm.unit_s > 0.0);
    if (rhythm.text.empty()) return {Note{0.0, duration_s}};
    std::vector<Note> result;
    constexpr double kMostReserved = 10'000.0;
    const double steps = duration_s / rhythm.unit_s;
    result.reserve(1 + static_cast<std::size_t>(std::clamp(0.5 * steps, 0.0, kMostReserved)));
    // Onsets are products, not sums, so that the thousandth step is where it should be.
    for (std::size_t step = 0;; ++step) {
        const double onset_s = static_cast<double>(step) * rhythm.unit_s;
        if (onset_s >= duration_s) break;
        const char mark = rhythm.text[step % rhythm.text.size()];
        if (mark == '-') continue;
        if (mark != '=') {
            const NoteKind kind = kind_of(rhythm, mark);
            result.push_back({onset_s, 0.0, kind.velocity, kind.pitch});
        }
        const double end_s = static_cast<double>(step + 1) * rhythm.unit_s;
        result.back().length_s = std::min(end_s, duration_s) - result.back().onset_s;
    }
    return result;
}

std::optional<Note> note_at(const Rhythm& rhythm, double duration_s, double t_s) {
    assert(rhythm.unit_s > 0.0);
    if (!(t_s >= 0.0 && t_s < duration_s)) return std::nullopt;
    if (rhythm.text.empty()) return Note{0.0, duration_s};
    const auto mark = [&](std::size_t step) { return rhythm.text[step % rhythm.text.size()]; };
    const auto start_s = [&](std::size_t step) {
        return static_cast<double>(step) * rhythm.unit_s;
    };
    auto step = static_cast<std::size_t>(t_s / rhythm.unit_s);
    if (start_s(step) > t_s) --step;  // the quotient was rounded up
    if (start_s(step + 1) <= t_s) ++step;
    if (mark(step) == '-') return std::nullopt;
    std::size_t first = step;
    while (mark(first) == '=') --first;  // no text begins with =
    std::size_t end = step + 1;
    while (mark(end) == '=') ++end;
    const NoteKind kind = kind_of(rhythm, mark(first));
    return Note{start_s(first), std::min(start_s(end), duration_s) - start_s(first), kind.velocity,
                kind.pitch};
}

double pitch_at(const Rhythm& rhythm, double t_s) {
    const std::string& text = rhythm.text;
    const auto first = std::ranges::find_if(text, starts_note);
    if (first == text.end()) return 1.0;
    constexpr double kRounding = 1e-9;  // of a step: an onset is the product of two numbers
    auto step = static_cast<std::size_t>(std::max(0.0, t_s / rhythm.unit_s + kRounding));
    const auto before_any = static_cast<std::size_t>(first - text.begin());
    step = std::max(step, before_any);
    while (!starts_note(text[step % text.size()])) --step;
    return kind_of(rhythm, text[step % text.size()]).pitch;
}

std::vector<std::size_t> onsets(std::string_view text) {
    std::vector<std::size_t> steps;
    for (std::size_t step = 0; step < text.size(); ++step) {
        if (starts_note(text[step])) steps.push_back(step);
    }
    return steps;
}

double evenness(std::string_view text) {
    const std::vector<std::size_t> steps = onsets(text);
    double cosines = 0.0;
    double sines = 0.0;
    for (std::size_t j = 0; j < steps.size(); ++j) {
        const double turn = static_cast<double>(steps[j]) / static_cast<double>(text.size()) -
                            static_cast<double>(j) / static_cast<double>(steps.size());
        cosines += portable::cos(2.0 * std::numbers::pi * turn);
        sines += portable::sin(2.0 * std::numbers::pi * turn);
    }
    if (steps.empty()) return 0.0;
    return portable::hypot(cosines, sines) / static_cast<double>(steps.size());
}

std::string with_note(std::string text, std::size_t first, std::size_t last) {
    assert(first <= last && last < text.size());
    if (!starts_note(text[first])) text[first] = 'x';
    for (std::size_t step = first + 1; step <= last; ++step) text[step] = '=';
    // What held a note that is cut now would hold this one.
    for (std::size_t step = last + 1; step < text.size() && text[step] == '='; ++step) {
        text[step] = '-';
    }
    return text;
}

namespace {

// Euler's function.
std::uint64_t totient(std::uint64_t n) {
    std::uint64_t count = 0;
    for (std::uint64_t k = 1; k <= n; ++k) count += std::gcd(k, n) == 1 ? 1U : 0U;
    return count;
}

std::uint64_t choose(std::uint64_t n, std::uint64_t k) {
    std::uint64_t ways = 1;
    for (std::uint64_t j = 1; j <= k; ++j) ways = ways * (n - k + j) / j;
    return ways;
}

bool has_rhythms(std::size_t steps, std::size_t notes) {
    return steps > 0 && steps <= kMostListSteps && notes <= steps;
}

// Grows prenecklaces of rests and notes; those of the full length whose period divides it are
// necklaces, in dictionary order.
struct NecklaceSearch {
    std::size_t steps;
    std::size_t notes;
    std::string letters;  // [1 .. steps]; [0] only starts the recursion
    std::vector<std::string> found;

    void grow(std::size_t at, std::size_t period, std::size_t used) {
        if (used > notes || used + (steps + 1 - at) < notes) return;
        if (at > steps) {
            if (steps % period == 0) take();
            return;
        }
        letters[at] = letters[at - period];
        const bool is_note = letters[at] == 'x';
        grow(at + 1, period, used + (is_note ? 1 : 0));
        if (is_note) return;
        letters[at] = 'x';
        grow(at + 1, at, used + 1);
    }

    // The first rotation in dictionary order ends with a note; moved to the front it begins the
    // first one of those that begin with a note.
    void take() { found.push_back("x" + letters.substr(1, steps - 1)); }
};

}  // namespace

std::uint64_t necklace_count(std::size_t steps, std::size_t notes) {
    if (!has_rhythms(steps, notes)) return 0;
    const std::size_t common = std::gcd(steps, notes);
    std::uint64_t fixed = 0;  // by all rotations together
    for (std::size_t d = 1; d <= common; ++d) {
        if (common % d == 0) fixed += totient(d) * choose(steps / d, notes / d);
    }
    return fixed / steps;
}

std::vector<std::string> necklaces(std::size_t steps, std::size_t notes) {
    if (!has_rhythms(steps, notes) || notes == 0) return {};
    NecklaceSearch search{steps, notes, std::string(steps + 1, '-'), {}};
    search.grow(1, 1, 0);
    return std::move(search.found);
}

std::string euclidean_rhythm(std::size_t steps, std::size_t notes) {
    if (!has_rhythms(steps, notes) || notes == 0) return {};
    std::vector<std::string> heads(notes, "x");
    std::vector<std::string> rest(steps - notes, "-");
    // Pairs heads with what is left over, until at most one is.
    do {
        const std::size_t pairs = std::min(heads.size(), rest.size());
        for (std::size_t k = 0; k < pairs; ++k) heads[k] += rest[k];
        const auto behind = static_cast<std::ptrdiff_t>(pairs);
        std::vector<std::string> over(heads.begin() + behind, heads.end());
        over.insert(over.end(), rest.begin() + behind, rest.end());
        if (pairs == 0) break;
        heads.resize(pairs);
        rest = std::move(over);
    } while (rest.size() > 1);
    std::string text;
    for (const std::string& part : heads) text += part;
    for (const std::string& part : rest) text += part;
    return text;
}

std::string with_note_length(std::string text, std::size_t steps) {
    assert(rhythm_fault(text).empty() && "rhythm text was not checked");
    std::size_t since_onset = 0;
    bool in_note = false;
    for (char& mark : text) {
        if (starts_note(mark)) {
            in_note = true;
            since_onset = 0;
        } else if (in_note) {
            ++since_onset;
            mark = steps == 0 || since_onset < steps ? '=' : '-';
        }
    }
    return text;
}

}  // namespace tact
