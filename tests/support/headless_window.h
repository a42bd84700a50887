// A window without a screen: ImGui frames fed from an input queue, for tests of what is drawn.
//
// Output    what the widgets did; nothing is rasterised
#pragma once

#include <imgui.h>

#include <string>

#include "app/screen/screen.h"
#include "viz/drawing/imgui_versions.h"

namespace tact {

struct HeadlessWindow {
    InputQueue input;
    double now_s = 0.0;
    double frame_s = 0.016;

    HeadlessWindow() : before_(ImGui::GetCurrentContext()), context_(ImGui::CreateContext()) {
        ImGui::SetCurrentContext(context_);
        ImGuiIO& io = ImGui::GetIO();
        io.IniFilename = nullptr;
        // As the backend of the window has it.
        io.BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;
        io.DisplaySize = {800.0F, 600.0F};
        io.ConfigFlags |= ImGuiConfigFlags_NavEnableKeyboard;
        io.Fonts->Build();
        name_keys(io);
    }
    ~HeadlessWindow() {
        ImGui::DestroyContext(context_);
        ImGui::SetCurrentContext(before_);
    }
    HeadlessWindow(const HeadlessWindow&) = delete;
    HeadlessWindow& operator=(const HeadlessWindow&) = delete;

    template <class Draw>
    void frame(Draw draw) {
        now_s += frame_s;
        apply(input, ImGui::GetIO(), now_s);
        ImGui::NewFrame();
        draw();
        ImGui::Render();
    }

    // Draws until all input has had its effect, and two frames more for what opens late.
    template <class Draw>
    void settle(Draw draw) {
        while (pending(input)) frame(draw);
        for (int i = 0; i < 2; ++i) frame(draw);
    }

    void move(ImVec2 to) { push(input, {now_s, MouseMove{to.x, to.y}}); }
    void button(bool down, int which = 0) { push(input, {now_s, MouseButton{which, down}}); }
    void click(ImVec2 at) {
        move(at);
        button(true);
        button(false);
    }
    void press(int code, char32_t sign = 0) {
        push(input, {now_s, KeyChange{code, true, false, sign}});
        push(input, {now_s, KeyChange{code, false, false, sign}});
    }
    // As a keyboard does it: key down, character, key up.
    void type(const std::string& text) {
        for (const char sign : text) {
            const auto code = static_cast<char32_t>(sign);
            const bool is_lower = sign >= 'a' && sign <= 'z';
            const int key_code = is_lower ? sign - 'a' + 'A' : sign;
            push(input, {now_s, KeyChange{key_code, true, false, code}});
            push(input, {now_s, Character{code}});
            push(input, {now_s, KeyChange{key_code, false, false, code}});
        }
    }

  private:
    ImGuiContext* before_;
    ImGuiContext* context_;
};

// The middle of the item drawn last.
inline ImVec2 item_middle() {
    const ImVec2 low = ImGui::GetItemRectMin();
    const ImVec2 high = ImGui::GetItemRectMax();
    return {(low.x + high.x) / 2.0F, (low.y + high.y) / 2.0F};
}

}  // namespace tact
