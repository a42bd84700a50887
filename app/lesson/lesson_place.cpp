#include "app/lesson/lesson.h"

#include <algorithm>

#include "model/text/numbers.h"

namespace tact {

namespace {

constexpr double kNudge = 0.02;  // share of the map's width

// The flat map on screen for placing a pattern of the lesson.
struct PlacedIn {
    const Eigen::MatrixXd& points;
    Eigen::Index row = 0;  // row of the pattern
};

std::optional<PlacedIn> placed_in(const LessonState& state, const ShownMap& shown_map) {
    const MapTransition& map = shown_map.transition;
    if (!asks_for_place(state) || !map.shown || map.to.cols() != 2) return std::nullopt;
    const auto row = place_named(*map.shown->request.set, step_of(state)->pattern);
    if (!row || static_cast<Eigen::Index>(*row) >= map.to.rows()) return std::nullopt;
    return PlacedIn{map.to, static_cast<Eigen::Index>(*row)};
}

Eigen::RowVectorXd row_of(const MapPlace& place) { return Eigen::RowVector2d(place[0], place[1]); }

double width_of(const Eigen::MatrixXd& points) {
    double width = 0.0;
    for (Eigen::Index i = 0; i < points.rows(); ++i) {
        for (Eigen::Index j = 0; j < i; ++j) {
            width = std::max(width, (points.row(i) - points.row(j)).norm());
        }
    }
    return width;
}

// The centre of the other patterns.
MapPlace first_place(const PlacedIn& map) {
    const Eigen::RowVectorXd others =
        (map.points.colwise().sum() - map.points.row(map.row)) /
        static_cast<double>(std::max<Eigen::Index>(map.points.rows() - 1, 1));
    return {others(0), others(1)};
}

Eigen::Index nearest_row(const PlacedIn& map, const MapPlace& place) {
    Eigen::Index nearest = map.row == 0 ? 1 : 0;
    const auto away = [&](Eigen::Index k) { return (map.points.row(k) - row_of(place)).norm(); };
    for (Eigen::Index k = 0; k < map.points.rows(); ++k) {
        if (k != map.row && away(k) < away(nearest)) nearest = k;
    }
    return nearest;
}

}  // namespace

bool asks_for_place(const LessonState& state) {
    const LessonQuestion* question = question_of(state);
    return question != nullptr && question->kind == QuestionKind::place && !state.editing &&
           *state.step < state.tallies.size();
}

void mark_place(const LessonState& state, const ShownMap& shown_map, MapMarks& marks) {
    if (!asks_for_place(state)) return;
    const Tally& tally = state.tallies[*state.step];
    const auto map = placed_in(state, shown_map);
    // Hidden even while the map is not flat yet.
    if (!tally.revealed && shown_map.transition.shown) {
        marks.hidden =
            place_named(*shown_map.transition.shown->request.set, step_of(state)->pattern);
        marks.takes_place = map.has_value();
    }
    if (!map || !tally.place) return;
    marks.maybes.wanted = row_of(*tally.place);
    if (tally.revealed) marks.maybes.reached = Eigen::RowVectorXd(map->points.row(map->row));
}

void take_place(LessonState& state, const SpacePaneAction& done) {
    if (!done.placed_at || done.placed_at->size() != 2) return;
    if (!asks_for_place(state) || !hides_answer(state)) return;
    state.tallies[*state.step].place = MapPlace{(*done.placed_at)(0), (*done.placed_at)(1)};
}

bool nudge_place(LessonState& state, const ShownMap& shown_map, const KeyPress& press) {
    const bool left = press.code == key::kLeft;
    const bool right = press.code == key::kRight;
    const bool up = press.code == key::kUp;
    const bool down = press.code == key::kDown;
    if (!press.shift || !(left || right || up || down) || !hides_answer(state)) return false;
    const auto map = placed_in(state, shown_map);
    if (!map) return false;
    auto& place = state.tallies[*state.step].place;
    if (!place) {
        place = first_place(*map);
        return true;
    }
    const double step = kNudge * width_of(map->points);
    (*place)[0] += (right ? step : 0.0) - (left ? step : 0.0);
    (*place)[1] += (up ? step : 0.0) - (down ? step : 0.0);
    return true;
}

std::optional<double> place_off_by(const LessonState& state, const ShownMap& shown_map) {
    const auto map = placed_in(state, shown_map);
    if (!map || !state.tallies[*state.step].place) return std::nullopt;
    const double width = width_of(map->points);
    if (width <= 0.0) return std::nullopt;
    const Eigen::RowVectorXd place = row_of(*state.tallies[*state.step].place);
    return (map->points.row(map->row) - place).norm() / width;
}

std::string place_text(const LessonState& state, const ShownMap& shown_map) {
    const auto off = place_off_by(state, shown_map);
    if (!off) return {};
    return "The cross is off by " + percent(*off) + " of the map's width.";
}

void count_place(LessonState& state, const ShownMap& shown_map) {
    const auto map = placed_in(state, shown_map);
    const LessonAnswers* answers = answers_of(state);
    if (!map || answers == nullptr || *state.step >= answers->questions.size()) return;
    Tally& tally = state.tallies[*state.step];
    if (!tally.place || *std::ranges::max_element(tally.votes) > 0) return;
    const auto nearest = static_cast<std::size_t>(nearest_row(*map, *tally.place));
    const auto& options = answers->questions[*state.step].options;
    const std::string& name = shown_map.transition.shown->request.set->vibrations[nearest].name;
    const auto at = std::ranges::find(options, name);
    if (at != options.end()) ++tally.votes[static_cast<std::size_t>(at - options.begin())];
}

}  // namespace tact
