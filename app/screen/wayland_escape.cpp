#include "app/screen/parts.h"

#include <linux/input-event-codes.h>
#include <poll.h>
#include <unistd.h>
#include <wayland-client.h>

#include <array>
#include <cstdint>
#include <string_view>

namespace tact {

namespace {

// Since this version a keyboard can be given back, and seats of all desktops have it.
constexpr std::uint32_t kSeatVersion = 3;

struct Keyboards {
    const std::function<void()>* pressed = nullptr;
    wl_seat* seat = nullptr;
    std::uint32_t seat_name = 0;
    wl_keyboard* keyboard = nullptr;
};

Keyboards& in(void* data) { return *static_cast<Keyboards*>(data); }

void give_back_keyboard(Keyboards& of) {
    if (of.keyboard != nullptr) wl_keyboard_release(of.keyboard);
    of.keyboard = nullptr;
}

void give_back_seat(Keyboards& of) {
    give_back_keyboard(of);
    if (of.seat != nullptr) wl_seat_destroy(of.seat);
    of.seat = nullptr;
}

void heed_key(void* data, wl_keyboard* /*keyboard*/, std::uint32_t /*serial*/,
              std::uint32_t /*time*/, std::uint32_t key, std::uint32_t state) {
    if (key == KEY_ESC && state == WL_KEYBOARD_KEY_STATE_PRESSED) (*in(data).pressed)();
}

constexpr wl_keyboard_listener kKeyboardListener{
    .keymap = [](void*, wl_keyboard*, std::uint32_t, std::int32_t file,
                 std::uint32_t) { ::close(file); },
    .enter = [](void*, wl_keyboard*, std::uint32_t, wl_surface*, wl_array*) {},
    .leave = [](void*, wl_keyboard*, std::uint32_t, wl_surface*) {},
    .key = heed_key,
    .modifiers = [](void*, wl_keyboard*, std::uint32_t, std::uint32_t, std::uint32_t, std::uint32_t,
                    std::uint32_t) {},
    .repeat_info = [](void*, wl_keyboard*, std::int32_t, std::int32_t) {},
};

// A keyboard may be plugged in and out.
void heed_capabilities(void* data, wl_seat* seat, std::uint32_t capabilities) {
    Keyboards& of = in(data);
    const bool has_keyboard = (capabilities & WL_SEAT_CAPABILITY_KEYBOARD) != 0;
    if (!has_keyboard) give_back_keyboard(of);
    if (!has_keyboard || of.keyboard != nullptr) return;
    of.keyboard = wl_seat_get_keyboard(seat);
    wl_keyboard_add_listener(of.keyboard, &kKeyboardListener, data);
}

constexpr wl_seat_listener kSeatListener{
    .capabilities = heed_capabilities,
    .name = [](void*, wl_seat*, const char*) {},
};

// The first seat, which GLFW takes as well.
void heed_global(void* data, wl_registry* registry, std::uint32_t name, const char* interface,
                 std::uint32_t version) {
    Keyboards& of = in(data);
    if (of.seat != nullptr || version < kSeatVersion ||
        std::string_view(interface) != wl_seat_interface.name) {
        return;
    }
    of.seat =
        static_cast<wl_seat*>(wl_registry_bind(registry, name, &wl_seat_interface, kSeatVersion));
    of.seat_name = name;
    wl_seat_add_listener(of.seat, &kSeatListener, data);
}

void heed_global_gone(void* data, wl_registry* /*registry*/, std::uint32_t name) {
    Keyboards& of = in(data);
    if (of.seat != nullptr && of.seat_name == name) give_back_seat(of);
}

constexpr wl_registry_listener kRegistryListener{
    .global = heed_global,
    .global_remove = heed_global_gone,
};

wl_registry* registry_on(wl_display* display, wl_event_queue* queue) {
    auto* const wrapper = static_cast<wl_display*>(wl_proxy_create_wrapper(display));
    if (wrapper == nullptr) return nullptr;
    wl_proxy_set_queue(reinterpret_cast<wl_proxy*>(wrapper), queue);
    wl_registry* const registry = wl_display_get_registry(wrapper);
    wl_proxy_wrapper_destroy(wrapper);
    return registry;
}

// Waits for the compositor or for the stop; false once there is nothing more to wait for. A thread
// that has announced that it will read must read or say that it will not: the others wait for that.
bool wait_for_events(wl_display* display, wl_event_queue* queue, int woken) {
    while (wl_display_prepare_read_queue(display, queue) != 0) {
        if (wl_display_dispatch_queue_pending(display, queue) < 0) return false;
    }
    wl_display_flush(display);
    std::array<pollfd, 2> sources{{{wl_display_get_fd(display), POLLIN, 0}, {woken, POLLIN, 0}}};
    const int count = poll(sources.data(), sources.size(), -1);
    if (count <= 0 || sources[0].revents == 0) {
        wl_display_cancel_read(display);
        return sources[1].revents == 0;
    }
    return wl_display_read_events(display) == 0 &&
           wl_display_dispatch_queue_pending(display, queue) >= 0;
}

}  // namespace

void watch_wayland_escape(const std::stop_token& stop, wl_display* display, int woken,
                          const std::function<void()>& pressed) {
    wl_event_queue* const queue = wl_display_create_queue(display);
    if (queue == nullptr) return;
    Keyboards keyboards{.pressed = &pressed};
    if (wl_registry* const registry = registry_on(display, queue); registry != nullptr) {
        wl_registry_add_listener(registry, &kRegistryListener, &keyboards);
        while (!stop.stop_requested() && wait_for_events(display, queue, woken)) {
        }
        give_back_seat(keyboards);
        wl_registry_destroy(registry);
    }
    wl_event_queue_destroy(queue);
}

}  // namespace tact
