#include "app/window/jobs.h"

#include "app/compare/bench_follow.h"
#include "app/map/map_follow.h"
#include "app/measured/import_follow.h"
#include "app/model_bench/training_follow.h"
#include "app/physiology/physiology_follow.h"
#include "app/study/study_follow.h"
#include "app/subset/subset_follow.h"

namespace tact {

void make_jobs(App& app) {
    make_map_jobs(app);
    make_stages_jobs(app);
    make_bench_jobs(app);
    make_subset_jobs(app);
    make_training_job(app);
}

void stop_jobs(App& app) {
    stop_study(app);
    app.generate.job.reset();
    stop_import(app);
    stop_subset_jobs(app);
    stop_training(app);
    app.findings_job.reset();
    app.rendering.job.reset();
    app.difference_job.reset();
    app.comparison_job.reset();
    app.full_job.reset();
    app.preview_job.reset();
    app.stages_job.reset();
    app.pinned_job.reset();
}

void take_answers(App& app) {
    take_maps(app);
    take_stages(app);
    take_bench_answers(app);
}

}  // namespace tact
