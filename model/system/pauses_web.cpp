#include "model/system/pauses.h"

#include <array>
#include <chrono>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

// In app/page/page.js.
extern "C" {
int page_can_pause();
void page_call_with_pauses(void (*run)(void* call), void* call, void* end_of_stack);
void page_pause();
}

namespace tact {

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds kPiece{50};
constexpr std::size_t kStackBytes = 2 << 20;  // what a thread has (app/CMakeLists.txt)

// A stack of its own for each, as the page uses its own while the work pauses. It grows from its
// end.
struct Call {
    std::function<void()> work;
    alignas(16) std::array<std::byte, kStackBytes> stack;
};

std::vector<std::unique_ptr<Call>> ended;  // for others: none is freed while it runs on its stack
int calls = 0;                             // that have not ended
bool is_running = false;                   // one of them, which does not pause
Clock::time_point piece_ends;

// Their pieces together are as long as one.
void begin_piece() {
    is_running = true;
    piece_ends = Clock::now() + kPiece / calls;
}

void run(void* given) {
    std::unique_ptr<Call> call(static_cast<Call*>(given));
    begin_piece();
    std::exchange(call->work, nullptr)();
    is_running = false;
    --calls;
    ended.push_back(std::move(call));
}

}  // namespace

void call_with_pauses(std::function<void()> work) {
    if (page_can_pause() == 0) return work();
    if (ended.empty()) ended.push_back(std::make_unique<Call>());
    Call* const call = ended.back().release();
    ended.pop_back();
    call->work = std::move(work);
    ++calls;
    page_call_with_pauses(run, call, call->stack.data() + kStackBytes);
}

void pause_if_due() {
    if (!is_running || Clock::now() < piece_ends) return;
    is_running = false;
    page_pause();
    begin_piece();
}

bool is_pausable() { return is_running; }

}  // namespace tact
