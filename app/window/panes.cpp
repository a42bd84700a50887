// Content of each pane, and the controls over it.

#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include "app/ask/ask.h"
#include "app/candidates/candidates.h"
#include "app/compare/compare.h"
#include "app/document/editing.h"
#include "app/document/workspace.h"
#include "app/generate/generate.h"
#include "app/lesson/lesson.h"
#include "app/library/library.h"
#include "app/map/map.h"
#include "app/measured/measured.h"
#include "app/model_bench/model_bench.h"
#include "app/patterns/patterns.h"
#include "app/play/play.h"
#include "app/rendering/rendering.h"
#include "app/stages/stages.h"
#include "app/study/study.h"
#include "app/subset/subset.h"
#include "app/transform/transform.h"
#include "app/ui/widgets.h"
#include "app/window/window.h"
#include "model/map/mds.h"
#include "model/text/numbers.h"

namespace tact {

namespace {

// State of the numbers on screen: "exact, computed in 0.8 s", "preview", "computing 40 %".
std::string map_state_text(const App& app) {
    const bool busy = is_computing(app);
    const std::string done = percent_done(busy ? app.shown_map.full_job.progress() : 0.0);
    const bool another = shows_another_set(app.work, app.shown_map);
    switch (another ? MapState::none : map_state(app.work, app.shown_map)) {
        case MapState::none:
            if (!busy) return {};
            return "computing, " + done;
        case MapState::too_large:
            return "not computed";
        case MapState::exact:
            if (app.shown_map.transition.shown->seconds <= 0.0) return "exact";
            return "exact, computed in " + duration_text(app.shown_map.transition.shown->seconds);
        case MapState::preview:
            if (exact_waits(app.work, app.shown_map)) return "preview; exact waits";
            return "preview; exact " + done;
        case MapState::stale:
            return "before the edit; computing, " + done;
    }
    return {};
}

// From the longest form to the shortest: "exact, computed in 5.8 s", "exact"; a preview and an
// earlier state are named in every form.
std::vector<std::string> map_state_forms(const App& app) {
    const std::string whole = map_state_text(app);
    return {whole, whole.substr(0, whole.find(',')), whole.substr(0, whole.find_first_of(",;"))};
}

std::vector<std::string> space_title_right(const App& app) {
    if (!app.shown_map.transition.shown || app.shown_map.transition.to.rows() < 2)
        return map_state_forms(app);
    // Stress of an earlier state or of a preview would be taken for the present one.
    if (map_state(app.work, app.shown_map) != MapState::exact) return map_state_forms(app);
    const PerceptualSpace& space = app.shown_map.transition.shown->space;
    if (space.verdict == MdsVerdict::constant || app.shown_map.has_headline)
        return map_state_forms(app);
    const std::string stress = "stress-1 " + with_decimals(space.stress1, 3);
    const std::string worded = stress + ", " + fit_label(space);
    const std::vector<std::string> state = map_state_forms(app);
    return {worded + "    " + state[0], worded + "    " + state[1], stress + "    " + state[1],
            worded, stress};
}

std::vector<std::string> together_forms(const App& app) {
    if (app.work.selection.others.empty()) return {};
    const std::string count = std::to_string(app.work.selection.others.size() + 1);
    return {count + " edited together"};
}

// Patterns that the map leaves out are named over it.
std::string side_detail(const App& app) {
    return shown_side(app.work) == Side::both ? "" : shown_patterns_text(app.work);
}

void do_with_pattern(App& app, PatternAction action) {
    const std::size_t current = app.work.selection.current;
    switch (action) {
        case PatternAction::none:
            return;
        case PatternAction::play:
            return play_once(app.ui, app.work, app.timeline, app.play, current);
        case PatternAction::rename:
            app.ui.waiting.emplace_back([&app] { start_rename(app); });
            return;
        case PatternAction::similar:
            return select_similar(app.ui, app.work, app.shown_map, current);
        case PatternAction::vary:
            return vary(app.ui, app.work, app.proposals);
        case PatternAction::transform:
            return open_transform(app.ui, app.work, app.transform);
        case PatternAction::steps:
            return open_steps(app.ui, app.work, app.steps, {}, {});
    }
}

std::string current_name(const App& app) {
    const Vibration* current = current_vibration(app.work);
    return current == nullptr ? "" : current->name;
}

// States for the panes beside the map; only the map's own title says "exact".
std::vector<std::string> beside_map_forms(const App& app) {
    const bool is_exact = !shows_another_set(app.work, app.shown_map) &&
                          map_state(app.work, app.shown_map) == MapState::exact;
    return is_exact && !app.layout.maximised ? std::vector<std::string>() : map_state_forms(app);
}

PaneTitle bench_title(const App& app) {
    const auto& row = kBenchTabs[static_cast<std::size_t>(app.layout.bench)];
    PaneTitle title{row.label, row.about, {}};
    if (row.tab == BenchTab::matrix && shown_side(app.work) != Side::both)
        title.detail = side_detail(app);
    if (row.tab == BenchTab::matrix || row.tab == BenchTab::subset)
        title.right = beside_map_forms(app);
    if (row.tab == BenchTab::candidates) title.right = {shown_patterns_text(app.work)};
    if (row.tab == BenchTab::device)
        title.detail += " " + (current_vibration(app.work) == nullptr ? "it" : current_name(app));
    return title;
}

std::vector<std::string> people_forms(const App& app) {
    const auto& answers = app.studying.answers;
    if (!answers || answers->records.empty()) return {};
    return {std::to_string(answers->records.size())};
}

// The people whose answers are shown.
std::string shown_voice(const App& app) {
    const auto& answers = app.studying.answers;
    if (!answers || !answers->results) return {};
    const auto& shown = app.studying.shown;
    // Ratings of similarity, 0 to 100, are shown as 100 minus the rating.
    const std::string what = "dissimilarity, ";
    if (!shown || *shown >= answers->records.size()) {
        const std::string left_out = left_out_text(answers->results->mark);
        return what + "mean of those who count" + (left_out.empty() ? "" : ", " + left_out);
    }
    const std::string& code = answers->records[*shown].header.participant.code;
    const auto& people = answers->results->people;
    const auto person = std::ranges::find(people, code, &ParticipantSummary::code);
    const bool counts = person == people.end() || person->excluded.empty();
    return what + code + (counts ? "" : ", left out: " + person->excluded);
}

// The title tells if results are about patterns as a device plays them.
PaneTitle with_origin(const App& app, PaneTitle title) {
    const std::string model = phrase_of(mark_of(app.work.document.set));
    for (const std::string& origin : {rendered_words(app.rendered), model}) {
        if (origin.empty()) continue;
        title.detail += (title.detail.empty() ? "" : "   ") + origin;
    }
    return title;
}

PaneTitle title_of(const App& app, Pane pane) {
    const std::string name = current_name(app);
    switch (pane) {
        case Pane::patterns:
            if (app.layout.arrangement == Arrangement::select)
                return with_origin(app,
                                   {"Candidates", "side by side", {shown_patterns_text(app.work)}});
            return {"Patterns", "", {shown_patterns_text(app.work)}};
        case Pane::editor:
            return {"Editor", name, together_forms(app)};
        case Pane::physiology:
            return with_origin(app, {"Physiology", name, {}});
        case Pane::space:
            return with_origin(
                app, {"Perceptual space", side_detail(app), space_title_right(app), true});
        case Pane::matrix:
            return app.layout.bench == BenchTab::model || app.layout.bench == BenchTab::device
                       ? bench_title(app)
                       : with_origin(app, bench_title(app));
        case Pane::start:
            return {"Start", "", {}};
        case Pane::study_design:
            return {"Study", "what people are asked", {}};
        case Pane::study_people:
            return {"Participants", "", people_forms(app)};
        case Pane::study_answers:
            return {"Answers", shown_voice(app), {}};
    }
    return {};
}

void draw_bench_tabs(App& app) {
    const auto tab = [&app](BenchTab which, const char* name) {
        const Item item{.id = std::string("tab:") + name, .label = name};
        if (chip(app.ui, item, app.layout.bench == which)) app.layout.bench = which;
    };
    // In the arrangement to select, the others are in the View menu.
    const bool selects = app.layout.arrangement == Arrangement::select;
    const auto is_offered = [&](BenchTab which) {
        return !selects || which == BenchTab::subset || which == BenchTab::matrix ||
               which == BenchTab::why || which == app.layout.bench;
    };
    std::vector<std::pair<BenchTab, const char*>> offered;
    for (const auto& row : kBenchTabs) {
        if (is_offered(row.tab)) offered.emplace_back(row.tab, row.label);
    }
    // If one row is too narrow, two rows of about the same number: no tab stands alone below.
    const float gap_px = 2.0F * app.ui.theme.scale;
    float all_px = -gap_px;
    for (const auto& [which, name] : offered) all_px += chip_width(app.ui, name) + gap_px;
    const bool in_two = all_px > ImGui::GetContentRegionAvail().x;
    const std::size_t second_row = (offered.size() + 1) / 2;
    for (std::size_t k = 0; k < offered.size(); ++k) {
        const auto& [which, name] = offered[k];
        if (k > 0 && !(in_two && k == second_row)) flow_on(chip_width(app.ui, name), gap_px);
        tab(which, name);
    }
}

void draw_bench(App& app) {
    if (!app.ui.as_picture) draw_bench_tabs(app);
    switch (app.layout.bench) {
        case BenchTab::matrix:
            return draw_matrix_panel(app.ui, app.work, app.shown_map);
        case BenchTab::candidates:
            return do_with_pattern(
                app, draw_candidates_panel(app.ui, app.work, app.shown_map, app.candidates));
        case BenchTab::subset: {
            const PatternAction action = draw_subset_panel(app.ui, app.work, app.timeline,
                                                           app.shown_map, app.play, app.picking);
            if (std::exchange(app.picking.grow_asked, false)) {
                grow_to(app.ui, app.work, app.shown_map, app.proposals,
                        static_cast<std::size_t>(app.picking.count));
            }
            return do_with_pattern(app, action);
        }
        case BenchTab::compare:
            return draw_compare_panel(app.ui, app.work, app.layout, app.shown_map, app.table,
                                      app.comparing);
        case BenchTab::shepard:
            return draw_shepard_panel(app.ui, app.work, app.shown_map, app.comparing);
        case BenchTab::why:
            return draw_why_panel(app.ui, app.work, app.layout, app.timeline, app.shown_map,
                                  app.comparing);
        case BenchTab::model:
            return draw_model_panel(app.ui, app.work, app.table, app.model_bench);
        case BenchTab::device:
            return draw_device_panel(app.ui, app.work, app.timeline, app.rendered, app.play);
        case BenchTab::library:
            return draw_library_panel(app.ui, app.work, app.layout, app.library);
    }
}

// Held, the proposal is played; clicked, it is taken.
void take_proposal(App& app, const SpacePaneAction& done) {
    const auto found = found_variants(app.proposals);
    if (!found) return;
    if (done.proposal_pressed && *done.proposal_pressed < found->patterns.size()) {
        Vibration felt;
        felt.name = "neighbour " + std::to_string(*done.proposal_pressed + 1);
        felt.source = found->patterns[*done.proposal_pressed];
        note_pressed(app.work, felt);
    }
    if (done.proposal_clicked)
        take_variant(app.ui, app.work, app.proposals, *done.proposal_clicked);
}

// Beside the point and its name.
void draw_point_menu(App& app, std::optional<std::size_t> asked) {
    if (asked) {
        app.shown_map.menu_of = *asked;
        const ImVec2 away{2.0F * app.ui.theme.gap_px, 2.0F * app.ui.theme.gap_px};
        ImGui::SetNextWindowPos(ImGui::GetIO().MousePos + away);
        ImGui::OpenPopup("point menu");
    }
    if (!ImGui::BeginPopup("point menu")) return;
    const PatternAction action = draw_pattern_menu(app.ui, app.work, app.shown_map.menu_of);
    ImGui::EndPopup();
    do_with_pattern(app, action);
}

void draw_space(App& app) {
    draw_vary_bar(app.ui, app.work, app.proposals);
    const SpacePaneAction done = draw_space_panel(app.ui, app.work, app.shown_map, map_marks(app));
    app.play.hovered_in_map = done.hovered ? done.hovered : app.play.hovered_in_map;
    if (done.double_clicked)
        play_once(app.ui, app.work, app.timeline, app.play, *done.double_clicked);
    take_proposal(app, done);
    take_place(app.lesson, done);
    if (!app.ui.as_picture) draw_point_menu(app, done.menu_asked);
    if (done.moved) {
        move_point(app.ui, app.work, app.shown_map, app.proposals,
                   {*done.moved, done.moved_to, done.move_ended});
    }
    if (done.drawn_between) {
        const auto& all = app.work.document.set.vibrations;
        open_steps(app.ui, app.work, app.steps, all[done.drawn_between->first].name,
                   all[done.drawn_between->second].name);
    }
}

void do_with_stages(App& app, StagesAction action) {
    switch (action) {
        case StagesAction::none:
            return;
        case StagesAction::tour:
            return begin_tour(app);
        case StagesAction::fold:
            return fold_physiology(app, Fold::row);
        case StagesAction::unfold:
            return fold_physiology(app, Fold::open);
        case StagesAction::close:
            say(app.ui, "The stages are away. View > Stages > Stages in one row brings them back.");
            return fold_physiology(app, Fold::closed);
    }
}

void draw_stage_row(App& app) {
    do_with_stages(app, draw_physiology_row(app.ui, app.work, app.timeline, app.physiology));
}

void draw_physiology(App& app) {
    if (app.layout.physiology == Fold::row && !app.layout.maximised && !is_presenting(app.lesson))
        return draw_stage_row(app);
    do_with_stages(app, draw_physiology_panel(app.ui, app.work, app.timeline, app.physiology,
                                              app.lesson.left_at.contains(kTourLesson)));
}

void draw_editor(App& app) {
    const bool has_foot = app.layout.physiology == Fold::row && !app.ui.as_picture;
    const auto done =
        draw_editor_panel(app.ui, app.work, app.pattern_panes, app.timeline, app.shown_map,
                          has_foot ? [&app] { draw_stage_row(app); } : DrawFoot());
    const auto& all = app.work.document.set.vibrations;
    if (!done || done->neighbour >= all.size()) return;
    const std::size_t current = app.work.selection.current;
    switch (done->action) {
        case NeighbourChoice::play_both:
            return play_pair(app.ui, app.work, app.timeline, app.play, current, done->neighbour);
        case NeighbourChoice::why:
            choose_pair(app.work, current, done->neighbour);
            app.layout.bench = BenchTab::why;
            return;
        case NeighbourChoice::separate:
            app.layout.bench = BenchTab::subset;
            return ask_about_pair(app.ui, app.work, app.shown_map, app.picking, all[current].name,
                                  all[done->neighbour].name);
    }
}

void draw_start(App& app) {
    const auto done = draw_start_page(app.ui, app.work, app.pattern_panes.start);
    if (!done) return;
    switch (done->way) {
        case StartAction::Way::open:
            return open_dialog(app);
        case StartAction::Way::generate:
            return open_generate(app.ui, app.work, app.generating);
        case StartAction::Way::recent:
            app.ui.waiting.emplace_back([&app, file = done->file] { open_file(app, file); });
            return;
    }
}

void draw_content(App& app, Pane pane) {
    switch (pane) {
        case Pane::patterns:
            if (app.layout.arrangement == Arrangement::select)
                return do_with_pattern(
                    app, draw_candidates_panel(app.ui, app.work, app.shown_map, app.candidates));
            return do_with_pattern(app, draw_set_panel(app.ui, app.work, app.pattern_panes));
        case Pane::editor:
            return draw_editor(app);
        case Pane::physiology:
            return draw_physiology(app);
        case Pane::space:
            return draw_space(app);
        case Pane::matrix:
            return draw_bench(app);
        case Pane::start:
            return draw_start(app);
        case Pane::study_design:
            return draw_study_design(app.ui, app.work, app.play, app.studying);
        case Pane::study_people:
            return draw_study_people(app.ui, app.work, app.layout, app.timeline, app.shown_map,
                                     app.comparing, app.play, app.studying);
        case Pane::study_answers:
            return draw_study_answers(app.ui, app.work, app.shown_map, app.studying);
    }
}

}  // namespace

MapMarks map_marks(App& app) {
    MapMarks marks = subset_marks(app.ui.theme, app.layout, app.shown_map, app.picking);
    if (app.shown_map.show_people) marks.people = people_over_map(app.shown_map, app.comparing);
    if (marks.people) marks.people_text = people_over_map_text(app.comparing);
    marks.maybes = shown_proposals(app.shown_map, app.proposals);
    mark_place(app.lesson, app.shown_map, marks);
    return marks;
}

std::string name_of_pane(const App& app, Pane pane) { return title_of(app, pane).title; }

void draw_pane_of(App& app, Pane pane, const Rect& area) {
    PaneTitle title = title_of(app, pane);
    // The window has the set's name above its panes.
    const std::string& set = app.work.document.set.name;
    if (app.ui.as_picture && !set.empty()) title.detail = set + "   " + title.detail;
    draw_pane(app.ui, app.layout, pane, area, title, [&app, pane] {
        if (ImGui::IsWindowFocused(ImGuiFocusedFlags_ChildWindows)) app.in_use.pane = pane;
        draw_content(app, pane);
        if (!app.ui.as_picture && !app.ui.presenting) draw_pane_menu(app, pane);
    });
}

}  // namespace tact
