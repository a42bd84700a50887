#include "app/window/drop.h"

#include <algorithm>

#include "app/document/files.h"
#include "app/document/rating_files.h"
#include "app/measured/import_follow.h"
#include "model/io/people/ratings_file.h"
#include "model/io/recordings/recording.h"
#include "model/text/atomic_file.h"

namespace tact {

void drop_paths(App& app, const std::vector<std::filesystem::path>& paths) {
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
