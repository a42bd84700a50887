#include "app/subset/subset.h"

#include <algorithm>

#include "app/document/editing.h"
#include "app/map/map.h"
#include "devices/calibration/rendering.h"
#include "model/common/distributions.h"
#include "model/set/set_ratings.h"

namespace tact {

namespace {

constexpr std::size_t kMostPairs = 200;

const std::vector<Vibration>& mapped(const ShownMap& shown_map) {
    return shown_map.transition.shown->request.set->vibrations;
}

// What is asked for now, without the pairs themselves.
TooClosePairs question_of(const ShownMap& shown_map, const SubsetState& picking) {
    TooClosePairs asked;
    asked.of = shown_map.transition.shown;
    asked.by = picking.too_close;
    asked.share = picking.share;
    asked.reference = picking.reference_a + "\n" + picking.reference_b;
    const Subset* subset =
        picking.too_close == TooClose::picked ? shown_subset(shown_map, picking) : nullptr;
    if (subset != nullptr) asked.picked = subset->members;
    return asked;
}

bool is_same_question(const TooClosePairs& a, const TooClosePairs& b) {
    return a.of == b.of && a.by == b.by && a.share == b.share && a.reference == b.reference &&
           a.picked == b.picked;
}

void keep_closest(TooClosePairs& pairs, const Dissimilarity& dissimilarity) {
    pairs.pairs = confusable_pairs(dissimilarity, pairs.threshold, kMostPairs);
    pairs.count = static_cast<std::size_t>(std::ranges::count_if(
        dissimilarity.condensed, [&](double value) { return value <= pairs.threshold; }));
}

std::optional<FoundSeparations> find_separations(const SeparationRequest& request,
                                                 std::stop_token stop,
                                                 std::atomic<float>& progress) {
    SeparationOptions options;
    options.from = request.from;
    options.share = request.share;
    options.by_a_step = request.by_a_step;
    options.stop = stop;
    options.progress = [&progress](double share) { progress = static_cast<float>(share); };
    // As the map is: of what a device makes of the pattern.
    if (const auto& by = request.map->request.rendered_by) {
        options.felt = [&by](const Waveform& meant) { return rendering(*by, meant).waveform; };
    }
    auto all = separations(*request.map->request.set, request.map->prediction, request.changed,
                           request.threshold, options);
    if (!all) return std::nullopt;
    return FoundSeparations{request, *std::move(all)};
}

void find_pairs(TooClosePairs& pairs, const SubsetState& state) {
    const PatternSet& set = *pairs.of->request.set;
    const Dissimilarity& pm = pairs.of->prediction.pm;
    if (pairs.by == TooClose::felt) {
        pairs.pairs = pairs_within_a_step(set, pm);
        pairs.count = pairs.pairs.size();
        if (pairs.pairs.size() > kMostPairs) pairs.pairs.resize(kMostPairs);
        return;
    }
    if (pairs.by == TooClose::ratings) {
        const Expected<RatingStudy> study = study_of(set);
        if (!study) return;
        pairs.mark = mark_of(*study);
        const Dissimilarity people = mean_ratings(*study);
        pairs.threshold = threshold_at(people, pairs.share);
        return keep_closest(pairs, people);
    }
    if (pairs.by == TooClose::reference) {
        const auto a = place_named(set, state.reference_a);
        const auto b = place_named(set, state.reference_b);
        if (!a || !b || *a == *b) return;
        pairs.threshold = pm(*a, *b);
        return keep_closest(pairs, pm);
    }
    if (pairs.by == TooClose::share) {
        pairs.threshold = quantile(pairs.of->sorted_pm, pairs.share);
        return keep_closest(pairs, pm);
    }
    if (pairs.picked.size() < 2) return;
    const Dissimilarity picked = among(pm, pairs.picked);
    pairs.threshold = threshold_at(picked, pairs.share);
    keep_closest(pairs, picked);
    for (ConfusablePair& pair : pairs.pairs) {
        pair.a = pairs.picked[pair.a];
        pair.b = pairs.picked[pair.b];
    }
}

}  // namespace

const TooClosePairs& too_close_pairs(const ShownMap& shown_map, SubsetState& picking) {
    TooClosePairs& pairs = picking.pairs;
    TooClosePairs asked = question_of(shown_map, picking);
    if (is_same_question(pairs, asked)) return pairs;
    pairs = std::move(asked);
    if (!pairs.of) return pairs;
    find_pairs(pairs, picking);
    return pairs;
}

void open_pair(Workspace& work, SubsetState& picking, const std::string& a, const std::string& b) {
    picking.opened = {a, b};
    const auto first = place_named(work.document.set, a);
    const auto second = place_named(work.document.set, b);
    if (first && second) choose_pair(work, *first, *second);
}

std::optional<std::pair<std::size_t, std::size_t>> opened_rows(const ShownMap& shown_map,
                                                               const SubsetState& picking) {
    const auto& opened = picking.opened;
    if (!opened || !shown_map.transition.shown) return std::nullopt;
    const auto a = place_named(*shown_map.transition.shown->request.set, opened->first);
    const auto b = place_named(*shown_map.transition.shown->request.set, opened->second);
    if (!a || !b || *a == *b) return std::nullopt;
    return std::minmax(*a, *b);
}

std::string fixed_because(const Workspace& work, const ShownMap& shown_map, std::size_t row) {
    const auto place = place_named(work.document.set, mapped(shown_map)[row].name);
    if (!place) return "removed";
    const Vibration& vibration = work.document.set.vibrations[*place];
    if (std::holds_alternative<LayeredPattern>(vibration.source)) return "has layers";
    if (!std::holds_alternative<Pattern>(vibration.source)) return "measured";
    return vibration.locked ? "locked" : "";
}

std::size_t row_to_change(const Workspace& work, const ShownMap& shown_map,
                          const SubsetState& picking, std::pair<std::size_t, std::size_t> rows) {
    const bool first = fixed_because(work, shown_map, rows.first).empty();
    const bool second = fixed_because(work, shown_map, rows.second).empty();
    const bool is_second = first == second ? picking.change_second : second;
    return is_second ? rows.second : rows.first;
}

SeparationRequest separation_request(const ShownMap& shown_map, SubsetState& picking,
                                     std::size_t row) {
    const TooClosePairs& pairs = too_close_pairs(shown_map, picking);
    SeparationRequest request{pairs.of, row, pairs.threshold, pairs.picked};
    if (pairs.by == TooClose::share || pairs.by == TooClose::picked) request.share = pairs.share;
    if (pairs.by != TooClose::felt) return request;
    request.by_a_step = true;
    if (const auto opened = opened_rows(shown_map, picking)) {
        request.threshold = pairs.of->prediction.pm(opened->first, opened->second);
    }
    return request;
}

std::string separation_obstacle(const Workspace& work, const ShownMap& shown_map,
                                const SubsetState& picking, std::size_t row) {
    const std::string why = fixed_because(work, shown_map, row);
    if (why == "locked") return "Neither may be changed: unlock one of them (Ctrl+L).";
    if (why == "measured") return "Only a pattern made of parameters can be changed.";
    if (why == "has layers") return "Only a pattern without layers can be changed.";
    if (!why.empty()) return "The pattern was removed.";
    if (picking.too_close == TooClose::ratings) {
        return "People have not rated a changed pattern: choose Closest, which goes by PM.";
    }
    return map_state(work, shown_map) == MapState::exact ? ""
                                                         : "It can be asked once the map is exact.";
}

void ask_for_separation(const Ui& ui, const Workspace& work, const ShownMap& shown_map,
                        SubsetState& picking, std::size_t row) {
    if (!separation_obstacle(work, shown_map, picking, row).empty()) return;
    picking.separation_job.ask(separation_request(shown_map, picking, row), find_separations,
                               ui.wake);
}

void ask_about_picked(const Ui& ui, Workspace& work, const ShownMap& shown_map,
                      SubsetState& picking, const std::string& a, const std::string& b) {
    picking.view = SubsetView::confusable;
    picking.too_close = TooClose::picked;
    open_pair(work, picking, a, b);
    if (const auto rows = opened_rows(shown_map, picking))
        ask_for_separation(ui, work, shown_map, picking,
                           row_to_change(work, shown_map, picking, *rows));
}

void ask_about_pair(const Ui& ui, Workspace& work, const ShownMap& shown_map, SubsetState& picking,
                    const std::string& a, const std::string& b) {
    picking.view = SubsetView::confusable;
    if (picking.too_close == TooClose::ratings) picking.too_close = TooClose::felt;
    open_pair(work, picking, a, b);
    const auto rows = opened_rows(shown_map, picking);
    if (!rows) return;
    const auto& all = shown_map.transition.shown->request.set->vibrations;
    picking.change_second = all[rows->second].name == a;
    ask_for_separation(ui, work, shown_map, picking,
                       row_to_change(work, shown_map, picking, *rows));
}

bool is_listed(const TooClosePairs& pairs, const std::string& a, const std::string& b) {
    if (!pairs.of) return false;
    const auto& all = pairs.of->request.set->vibrations;
    return std::ranges::any_of(pairs.pairs, [&](const ConfusablePair& pair) {
        const std::string& first = all[pair.a].name;
        const std::string& second = all[pair.b].name;
        return (first == a && second == b) || (first == b && second == a);
    });
}

void check_applied(Ui& ui, const Workspace& work, const ShownMap& shown_map, SubsetState& picking) {
    if (!picking.applied) return;
    if (work.revision != picking.applied->revision) return picking.applied.reset();
    if (map_state(work, shown_map) != MapState::exact) return;
    const AppliedChange applied = *std::exchange(picking.applied, std::nullopt);
    const bool listed =
        is_listed(too_close_pairs(shown_map, picking), applied.changed, applied.other);
    const std::string pair = applied.changed + " and " + applied.other;
    if (!listed) return say(ui, pair + " are no longer too close. Ctrl+Z takes the change back.");
    complain(ui, pair +
                     " are still listed: the change moved the ranks of the other pairs, too. "
                     "Ask again, or take a larger one.");
}

void apply_separation(Ui& ui, Workspace& work, std::size_t place, const Separation& separation) {
    Vibration& vibration = work.document.edit().vibrations[place];
    auto* pattern = std::get_if<Pattern>(&vibration.source);
    if (pattern == nullptr || vibration.locked) return;
    *pattern = with_value(*pattern, separation.parameter, separation.to);
    vibration.generated = false;  // another generation is not to take it away
    document_changed(work);
    const std::string what =
        std::string(traits(separation.parameter).name) + " of " + vibration.name;
    commit_step(ui, work, "Change " + what);
    select_only(work, place);
    say(ui, "Changed " + what + ". Ctrl+Z takes it back.");
}

}  // namespace tact
