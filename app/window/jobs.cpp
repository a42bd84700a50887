#include "app/window/jobs.h"

#include "app/ask/maybes_follow.h"
#include "app/compare/compare_follow.h"
#include "app/lesson/lesson.h"
#include "app/manual/open_manual.h"
#include "app/map/map_follow.h"
#include "app/measured/import_follow.h"
#include "app/model_bench/training_follow.h"
#include "app/physiology/physiology_follow.h"
#include "app/study/study_follow.h"
#include "app/subset/subset_follow.h"

namespace tact {

void make_jobs(App& app) {
    make_render_job(app.work.cache, app.ui.wake);
    make_map_jobs(app.ui, app.work, app.shown_map);
    make_stages_jobs(app.ui, app.physiology);
    make_compare_jobs(app.ui, app.rendered, app.comparing);
    make_subset_jobs(app.ui, app.picking);
    make_maybes_jobs(app.ui, app.maybes);
    make_effect_job(app.ui, app.exports.effects);
    make_training_job(app.ui, app.model_bench);
    make_lesson_job(app.ui, app.lesson);
}

void stop_jobs(App& app) {
    stop_study(app.studying);
    app.work.cache.render_job.reset();
    app.generating.job.reset();
    app.manual.job.reset();
    app.pattern_panes.recording.job.reset();
    stop_import(app.importing);
    stop_subset_jobs(app.picking);
    stop_training(app.model_bench);
    stop_maybes_jobs(app.maybes);
    app.steps.job.reset();
    app.exports.effects.job.reset();
    app.comparing.findings_job.reset();
    app.rendered.job.reset();
    app.comparing.fit_job.reset();
    app.comparing.difference_job.reset();
    app.comparing.comparison_job.reset();
    app.shown_map.full_job.reset();
    app.shown_map.preview_job.reset();
    app.shown_map.unshifted_job.reset();
    app.physiology.stages_job.reset();
    app.physiology.pinned_job.reset();
    app.lesson.job.reset();
}

void take_answers(App& app) {
    take_maps(app.ui, app.shown_map);
    take_stages(app.physiology);
    follow_lesson(app.lesson);
    take_manual(app.ui, app.manual);
    take_compare_answers(app.rendered, app.comparing);
}

}  // namespace tact
