#include "app/ui/file_question.h"

namespace tact {

void ask_for_file(App& app, const FileQuestion& question, const std::filesystem::path& folder,
                  const std::string& name) {
    app.chooser_purpose = question.purpose;
    app.chooser.use = question.use;
    app.chooser.title = question.title;
    app.chooser.extensions = question.extensions;
    app.chooser.folders_too = question.folders_too;
    app.chooser.file_names = question.file_names;
    show(app.chooser, folder, name);
}

}  // namespace tact
