// The dialog of a paper's files.

#include <optional>

#include "app/export/export.h"
#include "app/ui/ui.h"
#include "app/ui/widgets.h"
#include "model/pattern/pattern_parameter.h"
#include "model/set/parameter_paths.h"
#include "model/text/names.h"
#include "viz/drawing/marks.h"

namespace tact {

namespace {

constexpr float kPaperDialogPx = 720.0F;

// Names may be long, and have a line of their own.
void draw_set(const Ui& ui, const std::string& name, const std::string& words) {
    const float room = ImGui::GetContentRegionAvail().x;
    ImGui::TextUnformatted(shortened(ui.theme.fonts.regular, name, room).c_str());
    dim_text(ui, words);
}

// The open set, and those that were added, each with a link that takes it away again.
void draw_sets(Ui& ui, const Workspace& work, PaperState& paper) {
    const PatternSet& set = work.document.set;
    draw_label(ui, "Sets");
    ImGui::BeginGroup();
    const std::string open = set.name.empty() ? "The open set" : set.name;
    draw_set(ui, open,
             set.ratings.empty() ? "Has no ratings and is left out: File > Load ratings..."
                                 : words_on_ratings(set));
    note_item(ui.rects, "paper:open set", words_on_ratings(set));
    std::optional<std::size_t> gone;
    for (std::size_t k = 0; k < paper.more.size(); ++k) {
        const PaperSet& one = paper.more[k];
        draw_set(ui, one.name, one.words);
        ImGui::SameLine();
        const Item item{
            .id = "paper:set " + std::to_string(k + 1), .label = "Take away", .value = one.name};
        if (link(ui, item)) gone = k;
    }
    ImGui::EndGroup();
    if (gone) paper.more.erase(paper.more.begin() + static_cast<std::ptrdiff_t>(*gone));
}

// By name; the first joins along what joins most.
void draw_along(Ui& ui, const PatternSet& set, std::string& along) {
    draw_label(ui, "Join along");
    const auto most = most_joining(set.vibrations);
    const std::string usual =
        most ? std::string("what joins most: ") + traits(*most).name : "what joins most";
    std::string shown = usual;
    for (const PatternParameter one : kPatternParameters) {
        if (along == traits(one).key) shown = traits(one).name;
    }
    const Item chosen{.id = "paper:along",
                      .label = shown,
                      .tip = "In the maps, lines join patterns that differ in this number alone."};
    drop_down(ui, chosen, 320.0F * ui.theme.scale, [&] {
        if (ImGui::Selectable(usual.c_str(), along.empty())) along.clear();
        for (const PatternParameter one : kPatternParameters) {
            const ParameterTraits& about = traits(one);
            const Item item{.id = std::string("paper along:") + about.key, .label = about.name};
            if (option(ui, item, along == about.key)) along = about.key;
        }
    });
}

void choose_set(Ui& ui, const Workspace& work, PaperState& paper) {
    ask_for_file(
        ui,
        {.title = "Add a set that keeps ratings",
         .extensions = {".json"},
         .take = [&](const std::filesystem::path& file) { add_paper_set(ui, paper, file); }},
        work.document.path.parent_path());
}

void choose_folder(Ui& ui, const Workspace& work, const std::vector<ForeignMetric>& foreign,
                   PaperState& paper) {
    const std::string& name = work.document.set.name;
    ask_for_file(ui,
                 {.use = ChooserUse::save_folder,
                  .title = "Tables and figures into a new folder",
                  .extensions = {".html", ".csv", ".py", ".R"},
                  .folders_too = true,
                  .file_names = {"paper.html", "table2.csv", "pairs.csv", "maps.csv"},
                  .take =
                      [&](const std::filesystem::path& folder) {
                          std::vector<std::string> from;
                          for (const ForeignMetric& one : foreign) from.push_back(one.from);
                          write_paper(ui, work, paper, from, folder);
                      }},
                 work.document.path.parent_path(),
                 name.empty() ? "paper" : file_stem(name + " paper"));
}

}  // namespace

void draw_paper_dialog(Ui& ui, const Workspace& work, const std::vector<ForeignMetric>& foreign,
                       PaperState& paper) {
    if (!begin_dialog(ui, kPaperDialog, kPaperDialogPx)) return;
    wrapped_text(
        "Table 2 and Figures 4 to 10 of Lim & Park 2023, of these sets and their ratings: how well "
        "PM and six other metrics agree with people, maps turned onto theirs, what the model makes "
        "of a pattern, a methods paragraph, and scripts in Python and R that compute the numbers "
        "again.");
    draw_divider(ui.theme);
    draw_sets(ui, work, paper);
    draw_along(ui, work.document.set, paper.along);
    if (!foreign.empty()) {
        std::string names;
        for (const ForeignMetric& one : foreign) names += (names.empty() ? "" : ", ") + one.key;
        draw_label(ui, "Besides");
        dim_text(ui, {.id = "paper:metrics", .text = names});
    }
    const bool more = button(ui, {.id = "button:add a set", .label = "Add a set..."});
    ImGui::SameLine();
    if (more) {
        give_way(ui);
        return choose_set(ui, work, paper);
    }
    const bool rated = !work.document.set.ratings.empty() || !paper.more.empty();
    if (draw_ends(ui, "Choose a folder...", rated && !is_writing_paper(paper))) {
        choose_folder(ui, work, foreign, paper);
    }
}

}  // namespace tact
