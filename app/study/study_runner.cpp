#include "app/study/study.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "model/io/people/study_file.h"
#include "model/io/people/study_lines.h"

namespace tact {

namespace {

using What = StudyEvent::What;

std::size_t patterns_of(const StudyRun& run) { return run.record.header.patterns.size(); }

bool is_pairwise(const StudyRun& run) { return run.record.header.kind == StudyKind::pairwise; }

bool is_complete(const StudyRun& run) {
    return answers_given(run.record) >= answers_wanted(run.record);
}

TrialPlan plan_of(const StudyRun& run) {
    const StudyHeader& header = run.record.header;
    return plan_of(header.design, header.patterns.size(), header.seed);
}

// The next trial, or round, onto the screen; without one the end.
void show_next(StudyRun& run, double now_s) {
    if (is_complete(run)) {
        run.page = StudyPage::finished;
        return;
    }
    run.shown_s = now_s;
    if (!is_pairwise(run)) {
        run.page = StudyPage::sorting;
        run.asked_groups = next_round_groups(run.record);
        run.groups.assign(patterns_of(run), kUnsorted);
        run.felt_in_round = {};
        run.felt_in_round.plays.assign(patterns_of(run), 0);
        return;
    }
    run.page = StudyPage::trial;
    run.given = {};
    run.feels_again = false;
    run.similarity.reset();
    const std::size_t place = run.record.answers.size();
    if (run.record.header.design.order == StudyOrder::full) {
        if (place < run.trials.size()) run.trial = run.trials[place];
        return;
    }
    const auto next = next_adaptive_trial(plan_of(run), rated_trials(run.record));
    if (next) run.trial = *next;
}

bool is_time_to_rest(const StudyRun& run) {
    const auto every = static_cast<std::size_t>(run.record.header.design.break_every);
    const std::size_t so_far = run.record.answers.size();
    return is_pairwise(run) && every > 0 && so_far % every == 0 && so_far > run.answers_before &&
           !is_complete(run);
}

void play_until(StudyRun& run, double until_s) {
    run.playing_until_s = until_s;
    run.quiet_until_s = until_s + run.rest_s;
}

void start_playing(StudyRun& run, StudyActions& actions, std::size_t pattern, double now_s) {
    const StudyDesign& design = run.record.header.design;
    actions.play = pattern;
    actions.rest_s = run.rest_s;
    run.playing = pattern;
    run.was_silenced = false;
    run.rest_s = run.page == StudyPage::training ? design.rest_s : design.gap_s;
    play_until(run, std::max(now_s, run.quiet_until_s) + run.duration_s[pattern]);
}

// What played has come to an end, its own or another.
void end_playing(StudyRun& run, const Play& played) {
    run.playing.reset();
    run.feels_again = !is_whole(played);
    run.cut_short = run.feels_again ? run.cut_short + 1 : 0;
    run.cut_short_in_all += run.feels_again ? 1 : 0;
    if (run.page == StudyPage::training) {
        ++(run.feels_again ? run.broken_in_training : run.felt[run.playing_button]);
    }
    if (run.page == StudyPage::trial) note_play(run.given, run.playing_button == 0, played);
    if (run.page != StudyPage::sorting) return;
    note_play(run.felt_in_round, run.playing_button, played);
    if (!run.feels_again) ++run.felt_sorting[run.playing_button];
}

void play(StudyRun& run, StudyActions& actions, std::size_t button, double now_s) {
    if (!may_play(run, now_s)) return;
    run.playing_button = button;
    if (run.page == StudyPage::training && button < run.training.size()) {
        start_playing(run, actions, run.training[button], now_s);
    } else if (run.page == StudyPage::trial && button < 2) {
        start_playing(run, actions, button == 0 ? run.trial.left : run.trial.right, now_s);
    } else if (run.page == StudyPage::sorting && button < patterns_of(run)) {
        start_playing(run, actions, button, now_s);
    }
}

void fall_silent(StudyRun& run, StudyActions& actions, Play played, double now_s) {
    if (!run.playing) return;
    actions.silence = true;
    played.is_to_the_end = false;
    end_playing(run, played);
    run.was_silenced = true;
    run.playing_until_s = now_s;
    run.quiet_until_s = now_s + run.record.header.design.gap_s;
}

double tenths(double seconds) { return std::round(10.0 * seconds) / 10.0; }

PairAnswer pair_answer(const StudyRun& run, const std::string& at, double now_s) {
    PairAnswer answer = run.given;
    answer.trial = run.trial;
    answer.similarity = run.similarity.value_or(0.0);
    const bool is_first = run.record.answers.size() == run.answers_before;
    answer.broken_in_training = is_first ? run.broken_in_training : 0;
    answer.response_s = tenths(now_s - run.shown_s);
    answer.at = at;
    return answer;
}

SortingAnswer sorting_answer(const StudyRun& run, const std::string& at, double now_s) {
    // Groups by number, without the empty ones between.
    SortingAnswer answer = run.felt_in_round;
    answer.asked_groups = run.asked_groups;
    answer.groups = run.groups;
    answer.response_s = tenths(now_s - run.shown_s);
    answer.at = at;
    std::vector<std::size_t> used = run.groups;
    std::ranges::sort(used);
    const auto rest = std::ranges::unique(used);
    used.erase(rest.begin(), rest.end());
    for (std::size_t& group : answer.groups) {
        const auto place = std::ranges::find(used, group) - used.begin();
        group = static_cast<std::size_t>(place);
    }
    return answer;
}

void give_answer(StudyRun& run, StudyActions& actions, const std::string& at, double now_s) {
    const StudyHeader& header = run.record.header;
    if (is_pairwise(run)) {
        run.record.answers.push_back(pair_answer(run, at, now_s));
        actions.line =
            answer_line(header, run.record.answers.size() - 1, run.record.answers.back());
    } else {
        run.record.sortings.push_back(sorting_answer(run, at, now_s));
        actions.line =
            answer_line(header, run.record.sortings.size() - 1, run.record.sortings.back());
    }
    run.is_waiting = true;
}

void go_on(StudyRun& run, StudyActions& actions, const std::string& at, double now_s) {
    if (!may_go_on(run, now_s)) return;
    switch (run.page) {
        case StudyPage::consent:
            run.record.header.consented = true;
            run.record.header.begun = at;
            run.is_waiting = true;
            actions.begin_file = true;
            break;
        case StudyPage::instructions:
            if (answers_given(run.record) > 0 || !is_pairwise(run)) {
                show_next(run, now_s);
            } else {
                run.page = StudyPage::training;
            }
            break;
        case StudyPage::training:
        case StudyPage::rest:
            show_next(run, now_s);
            break;
        case StudyPage::trial:
        case StudyPage::sorting:
            give_answer(run, actions, at, now_s);
            break;
        case StudyPage::finished:
            actions.left = true;
            break;
    }
}

void take_saved(StudyRun& run, double now_s) {
    if (!run.is_waiting) return;
    run.is_waiting = false;
    run.trouble.clear();
    if (run.page == StudyPage::consent) {
        run.page = StudyPage::instructions;
    } else if (is_time_to_rest(run)) {
        run.page = StudyPage::rest;
    } else {
        show_next(run, now_s);
    }
}

// The answer was not given after all: the trial stays on the screen.
void take_not_saved(StudyRun& run, const std::string& why) {
    if (!run.is_waiting) return;
    run.is_waiting = false;
    run.trouble = why;
    if (run.page == StudyPage::consent) run.record.header.begun.clear();
    if (run.page == StudyPage::trial) run.record.answers.pop_back();
    if (run.page == StudyPage::sorting) run.record.sortings.pop_back();
}

void ask(StudyRun& run, StudyActions& actions, const Play& played, double now_s) {
    if (run.is_asking || run.is_waiting) return;
    if (run.page == StudyPage::finished) return;  // there is nothing left to pause
    fall_silent(run, actions, played, now_s);
    run.is_asking = true;
    run.asked_s = now_s;
}

void stay(StudyRun& run, double now_s) {
    if (!run.is_asking) return;
    run.is_asking = false;
    run.shown_s += now_s - run.asked_s;
}

void put(StudyRun& run, std::size_t pattern, double group) {
    if (run.page != StudyPage::sorting || run.is_asking || pattern >= run.groups.size()) return;
    run.groups[pattern] = group < 0.0 ? kUnsorted : static_cast<std::size_t>(group);
}

}  // namespace

StudyRun study_run(StudyRecord record, std::vector<double> duration_s) {
    StudyRun run;
    run.record = std::move(record);
    run.duration_s = std::move(duration_s);
    run.duration_s.resize(patterns_of(run), 1.0);
    run.answers_before = answers_given(run.record);
    run.training = training_order(plan_of(run));
    run.felt.assign(run.training.size(), 0);
    run.felt_sorting.assign(patterns_of(run), 0);
    if (is_pairwise(run) && run.record.header.design.order == StudyOrder::full) {
        run.trials = trial_list(plan_of(run));
    }
    if (!run.record.header.begun.empty()) run.page = StudyPage::instructions;
    if (!run.record.header.begun.empty() && is_complete(run)) run.page = StudyPage::finished;
    return run;
}

StudyStep stepped(StudyRun run, const StudyEvent& event, double now_s) {
    StudyActions actions;
    if (run.playing && event.what == What::plays_on) {
        play_until(run, now_s + event.value);
    } else if (run.playing && now_s >= run.playing_until_s) {
        end_playing(run, event.played);
    }
    switch (event.what) {
        case What::tick:
        case What::plays_on:
            break;
        case What::cut_short:
            fall_silent(run, actions, event.played, now_s);
            break;
        case What::go_on:
            go_on(run, actions, event.at, now_s);
            break;
        case What::play:
            play(run, actions, event.index, now_s);
            break;
        case What::rate:
            if (may_rate(run, now_s)) run.similarity = std::clamp(event.value, 0.0, 100.0);
            break;
        case What::put:
            put(run, event.index, event.value);
            break;
        case What::ask:
            ask(run, actions, event.played, now_s);
            break;
        case What::stay:
            stay(run, now_s);
            break;
        case What::leave:
            actions.left = run.is_asking;
            break;
        case What::saved:
            take_saved(run, now_s);
            break;
        case What::not_saved:
            take_not_saved(run, event.text);
            break;
    }
    return {std::move(run), std::move(actions)};
}

bool may_play(const StudyRun& run, double now_s) {
    return !run.is_asking && !run.is_waiting && now_s >= run.playing_until_s &&
           (!run.was_silenced || now_s >= run.quiet_until_s);
}

bool may_rate(const StudyRun& run, double now_s) {
    return run.page == StudyPage::trial && !run.is_asking && !run.is_waiting &&
           run.given.plays_left > 0 && run.given.plays_right > 0 && now_s >= run.playing_until_s;
}

bool may_go_on(const StudyRun& run, double now_s) {
    if (run.is_asking || run.is_waiting) return false;
    const bool is_quiet = now_s >= run.playing_until_s;
    switch (run.page) {
        case StudyPage::consent:
            return !study_file_name(run.record.header.participant.code).empty();
        case StudyPage::training:
            return is_quiet && std::ranges::all_of(run.felt, [](int times) { return times > 0; });
        case StudyPage::trial:
            return may_rate(run, now_s) && run.similarity.has_value();
        case StudyPage::sorting: {
            const std::size_t filled = filled_groups(run);
            const bool is_as_asked =
                run.asked_groups == 0 || filled == static_cast<std::size_t>(run.asked_groups);
            return is_quiet && unsorted_count(run) == 0 && unfelt_count(run) == 0 && is_as_asked;
        }
        case StudyPage::instructions:
        case StudyPage::rest:
        case StudyPage::finished:
            return true;
    }
    return false;
}

double next_change_s(const StudyRun& run, double now_s) {
    double next = std::numeric_limits<double>::infinity();
    for (const double at : {run.playing_until_s, run.quiet_until_s}) {
        if (at > now_s) next = std::min(next, at - now_s);
    }
    return next;
}

std::size_t filled_groups(const StudyRun& run) { return group_count(run.groups); }

std::size_t unfelt_count(const StudyRun& run) {
    return static_cast<std::size_t>(std::ranges::count(run.felt_sorting, 0));
}

std::size_t unsorted_count(const StudyRun& run) {
    return static_cast<std::size_t>(std::ranges::count(run.groups, kUnsorted));
}

double minutes_left(const StudyRun& run) {
    const StudyHeader& header = run.record.header;
    const std::size_t wanted = answers_wanted(run.record);
    const std::size_t left = wanted - std::min(wanted, answers_given(run.record));
    constexpr std::size_t kPace = 20;
    const auto& answers = run.record.answers;
    const std::size_t known = std::min(kPace, answers.size());
    if (!is_pairwise(run)) return 3.0 * static_cast<double>(left);
    if (known < 5) {
        const double mean_s = header.patterns.empty() ? 1.0 : run.duration_s.front();
        const double all = predicted_minutes(header.design, header.patterns.size(), mean_s);
        return wanted == 0 ? 0.0 : all * static_cast<double>(left) / static_cast<double>(wanted);
    }
    double seconds = 0.0;
    for (std::size_t k = answers.size() - known; k < answers.size(); ++k) {
        seconds += answers[k].response_s;
    }
    return seconds / static_cast<double>(known) * static_cast<double>(left) / 60.0;
}

}  // namespace tact
