#include "app/document/rating_files.h"

#include "app/document/editing.h"
#include "app/ui/file_question.h"
#include "model/io/people/ratings_file.h"
#include "model/set/felt_versions.h"
#include "model/set/measured_twin.h"
#include "model/set/set_ratings.h"

namespace tact {

void load_ratings_dialog(Ui& ui, const Workspace& work) {
    ask_for_file(ui,
                 {.purpose = ChooserPurpose::load_ratings,
                  .use = ChooserUse::open,
                  .title = "Load ratings: a table, or a folder with one for each participant",
                  .extensions = {".csv", ".txt"},
                  .folders_too = true},
                 work.document.path.parent_path());
}

Expected<RatingStudy> study_for(const PatternSet& set, const LoadedRatings& loaded) {
    Expected<RatingStudy> study = matched(loaded.study, names_of(set));
    if (study && unrated_patterns(*study).empty() && study->gone.empty()) return study;
    // People rate the intended patterns, not what measures them.
    auto of_intended = matched(loaded.study, names_of(one_side(set, Side::intended)));
    return of_intended ? of_intended : study;
}

void take_ratings(Ui& ui, Workspace& work, Layout& layout, const std::filesystem::path& path,
                  const LoadedRatings& loaded) {
    const std::string file = path.filename().string();
    const Expected<RatingStudy> study = study_for(work.document.set, loaded);
    if (!study) return complain(ui, file + ": " + study.error().message);
    auto ratings = kept_ratings(*study, file);
    note_versions(ratings, *study, work.document.set);
    work.document.edit().ratings = std::move(ratings);
    document_changed(work);
    commit_step(ui, work, "Load ratings");
    layout.bench = BenchTab::compare;
    std::string text = "Ratings loaded from " + file;
    for (const std::string& remark : loaded.remarks) text += "; " + remark;
    const std::string unrated = remark_on_unrated(unrated_patterns(*study), study->labels.size());
    if (!unrated.empty()) text += "; " + unrated;
    if (!study->gone.empty()) text += "; " + words_on_gone(study->gone);
    say(ui, text + ".");
}

}  // namespace tact
