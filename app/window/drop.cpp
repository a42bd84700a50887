#include "app/window/drop.h"

#include <algorithm>

#include "app/document/editing.h"
#include "app/document/files.h"
#include "app/document/rating_files.h"
#include "app/measured/import_follow.h"
#include "app/study/study_follow.h"
#include "model/io/people/ratings_file.h"
#include "model/io/recordings/recording.h"
#include "model/text/atomic_file.h"

namespace tact {

namespace {

// A question or a participant comes first: what is dropped would change the set beneath them.
bool is_in_the_middle(const App& app) {
    const bool is_popup_open =
        ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel);
    return is_study_running(app) || app.dialog != Dialog::none || app.chooser.is_open ||
           app.palette.open || app.question || is_popup_open;
}

}  // namespace

void drop_paths(App& app, const std::vector<std::filesystem::path>& paths) {
    if (is_in_the_middle(app)) {
        return complain(app, "Nothing was opened: finish what is on the screen, then drop again.");
    }
    const bool tables = !paths.empty() && std::ranges::all_of(paths, [](const auto& path) {
        return extension_of(path) == ".csv";
    });
    if (tables && !read_ratings(paths, RatingScale::guess) && are_accelerations(paths)) {
        return import_recordings(app, paths);
    }
    if (tables) return load_ratings(app, paths);
    open_paths(app, paths);
}

}  // namespace tact
