#include "model/system/pauses.h"

#include <chrono>
#include <cstddef>
#include <utility>

// In app/page/page.js.
extern "C" {
int page_can_pause();
void page_call_with_pauses(void (*work)(), void* end_of_stack);
void page_pause();
}

namespace tact {

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds kPiece{50};
constexpr std::size_t kStackBytes = 2 << 20;  // what a thread has (app/CMakeLists.txt)

std::function<void()> called;  // the work, while it has not ended
bool is_running = false;       // and does not pause
Clock::time_point piece_ends;

void begin_piece() {
    is_running = true;
    piece_ends = Clock::now() + kPiece;
}

void run_to_its_end() {
    begin_piece();
    called();
    is_running = false;
    called = nullptr;
}

}  // namespace

void call_with_pauses(std::function<void()> work) {
    if (page_can_pause() == 0) return work();
    alignas(16) static char stack[kStackBytes];  // it grows from its end
    called = std::move(work);
    page_call_with_pauses(run_to_its_end, stack + kStackBytes);
}

void pause_if_due() {
    if (!is_running || Clock::now() < piece_ends) return;
    is_running = false;
    page_pause();
    begin_piece();
}

bool is_pausable() { return is_running; }

}  // namespace tact
