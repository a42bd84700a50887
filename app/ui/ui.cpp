#include "app/ui/ui.h"

#include <algorithm>
#include <limits>
#include <utility>

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
    ui.fonts_outdated = true;  // the theme is made again with them
}

constexpr double kBehindS = 0.3;

bool looks_stale(Ui& ui, const std::string& pane, std::shared_ptr<const void> shown, bool stale) {
    if (ui.as_picture) return stale;
    ShownAge& age = ui.ages[pane];
    const bool goes_on = stale && age.stale && age.of == shown;
    age = {std::move(shown), stale, goes_on ? age.since_s : ui.time_s};
    return stale && ui.time_s - age.since_s >= kBehindS;
}

double aging_wake_s(const Ui& ui) {
    double wake_s = std::numeric_limits<double>::infinity();
    for (const auto& [pane, age] : ui.ages) {
        const double left_s = age.since_s + kBehindS - ui.time_s;
        if (age.stale && left_s > 0.0) wake_s = std::min(wake_s, left_s + 0.001);
    }
    return wake_s;
}

}  // namespace tact
