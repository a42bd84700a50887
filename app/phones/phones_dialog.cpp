#include "app/phones/phones.h"

#include <algorithm>
#include <array>

#include "app/document/editing.h"
#include "app/play/play.h"
#include "app/ui/ui.h"
#include "app/ui/widgets.h"
#include "devices/phone/phone_device.h"
#include "model/text/numbers.h"
#include "model/text/shown_text.h"
#include "viz/drawing/plot.h"

namespace tact {

namespace {

constexpr float kPhonesDialogPx = 860.0F;
constexpr float kCodePx = 220.0F;
constexpr float kLeastModulePx = 2.0F;

// Where the page is served: an address of this computer for each network that it is in.
void draw_networks(Ui& ui, PhonesState& state) {
    const bool may_be_others = state.interfaces.empty() || ImGui::IsWindowAppearing();
    if (may_be_others) state.interfaces = network_interfaces();
    draw_label(ui, "Network");
    const auto chosen = std::ranges::find(state.interfaces, state.host, &NetworkInterface::address);
    const auto words = [](const NetworkInterface& one) { return one.name + "  " + one.address; };
    const std::string shown = chosen != state.interfaces.end() ? words(*chosen)
                              : state.interfaces.empty()       ? "This computer alone"
                                                               : words(state.interfaces.front());
    drop_down(
        ui,
        {.id = "combo:phones network",
         .label = shown,
         .tip = "The network that the phones are in, too"},
        320.0F * ui.theme.scale,
        [&] {
            for (const NetworkInterface& one : state.interfaces) {
                const Item item{.id = "phones network:" + one.address, .label = words(one)};
                if (option(ui, item, one.address == state.host)) state.host = one.address;
            }
        },
        ImGuiComboFlags_HeightRegular);
}

void draw_off(Ui& ui, PlayState& play, PhonesState& state) {
    wrapped_text(
        "A phone that scans a code opens a page of this program: it feels the patterns, answers "
        "the questions of a lesson, and rates pairs. Phones and this computer have to be in one "
        "network; nothing goes any further.");
    ImGui::Spacing();
    draw_networks(ui, state);
    ImGui::Spacing();
    if (primary_button(ui, {.id = "button:serve phones", .label = "Serve the page"}))
        serve_phones(ui, play, state);
    if (!state.fault.empty()) coloured_text(ui.theme.warning, state.fault);
}

// Black on white in both themes: cameras read nothing else as surely.
void draw_code(const Ui& ui, const QrCode& code) {
    const std::size_t side = code.side + 2 * kQuietModules;
    const float module =
        std::max(kLeastModulePx, std::floor(kCodePx * ui.theme.scale / static_cast<float>(side)));
    const float size = module * static_cast<float>(side);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(at, {at.x + size, at.y + size}, IM_COL32_WHITE);
    for (std::size_t k = 0; k < code.dark.size(); ++k) {
        if (!code.dark[k]) continue;
        const std::size_t column = kQuietModules + k % code.side;
        const std::size_t row = kQuietModules + k / code.side;
        const ImVec2 from{at.x + module * static_cast<float>(column),
                          at.y + module * static_cast<float>(row)};
        list.AddRectFilled(from, {from.x + module, from.y + module}, IM_COL32_BLACK);
    }
    ImGui::Dummy({size, size});
}

void draw_address(Ui& ui, const PhonesState& state) {
    const std::string address = state.server->address();
    plain_text(ui, {.id = "phones:address", .text = address});
    ImGui::SameLine(0.0F, ui.theme.gap_px);
    if (link(ui, {.id = "link:copy address", .label = "Copy the address"}))
        ImGui::SetClipboardText(address.c_str());
}

std::string latency_words(const ConnectedPhone& phone) {
    if (!phone.vibrates) return "does not vibrate";
    if (!phone.is_here) return "asleep";
    if (!phone.latency_s) return "vibrates";
    return "vibrates, " + stepped(1e3 * *phone.latency_s, 1.0) + " ms late";
}

constexpr std::array kSides{
    Choice{PhoneSide::both, "Both", "Plays all that is played"},
    Choice{PhoneSide::a, "A", "Plays the first of A|B, the current pattern"},
    Choice{PhoneSide::b, "B", "Plays the second of A|B, which the current one is held against"}};

void draw_side(Ui& ui, PhonesState& state, const ConnectedPhone& phone) {
    PhoneSide side = phone.side;
    const std::string noted = "phone " + std::to_string(phone.number) + " side:";
    if (draw_segments(ui, kSides, side, noted)) state.server->set_side(phone.number, side);
}

void draw_phone(Ui& ui, PhonesState& state, const ConnectedPhone& phone, PhonesActions& actions) {
    const std::string number = std::to_string(phone.number);
    ImGui::PushID(phone.number);
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::AlignTextToFramePadding();
    plain_text(ui, {.id = "phone:" + number, .text = shown_text(phone.nickname)});
    ImGui::TableNextColumn();
    ImGui::AlignTextToFramePadding();
    dim_text(ui, {.id = "phone " + number + " state", .text = latency_words(phone)});
    ImGui::TableNextColumn();
    draw_side(ui, state, phone);
    ImGui::TableNextColumn();
    if (row_link(ui,
                 {.id = "phone " + number + " trials",
                  .label = "Tell apart...",
                  .tip = "Which of three is another one? Trials on this phone, of the pairs "
                         "that PM puts closest: what may be confused on it, and by this person.",
                  .enabled = phone.vibrates && !state.rating})) {
        actions.trials_on = phone.number;
    }
    ImGui::SameLine();
    if (row_link(ui, {.id = "phone " + number + " close",
                      .label = "Close",
                      .tip = "The page on this phone ends"})) {
        state.server->close_phone(phone.number);
    }
    ImGui::PopID();
}

void draw_phones(Ui& ui, PhonesState& state, PhonesActions& actions) {
    plain_text(ui, {.id = "phones:here", .text = phones_words(state)});
    if (state.phones.empty()) {
        ImGui::PushTextWrapPos(0.0F);
        dim_text(ui, "Scan the code with a phone that is in the same network.");
        ImGui::PopTextWrapPos();
        return;
    }
    constexpr ImGuiTableFlags kFlags =
        ImGuiTableFlags_SizingFixedFit | ImGuiTableFlags_ScrollY | ImGuiTableFlags_RowBg;
    const float height = std::min(dialog_room_px(), kCodePx * ui.theme.scale);
    if (!ImGui::BeginTable("phones", 4, kFlags, {0.0F, height})) return;
    ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthStretch);
    ImGui::TableSetupColumn("");
    // Segments go below each other where they have no room beside.
    ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthFixed,
                            segments_width(ui, kSides) + ui.theme.gap_px);
    ImGui::TableSetupColumn("");
    for (const ConnectedPhone& phone : state.phones) draw_phone(ui, state, phone, actions);
    ImGui::EndTable();
}

void draw_playing(Ui& ui, Timeline& timeline, PlayState& play) {
    const bool plays = play.choice.id == kPhonesId;
    wrapped_text(plays ? "Play, A|B and the keys of the window play on the phones."
                       : "Phones feel what is tapped on them. To play there from the window:");
    if (plays) return;
    if (button(ui, {.id = "button:play on phones", .label = "Play on the phones"})) {
        choose_device(ui, timeline, play, remembered_choice(play, kPhonesId));
        play.level = 1.0;  // a phone's motor is weak: nobody is startled, and 10 % is not felt
    }
}

constexpr std::array kTimes{Choice{1, "once"}, Choice{2, "twice"}, Choice{4, "four times"}};

// Several that are selected take part in the place of the study's.
std::string rating_obstacle(const Workspace& work) {
    const std::size_t selected = selected_indices(work).size();
    const bool are_chosen = can_rate_together(selected);
    return are_chosen ? std::string() : class_rating_obstacle(work.document.set);
}

void draw_rating(Ui& ui, const Workspace& work, PhonesState& state, PhonesActions& actions) {
    if (!state.rating) {
        const std::string obstacle = rating_obstacle(work);
        actions.rate_together =
            button(ui, {.id = "button:rate together",
                        .label = "Rate together",
                        .tip = "Every phone rates all pairs of the study's patterns, in an order "
                               "of its own. The answers are a study as any other.",
                        .why_not = obstacle,
                        .enabled = !state.phones.empty(),
                        .value = obstacle});
        ImGui::SameLine(0.0F, ui.theme.gap_px);
        dim_text(ui, "each pair");
        ImGui::SameLine(0.0F, ui.theme.gap_px);
        draw_segments(ui, kTimes, state.repetitions, "phones rate:");
        return;
    }
    const RatingProgress progress = progress_of(*state.rating);
    const std::string words = counted(progress.raters, "phone rates", "phones rate") + ", " +
                              std::to_string(progress.finished) + " to the end, " +
                              counted(progress.answers, "answer", "answers");
    wrapped_text(ui, {.id = "phones:rating", .text = words});
    if (!state.rating->fault.empty()) coloured_text(ui.theme.warning, state.rating->fault);
    actions.show_answers = button(ui, {.id = "button:show rating", .label = "Show the answers"});
    ImGui::SameLine();
    if (button(ui, {.id = "button:end rating", .label = "End the rating"})) end_rating(ui, state);
}

constexpr std::array kCounts{Choice{10, "10"}, Choice{20, "20"}, Choice{40, "40"}};

void draw_trials(Ui& ui, PhonesState& state) {
    if (!state.trials) {
        dim_text(ui, "Tell apart, in trials:");
        ImGui::SameLine(0.0F, ui.theme.gap_px);
        draw_segments(ui, kCounts, state.trials_asked, "phones trials:");
        return;
    }
    wrapped_text(ui, {.id = "phones:trials", .text = words_on(state.trials->trials)});
    if (link(ui, {.id = "link:end trials", .label = "Stop the trials"})) end_trials(ui, state);
}

void draw_on(Ui& ui, Workspace& work, Timeline& timeline, PlayState& play, PhonesState& state,
             PhonesActions& actions) {
    if (ImGui::BeginTable("phones page", 2, ImGuiTableFlags_SizingFixedFit)) {
        ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthFixed,
                                (kCodePx + 40.0F) * ui.theme.scale);
        ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthStretch);
        ImGui::TableNextColumn();
        draw_code(ui, state.code);
        ImGui::TableNextColumn();
        draw_phones(ui, state, actions);
        ImGui::EndTable();
    }
    draw_address(ui, state);
    draw_divider(ui.theme);
    draw_playing(ui, timeline, play);
    ImGui::Spacing();
    draw_rating(ui, work, state, actions);
    draw_trials(ui, state);
    ImGui::Spacing();
    if (link(ui, {.id = "link:stop phones",
                  .label = "Close the page",
                  .tip = "No phone plays or answers any more; what was answered is kept."})) {
        stop_phones(ui, timeline, play, state);
    }
}

}  // namespace

PhonesActions draw_phones_dialog(Ui& ui, Workspace& work, Timeline& timeline, PlayState& play,
                                 PhonesState& state) {
    PhonesActions actions;
    if (!begin_dialog(ui, kPhonesDialog, kPhonesDialogPx)) return actions;
    if (!state.server) {
        draw_off(ui, play, state);
    } else {
        draw_on(ui, work, timeline, play, state, actions);
    }
    end_dialog(ui);
    return actions;
}

}  // namespace tact
