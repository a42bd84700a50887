#include "app/ui/ui.h"

#include <algorithm>

namespace tact {

void say(Ui& ui, const std::string& text) { ui.status = {text, false, ui.time_s}; }

void complain(Ui& ui, const std::string& text) { ui.status = {text, true, ui.time_s}; }

void set_text_scale(Ui& ui, float scale) {
    ui.text_scale = scale;
    ui.fonts_outdated = true;
}

void step_text_scale(Ui& ui, float factor) {
    set_text_scale(ui, std::clamp(ui.text_scale * factor, 0.75F, 2.0F));
}

void set_theme(Ui& ui, bool dark) {
    ui.dark = dark;
    ui.fonts_outdated = true;  // the theme is made anew with them
}

}  // namespace tact
