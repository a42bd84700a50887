#include "app/screen/screen.h"

#include <epoxy/gl.h>
// After OpenGL's own header.
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <backends/imgui_impl_opengl3.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <mutex>
#include <string_view>

#include "app/screen/parts.h"
#include "model/text/shown_text.h"
#include "viz/drawing/imgui_versions.h"
#include "viz/picture/program_icon.h"

namespace tact {
namespace {

// ImGui lays some things out a frame late (popups, sizes that follow their content).
constexpr int kSettlingFrames = 3;
constexpr double kCursorBlinkS = 0.2;
// Where swapping buffers does not wait for the screen, animations must not spin.
constexpr double kShortestFrameS = 1.0 / 125.0;

// GLFW is one per process, and so is this: whether it may be called from another thread.
std::mutex glfw_mutex;
bool glfw_is_ready = false;
// Since the last frame, by wake_window(): its event may be taken while frames are drawn anyway.
std::atomic<bool> was_woken = false;

std::string glfw_reason() {
    const char* text = nullptr;
    glfwGetError(&text);
    return text == nullptr ? "unknown reason" : text;
}

// Whether Wayland may be asked for a display. Without a folder for its sockets its library writes
// to the terminal what GLFW then says once more.
bool has_wayland_folder() {
    const auto is_path = [](const char* variable) {
        const char* value = std::getenv(variable);  // NOLINT(concurrency-mt-unsafe)
        return value != nullptr && std::string_view(value).starts_with('/');
    };
    return is_path("XDG_RUNTIME_DIR") || is_path("WAYLAND_DISPLAY");
}

// GLFW 3.4 and later: a program that was built with 3.3 may meet it on a newer system.
bool knows_platforms() {
    int major = 0;
    int minor = 0;
    glfwGetVersion(&major, &minor, nullptr);
    return major > 3 || (major == 3 && minor >= 4);
}

bool start_glfw() {
    constexpr int kPlatform = 0x00050003;  // GLFW_PLATFORM and GLFW_PLATFORM_X11 of its header
    constexpr int kPlatformX11 = 0x00060004;
    if (knows_platforms() && !has_wayland_folder()) glfwInitHint(kPlatform, kPlatformX11);
    return glfwInit() == GLFW_TRUE;
}

// GLFW from here to the end of the scope.
struct Glfw {
    bool is_ready = start_glfw();

    Glfw() {
        const std::lock_guard lock(glfw_mutex);
        glfw_is_ready = is_ready;
    }
    ~Glfw() {
        const std::lock_guard lock(glfw_mutex);
        glfw_is_ready = false;
        glfwTerminate();
    }
    Glfw(const Glfw&) = delete;
    Glfw& operator=(const Glfw&) = delete;
};

struct Window {
    GLFWwindow* glfw = nullptr;
    WindowEvents events;
    std::array<GLFWcursor*, ImGuiMouseCursor_COUNT> cursors{};
    ImGuiMouseCursor cursor = ImGuiMouseCursor_Arrow;
    std::string title;
    FullScreen full_screen;
    int frames_due = kSettlingFrames;
    double next_wake_s = 0.0;
    KeptFrame kept;
    SideWindow side;
    bool side_closed = false;
};

float content_scale(GLFWwindow* glfw) {
    float x = 1.0F;
    float y = 1.0F;
    glfwGetWindowContentScale(glfw, &x, &y);
    return std::max(x, y);
}

void make_cursors(Window& window) {
    const auto set = [&](ImGuiMouseCursor which, int shape) {
        window.cursors[static_cast<std::size_t>(which)] = glfwCreateStandardCursor(shape);
    };
    set(ImGuiMouseCursor_Arrow, GLFW_ARROW_CURSOR);
    set(ImGuiMouseCursor_TextInput, GLFW_IBEAM_CURSOR);
    set(ImGuiMouseCursor_ResizeNS, GLFW_VRESIZE_CURSOR);
    set(ImGuiMouseCursor_ResizeEW, GLFW_HRESIZE_CURSOR);
    set(ImGuiMouseCursor_Hand, GLFW_HAND_CURSOR);
}

// In the sizes that window managers ask for; they choose.
void show_icon(GLFWwindow* glfw) {
    std::array images{program_icon(16), program_icon(32), program_icon(48), program_icon(128)};
    std::array<GLFWimage, images.size()> icons{};
    for (std::size_t k = 0; k < images.size(); ++k) {
        icons[k] = {images[k].width, images[k].height, images[k].rgba.data()};
    }
    glfwSetWindowIcon(glfw, static_cast<int>(icons.size()), icons.data());
}

void show_cursor(Window& window) {
    const ImGuiMouseCursor wanted = ImGui::GetMouseCursor();
    if (wanted == window.cursor || wanted < 0) return;
    window.cursor = wanted;
    glfwSetCursor(window.glfw, window.cursors[static_cast<std::size_t>(wanted)]);
}

void connect_imgui(Window& window) {
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;  // what lasts is in the session
    io.ConfigFlags |= ImGuiConfigFlags_NavEnableKeyboard;
    io.BackendFlags |= ImGuiBackendFlags_HasMouseCursors;
    io.BackendPlatformName = "tactspace";
    io.ClipboardUserData = window.glfw;
    io.SetClipboardTextFn = [](void* glfw, const char* text) {
        glfwSetClipboardString(static_cast<GLFWwindow*>(glfw), text);
    };
    io.GetClipboardTextFn = [](void* glfw) {
        return glfwGetClipboardString(static_cast<GLFWwindow*>(glfw));
    };
    name_keys(io);
    ImGui_ImplOpenGL3_Init("#version 130");
}

void rebuild_fonts(Window& window) {
    ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
    ImGui_ImplOpenGL3_DestroyFontsTexture();
    atlas.Clear();
    const WindowClient& client = *window.events.client;
    if (client.build_fonts) client.build_fonts(content_scale(window.glfw));
    if (atlas.Fonts.empty()) atlas.AddFontDefault();
    ImGui_ImplOpenGL3_CreateFontsTexture();
    forget(window.kept);
    window.events.fonts_outdated = false;
}

FrameContext context_of(const Window& window, double time_s) {
    FrameContext context;
    context.time_s = time_s;
    context.content_scale = content_scale(window.glfw);
    context.pressed = window.events.input.pressed;
    const WindowSize size = window_size(window.glfw);
    context.width = size.width;
    context.height = size.height;
    context.maximised = window.events.maximised;
    const auto has_focus = [](GLFWwindow* glfw) {
        return glfw != nullptr && glfwGetWindowAttrib(glfw, GLFW_FOCUSED) == GLFW_TRUE;
    };
    context.focused = has_focus(window.glfw) || has_focus(window.side.glfw);
    context.side_closed = window.side_closed;
    return context;
}

void put_on_screen(Window& window, WindowSize pixels, ImU32 background) {
    paint(window.kept, *ImGui::GetDrawData(), pixels.width, pixels.height, background);
    glfwSwapBuffers(window.glfw);
}

void heed(Window& window, const FrameRequest& request, double now_s) {
    window.events.fonts_outdated |= request.rebuild_fonts;
    if (request.close) glfwSetWindowShouldClose(window.glfw, GLFW_TRUE);
    set_full_screen(*window.glfw, window.full_screen, request.full_screen);
    if (!request.title.empty() && request.title != window.title) {
        window.title = request.title;
        glfwSetWindowTitle(window.glfw, shown_text(window.title).c_str());
    }
    const ImGuiIO& io = ImGui::GetIO();
    const bool goes_on = request.animate || window.events.fonts_outdated ||
                         is_anything_held(window.events.input, io);
    window.frames_due = std::max(window.frames_due - 1, goes_on ? 1 : 0);
    const double wait_s = io.WantTextInput ? kCursorBlinkS : request.wake_after_s;
    window.next_wake_s = now_s + std::min(std::max(wait_s, 0.0), request.wake_after_s);
}

void draw_frame(Window& window, WindowSize pixels) {
    if (window.events.fonts_outdated) rebuild_fonts(window);
    const double now_s = glfwGetTime();
    ImGuiIO& io = ImGui::GetIO();
    io.DisplaySize = {static_cast<float>(pixels.width), static_cast<float>(pixels.height)};
    if (pending(window.events.input)) window.frames_due = kSettlingFrames;
    apply(window.events.input, io, now_s);
    ImGui_ImplOpenGL3_NewFrame();
    ImGui::NewFrame();
    FrameRequest request;
    const WindowClient& client = *window.events.client;
    if (client.frame) request = client.frame(context_of(window, now_s));
    ImGui::Render();
    show_cursor(window);
    put_on_screen(window, pixels, request.background);
    heed(window, request, now_s);
    window.side_closed = show_side(window.side, *window.glfw, window.events, request.side);
    if (window.side_closed) window.frames_due = kSettlingFrames;
    if (client.after_frame) client.after_frame();
}

// Lets GLFW deliver events: at once while frames are due, otherwise waiting until something
// happens.
void deliver_events(Window& window, double frame_start_s) {
    if (pending(window.events.input)) return glfwPollEvents();
    const double now_s = glfwGetTime();
    if (window.frames_due > 0) {
        const double rest_s = frame_start_s + kShortestFrameS - now_s;
        return rest_s > 0.0 ? glfwWaitEventsTimeout(rest_s) : glfwPollEvents();
    }
    const double sleep_s = window.next_wake_s - now_s;
    if (std::isinf(sleep_s)) {
        glfwWaitEvents();
    } else if (sleep_s > 0.0) {
        glfwWaitEventsTimeout(sleep_s);
    }
    window.frames_due = glfwGetTime() < window.next_wake_s ? kSettlingFrames : 1;
}

// What somebody woke the window for is laid out in as many frames as what a person did.
void wait_for_events(Window& window, double frame_start_s) {
    deliver_events(window, frame_start_s);
    if (was_woken.exchange(false)) window.frames_due = kSettlingFrames;
}

void run_loop(Window& window) {
    while (glfwWindowShouldClose(window.glfw) == GLFW_FALSE) {
        const double start_s = glfwGetTime();
        const WindowSize pixels = framebuffer_size(window.glfw);
        if (pixels.width <= 0 || pixels.height <= 0) {
            glfwWaitEvents();  // minimised
            continue;
        }
        draw_frame(window, pixels);
        wait_for_events(window, start_s);
    }
}

WindowSize fitted(const WindowOptions& options) {
    WindowSize size{options.width, options.height};
    int x = 0;
    int y = 0;
    WindowSize area;
    if (GLFWmonitor* monitor = glfwGetPrimaryMonitor(); monitor != nullptr) {
        glfwGetMonitorWorkarea(monitor, &x, &y, &area.width, &area.height);
    }
    if (area.width > 0) size.width = std::min(size.width, area.width);
    if (area.height > 0) size.height = std::min(size.height, area.height);
    return {std::max(size.width, 1), std::max(size.height, 1)};
}

GLFWwindow* create_glfw_window(const WindowOptions& options) {
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 0);
    glfwWindowHint(GLFW_VISIBLE, options.visible ? GLFW_TRUE : GLFW_FALSE);
    glfwWindowHint(GLFW_MAXIMIZED, options.maximised ? GLFW_TRUE : GLFW_FALSE);
    glfwWindowHintString(GLFW_X11_CLASS_NAME, "tactspace");
    const WindowSize size = fitted(options);
    return glfwCreateWindow(size.width, size.height, options.title.c_str(), nullptr, nullptr);
}

}  // namespace

bool display_available() {
    {
        const std::lock_guard lock(glfw_mutex);
        if (glfw_is_ready) return true;
    }
    return Glfw{}.is_ready;
}

Expected<Done> run_window(const WindowOptions& options, const WindowClient& client) {
    const Glfw glfw;
    if (!glfw.is_ready) {
        return Error{"no display: " + glfw_reason() +
                     ". Start tactspace in a graphical session, or see tactspace --help for what "
                     "works without one."};
    }
    Window window;
    window.glfw = create_glfw_window(options);
    if (window.glfw == nullptr) {
        return Error{"no window: " + glfw_reason() + ". The display must offer OpenGL 3.0."};
    }
    window.events.client = &client;
    window.title = options.title;
    window.events.maximised = options.maximised;
    glfwMakeContextCurrent(window.glfw);
    // Wayland asks a window that is covered for no frame: to wait for it would be to hang.
    glfwSwapInterval(wayland_display() == nullptr ? 1 : 0);
    listen(*window.glfw, window.events);
    make_cursors(window);
    show_icon(window.glfw);
    const EscapeWatch escape_watch(window.glfw, client.escape);
    end_with_display(client.display_gone);

    ImGuiContext* context = ImGui::CreateContext();
    connect_imgui(window);
    run_loop(window);
    end_with_display(nullptr);
    close_side(window.side, *window.glfw);
    destroy(window.kept);
    ImGui_ImplOpenGL3_Shutdown();
    ImGui::DestroyContext(context);
    glfwDestroyWindow(window.glfw);
    if (client.end) client.end();
    return Done{};
}

void wake_window() {
    const std::lock_guard lock(glfw_mutex);
    was_woken = true;
    if (glfw_is_ready) glfwPostEmptyEvent();
}

}  // namespace tact
