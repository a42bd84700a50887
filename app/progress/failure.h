// Why a job that a pane waits for has no answer: said in place of the waiting.
#pragma once

#include <memory>
#include <string>

#include "app/ui/ui.h"

namespace tact {

// Of work in the background (app/jobs/latest_job.h); empty while it is under way, and where it came
// to its end. A null job has none.
template <class Job>
std::string failure_of(const std::unique_ptr<Job>& job) {
    return job && !job->busy() ? job->failure() : std::string();
}

// The sentence at the cursor; false: there is none to say. `pane` is its name for tests.
bool draw_failure(Ui& ui, const char* pane, const std::string& failure);

}  // namespace tact
