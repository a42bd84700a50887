// A page is a process by itself, and its threads are the browser's to weigh.
#include "model/system/process.h"

namespace tact {

std::int64_t own_process() { return 1; }

bool is_running(std::int64_t) { return true; }

int bound_processors(int machine) { return machine; }

void give_way() {}

}  // namespace tact
