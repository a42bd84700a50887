#include "app/classroom/classroom.h"

#include <algorithm>
#include <filesystem>
#include <numeric>
#include <utility>

#include "app/document/editing.h"
#include "app/lesson/lesson.h"
#include "app/phones/phones.h"
#include "app/study/study.h"
#include "model/set/set_ratings.h"
#include "model/text/utc_time.h"
#include "model/told_apart/told_apart_results.h"

namespace tact {

namespace fs = std::filesystem;

namespace {

// What is asked about one pattern can be felt with the question.
std::vector<int> felt_with(const Classroom& room, const LessonStep& step) {
    if (!step.partner.empty() || !room.phones.cards_of) return {};
    const auto& patterns = room.phones.cards_of->patterns;
    const auto found = std::ranges::find(patterns, step.pattern, &PhonePattern::name);
    return found == patterns.end() ? std::vector<int>() : found->ms;
}

std::optional<ChoiceCard> card_of_lesson(const Classroom& room) {
    auto words = question_in_words(room.lesson);
    const LessonStep* step = step_of(room.lesson);
    if (!words || step == nullptr || room.lesson.editing) return std::nullopt;
    ChoiceCard card;
    // A lesson that is begun again asks again.
    card.id = "lesson " + std::to_string(room.work.document_number) + " step " +
              std::to_string(*room.lesson.step);
    card.ask = std::move(words->ask);
    card.options = std::move(words->options);
    card.ms = felt_with(room, *step);
    card.revealed = words->is_revealed;
    card.right = std::move(words->right);
    card.reveal = std::move(words->reveal);
    return card;
}

// Beside the participants who come to the window, in a folder of its own for each time.
fs::path folder_of_class(const Classroom& room) {
    fs::path folder = study_folder(room.work, room.studying);
    if (folder.empty()) return folder;
    // The last class may have left its own in the place of the study's.
    std::string name = folder.filename().string();
    name = name.substr(0, name.find(" phones ")) + " phones " + utc_now().substr(0, 10);
    fs::path own = folder.parent_path() / name;
    std::error_code none;
    for (int number = 2; fs::exists(own, none); ++number) {
        own = folder.parent_path() / (name + " " + std::to_string(number));
    }
    return own;
}

// The study asks what the phones are asked, in one step: the patterns that are selected, where they
// are several, and each pair as often.
void fit_study(const Classroom& room) {
    Workspace& work = room.work;
    StudyDesign design = work.document.set.study;
    design.repetitions = room.phones.repetitions;
    const std::vector<std::size_t> places = selected_indices(work);
    if (can_rate_together(places.size())) {
        design.patterns.clear();
        for (const std::size_t place : places) {
            design.patterns.push_back(work.document.set.vibrations[place].name);
        }
    }
    if (design == work.document.set.study) return;
    work.document.edit().study = std::move(design);
    document_changed(work);
    commit_step(room.ui, work, "study: as the phones rate");
}

void rate_together(const Classroom& room) {
    fit_study(room);
    const fs::path folder = folder_of_class(room);
    if (folder.empty()) return complain(room.ui, "Save the set first: its answers lie beside it.");
    begin_rating(room.ui, room.work, room.phones, folder);
    if (!room.phones.rating) return;
    room.studying.kind = StudyKind::pairwise;
    set_study_folder(room.work, room.studying, folder);
    ++room.studying.folder_revision;
}

// The pairs that PM puts closest and what lies between them and the farthest; of the patterns that
// are selected, where they are several.
void try_pairs_on(const Classroom& room, int phone) {
    const auto& map = room.map.transition.shown;
    const bool is_exact = map && map->prediction.envelope_decimation == 1 && !map->request.preview;
    const bool is_current = map && map->request.revision == room.work.revision &&
                            map->request.document == room.work.document_number;
    if (!is_exact || !is_current || map->request.rendered_by) {
        return complain(room.ui,
                        "The exact map of the patterns as they are meant must be there first: it "
                        "says which pairs are close.");
    }
    std::vector<std::size_t> places = selected_indices(room.work);
    if (places.size() < 2) {
        places.resize(map->prediction.pm.size);
        std::iota(places.begin(), places.end(), std::size_t{0});
    }
    const std::vector<std::string> all = names_of(*map->request.set);
    std::vector<std::string> names;
    for (const std::size_t place : places) names.push_back(all[place]);
    begin_trials(room.ui, room.work, room.phones, phone,
                 pairs_to_ask(names, among(map->prediction.pm, places)));
}

// With the set, as what one person felt on one phone: one step.
void keep_trials(const Classroom& room, const PhoneTrials& tried) {
    Workspace& work = room.work;
    const ToldApart told = told_apart_of(tried.trials, *tried.felt);
    work.document.edit().told_apart.push_back(told);
    document_changed(work);
    commit_step(room.ui, work, "trials on " + told.device);
    const ToldApartResults results = results_of(told);
    say(room.ui, told.person + ": " + share_words(results) + " " + threshold_words(results));
}

}  // namespace

void follow_class(const Classroom& room) {
    if (!are_phones_served(room.phones)) return;
    ask_phones(room.phones, card_of_lesson(room));
    const PhonesNews news = follow_phones(room.ui, room.work, room.play, room.phones);
    if (news.rated) ++room.studying.folder_revision;
    if (news.all_tried) keep_trials(room, *news.all_tried);
    if (room.phones.question) count_elsewhere(room.lesson, room.phones.question->votes);
}

void act_on_phones(const Classroom& room, const PhonesActions& actions) {
    if (actions.rate_together) rate_together(room);
    if (actions.trials_on) try_pairs_on(room, *actions.trials_on);
    if (!actions.show_answers) return;
    room.ui.dialog = kNoDialog;
    room.studying.show = StudyShow::map;  // with PM's beside it
    open_study(room.layout, room.studying);
}

}  // namespace tact
