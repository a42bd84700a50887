#include "app/ui/file_question.h"

namespace tact {

void ask_for_file(Ui& ui, const FileQuestion& question, const std::filesystem::path& folder,
                  const std::string& name) {
    ui.chooser_purpose = question.purpose;
    ui.chooser.use = question.use;
    ui.chooser.title = question.title;
    ui.chooser.extensions = question.extensions;
    ui.chooser.folders_too = question.folders_too;
    ui.chooser.file_names = question.file_names;
    show(ui.chooser, folder, name);
}

}  // namespace tact
