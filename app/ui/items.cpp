// Widgets that say themselves.

#include "app/ui/widgets.h"
#include "model/text/shown_text.h"

namespace tact {

namespace {

// Words, and the name that ImGui knows an item by.
std::string named(const Item& item) { return label_of(item.label) + "###" + item.id; }

template <class Draw>
bool drawn(Ui& ui, const Item& item, const Draw& draw) {
    const bool is_disabled = !item.enabled || !item.why_not.empty();
    ImGui::BeginDisabled(is_disabled);
    const bool pressed = draw();
    say_of_last_item(ui, {.id = item.id,
                          .text = item.label,
                          .tip = item.why_not.empty() ? item.tip : item.why_not,
                          .value = item.value});
    ImGui::EndDisabled();
    return pressed && !is_disabled;
}

}  // namespace

void say_of_last_item(Ui& ui, const Said& said) {
    note_item(ui.rects, said.id, said.value.value_or(said.text));
    if (!said.tip.empty()) draw_tooltip(ui, said.tip.c_str());
}

bool button(Ui& ui, const Item& item, ImVec2 size) {
    return drawn(ui, item, [&] { return ImGui::Button(named(item).c_str(), size); });
}

bool small_button(Ui& ui, const Item& item) {
    return drawn(ui, item, [&] { return ImGui::SmallButton(named(item).c_str()); });
}

bool primary_button(Ui& ui, const Item& item, ImVec2 size) {
    return drawn(ui, item, [&] { return primary_button(ui, named(item).c_str(), size); });
}

bool link(Ui& ui, const Item& item) {
    return drawn(ui, item, [&] { return link(ui, item.id.c_str(), item.label); });
}

bool row_link(Ui& ui, const Item& item) {
    return drawn(ui, item, [&] { return row_link(ui, item.id.c_str(), item.label); });
}

bool name_link(Ui& ui, const Item& item) {
    return drawn(ui, item, [&] { return name_link(ui, item.id.c_str(), item.label); });
}

bool chip(Ui& ui, const Item& item, bool lit) {
    return drawn(ui, item, [&] { return draw_chip(ui, item.id.c_str(), item.label.c_str(), lit); });
}

bool toggle(Ui& ui, const Item& item, bool on) {
    return drawn(ui, item,
                 [&] { return draw_switch(ui, item.id.c_str(), item.label.c_str(), on); });
}

bool check(Ui& ui, Item item, bool& on) {
    return drawn(ui, item, [&] {
        const bool pressed = draw_check(ui.theme, named(item).c_str(), on);
        if (!item.value) item.value = on ? "on" : "off";
        return pressed;
    });
}

bool radio(Ui& ui, const Item& item, bool chosen) {
    return drawn(ui, item, [&] { return draw_radio(ui, item.label.c_str(), chosen); });
}

bool segment(Ui& ui, const Item& item, bool chosen) {
    return drawn(ui, item, [&] { return draw_segment(ui, item.label.c_str(), chosen); });
}

bool option(Ui& ui, const Item& item, bool chosen, ImGuiSelectableFlags flags, ImVec2 size) {
    return drawn(ui, item,
                 [&] { return ImGui::Selectable(named(item).c_str(), chosen, flags, size); });
}

bool menu_item(Ui& ui, const Item& item, const char* keys, bool checked) {
    return drawn(ui, item, [&] { return ImGui::MenuItem(named(item).c_str(), keys, checked); });
}

void drop_down(Ui& ui, const Item& item, float width_px, const std::function<void()>& rows,
               ImGuiComboFlags flags) {
    drawn(ui, item, [&] {
        if (width_px != 0.0F) ImGui::SetNextItemWidth(width_px);
        if (!ImGui::BeginCombo(("##" + item.id).c_str(), label_of(item.label).c_str(), flags)) {
            return false;
        }
        rows();
        ImGui::EndCombo();
        return false;
    });
}

void plain_text(Ui& ui, const Said& said) {
    ImGui::TextUnformatted(shown_lines(said.text).c_str());
    say_of_last_item(ui, said);
}

void dim_text(Ui& ui, const Said& said) {
    dim_text(ui, said.text);
    say_of_last_item(ui, said);
}

void dim_text_beside(Ui& ui, const Said& said) {
    dim_text_beside(ui, said.text);
    say_of_last_item(ui, said);
}

void wrapped_text(Ui& ui, const Said& said) {
    wrapped_text(said.text);
    say_of_last_item(ui, said);
}

void coloured_text(Ui& ui, ImU32 colour, const Said& said) {
    coloured_text(colour, said.text);
    say_of_last_item(ui, said);
}

}  // namespace tact
