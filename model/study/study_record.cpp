#include "model/study/study_record.h"

#include <algorithm>

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
