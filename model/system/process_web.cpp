// A page is a process by itself, and its threads are the browser's to weigh.
#include "model/system/process.h"

#include <emscripten/threading.h>

namespace tact {

std::int64_t own_process() { return 1; }

bool is_running(std::int64_t) { return true; }

bool has_threads() { return emscripten_has_threading_support() != 0; }

int bound_processors(int machine) { return has_threads() ? machine : 1; }

void give_way() {}

bool threads_weigh_alike() { return true; }

}  // namespace tact
