#include "model/study/study_record.h"

#include <algorithm>
#include <tuple>

#include "model/text/numbers.h"
#include "model/text/utf8.h"

namespace tact {

std::string instructions_of(const StudyDesign& design, StudyKind kind) {
    if (kind == StudyKind::pairwise || !design.instructions.empty()) return instructions_of(design);
    return "You will sort vibrations into groups, so that what feels alike lies together.\n\n"
           "Click a number to feel it, as often as you like, and drag it into a group. First you "
           "make as many groups as you please; then you are asked for given numbers of groups. "
           "There is no right or wrong answer; what counts is what you feel.\n\n"
           "You may stop at any time.";
}

bool is_rehearsal(const StudyDevice& device) { return device.name == kNoDevice; }

bool is_whole(const Play& play) { return play.is_to_the_end && play.dropouts == 0; }

namespace {

// Whether it counts.
bool noted(PlaysReport& report, const Play& play) {
    report.turned_down_db = std::max(report.turned_down_db, play.turned_down_db);
    if (is_whole(play)) return true;
    ++report.broken;
    report.dropouts += play.dropouts;
    return false;
}

// Whether every pattern was played whole in a round up to this one; files of before do not say.
bool is_sorting_felt(const StudyRecord& record, std::size_t round) {
    std::vector<bool> felt(record.header.patterns.size(), false);
    for (std::size_t k = 0; k <= round; ++k) {
        const std::vector<int>& plays = record.sortings[k].plays;
        if (plays.size() != felt.size()) return true;
        for (std::size_t p = 0; p < felt.size(); ++p) felt[p] = felt[p] || plays[p] > 0;
    }
    return std::ranges::find(felt, false) == felt.end();
}

}  // namespace

void note_play(PairAnswer& answer, bool is_left, const Play& play) {
    if (!noted(is_left ? answer.left : answer.right, play)) return;
    if (answer.first == FeltFirst::unknown) {
        answer.first = is_left ? FeltFirst::left : FeltFirst::right;
    }
    ++(is_left ? answer.plays_left : answer.plays_right);
}

void note_play(SortingAnswer& answer, std::size_t pattern, const Play& play) {
    if (noted(answer.report, play) && pattern < answer.plays.size()) ++answer.plays[pattern];
}

int replays_of(const PairAnswer& answer) {
    return std::max(answer.plays_left - 1, 0) + std::max(answer.plays_right - 1, 0);
}

namespace {

std::string shown(double value) { return shortest_digits(value); }
std::string shown(StudyOrder order) { return order == StudyOrder::full ? "full" : "adaptive"; }
std::string shown(const std::vector<int>& rounds) {
    if (rounds.empty()) return "by default";
    std::string text;
    for (const int groups : rounds) {
        text += (text.empty() ? "" : " ") + (groups == 0 ? "free" : std::to_string(groups));
    }
    return text;
}

// "with "a" and 2 more": those of `names` that `others` lack; "" where there are no such.
std::string missing_from(const std::vector<std::string>& others,
                         const std::vector<std::string>& names, const char* word) {
    std::string text;
    std::size_t more = 0;
    for (const std::string& name : names) {
        if (std::ranges::find(others, name) != others.end()) continue;
        if (!text.empty()) {
            ++more;
        } else {
            text = std::string(word) + " " + in_quotes(name);
        }
    }
    return more == 0 ? text : text + " and " + std::to_string(more) + " more";
}

void note_patterns(std::vector<std::string>& changes, const StudyHeader& first,
                   const StudyHeader& now) {
    for (std::string phrase : {missing_from(now.patterns, first.patterns, "without the pattern"),
                               missing_from(first.patterns, now.patterns, "with the pattern")}) {
        if (!phrase.empty()) changes.push_back(std::move(phrase));
    }
    if (first.patterns != now.patterns) {
        if (changes.empty()) changes.emplace_back("the patterns in another order");
        return;
    }
    const bool both_known = !first.set_fingerprint.empty() && !now.set_fingerprint.empty();
    if (both_known && first.set_fingerprint != now.set_fingerprint) {
        changes.emplace_back("patterns that have been edited");
    }
}

}  // namespace

std::vector<std::string> changes_since(const StudyHeader& first, const StudyHeader& now) {
    std::vector<std::string> changes;
    note_patterns(changes, first, now);
    const StudyDesign& was = first.design;
    const StudyDesign& is = now.design;
    const auto note = [&changes](const char* what, const auto& before, const auto& after,
                                 const char* unit = "") {
        if (before == after) return;
        changes.push_back(std::string(what) + " " + shown(after) + unit + ", not " + shown(before) +
                          unit);
    };
    if (now.kind == StudyKind::pairwise) {
        note("repetitions", was.repetitions, is.repetitions);
        note("identical pairs", was.attention_pairs, is.attention_pairs);
        note("order", was.order, is.order);
        note("a break every", was.break_every, is.break_every, " trials");
        note("rest", was.rest_s, is.rest_s, " s");
    } else {
        note("rounds", was.groups, is.groups);
    }
    note("gap", was.gap_s, is.gap_s, " s");
    note("masking noise", 100.0 * was.masking, 100.0 * is.masking, " %");
    if (instructions_of(was, now.kind) != instructions_of(is, now.kind)) {
        changes.emplace_back("other instructions");
    }
    if (consent_of(was) != consent_of(is)) changes.emplace_back("other words of consent");
    return changes;
}

std::string words_on_changes(const std::vector<std::string>& changes) {
    std::string text;
    for (const std::string& change : changes) text += (text.empty() ? "" : "; ") + change;
    return text;
}

const StudyRecord* founder_of(std::span<const StudyRecord> records) {
    const auto place = [](const StudyRecord& record) {
        const StudyHeader& header = record.header;
        const int kind = is_rehearsal(header.device) ? 2 : header.synthetic ? 1 : 0;
        return std::tuple(kind, header.begun, header.participant.code);
    };
    const auto first = std::ranges::min_element(records, {}, place);
    return first == records.end() ? nullptr : &*first;
}

int cut_short_plays(const StudyRecord& record) {
    int count = 0;
    for (const PairAnswer& answer : record.answers) {
        count += answer.left.broken + answer.right.broken + answer.broken_in_training;
    }
    for (const SortingAnswer& answer : record.sortings) count += answer.report.broken;
    return count;
}

std::size_t answers_wanted(const StudyRecord& record) {
    const StudyHeader& header = record.header;
    if (header.kind == StudyKind::pairwise) {
        return trial_count(header.design, header.patterns.size());
    }
    if (!header.design.groups.empty()) return header.design.groups.size();
    // Until it is known, a free choice of the middle is expected.
    const std::size_t free_choice = record.sortings.empty()
                                        ? header.patterns.size() / 2
                                        : group_count(record.sortings.front().groups);
    return sorting_rounds(header.patterns.size(), free_choice).size();
}

int next_round_groups(const StudyRecord& record) {
    const std::size_t round = record.sortings.size();
    if (!record.header.design.groups.empty()) return record.header.design.groups[round];
    if (round == 0) return 0;
    return sorting_rounds(record.header.patterns.size(),
                          group_count(record.sortings.front().groups))[round];
}

std::size_t answers_given(const StudyRecord& record) {
    return record.header.kind == StudyKind::pairwise ? record.answers.size()
                                                     : record.sortings.size();
}

const StudyDevice& device_of(const StudyRecord& record, std::size_t k) {
    const StudyDevice* device = &record.header.device;
    for (const DeviceChange& change : record.devices) {
        if (change.before <= k) device = &change.device;
    }
    return *device;
}

Felt felt_of(const StudyRecord& record, std::size_t k) {
    if (is_rehearsal(device_of(record, k))) return Felt::nothing;
    if (record.header.kind != StudyKind::pairwise) {
        return is_sorting_felt(record, k) ? Felt::whole : Felt::in_part;
    }
    const PairAnswer& answer = record.answers[k];
    // Files of before say nothing of broken plays.
    const bool left_missing = answer.plays_left == 0 && answer.left.broken > 0;
    const bool right_missing = answer.plays_right == 0 && answer.right.broken > 0;
    return left_missing || right_missing ? Felt::in_part : Felt::whole;
}

std::vector<RatedTrial> rated_trials(const StudyRecord& record) {
    std::vector<RatedTrial> rated;
    for (const PairAnswer& answer : record.answers) {
        rated.push_back({answer.trial, answer.similarity});
    }
    return rated;
}

}  // namespace tact
