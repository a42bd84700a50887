// What a participant sees: one page at a time, over the whole window.
//
// Everything goes by keyboard as well, and the keys are on the page.
#pragma once

#include <span>

#include "app/document/workspace.h"
#include "app/play/play_state.h"
#include "app/screen/input_queue.h"
#include "app/study/study_follow.h"
#include "app/study/study_state.h"
#include "app/ui/ui.h"
#include "viz/drawing/geometry.h"

namespace tact {

// The page of the run; there must be one.
void draw_study_pages(Ui& ui, const Workspace& work, const PlayState& play, StudyState& studying,
                      std::span<const KeyPress> pressed);

// How much larger than on an ordinary screen a page is, so that it is read at arm's length in a
// window of this size; in eighths, as fonts are made again for each.
float wanted_page_scale(const Ui& ui, ImVec2 window_px);

// After kCallAfter plays in a row that were cut short.
inline constexpr const char* kCallText =
    "It is cut short again and again: please call the experimenter.";

// Content of pages, in the middle of `area`; each takes its own keys.
void draw_training_page(Ui& ui, const Workspace& work, const PlayState& play, StudyState& studying,
                        const Rect& area, std::span<const KeyPress> pressed);
void draw_trial_page(Ui& ui, const Workspace& work, const PlayState& play, StudyState& studying,
                     const Rect& area, std::span<const KeyPress> pressed);
void draw_sorting_page(Ui& ui, const Workspace& work, const PlayState& play, StudyState& studying,
                       const Rect& area, std::span<const KeyPress> pressed);

// A large button with its key beneath; filled as far as its pattern has played. True when pressed.
struct FeelButton {
    const char* id;  // noted under this name
    std::string label;
    std::string key;  // shown small; may be empty
    bool is_playing = false;
    int times = 0;  // felt before
    bool is_enabled = true;
};
bool draw_feel_button(Ui& ui, const StudyState& studying, const Rect& area,
                      const FeelButton& button);

// The button at the foot of a page that leads to the next, and its size.
ImVec2 go_on_size(const Theme& theme);
void draw_go_on(Ui& ui, const Workspace& work, const PlayState& play, StudyState& studying,
                const Rect& area, const char* label);

// Share of the pattern that has played, 0 to 1.
float played_share(const Ui& ui, const StudyState& studying);

// A sign was typed, without Ctrl and the like.
bool was_typed(std::span<const KeyPress> pressed, char32_t sign);

// Words in the middle of a page.
void centred_text(const ImFont* font, ImU32 colour, const Rect& area, float y,
                  const std::string& text);

}  // namespace tact
