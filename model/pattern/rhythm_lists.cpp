#include "model/pattern/rhythm_lists.h"

#include <algorithm>
#include <cassert>
#include <numeric>

#include "model/pattern/rhythm.h"

namespace tact {

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
