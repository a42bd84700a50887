// Why the model tells two patterns apart: the parts of their distance, the channels behind it, the
// times at which they differ, and the matched moments of their rhythms.

#include <algorithm>
#include <cmath>

#include "app/compare/compare.h"
#include "app/document/editing.h"
#include "app/document/workspace.h"
#include "app/map/map.h"
#include "app/physiology/physiology.h"
#include "app/progress/progress.h"
#include "app/timeline/timeline.h"
#include "app/ui/widgets.h"
#include "model/text/numbers.h"
#include "model/textbook/textbook.h"
#include "viz/drawing/colour.h"
#include "viz/drawing/marks.h"
#include "viz/drawing/plot.h"

namespace tact {

namespace {

// The next `height_px` of the pane, in full width.
Rect take_row(float height_px) {
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const Rect row = rect_at(corner, {ImGui::GetContentRegionAvail().x, height_px});
    ImGui::Dummy(row.size());
    return row;
}

// The detail moves to the next line if the first has no room for it.
void draw_heading(const Ui& ui, const char* text, const std::string& detail) {
    ImGui::PushFont(ui.theme.fonts.semibold);
    ImGui::TextUnformatted(text);
    ImGui::PopFont();
    const bool beside = flow_on(text_size(ui.theme.fonts.small, detail).x, ui.theme.gap_px);
    ImGui::PushFont(ui.theme.fonts.small);
    const float lower = 0.5F * (ui.theme.fonts.regular->FontSize - ImGui::GetFontSize());
    if (beside) ImGui::SetCursorPosY(ImGui::GetCursorPosY() + lower);
    const float room = ImGui::GetContentRegionAvail().x;
    dim_text(ui, shortened(ui.theme.fonts.small, detail, room));
    ImGui::PopFont();
}

void draw_names(Ui& ui, Workspace& work, Layout& layout, const ChosenPair& pair) {
    const auto& all = work.document.set.vibrations;
    const std::string a = all[pair.current].name;
    const std::string b = all[pair.partner].name;
    const char* how = "";
    if (pair.kind == PartnerKind::closest) how = "its closest by PM";
    if (pair.kind == PartnerKind::pinned) how = "pinned";
    const float beside = text_size(ui.theme.fonts.small, how).x + ui.theme.gap_px;
    const float room = std::max(0.0F, ImGui::GetContentRegionAvail().x - beside);
    draw_heading(ui, shortened(ui.theme.fonts.semibold, a + " and " + b, room).c_str(), how);
    note_item(ui.rects, "why:pair", a + "|" + b);
    const bool pinned = work.selection.pinned == b;
    const char* words = pinned ? "Both pipelines are shown" : "Show both pipelines";
    flow_on(ImGui::CalcTextSize(words).x, 2.0F * ui.theme.gap_px);
    if (link(ui, {.id = "link:both pipelines",
                  .label = words,
                  .tip = "Pins the second pattern: every stage of both appears in the middle."})) {
        work.selection.pinned = b;
        layout.maximised.reset();
        layout.physiology = Fold::open;
    }
}

// PM as its two parts, weighted ranks both.
void draw_parts(Ui& ui, const LiveMap& map, std::size_t k) {
    const Prediction& prediction = map.prediction;
    const Theme& theme = ui.theme;
    const PartShares shares = part_shares(prediction, k);
    const std::string pm = "PM " + significant(prediction.pm.condensed[k]) + " of " +
                           significant(*std::ranges::max_element(prediction.pm.condensed));
    draw_heading(ui, pm.c_str(),
                 "NC " + significant(map.nc.condensed[k]) + ", rank " +
                     significant(prediction.nc_rank[k]) + "    OC " +
                     significant(map.oc.condensed[k]) + ", rank " +
                     significant(prediction.oc_rank[k]));
    const Rect row = take_row(20.0F * theme.scale);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float middle = row.min.x + row.width() * static_cast<float>(shares.nc);
    const ImU32 nc_colour = theme.series;
    const ImU32 oc_colour = theme.hover;
    if (shares.nc > 0.0) list.AddRectFilled(row.min, {middle, row.max.y}, nc_colour);
    if (shares.nc < 1.0) list.AddRectFilled({middle, row.min.y}, row.max, oc_colour);
    const std::string nc_text = "neural coding " + percent(shares.nc);
    const std::string oc_text = "rhythm " + percent(shares.oc);
    const float y = row.centre().y - 0.5F * text_size(theme.fonts.small, "N").y;
    const float pad = 0.75F * theme.gap_px;
    const ImU32 ink = readable_on(nc_colour);
    const ImVec2 oc_size = text_size(theme.fonts.small, oc_text);
    const bool nc_fits = text_size(theme.fonts.small, nc_text).x + 2.0F * pad < middle - row.min.x;
    const bool oc_fits = oc_size.x + 2.0F * pad < row.max.x - middle;
    if (nc_fits) draw_text(list, theme.fonts.small, {row.min.x + pad, y}, ink, nc_text);
    if (oc_fits) {
        draw_text(list, theme.fonts.small, {row.max.x - oc_size.x - pad, y}, theme.text, oc_text);
    }
    if (!nc_fits || !oc_fits) {
        // The number below the end of its bar.
        const Rect below = take_row(oc_size.y);
        if (!nc_fits) draw_text(list, theme.fonts.small, below.min, theme.text, nc_text);
        const ImVec2 corner{below.max.x - oc_size.x, below.min.y};
        if (!oc_fits) draw_text(list, theme.fonts.small, corner, theme.text, oc_text);
    }
    note_rect(ui.rects, "why:parts", row.min, row.max, nc_text + ", " + oc_text);
}

// The difference that people notice, and the part of it that PM keeps.
void draw_noticed(Ui& ui, const LiveMap& map, std::size_t k,
                  const std::pair<std::size_t, std::size_t>& rows) {
    constexpr double kNear = 1.0 / 3.0;  // rank among all pairs, by NC
    const auto& all = map.request.set->vibrations;
    const auto* a = std::get_if<Pattern>(&all[rows.first].source);
    const auto* b = std::get_if<Pattern>(&all[rows.second].source);
    if (a == nullptr || b == nullptr) return;
    std::string text = noticed_text(*a, *b);
    if (text.empty()) return;
    const std::vector<double>& ranks = map.prediction.nc_rank;
    const auto pairs = static_cast<double>(ranks.size());
    if (ranks.size() > 2 && tell_by_frequency(*a, *b) && ranks[k] <= kNear * pairs) {
        text += " NC ranks them " + significant(ranks[k]) + " of " + significant(pairs) +
                ", from the closest: its gates have forgotten the frequency.";
    }
    ImGui::PushFont(ui.theme.fonts.small);
    ImGui::PushTextWrapPos(0.0F);
    plain_text(ui, {.id = "why:noticed", .text = text});
    ImGui::PopTextWrapPos();
    ImGui::PopFont();
}

// One channel, or two together.
struct Term {
    std::string name;
    ImU32 colour = 0;
    double share = 0.0;
};

std::vector<Term> terms_of(const Theme& theme, const ChannelShares& shares) {
    std::vector<Term> terms;
    for (std::size_t c = 0; c < kReceptorCount; ++c) {
        for (std::size_t d = c; d < kReceptorCount; ++d) {
            if (std::abs(shares[c][d]) < 0.0005) continue;
            std::string name = traits(kReceptors[c]).name;
            ImU32 colour = theme.receptor[c];
            if (c != d) {
                name += std::string(" with ") + traits(kReceptors[d]).name;
                colour = mixed(theme.receptor[c], theme.receptor[d], 0.5F);
            }
            terms.push_back({name, colour, shares[c][d]});
        }
    }
    return terms;
}

// One bar per term, all from the same zero line: the terms of two channels may be negative.
void draw_channels(Ui& ui, const LiveDifference& live) {
    const Theme& theme = ui.theme;
    const std::vector<Term> terms = terms_of(theme, live.shares);
    draw_heading(ui, "Channels", terms.empty() ? "the same brain waveform" : "share of NC squared");
    draw_tooltip(ui,
                 "What each channel alone, and each two together, have in the squared distance. "
                 "Two together are negative where they make up for each other.");
    double most = 0.0;
    double least = 0.0;
    float names_px = 0.0F;
    for (const Term& term : terms) {
        most = std::max(most, term.share);
        least = std::min(least, term.share);
        names_px = std::max(names_px, text_size(theme.fonts.small, term.name).x);
    }
    const float number_px = text_size(theme.fonts.small, "> \u22120.001 %").x + theme.gap_px;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    for (const Term& term : terms) {
        const Rect row = take_row(1.15F * text_size(theme.fonts.small, "N").y);
        const float left = row.min.x + names_px + theme.gap_px;
        const float width = std::max(1.0F, row.max.x - number_px - left);
        const auto x = [&](double share) {
            return left + width * static_cast<float>((share - least) / (most - least));
        };
        draw_text(list, theme.fonts.small, row.min, theme.dim_text, term.name);
        list.AddRectFilled({std::min(x(0.0), x(term.share)), row.min.y + 2.0F * theme.scale},
                           {std::max(x(0.0), x(term.share)), row.max.y - 2.0F * theme.scale},
                           term.colour);
        const std::string text = percent(term.share);
        draw_text(list, theme.fonts.small,
                  {row.max.x - text_size(theme.fonts.small, text).x, row.min.y}, theme.text, text);
        note_rect(ui.rects, "why:channel " + term.name, row.min, row.max, text);
    }
}

// Axis of seconds below the plots over time.
void draw_seconds(Ui& ui, const TimeRange& range) {
    const Rect row = take_row(time_axis_height(ui));
    Plot plot{row, {row.min, {row.max.x, row.min.y}}, {}, {}};
    plot.x = {.low = range.start_s, .high = range.end_s, .low_px = row.min.x, .high_px = row.max.x};
    draw_axes(*ImGui::GetWindowDrawList(), ui.theme, plot,
              {.x_unit = "s", .y_unit = "", .y_grid = false});
    note_rect(ui.rects, "why:seconds", row.min, row.max);
}

// Both patterns on one scale of g, if there is room.
void draw_vibrations(Ui& ui, Workspace& work, Timeline& timeline, const ChosenPair& pair,
                     float row_px) {
    const auto& all = work.document.set.vibrations;
    const std::array<std::size_t, 2> who{pair.current, pair.partner};
    std::array<const Waveform*, 2> waves{};
    double most_g = 0.0;
    for (std::size_t side = 0; side < 2; ++side) {
        waves[side] = waveform_in_time(work.cache, all[who[side]]);
        if (waves[side] != nullptr) most_g = std::max(most_g, peak_g(*waves[side]));
    }
    draw_heading(ui, "Vibrations", "both on one scale, \u00b1" + significant(most_g) + " g");
    for (std::size_t side = 0; side < 2; ++side) {
        const float room = ImGui::GetContentRegionAvail().x;
        ImGui::PushFont(ui.theme.fonts.small);
        dim_text(ui, shortened(ui.theme.fonts.small, all[who[side]].name, room));
        ImGui::PopFont();
        const Rect area = take_row(row_px);
        if (waves[side] == nullptr) continue;
        TimeRow row{.id = side == 0 ? "why first" : "why second",
                    .samples = waves[side]->samples_g,
                    .rate_hz = waves[side]->rate_hz,
                    .colour = look_of(ui, work, who[side]).colour};
        row.largest = most_g;
        draw_time_row(ui, work, timeline, area, row);
    }
}

void draw_when(Ui& ui, const Workspace& work, Timeline& timeline, const LiveDifference& live,
               float row_px) {
    const double most = live.apart.empty() ? 0.0 : *std::ranges::max_element(live.apart);
    draw_heading(ui, "When", "the brain waveforms differ, squared: 0 to " + significant(most));
    TimeRow row{.id = "why apart",
                .samples = live.apart,
                .rate_hz = kStepRateHz,
                .colour = ui.theme.series,
                .style = TraceStyle::filled};
    row.signed_values = false;
    draw_time_row(ui, work, timeline, take_row(row_px), row);
}

// Both envelopes between their names, with lines between matched moments.
void draw_way(Ui& ui, const Workspace& work, const Timeline& timeline, const LiveDifference& live,
              const ChosenPair& pair, const Rect& area) {
    const Theme& theme = ui.theme;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float name_px = text_size(theme.fonts.small, "N").y + 2.0F * theme.scale;
    const float third = (area.height() - 2.0F * name_px) / 3.0F;
    const double rate_hz = kModelRateHz / static_cast<double>(live.decimation);
    const float top = area.min.y + name_px;
    const float bottom = area.max.y - name_px;
    const std::array<Rect, 2> rooms{Rect{{area.min.x, top}, {area.max.x, top + third}},
                                    Rect{{area.min.x, bottom - third}, {area.max.x, bottom}}};
    const std::array<const std::vector<double>*, 2> envelopes{&live.envelope_a, &live.envelope_b};
    const std::array<std::size_t, 2> who{pair.current, pair.partner};
    const TimeRange range = shown_range(timeline, shown_duration_s(work));
    Axis time{.low = range.start_s, .high = range.end_s};
    time.low_px = area.min.x;
    time.high_px = area.max.x;
    list.PushClipRect(area.min, area.max, true);
    const double per_line = static_cast<double>(live.path.steps.size()) / (area.width() / 5.0F);
    const auto stride = static_cast<std::size_t>(std::max(1.0, per_line));
    for (std::size_t k = 0; k < live.path.steps.size(); k += stride) {
        const auto [i, j] = live.path.steps[k];
        list.AddLine({to_pixel(time, static_cast<double>(i) / rate_hz), rooms[0].max.y},
                     {to_pixel(time, static_cast<double>(j) / rate_hz), rooms[1].min.y},
                     faded(theme.dim_text, 0.6F), theme.hairline_px);
    }
    for (std::size_t side = 0; side < 2; ++side) {
        Plot plot{rooms[side], rooms[side], time, {.low = 0.0, .high = 1.05}};
        plot.y.high = std::max(1.05, *std::ranges::max_element(*envelopes[side]));
        plot.y.low_px = side == 0 ? rooms[side].max.y : rooms[side].min.y;
        plot.y.high_px = side == 0 ? rooms[side].min.y : rooms[side].max.y;
        draw_signal(list, theme, plot, *envelopes[side], rate_hz,
                    look_of(ui, work, who[side]).colour, TraceStyle::filled);
        const std::string name = shortened(
            theme.fonts.small, work.document.set.vibrations[who[side]].name, area.width());
        const float name_y = side == 0 ? area.min.y : bottom + 2.0F * theme.scale;
        draw_text(list, theme.fonts.small, {area.min.x, name_y}, theme.dim_text, name);
    }
    draw_upright_line(list, to_pixel(time, timeline.playhead.at_s), top, bottom, theme.hairline_px,
                      theme.accent);
    list.PopClipRect();
    note_rect(ui.rects, "plot:why path", area.min, area.max,
              std::to_string(live.path.steps.size()));
}

void draw_rhythm(Ui& ui, const Workspace& work, Timeline& timeline, const LiveDifference& live,
                 const ChosenPair& pair) {
    std::string detail = "which moments of the envelopes match";
    if (live.decimation > 1) {
        const double rate_khz = 1e-3 * kModelRateHz / static_cast<double>(live.decimation);
        detail += ", at " + significant(rate_khz, 2) + " kHz";
    }
    draw_heading(ui, "Rhythm", detail);
    const float below = time_axis_height(ui) + ImGui::GetStyle().ItemSpacing.y + ui.theme.gap_px;
    const float height = std::max(96.0F * ui.theme.scale, ImGui::GetContentRegionAvail().y - below);
    draw_tooltip(ui,
                 "Time warping lets either rhythm wait for the other. The lines are traced through "
                 "coarser envelopes where those are long; OC itself is computed at 10 kHz.");
    const Rect area = take_row(height);
    if (live.envelope_a.empty()) return;
    draw_way(ui, work, timeline, live, pair, area);
    ImGui::SetCursorScreenPos(area.min);
    ImGui::InvisibleButton("way", area.size());
    TimeGesture gesture;
    const float mouse = ImGui::GetIO().MousePos.x;
    const double share = static_cast<double>((mouse - area.min.x) / area.width());
    const TimeRange range = shown_range(timeline, shown_duration_s(work));
    const double at_s = range.start_s + share * range.length_s();
    if (ImGui::IsItemHovered()) gesture.hovered_s = at_s;
    if (ImGui::IsItemActive()) gesture.scrubbed_s = std::max(0.0, at_s);
    take_time_gesture(work, timeline, area, gesture);
    draw_seconds(ui, range);
}

// Below the channels, as high as the room allows: two rows with their names, under one heading.
void draw_vibrations_below(Ui& ui, Workspace& work, Timeline& timeline, const ChosenPair& pair) {
    const float spacing = ImGui::GetStyle().ItemSpacing.y;
    const float names_px = ui.theme.fonts.semibold->FontSize +
                           2.0F * ui.theme.fonts.small->FontSize + time_axis_height(ui) +
                           5.0F * spacing + ui.theme.gap_px;
    const float row_px = 0.5F * (ImGui::GetContentRegionAvail().y - names_px);
    if (row_px < 36.0F * ui.theme.scale) return;
    draw_vibrations(ui, work, timeline, pair, std::floor(row_px));
    draw_seconds(ui, shown_range(timeline, shown_duration_s(work)));
}

// Plots over time, higher in a high pane; a high pane also shows both patterns unless they stand
// beside.
void draw_times(Ui& ui, Workspace& work, Timeline& timeline, const LiveDifference& live,
                const ChosenPair& pair, bool with_vibrations) {
    const float s = ui.theme.scale;
    const float room = ImGui::GetContentRegionAvail().y;
    if (with_vibrations && room > 480.0F * s) {
        draw_vibrations(ui, work, timeline, pair, std::clamp(0.1F * room, 48.0F * s, 110.0F * s));
    }
    draw_when(ui, work, timeline, live, std::clamp(0.18F * room, 46.0F * s, 200.0F * s));
    draw_rhythm(ui, work, timeline, live, pair);
}

// Channels and patterns stand beside the plots over time in a wide or low pane, otherwise above
// them.
void draw_live(Ui& ui, Workspace& work, Timeline& timeline, const LiveDifference& live,
               const ChosenPair& pair) {
    const float s = ui.theme.scale;
    const ImVec2 room = ImGui::GetContentRegionAvail();
    const bool beside = room.x >= 900.0F * s || (room.x >= 440.0F * s && room.y < 520.0F * s);
    if (!beside) {
        draw_channels(ui, live);
    } else {
        const float most = std::max(460.0F * s, 0.3F * room.x);
        ImGui::BeginChild("channels", {std::min(0.42F * room.x, most), room.y});
        draw_channels(ui, live);
        draw_vibrations_below(ui, work, timeline, pair);
        ImGui::EndChild();
        ImGui::SameLine(0.0F, 2.0F * ui.theme.gap_px);
        ImGui::BeginChild("times", {0.0F, room.y});
    }
    draw_times(ui, work, timeline, live, pair, !beside);
    if (beside) ImGui::EndChild();
}

void draw_none(const Ui& ui, const char* title, const char* reason) {
    const Rect area = rest_of_pane();
    if (!area.empty()) draw_empty(*ImGui::GetWindowDrawList(), ui.theme, area, title, reason);
}

// Whether both maps are of the same document and have the same two patterns, by name, in these
// rows.
bool is_same_pair(const LiveMap& one, const LiveMap& other,
                  const std::pair<std::size_t, std::size_t>& rows) {
    if (one.request.document != other.request.document) return false;
    const auto& before = one.request.set->vibrations;
    const auto& now = other.request.set->vibrations;
    const auto is_same = [&](std::size_t row) {
        return row < before.size() && before[row].name == now[row].name;
    };
    return is_same(rows.first) && is_same(rows.second);
}

// Distances of the pair by foreign metrics, if they were compared on this map.
void draw_foreign_parts(Ui& ui, const Comparing& comparing, const LiveMap& map, std::size_t k) {
    if (!comparing.comparison || comparing.comparison->request.map.get() != &map) return;
    for (const ComparedMetric& row : comparing.comparison->metrics) {
        if (row.metric || k >= row.ranks.size()) continue;
        const std::string text = row.name + " " + significant(row.matrix.condensed[k]) + ", rank " +
                                 significant(row.ranks[k]) + " of " +
                                 std::to_string(row.ranks.size());
        dim_text(ui, {.id = "why:" + row.key, .text = text});
    }
}

}  // namespace

void draw_why_panel(Ui& ui, Workspace& work, Layout& layout, Timeline& timeline,
                    const ShownMap& shown_map, const Comparing& comparing) {
    const std::optional<ChosenPair> pair = chosen_pair(work, shown_map);
    if (!pair) return draw_none(ui, "No pair", "It takes two patterns to differ.");
    draw_names(ui, work, layout, *pair);
    const std::shared_ptr<const LiveMap> map = shown_map.transition.shown;
    const auto rows = map ? rows_in_map(work, shown_map, *pair) : std::nullopt;
    if (!rows) {
        const bool left_out = map && map_state(work, shown_map) == MapState::exact;
        return draw_none(ui, left_out ? "Not in the map" : "No distance yet",
                         left_out ? "One of the two is of the side that is not shown."
                                  : "It is computed together with the space above.");
    }
    const std::size_t count = map->prediction.pm.size;
    ImGui::BeginChild("why", ImGui::GetContentRegionAvail());
    const auto [a, b] = *rows;
    const std::size_t k = pair_index(count, std::min(a, b), std::max(a, b));
    draw_parts(ui, *map, k);
    draw_foreign_parts(ui, comparing, *map, k);
    draw_noticed(ui, *map, k, *rows);
    const std::shared_ptr<const LiveDifference> live = comparing.difference;
    const bool fits = live && live->request.a == a && live->request.b == b &&
                      is_same_pair(*live->request.map, *map, *rows);
    if (fits) {
        timeline.range = unless_whole(timeline.range, shown_duration_s(work));
        draw_live(ui, work, timeline, *live, *pair);
    } else if (!draw_failure(ui, "why", comparing.difference_job.failure())) {
        dim_text(ui, map_state(work, shown_map) == MapState::exact
                         ? "looking closer\u2026"
                         : "waiting for the exact map\u2026");
    }
    ImGui::EndChild();
}

}  // namespace tact
