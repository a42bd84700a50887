// The window as a canvas that fills a page. A browser calls for each frame, and takes it back if
// nothing is due; run_window() returns at once, and the window is there until the page is gone.
// Where the page has no threads, jobs get their turns between two frames (app/jobs/jobs.h).
#include <backends/imgui_impl_opengl3.h>
#include <emscripten.h>
#include <emscripten/html5.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <string>

#include "app/jobs/jobs.h"
#include "app/page/page_events.h"
#include "app/screen/screen.h"
#include "model/text/shown_text.h"
#include "viz/drawing/imgui_versions.h"

// In page.js.
extern "C" {
int page_is_there();  // 0: node
void page_show_cursor(const char* name);
void page_pick_files();
int page_is_for_fingers();
void page_read_out(const char* words);
}

namespace tact {
namespace {

constexpr int kSettlingFrames = 3;
constexpr double kCursorBlinkS = 0.2;
constexpr double kRestS = 0.3;  // after the last input, before work that holds the picture up

std::atomic<bool> was_woken = false;

struct Page {
    PageEvents events;
    KeptFrame kept;
    ImGuiMouseCursor cursor = ImGuiMouseCursor_Arrow;
    std::string title;
    std::string reading;
    int width = 0;  // of the canvas in pixels
    int height = 0;
    float scale = 1.0F;
    int frames_due = kSettlingFrames;
    bool shows_last_turn = false;  // what the last turn of a job has found is on the screen
    double last_input_s = 0.0;
    double next_wake_s = 0.0;
};

void connect_imgui(Page& page) {
    ImGui::CreateContext();
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;  // what lasts is in the session
    io.ConfigFlags |= ImGuiConfigFlags_NavEnableKeyboard;
    io.BackendFlags |= ImGuiBackendFlags_HasMouseCursors;
    io.BackendPlatformName = "tactspace";
    io.ClipboardUserData = &page.events;
    io.SetClipboardTextFn = [](void* events, const char* text) {
        static_cast<PageEvents*>(events)->clipboard = text;
        copy_in_page(text);
    };
    io.GetClipboardTextFn = [](void* events) {
        return static_cast<PageEvents*>(events)->clipboard.c_str();
    };
    name_keys(io);
    ImGui_ImplOpenGL3_Init("#version 300 es");
}

// As large as the page, in pixels of the screen.
void fit_canvas(Page& page) {
    double width = 0.0;
    double height = 0.0;
    emscripten_get_element_css_size("#canvas", &width, &height);
    const float scale = page_scale();
    const auto wide = static_cast<int>(std::lround(width * scale));
    const auto high = static_cast<int>(std::lround(height * scale));
    if (wide == page.width && high == page.height && scale == page.scale) return;
    page.events.fonts_outdated |= scale != page.scale;
    page.width = wide;
    page.height = high;
    page.scale = scale;
    emscripten_set_canvas_element_size("#canvas", wide, high);
    page.frames_due = kSettlingFrames;
}

void rebuild_fonts(Page& page) {
    ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
    ImGui_ImplOpenGL3_DestroyFontsTexture();
    atlas.Clear();
    if (page.events.client.build_fonts) page.events.client.build_fonts(page.scale);
    if (atlas.Fonts.empty()) atlas.AddFontDefault();
    ImGui_ImplOpenGL3_CreateFontsTexture();
    forget(page.kept);
    page.events.fonts_outdated = false;
}

void show_cursor(Page& page) {
    const ImGuiMouseCursor wanted = ImGui::GetMouseCursor();
    if (wanted == page.cursor || wanted < 0) return;
    page.cursor = wanted;
    constexpr std::array kNames{"default",     "text",        "move",    "ns-resize",  "ew-resize",
                                "nesw-resize", "nwse-resize", "pointer", "not-allowed"};
    const auto which = static_cast<std::size_t>(wanted);
    page_show_cursor(kNames[std::min(which, kNames.size() - 1)]);
}

void heed(Page& page, const FrameRequest& request, double now_s) {
    page.events.fonts_outdated |= request.rebuild_fonts;
    if (!request.title.empty() && request.title != page.title) {
        page.title = request.title;
        emscripten_set_window_title(shown_text(page.title).c_str());
    }
    if (request.reading != page.reading) {
        page.reading = request.reading;
        page_read_out(shown_text(page.reading).c_str());
    }
    const ImGuiIO& io = ImGui::GetIO();
    const bool continues =
        request.animate || page.events.fonts_outdated || is_anything_held(page.events.input, io);
    page.frames_due = std::max(page.frames_due - 1, continues ? 1 : 0);
    const double wait_s = io.WantTextInput ? kCursorBlinkS : request.wake_after_s;
    page.next_wake_s = now_s + std::min(std::max(wait_s, 0.0), request.wake_after_s);
}

FrameContext context_of(const Page& page, double time_s) {
    FrameContext context;
    context.time_s = time_s;
    context.content_scale = page.scale;
    context.pressed = page.events.input.pressed;
    context.width = static_cast<int>(static_cast<float>(page.width) / page.scale);
    context.height = static_cast<int>(static_cast<float>(page.height) / page.scale);
    context.focused = page.events.focused;
    return context;
}

void draw_frame(Page& page) {
    if (page.events.fonts_outdated) rebuild_fonts(page);
    const double now_s = page_time_s();
    ImGuiIO& io = ImGui::GetIO();
    io.DisplaySize = {static_cast<float>(page.width), static_cast<float>(page.height)};
    if (pending(page.events.input)) {
        page.frames_due = kSettlingFrames;
        page.last_input_s = now_s;
    }
    apply(page.events.input, io, now_s);
    ImGui_ImplOpenGL3_NewFrame();
    ImGui::NewFrame();
    FrameRequest request;
    if (page.events.client.frame) request = page.events.client.frame(context_of(page, now_s));
    ImGui::Render();
    show_cursor(page);
    paint(page.kept, *ImGui::GetDrawData(), page.width, page.height, request.background);
    heed(page, request, now_s);
    page.shows_last_turn = true;
    if (page.events.client.after_frame) page.events.client.after_frame();
}

// A frame and a turn alternate, so that each frame is seen that says what is being computed.
bool gave_turn(Page& page) {
    const bool is_at_rest = !is_anything_held(page.events.input, ImGui::GetIO()) &&
                            !pending(page.events.input) &&
                            page_time_s() - page.last_input_s >= kRestS;
    if (!page.shows_last_turn || !give_turn(is_at_rest)) return false;
    page.shows_last_turn = false;
    page.frames_due = kSettlingFrames;
    return true;
}

void draw_if_due(void* user) {
    Page& page = *static_cast<Page*>(user);
    fit_canvas(page);
    if (page.width <= 0 || page.height <= 0 || gave_turn(page)) return;
    const bool is_time = page_time_s() >= page.next_wake_s;
    if (was_woken.exchange(false)) page.frames_due = kSettlingFrames;
    if (is_time || page.frames_due > 0 || pending(page.events.input)) draw_frame(page);
}

bool is_context_made() {
    EmscriptenWebGLContextAttributes attributes;
    emscripten_webgl_init_context_attributes(&attributes);
    attributes.majorVersion = 2;
    attributes.alpha = EM_FALSE;
    attributes.depth = EM_FALSE;
    attributes.antialias = EM_FALSE;  // the kept picture is copied unchanged
    const EMSCRIPTEN_WEBGL_CONTEXT_HANDLE made =
        emscripten_webgl_create_context("#canvas", &attributes);
    return made > 0 && emscripten_webgl_make_context_current(made) == EMSCRIPTEN_RESULT_SUCCESS;
}

}  // namespace

bool has_second_screen() { return false; }

bool is_for_fingers() { return page_is_for_fingers() != 0; }

std::function<void()> file_picker() { return page_pick_files; }

bool display_available() { return page_is_there() != 0; }

Expected<Done> run_window(const WindowOptions&, const WindowClient& client) {
    if (!display_available()) return Error{"no display: node has no page to draw on"};
    if (!is_context_made()) {
        return Error{"no window: the browser must offer WebGL 2"};
    }
    static Page page;  // as long as the browser calls for frames
    page.events.client = client;
    connect_imgui(page);
    listen_to_page(page.events);
    emscripten_set_main_loop_arg(draw_if_due, &page, 0, EM_FALSE);
    return Done{};
}

void wake_window() { was_woken = true; }

}  // namespace tact
