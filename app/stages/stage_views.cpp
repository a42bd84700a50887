#include "app/stages/parts.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "app/document/editing.h"
#include "app/document/workspace.h"
#include "app/physiology/physiology.h"
#include "app/timeline/timeline.h"
#include "app/ui/widgets.h"
#include "model/text/numbers.h"
#include "viz/drawing/colour.h"
#include "viz/drawing/marks.h"
#include "viz/drawing/plot.h"

namespace tact {

namespace {

// Whether a lane is empty: no receptor of the type fires, or its filter passes nothing.
bool is_silent(const StageSignal& signal) {
    return std::ranges::all_of(signal.samples, [](double sample) { return sample == 0.0; });
}

ImU32 colour_of(const Ui& ui, const ShownStages& shown, const StageSignal& signal, Stage stage) {
    if (signal.receptor) return ui.theme.receptor[index_of(*signal.receptor)];
    if (stage == Stage::vibration) return shown.look.colour;
    return stage == Stage::brain ? ui.theme.text : ui.theme.dim_text;
}

// The lane of a silent channel, from the left edge of the other lanes: its name and the reason.
void draw_silent_row(const Ui& ui, Rect area, const StageSignal& signal, bool large) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    if (large) area.min.x += value_room_px(ui);
    const float y = std::round(area.centre().y);
    draw_level_line(list, y, area.min.x, area.max.x, ui.theme.hairline_px, ui.theme.line);
    const std::string text = std::string(traits(*signal.receptor).name) + " silent";
    const float text_px = font_or_current(ui.theme.fonts.small).FontSize;
    if (area.height() < text_px) return;
    const ImVec2 size = text_size(ui.theme.fonts.small, text);
    const ImVec2 corner{area.centre().x - size.x / 2.0F, y - text_px / 2.0F};
    const float margin = ui.theme.gap_px * 0.5F;
    list.AddRectFilled({corner.x - margin, corner.y},
                       {corner.x + size.x + margin, corner.y + text_px}, ui.theme.pane);
    draw_text(list, ui.theme.fonts.small, corner, ui.theme.dim_text, text);
}

// The area right of a lane.
Rect beside_lane(const Rect& lane, const StageSize& size) {
    return {{lane.max.x, lane.min.y}, {lane.max.x + size.lanes_px, lane.max.y}};
}

// Heights of rows in an area: channels that are silent in all patterns on screen take less. A pair
// has the same rows, so that its lanes stand one above the other.
std::vector<float> row_weights(const Physiology& physiology, const LiveStages& live, Stage stage) {
    const ShownDifference& pair = physiology.view.difference;
    std::vector<float> weights;
    for (const LiveStages* one : {&live, pair.a.get(), pair.b.get()}) {
        if (one == nullptr) continue;
        const std::vector<StageSignal> signals = signals_of(*one, stage);
        weights.resize(std::max(weights.size(), signals.size()), 0.45F);
        for (std::size_t k = 0; k < signals.size(); ++k) {
            if (!signals[k].receptor || !is_silent(signals[k])) weights[k] = 1.0F;
        }
    }
    return weights;
}

std::vector<Rect> shared_out(const Rect& area, const std::vector<float>& weights, float axis_px) {
    const float total = std::accumulate(weights.begin(), weights.end(), 0.0F);
    const float height = area.height() - axis_px;
    std::vector<Rect> rects;
    float top = area.min.y;
    for (const float weight : weights) {
        const float bottom = top + height * weight / total;
        rects.push_back({{area.min.x, top}, {area.max.x, bottom}});
        top = bottom;
    }
    if (!rects.empty()) rects.back().max.y += axis_px;
    return rects;
}

// Vibrations of a set share one scale, and so do renderings and filtered signals, unless they are
// stronger.
double reach_of(const Workspace& work, const StageSignal& signal, Stage stage) {
    const double reach_g = shown_reach_g(work);
    const bool in_g = stage == Stage::vibration || stage == Stage::filtered;
    if (!in_g || reach_g == 0.0) return signal.largest;
    double peak = reach_g;
    for (const double sample : signal.samples) peak = std::max(peak, std::abs(sample));
    return peak;
}

// A note in a trace that shows nothing but filter leak.
void draw_leak_note(Ui& ui, const Rect& area, Receptor receptor) {
    const std::string text =
        std::string(traits(receptor).name) + ": nothing in its band, its filter leaks";
    const ImVec2 size = text_size(ui.theme.fonts.small, text);
    if (area.height() < size.y || area.width() < size.x) return;
    const ImVec2 corner{area.centre().x - size.x / 2.0F,
                        std::round(area.centre().y - size.y / 2.0F)};
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 pad{3.0F * ui.theme.scale, 0.0F};
    list.AddRectFilled(corner - pad, corner + size + pad, ui.theme.pane, ui.theme.rounding_px);
    draw_text(list, ui.theme.fonts.small, corner, ui.theme.dim_text, text);
    note_rect(ui.rects, std::string("leaks:") + traits(receptor).afferent, corner, corner + size,
              text);
}

TimeRow row_of(const Ui& ui, const ShownStages& shown, const StageSignal& signal, Stage stage) {
    TimeRow row;
    row.id = signal.id + (shown.pinned ? " pinned" : "");
    row.samples = signal.samples;
    row.rate_hz = signal.rate_hz;
    row.colour = colour_of(ui, shown, signal, stage);
    row.style = signal.is_signed ? TraceStyle::line : TraceStyle::filled;
    row.largest = signal.largest;
    row.signed_values = signal.is_signed;
    row.unit = signal.unit;
    row.stale = shown.stale;
    return row;
}

// If spikes are far enough apart to be told apart, the central signals show each of them.
constexpr double kSingleSpikesS = 0.05;

void draw_signals(Ui& ui, const Workspace& work, Timeline& timeline, const Physiology& physiology,
                  const ShownStages& shown, Stage stage, const Rect& area, const StageSize& size) {
    std::vector<StageSignal> signals = signals_of(*shown.live, stage);
    const double shown_s = shown_range(timeline, shown_duration_s(work)).length_s();
    if (stage == Stage::central && shown_s <= kSingleSpikesS) {
        for (StageSignal& signal : signals) {
            signal.samples = shown.live->central_spikes[index_of(*signal.receptor)];
            signal.rate_hz = kModelRateHz;
            signal.largest = 1.0;
        }
    }
    const float axis_px = size.time_axis ? time_axis_height(ui) : 0.0F;
    const std::vector<Rect> rects =
        shared_out(area, row_weights(physiology, *shown.live, stage), axis_px);
    for (std::size_t k = 0; k < signals.size(); ++k) {
        const bool last = k + 1 == signals.size();
        Rect lane = rects[k];
        if (last) lane.max.y -= axis_px;
        if (signals[k].receptor && size.lanes_px > 0.0F) {
            draw_lane_name(ui, beside_lane(lane, size), *signals[k].receptor);
        }
        const bool silent = signals[k].receptor && is_silent(signals[k]);
        if (silent && !(last && size.time_axis)) {
            draw_silent_row(ui, lane, signals[k], size.large);
            continue;
        }
        TimeRow row = row_of(ui, shown, signals[k], stage);
        row.large = size.large;
        row.largest = reach_of(work, signals[k], stage);
        row.time_axis = last && size.time_axis;
        row.values = !silent;
        if (silent) row.colour = IM_COL32_BLACK_TRANS;  // the line of its lane is enough
        draw_time_row(ui, work, timeline, rects[k], row);
        if (silent) draw_silent_row(ui, lane, signals[k], size.large);
        // In the large stage the remark above says it.
        if (stage == Stage::filtered && !size.large &&
            shown.live->only_leaks[index_of(*signals[k].receptor)]) {
            draw_leak_note(ui, lane, *signals[k].receptor);
        }
    }
}

// Words for stages without a signal to subtract.
void draw_difference_text(const Ui& ui, const Rect& area, Stage stage,
                          std::optional<double> difference) {
    if (!difference) return;
    const bool is_spectrum = stage == Stage::spectrum;
    // Bars at different frequencies share nothing, however close: a number would add nothing.
    const std::string text = is_spectrum && *difference > 0.995
                                 ? "no frequency in common"
                                 : percent(*difference) + " of the " +
                                       (is_spectrum ? "amplitudes" : "firing") + " not in common";
    const ImVec2 size = text_size(ui.theme.fonts.small, text);
    draw_text(*ImGui::GetWindowDrawList(), ui.theme.fonts.small,
              {area.centre().x - size.x / 2.0F, area.centre().y - size.y / 2.0F}, ui.theme.dim_text,
              text);
}

}  // namespace

float lane_names_px(const Ui& ui, float width_px) {
    float names_px = 0.0F;
    for (const Receptor type : kReceptors) {
        names_px = std::max(names_px, text_size(ui.theme.fonts.small, traits(type).name).x);
    }
    const float marks_px = ui.theme.gap_px + 2.6F * ui.theme.mark_px;
    return names_px + marks_px < 0.16F * width_px ? names_px + marks_px : marks_px;
}

void draw_lane_name(const Ui& ui, const Rect& place, Receptor receptor) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImFont* font = ui.theme.fonts.small;
    const float text_px = font_or_current(font).FontSize;
    const float left = place.min.x + ui.theme.gap_px;
    const float y = std::round(place.centre().y);
    const float radius = std::min(0.85F * ui.theme.mark_px, 0.4F * place.height());
    draw_receptor_mark(list, ui.theme, {left + ui.theme.mark_px, y}, radius, receptor);
    const float words_px = left + 2.6F * ui.theme.mark_px;
    const char* const name = traits(receptor).name;
    if (place.height() < 0.8F * text_px) return;  // no name reaches below its line
    if (words_px + text_size(font, name).x > place.max.x + 1.0F) return;
    draw_text(list, font, {words_px, y - 0.55F * text_px}, ui.theme.text, name);
}

std::string reach_text(const Workspace& work, const ShownStages& shown, Stage stage) {
    if (stage != Stage::vibration && stage != Stage::filtered) return {};
    const double reach_g = reach_of(work, signals_of(*shown.live, stage)[0], stage);
    return reach_g > 0.0 ? "\u00b1" + significant_digits(reach_g, 3) + " g" : std::string();
}

ImU32 difference_colour(const Theme& theme) {
    return theme.is_dark ? IM_COL32(0xB1, 0x8C, 0xFF, 0xFF) : IM_COL32(0x6A, 0x3F, 0xC4, 0xFF);
}

Receptor strongest_channel(const LiveStages& live) {
    std::size_t best = index_of(Receptor::pacinian);
    double most = -1.0;
    for (std::size_t c = 0; c < kReceptorCount; ++c) {
        const double spikes =
            std::accumulate(live.central_count[c].begin(), live.central_count[c].end(), 0.0) *
            (live.request.model.channel_weight[c] + 1e-3);
        if (spikes > most) {
            most = spikes;
            best = c;
        }
    }
    return kReceptors[best];
}

void draw_stage(Ui& ui, const Workspace& work, Timeline& timeline, Physiology& physiology,
                const ShownStages& shown, Stage stage, const Rect& area, const StageSize& size) {
    switch (stage) {
        case Stage::spectrum:
            return draw_spectrum_stage(ui, physiology, shown, area, size.large);
        case Stage::receptors:
            return draw_receptor_stage(ui, timeline, physiology, shown, area, size);
        case Stage::spikes:
            return draw_spike_stage(ui, work, timeline, physiology, shown, area, size);
        case Stage::networks:
            return draw_network_stage(ui, timeline, physiology, shown, area, size);
        default:
            return draw_signals(ui, work, timeline, physiology, shown, stage, area, size);
    }
}

void draw_stage_difference(Ui& ui, const Workspace& work, Timeline& timeline,
                           const Physiology& physiology, const ShownStages& a, const ShownStages& b,
                           Stage stage, const Rect& area, const StageSize& size) {
    const std::vector<StageSignal> signals = signals_of(*a.live, stage);
    const auto& differences = physiology.view.difference.signals[index_of(stage)];
    if (signals.empty() || differences.size() != signals.size()) {
        const auto& known = physiology.view.difference.stages;
        return draw_difference_text(ui, area, stage, known[index_of(stage)]);
    }
    const std::vector<Rect> rects = shared_out(area, row_weights(physiology, *a.live, stage), 0.0F);
    double largest = 0.0;  // the rows have one scale
    for (const std::vector<double>& difference : differences) {
        for (const double sample : difference) largest = std::max(largest, std::abs(sample));
    }
    for (std::size_t k = 0; k < signals.size(); ++k) {
        TimeRow row = row_of(ui, a, signals[k], stage);
        row.id = signals[k].id + " difference";
        row.samples = differences[k];
        row.colour = difference_colour(ui.theme);
        row.signed_values = true;
        row.largest = std::max(signals[k].largest, largest);
        row.large = size.large;
        row.stale = a.stale || b.stale;
        draw_time_row(ui, work, timeline, rects[k], row);
        if (signals[k].receptor && size.lanes_px > 0.0F) {
            draw_lane_name(ui, beside_lane(rects[k], size), *signals[k].receptor);
        }
    }
}

}  // namespace tact
