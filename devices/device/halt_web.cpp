// A page is halted when nobody sees it any more: hidden behind another one, or left.
#include <atomic>

#include "devices/device/halt.h"

namespace tact {

namespace {

std::atomic<std::uint64_t> counted = 0;
std::atomic<void (*)()> say_last = nullptr;

}  // namespace

const char* const kHalted = " was put to rest when the page was hidden: play again";

void rest_before_halts() {}

// On the page's own thread, which may not wait. Those that play see the count, and put to rest what
// they drive, as long as the page is there.
void rest_all() {
    counted.fetch_add(1);
    if (const auto say = say_last.load()) say();
}

void call_before_halts(void (*before_halt)()) { say_last = before_halt; }

std::uint64_t halts() { return counted.load(); }

}  // namespace tact
