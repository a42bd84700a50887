#include "app/document/rating_files.h"

#include "app/document/editing.h"
#include "app/ui/file_question.h"
#include "model/io/people/ratings_file.h"
#include "model/set/measured_twin.h"
#include "model/set/set_ratings.h"

namespace tact {

void load_ratings_dialog(App& app) {
    ask_for_file(app,
                 {.purpose = ChooserPurpose::load_ratings,
                  .use = ChooserUse::open,
                  .title = "Load ratings: a table, or a folder with one for each participant",
                  .extensions = {".csv", ".txt"},
                  .folders_too = true},
                 app.document.path.parent_path());
}

void load_ratings(App& app, const std::vector<std::filesystem::path>& paths) {
    if (paths.empty()) return;
    const Expected<LoadedRatings> loaded = read_ratings(paths, RatingScale::guess);
    if (!loaded) return complain(app, loaded.error().message);
    const std::string file = paths.front().filename().string();
    Expected<RatingStudy> study = matched(loaded->study, names_of(app.document.set));
    // People rate the intended patterns, not what measures them.
    if (!study || !unrated_patterns(*study).empty()) {
        const PatternSet intended = one_side(app.document.set, Side::intended);
        auto of_intended = matched(loaded->study, names_of(intended));
        if (of_intended) study = std::move(of_intended);
    }
    if (!study) return complain(app, file + ": " + study.error().message);
    app.document.set.ratings = kept_ratings(*study, file);
    document_changed(app);
    commit_step(app, "Load ratings");
    app.bench = BenchTab::compare;
    std::string text = "Ratings loaded from " + file;
    for (const std::string& remark : loaded->remarks) text += "; " + remark;
    say(app, text + ".");
}

}  // namespace tact
