// Turns at the only thread there is: work in the background where a page has no threads of its own.
//
// A job asks for a turn; the window gives one between two frames, and its picture stands still
// until the work has ended. So a preview comes while a slider moves, and work that a newer request
// would stop comes once the person rests.
//
// Input     jobs that ask; the window, which gives turns
// Output    their work, one at a time, in the order in which they asked
// Left out  several threads; a stop of work that has begun, unless it gives its turn back early
#pragma once

#include <functional>

namespace tact {

// Where the system has no threads (model/system/process.h).
bool work_takes_turns();

// For tests, until the next call: whether threads are left alone though the system has them.
void pretend_no_threads(bool pretend);

enum class TurnKind {
    soon,    // between the next two frames
    at_rest  // once nothing is held, moved or typed
};

class TurnTaker {
  public:
    TurnTaker(TurnKind kind, std::function<void()> work);
    ~TurnTaker();  // asks no more
    TurnTaker(const TurnTaker&) = delete;
    TurnTaker& operator=(const TurnTaker&) = delete;

    // One turn is given for any number of calls before it. Also from its own work.
    void ask();

  private:
    friend bool give_turn(bool at_rest);

    TurnKind kind_;
    std::function<void()> work_;
};

// Does the work of the one who asked first; false: nobody did whose turn it is.
bool give_turn(bool at_rest);

// For work that can continue where it was: its turn has been as long as a picture may wait. Never
// where there are threads.
bool is_turn_over();

// Said by work that has kept what it has by now and gives no answer yet.
void want_another_turn();

// Whether it was said since the last call.
bool take_wish_for_turn();

}  // namespace tact
