// What people said, as a matrix or as a map: of all who count, or of one beside them.

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <string>

#include "app/compare/compare.h"
#include "app/document/workspace.h"
#include "app/map/map.h"
#include "app/progress/progress.h"
#include "app/study/study.h"
#include "app/ui/widgets.h"
#include "model/map/alienation.h"
#include "model/map/procrustes.h"
#include "model/text/numbers.h"
#include "viz/charts/matrix_view.h"
#include "viz/drawing/marks.h"
#include "viz/drawing/plot.h"
#include "viz/space/space_view.h"

namespace tact {

namespace {

void draw_choice(Ui& ui, StudyState& studying) {
    constexpr std::array kShown{Choice{StudyShow::matrix, "Matrix"}, Choice{StudyShow::map, "Map"}};
    draw_segments(ui, kShown, studying.show, "study show:");
    if (!studying.shown) return;
    flow_on(ImGui::CalcTextSize("Show the mean").x, 2.0F * ui.theme.gap_px);
    if (row_link(ui, {.id = "link:show mean", .label = "Show the mean"})) studying.shown.reset();
}

bool has_map(const PerceptualSpace& space, std::size_t patterns) {
    return space.points.rows() == static_cast<Eigen::Index>(patterns) && patterns > 1 &&
           space.verdict != MdsVerdict::constant;
}

// PM's map of the patterns that people rated, turned onto theirs.
struct MapBeside {
    Eigen::MatrixXd points;
    std::string words;
};

// None while the map on screen has not all of them, or other dimensions.
std::optional<MapBeside> pm_beside(const Workspace& work, const ShownMap& shown_map,
                                   std::span<const std::string> labels,
                                   const Eigen::MatrixXd& people) {
    const auto& map = shown_map.transition.shown;
    if (!map || map->space.points.cols() != people.cols()) return std::nullopt;
    const std::vector<std::string> names = names_of(*map->request.set);
    if (!has_map(map->space, names.size())) return std::nullopt;
    Eigen::MatrixXd points(people.rows(), people.cols());
    for (std::size_t k = 0; k < labels.size(); ++k) {
        const auto found = std::ranges::find(names, labels[k]);
        if (found == names.end()) return std::nullopt;
        points.row(static_cast<Eigen::Index>(k)) = map->space.points.row(found - names.begin());
    }
    const auto k = alienation(points, people);
    const bool is_exact = map_state(work, shown_map) == MapState::exact;
    return MapBeside{
        procrustes(points, people).aligned,
        std::string(is_exact ? "PM" : "PM, preview") +
            (k ? ", K " + stepped(*k, 0.01) + "; of unrelated maps about 0.5" : std::string())};
}

void draw_map_words(const Ui& ui, const Rect& area, const std::string& words) {
    draw_text(*ImGui::GetWindowDrawList(), ui.theme.fonts.small, area.min, ui.theme.dim_text,
              words);
}

constexpr float kLeastMapPx = 260.0F;

// The map of all people, and PM's beside it where there is room: both turn together.
void draw_with_pm(Ui& ui, const Workspace& work, ShownMap& shown_map, SpaceScene scene,
                  const Rect& area) {
    const auto beside = pm_beside(work, shown_map, scene.labels, *scene.points);
    const bool has_room = area.width() > 2.0F * kLeastMapPx * ui.theme.scale;
    if (!beside || !has_room) {
        draw_space("study map", ui.theme, area, scene, shown_map.camera);
        return;
    }
    const float middle = 0.5F * (area.min.x + area.max.x);
    const Rect left{area.min, {middle, area.max.y}};
    const Rect right{{middle, area.min.y}, area.max};
    draw_space("study map", ui.theme, left, scene, shown_map.camera);
    draw_map_words(ui, left, "People");
    scene.points = &beside->points;
    draw_space("study map of PM", ui.theme, right, scene, shown_map.camera);
    draw_map_words(ui, right, beside->words);
    note_rect(ui.rects, "study map of PM", right.min, right.max, beside->words);
}

void draw_map(Ui& ui, const Workspace& work, ShownMap& shown_map, const StudyState& studying,
              const StudyAnswers& answers, const Rect& area) {
    const std::vector<std::string>& labels = answers.results->study.labels;
    const auto shown = studying.shown;
    const PerceptualSpace& space = shown ? answers.maps[*shown] : answers.mean_map;
    if (!has_map(space, labels.size())) {
        return draw_empty(*ImGui::GetWindowDrawList(), ui.theme, area, "No map of these answers",
                          "A map needs answers that differ, of more than a few pairs.");
    }
    Eigen::MatrixXd points = space.points;
    SpaceScene scene;
    // One's own map over that of all, turned and sized to fit it best.
    if (shown && has_map(answers.mean_map, labels.size())) {
        points = procrustes(points, answers.mean_map.points).aligned;
        scene.ghosts = &answers.mean_map.points;
        scene.ghost_opacity = 0.6;
    }
    std::vector<PatternLook> looks;
    for (const std::string& label : labels) {
        const auto place = place_named(work.document.set, label);
        looks.push_back(place ? look_of(ui, work, *place) : PatternLook{ui.theme.dim_text, true});
    }
    scene.labels = labels;
    scene.looks = looks;
    scene.points = &points;
    if (!shown) return draw_with_pm(ui, work, shown_map, scene, area);
    draw_space("study map", ui.theme, area, scene, shown_map.camera);
}

// The mark of the chosen participant, or of the mean where none is chosen.
NumberMark shown_mark(const StudyState& studying) {
    const StudyAnswers& answers = *studying.answers;
    if (!studying.shown) return answers.results->mark;
    const std::string& code = answers.records[*studying.shown].header.participant.code;
    const auto person = std::ranges::find(answers.results->people, code, &ParticipantSummary::code);
    if (person == answers.results->people.end()) return {};
    return {.synthetic = person->synthetic, .rehearsal = person->rehearsal};
}

void draw_values(const Ui& ui, const StudyState& studying, const StudyAnswers& answers,
                 const Rect& area) {
    const auto shown = studying.shown;
    const Dissimilarity& matrix = shown ? answers.matrices[*shown] : answers.results->mean;
    MatrixScene scene;
    scene.condensed = matrix.condensed;
    scene.labels = answers.results->study.labels;
    const std::string quantity = of_people("dissimilarity", shown_mark(studying));
    scene.quantity = quantity;
    scene.largest = studying.rule.scaling == RatingScaling::none ? 100.0 : 0.0;
    draw_matrix("study matrix", ui.theme, area, scene);
}

}  // namespace

void draw_study_answers(Ui& ui, const Workspace& work, ShownMap& shown_map, StudyState& studying) {
    const std::shared_ptr<const StudyAnswers> answers = studying.answers;
    if (answers && studying.shown && *studying.shown >= answers->records.size()) {
        studying.shown.reset();
    }
    const bool waits = !answers || !answers->results;
    if (waits && draw_failure(ui, "study answers", studying.job.failure())) return;
    if (waits) {
        const Rect area = rest_of_pane();
        if (area.empty()) return;
        return draw_empty(*ImGui::GetWindowDrawList(), ui.theme, area, "No answers yet",
                          "What participants say appears here, as a matrix and as a map.");
    }
    draw_choice(ui, studying);
    const Rect area = rest_of_pane();
    if (area.width() < 40.0F || area.height() < 40.0F) return;
    if (studying.show == StudyShow::map) {
        draw_map(ui, work, shown_map, studying, *answers, area);
        note_rect(ui.rects, "study map", area.min, area.max);
    } else {
        draw_values(ui, studying, *answers, area);
        note_rect(ui.rects, "study matrix", area.min, area.max);
    }
}

}  // namespace tact
