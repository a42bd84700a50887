#include "app/screen/screen.h"

#include <doctest/doctest.h>
#include <imgui_stdlib.h>

#include "tests/support/headless_window.h"

namespace input_queue_test {

using namespace tact;

namespace {

// One window with the widgets that lose most when input is lost.
struct Panel {
    int clicks = 0;
    int double_clicks = 0;
    std::string text;
    std::string other;
    float value = 0.0F;
    float wheel = 0.0F;
    std::vector<KeyPress> presses;
    ImVec2 button_at;
    ImVec2 text_at;
    ImVec2 other_at;
    ImVec2 slider_low;
    ImVec2 slider_high;

    void draw(const InputQueue& input) {
        ImGui::Begin("panel");
        clicks += ImGui::Button("press") ? 1 : 0;
        button_at = item_middle();
        if (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(0)) ++double_clicks;
        ImGui::InputText("text", &text);
        text_at = {ImGui::GetItemRectMin().x + 20.0F, item_middle().y};
        ImGui::InputText("other", &other);
        other_at = item_middle();
        ImGui::SliderFloat("##value", &value, 0.0F, 1.0F);
        slider_low = ImGui::GetItemRectMin();
        slider_high = ImGui::GetItemRectMax();
        wheel += ImGui::GetIO().MouseWheel;
        presses.insert(presses.end(), input.pressed.begin(), input.pressed.end());
        ImGui::End();
    }
};

struct Fixture {
    HeadlessWindow window;
    Panel panel;

    Fixture() { settle(); }
    void settle() {
        window.settle([this] { panel.draw(window.input); });
    }
    void frame() {
        window.frame([this] { panel.draw(window.input); });
    }
};

}  // namespace

TEST_CASE("input: ten clicks made within one slow frame are ten clicks") {
    Fixture f;
    f.window.frame_s = 0.5;
    for (int i = 0; i < 10; ++i) f.window.click(f.panel.button_at);
    f.settle();
    CHECK(f.panel.clicks == 10);
    CHECK_FALSE(pending(f.window.input));
}

TEST_CASE("input: fast typing with a correction arrives as it was typed") {
    Fixture f;
    f.window.frame_s = 0.5;
    f.window.click(f.panel.text_at);
    f.window.type("abc");
    f.window.press(key::kBackspace);
    f.window.type("d");
    f.settle();
    CHECK(f.panel.text == "abd");
}

TEST_CASE("input: characters without keys of their own go together and before the next key") {
    Fixture f;
    f.window.click(f.panel.text_at);
    f.settle();
    for (const char32_t sign : {U'\u00e4', U'b', U'c'}) {
        push(f.window.input, {f.window.now_s, Character{sign}});
    }
    f.window.press(key::kBackspace);
    f.frame();
    CHECK(f.panel.text == "\u00e4bc");
    f.settle();
    CHECK(f.panel.text == "\u00e4b");
}

TEST_CASE("input: nine Backspaces in a burst take nine characters") {
    Fixture f;
    f.panel.text = "0123456789";
    f.window.click(f.panel.text_at);
    f.window.press(key::kEnd);
    for (int i = 0; i < 9; ++i) f.window.press(key::kBackspace);
    f.settle();
    CHECK(f.panel.text == "0");
}

TEST_CASE("input: different editing keys of a burst all have their effect, in order") {
    Fixture f;
    f.window.click(f.panel.text_at);
    f.window.type("acd");
    f.window.press(key::kLeft);
    f.window.press(key::kLeft);
    f.window.type("b");
    f.window.press(key::kDelete);
    f.window.press(key::kEnd);
    f.window.type("e");
    f.settle();
    CHECK(f.panel.text == "abde");
}

TEST_CASE("input: fingers that overlap on the keys change nothing") {
    Fixture f;
    const auto key = [&](int code, bool down) {
        push(f.window.input, {f.window.now_s, KeyChange{code, down}});
    };
    f.window.click(f.panel.text_at);
    f.window.type("abc");
    key(key::kBackspace, true);
    key(key::kLeft, true);
    key(key::kBackspace, false);
    key(key::kLeft, false);
    key(key::kBackspace, true);
    push(f.window.input, {f.window.now_s, Character{U'x'}});
    key(key::kBackspace, false);
    f.settle();
    CHECK(f.panel.text == "xb");
}

TEST_CASE("input: text typed before the mouse button is up goes where the button went down") {
    Fixture f;
    f.window.click(f.panel.text_at);
    f.settle();
    f.window.move(f.panel.other_at);
    f.window.button(true);
    push(f.window.input, {f.window.now_s, Character{U'x'}});
    f.window.button(false);
    f.settle();
    CHECK(f.panel.text.empty());
    CHECK(f.panel.other == "x");
}

TEST_CASE("input: a drag released in the frame of its last move ends where the mouse was") {
    Fixture f;
    const ImVec2 low = f.panel.slider_low;
    const ImVec2 high = f.panel.slider_high;
    const float middle_y = (low.y + high.y) / 2.0F;
    f.window.move({low.x + 10.0F, middle_y});
    f.window.button(true);
    f.window.move({low.x + 40.0F, middle_y});
    f.window.move({high.x + 50.0F, middle_y});
    f.window.button(false);
    f.window.move(f.panel.button_at);
    f.settle();
    CHECK(f.panel.value == 1.0F);
}

TEST_CASE("input: wheel notches of one frame add up, none is lost") {
    Fixture f;
    f.window.move(f.panel.button_at);
    f.settle();
    const int frames_before = ImGui::GetFrameCount();
    for (int i = 0; i < 7; ++i) push(f.window.input, {f.window.now_s, MouseWheel{0.0F, 0.5F}});
    f.frame();
    CHECK(f.panel.wheel == 3.5F);
    CHECK(ImGui::GetFrameCount() == frames_before + 1);
}

TEST_CASE("input: a double click is known by when it was made, not by slow frames") {
    Fixture f;
    f.window.frame_s = 0.4;  // more than ImGui's 0.3 s between two clicks
    const auto click_at = [&](double time_s) {
        push(f.window.input, {time_s, MouseButton{0, true}});
        push(f.window.input, {time_s + 0.05, MouseButton{0, false}});
    };
    f.window.move(f.panel.button_at);
    f.settle();
    const double start_s = f.window.now_s;
    click_at(start_s + 0.01);
    click_at(start_s + 0.16);
    f.settle();
    CHECK(f.panel.double_clicks == 1);
}

TEST_CASE("input: two slow clicks that wait in the queue together are no double click") {
    Fixture f;
    f.window.frame_s = 1.0;
    f.window.move(f.panel.button_at);
    f.settle();
    const double start_s = f.window.now_s;
    for (const double time_s : {start_s + 0.1, start_s + 0.7}) {
        push(f.window.input, {time_s, MouseButton{0, true}});
        push(f.window.input, {time_s + 0.05, MouseButton{0, false}});
    }
    f.settle();
    CHECK(f.panel.clicks == 2);
    CHECK(f.panel.double_clicks == 0);
}

TEST_CASE("input: a shortcut keeps its modifier however fast it was typed") {
    Fixture f;
    for (int i = 0; i < 3; ++i) {
        push(f.window.input, {f.window.now_s, KeyChange{key::kLeftControl, true}});
        f.window.press('Z', U'z');
        push(f.window.input, {f.window.now_s, KeyChange{key::kLeftControl, false}});
        f.window.press('Z', U'z');
    }
    f.settle();
    REQUIRE(f.panel.presses.size() == 6);
    for (std::size_t i = 0; i < 6; ++i) {
        CHECK(f.panel.presses[i].sign == U'z');
        CHECK(f.panel.presses[i].ctrl == (i % 2 == 0));
    }
}

TEST_CASE("input: a modifier let go before its key still counts") {
    Fixture f;
    push(f.window.input, {f.window.now_s, KeyChange{key::kLeftControl, true}});
    f.frame();
    push(f.window.input, {f.window.now_s, KeyChange{'Z', true, false, U'z'}});
    push(f.window.input, {f.window.now_s, KeyChange{key::kLeftControl, false}});
    push(f.window.input, {f.window.now_s, KeyChange{'Z', false, false, U'z'}});
    f.frame();
    REQUIRE(f.panel.presses.size() == 1);
    CHECK(f.panel.presses[0].ctrl);
    CHECK(ImGui::GetIO().KeyCtrl);  // what widgets look at in this frame
    f.settle();
    CHECK_FALSE(ImGui::GetIO().KeyCtrl);
}

TEST_CASE("input: repeats of a held key reach shortcuts once a frame and never pile up") {
    Fixture f;
    push(f.window.input, {f.window.now_s, KeyChange{key::kUp, true}});
    for (int i = 0; i < 20; ++i)
        push(f.window.input, {f.window.now_s, {KeyChange{key::kUp, true, true}}});
    f.frame();
    CHECK_FALSE(pending(f.window.input));
    REQUIRE(f.panel.presses.size() == 1);
    CHECK_FALSE(f.panel.presses[0].repeat);
    push(f.window.input, {f.window.now_s, KeyChange{key::kUp, true, true}});
    f.frame();
    REQUIRE(f.panel.presses.size() == 2);
    CHECK(f.panel.presses[1].repeat);
    CHECK(is_anything_held(f.window.input, ImGui::GetIO()));
    push(f.window.input, {f.window.now_s, KeyChange{key::kUp, false}});
    f.frame();
    CHECK_FALSE(is_anything_held(f.window.input, ImGui::GetIO()));
}

TEST_CASE("input: losing the focus lets go of every key and button") {
    Fixture f;
    push(f.window.input, {f.window.now_s, KeyChange{key::kLeftControl, true}});
    f.window.move(f.panel.button_at);
    f.window.button(true);
    f.settle();
    REQUIRE(ImGui::GetIO().KeyCtrl);
    push(f.window.input, {f.window.now_s, FocusChange{false}});
    f.settle();
    CHECK_FALSE(ImGui::GetIO().KeyCtrl);
    CHECK_FALSE(is_anything_held(f.window.input, ImGui::GetIO()));
}

TEST_CASE("input: keys the program does not know are passed over") {
    Fixture f;
    f.window.press(key::kUnknown, U'\u00e4');
    f.window.press(100'000);
    f.window.button(true, 7);
    f.settle();
    CHECK_FALSE(is_anything_held(f.window.input, ImGui::GetIO()));
    CHECK(f.panel.presses.size() == 2);
}

TEST_CASE("input: Enter presses the focused button, Space does not") {
    Fixture f;
    int presses = 0;
    const auto draw = [&] {
        ImGui::Begin("keyboard");
        presses += ImGui::Button("focused") ? 1 : 0;
        ImGui::SetItemDefaultFocus();
        ImGui::End();
    };
    f.window.settle(draw);
    f.window.press(key::kDown);
    f.window.press(key::kSpace, U' ');
    f.window.settle(draw);
    CHECK(presses == 0);
    f.window.press(key::kEnter);
    f.window.settle(draw);
    CHECK(presses == 1);
}

TEST_CASE("input: ImGui's clock keeps up with the wall clock when nothing waits") {
    Fixture f;
    f.window.frame_s = 10.0;
    const double before_s = ImGui::GetTime();
    f.frame();
    f.frame();
    // DeltaTime is a float.
    CHECK(std::abs(ImGui::GetTime() - before_s - 20.0) < 1e-4);
}

}  // namespace input_queue_test
