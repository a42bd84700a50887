#include "model/set/set_candidates.h"

#include <algorithm>
#include <utility>

#include "model/pattern/same_vibration.h"
#include "model/text/names.h"
#include "model/text/numbers.h"

namespace tact {

bool is_replaced(const Vibration& vibration, Before before) {
    return before == Before::replaced && vibration.generated && !vibration.locked;
}

std::vector<Candidate> new_to(const PatternSet& set, const std::vector<Candidate>& candidates,
                              Before before) {
    SeenVibrations seen;
    for (const Vibration& vibration : set.vibrations) {
        const auto* pattern = std::get_if<Pattern>(&vibration.source);
        if (pattern != nullptr && !is_replaced(vibration, before)) seen.add(*pattern);
    }
    std::vector<Candidate> fresh;
    for (const Candidate& candidate : candidates) {
        if (seen.add(candidate.pattern)) fresh.push_back(candidate);
    }
    return fresh;
}

namespace {

// "A07": a letter, and digits alone.
bool is_short_name(const std::string& name, char letter) {
    return name.size() > 1 && name[0] == letter &&
           std::all_of(name.begin() + 1, name.end(), [](char c) { return c >= '0' && c <= '9'; });
}

}  // namespace

ShortNames::ShortNames(const PatternSet& set, std::size_t count)
    : digits_(std::max<std::size_t>(2, std::to_string(count).size())) {
    for (char letter = 'A'; letter <= 'Z'; ++letter) {
        letter_ = letter;
        const auto has_letter = [letter](const Vibration& v) {
            return is_short_name(v.name, letter);
        };
        if (std::ranges::none_of(set.vibrations, has_letter)) return;
    }
}

std::string ShortNames::next() {
    const std::string number = std::to_string(++last_);
    return letter_ + std::string(digits_ - std::min(digits_, number.size()), '0') + number;
}

Expected<PatternSet> with_candidates(PatternSet set, const DesignSpace& space,
                                     const std::vector<Candidate>& fresh, Before before) {
    std::erase_if(set.vibrations, [before](const Vibration& v) { return is_replaced(v, before); });
    const std::size_t size = set.vibrations.size() + fresh.size();
    if (size > limits::kMaxPatterns) {
        return Error{"the set would have " + grouped_digits(size) + " patterns, at most " +
                     grouped_digits(limits::kMaxPatterns) + " are possible"};
    }
    UnusedNames names;
    for (const Vibration& vibration : set.vibrations) names.taken.insert(vibration.name);
    ShortNames short_names(set, fresh.size());
    for (const Candidate& candidate : fresh) {
        Vibration vibration;
        vibration.name = names.unused(short_names.next());
        vibration.source = candidate.pattern;
        vibration.generated = true;
        set.vibrations.push_back(std::move(vibration));
    }
    set.generator = space;
    return set;
}

}  // namespace tact
