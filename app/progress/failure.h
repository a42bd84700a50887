// Why a job that a pane waits for has no answer: said in place of the waiting.
#pragma once

#include <memory>
#include <string>

#include "app/ui/ui.h"

namespace tact {

// Why work in the background (app/jobs/latest_job.h) failed; empty while it runs and when it
// succeeded. A null job has no failure.
template <class Job>
std::string failure_of(const std::unique_ptr<Job>& job) {
    return job && !job->busy() ? job->failure() : std::string();
}

// The sentence at the cursor; false: nothing to say. `pane` is its name for tests.
bool draw_failure(Ui& ui, const char* pane, const std::string& failure);

}  // namespace tact
