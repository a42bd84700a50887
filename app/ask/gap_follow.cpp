#include "app/ask/ask.h"

#include <algorithm>
#include <utility>

#include "app/ask/parts.h"
#include "app/document/editing.h"
#include "app/map/map.h"
#include "devices/calibration/rendering.h"
#include "model/ask/gap.h"
#include "model/pattern/same_vibration.h"
#include "model/text/numbers.h"

namespace tact {

namespace {

constexpr double kGapLimitS = 20.0;  // time limit of the proof
constexpr std::uint64_t kGapSeed = 1;

std::optional<FoundGap> find_gap(const GapRequest& request, std::stop_token stop,
                                 std::atomic<float>& progress) {
    const PatternSet& set = *request.set;
    const GapCandidates source =
        gap_candidates(set, request.picked, request.free, request.seed, stop);
    GapQuestion question{{}, source.patterns, request.missing, set.model};
    for (const std::size_t place : request.picked) question.picked.push_back(set.vibrations[place]);
    const std::size_t compared = question.picked.size() + question.candidates.size();
    question.coarse = expected_map_s(compared, longest_s(set)) > kLongestExactS;
    GapOptions options;
    options.stop = stop;
    options.time_limit_s = kGapLimitS;
    options.progress = [&progress](double share) { progress = static_cast<float>(share); };
    if (const auto& by = request.rendered_by) {
        options.felt = [&by](const Waveform& meant) { return rendering(*by, meant).waveform; };
    }
    auto answer = fill_gap(question, options);
    if (!answer) return std::nullopt;
    FoundGap found{
        request,        {}, *std::move(answer), source.patterns.size(), source.all_there_are,
        question.coarse};
    for (const std::size_t k : found.answer.chosen) found.chosen.push_back(source.patterns[k]);
    return found;
}

std::vector<std::size_t> not_dropped(const Workspace& work) {
    const auto& all = work.document.set.vibrations;
    std::vector<std::size_t> places;
    for (std::size_t k = 0; k < all.size(); ++k) {
        if (!all[k].dropped) places.push_back(k);
    }
    return places;
}

// The picked patterns; without a pick, all that are not dropped.
std::vector<std::size_t> picked_places(const Workspace& work) {
    const auto& names = work.selection.picked;
    if (names.empty()) return not_dropped(work);
    const auto& all = work.document.set.vibrations;
    std::vector<std::size_t> picked;
    for (std::size_t k = 0; k < all.size(); ++k) {
        if (names.contains(all[k].name)) picked.push_back(k);
    }
    return picked;
}

void ask_for(Ui& ui, const Workspace& work, const ShownMap& shown_map, ProposalsState& state,
             std::vector<std::size_t> picked, std::size_t missing) {
    const auto& shown = shown_map.transition.shown;
    state.gap.ask(
        {work.revision, std::make_shared<const PatternSet>(work.document.set), std::move(picked),
         free_of(state), missing, kGapSeed, shown ? shown->request.rendered_by : std::nullopt},
        find_gap, ui.wake);
    say(ui, "Searching what is farthest from all others.");
}

// The place of an equal pattern in the set, so that it is not added twice.
std::optional<std::size_t> place_of(const PatternSet& set, const Pattern& wanted) {
    for (std::size_t k = 0; k < set.vibrations.size(); ++k) {
        const auto* pattern = std::get_if<Pattern>(&set.vibrations[k].source);
        if (pattern != nullptr && essence(*pattern) == essence(wanted)) return k;
    }
    return std::nullopt;
}

void select_too(Workspace& work, const std::vector<std::size_t>& places, bool keeps) {
    for (const std::size_t place : places) {
        if (!keeps) select_only(work, place);
        if (keeps && place != work.selection.current) work.selection.others.insert(place);
        keeps = true;
    }
    work.selection.scroll_to_current = true;
}

void take_gap(Ui& ui, Workspace& work, const FoundGap& found) {
    std::vector<Vibration> fresh;
    std::vector<std::string> there;  // names, because places move when patterns are added
    for (const Pattern& pattern : found.chosen) {
        if (const auto place = place_of(work.document.set, pattern)) {
            there.push_back(work.document.set.vibrations[*place].name);
        } else {
            Vibration one;
            one.name = "gap";
            one.source = pattern;
            fresh.push_back(std::move(one));
        }
    }
    const bool adds = !fresh.empty();
    std::string what = adds ? std::to_string(fresh.size()) + " far from all others" : "";
    if (adds) {
        select_only(work, work.document.set.vibrations.size() - 1);
        add_vibrations(ui, work, std::move(fresh), "Add " + what);
    }
    std::vector<std::size_t> places;
    for (const std::string& name : there) places.push_back(*place_named(work.document.set, name));
    select_too(work, places, adds);
    std::string done = adds ? "Added " + what + "; Ctrl+Z takes them back. " : "";
    if (!there.empty()) {
        done += there[0];
        if (there.size() > 1) done += " and " + std::to_string(there.size() - 1) + " more";
        done += there.size() > 1 ? " are in the set already: selected. "
                                 : " is in the set already: selected. ";
    }
    say(ui, done + sentence_on(found));
}

}  // namespace

std::string sentence_on(const FoundGap& found) {
    const GapAnswer& answer = found.answer;
    std::string text = "PM " + significant(answer.weakest_pm, 3) + " of " +
                       significant(answer.largest_pm, 3) + " or more from all others: ";
    const std::string count = std::to_string(found.candidates);
    if (!found.all_there_are) {
        text += "the farthest of " + count + " that were tried";
    } else {
        text += "the farthest of the " + count + " left in the design space";
        text += answer.is_proven ? ", proven" : ", not proven in time";
    }
    return text + (found.coarse ? " (by a preview)." : ".");
}

void fill_the_gap(Ui& ui, const Workspace& work, const ShownMap& shown_map, ProposalsState& state) {
    std::vector<std::size_t> picked = picked_places(work);
    if (picked.empty()) return say(ui, "There is no pattern yet to be far from.");
    ask_for(ui, work, shown_map, state, std::move(picked), 1);
}

void grow_to(Ui& ui, const Workspace& work, const ShownMap& shown_map, ProposalsState& state,
             std::size_t count) {
    std::vector<std::size_t> all = not_dropped(work);
    if (all.empty()) return say(ui, "There is no pattern yet to be far from.");
    if (all.size() >= count) {
        return say(ui, "The set has " + std::to_string(all.size()) +
                           " patterns, and Subset picks " + std::to_string(count) +
                           ": none is missing. Raise that number to grow.");
    }
    const std::size_t missing = count - all.size();
    ask_for(ui, work, shown_map, state, std::move(all), missing);
}

void follow_gap(Ui& ui, Workspace& work, ProposalsState& state) {
    GapQuery& gap = state.gap;
    if (!gap.asked()) return;
    if (gap.asked()->revision != work.revision) {
        stop_filling(state);
        return say(ui, "The set has changed meanwhile: ask again what would fill the gap.");
    }
    const auto found = gap.current();
    if (!found) {
        if (gap.busy()) return;
        if (!gap.failure().empty()) complain(ui, "Nothing was found: " + gap.failure());
        gap.leave();
        return;
    }
    gap.leave();
    if (found->chosen.empty()) {
        return say(ui,
                   "Nothing is left that could fill a gap: all of the design space is "
                   "picked, or no number may change.");
    }
    take_gap(ui, work, *found);
}

void stop_filling(ProposalsState& state) { state.gap.leave(); }

bool is_filling(const ProposalsState& state) { return state.gap.asked().has_value(); }

}  // namespace tact
