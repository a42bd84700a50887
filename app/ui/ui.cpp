#include "app/ui/ui.h"

namespace tact {

void say(Ui& ui, const std::string& text) { ui.status = {text, false, ui.time_s}; }

void complain(Ui& ui, const std::string& text) { ui.status = {text, true, ui.time_s}; }

}  // namespace tact
