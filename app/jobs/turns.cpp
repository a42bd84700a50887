#include "app/jobs/jobs.h"

#include <algorithm>
#include <chrono>
#include <optional>
#include <utility>
#include <vector>

#include "model/system/pauses.h"
#include "model/system/process.h"

namespace tact {

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds kTurn{50};

bool pretends_no_threads = false;
bool another_is_wanted = false;
std::optional<Clock::time_point> turn_ends;  // none: no turn is under way

// Those who asked, in their order. Empty where there are threads.
std::vector<TurnTaker*>& asking() {
    static std::vector<TurnTaker*> turns;
    return turns;
}

}  // namespace

bool work_takes_turns() { return pretends_no_threads || !has_threads(); }

void pretend_no_threads(bool pretend) { pretends_no_threads = pretend; }

TurnTaker::TurnTaker(TurnKind kind, std::function<void()> work)
    : kind_(kind), work_(std::move(work)) {}

TurnTaker::~TurnTaker() { std::erase(asking(), this); }

void TurnTaker::ask() {
    if (std::ranges::find(asking(), this) == asking().end()) asking().push_back(this);
}

bool give_turn(bool at_rest) {
    const auto next = std::ranges::find_if(
        asking(), [&](const TurnTaker* turn) { return at_rest || turn->kind_ == TurnKind::soon; });
    if (next == asking().end()) return false;
    const TurnKind kind = (*next)->kind_;
    const std::function<void()> work = (*next)->work_;  // whoever asked may go meanwhile
    asking().erase(next);
    const auto ends_of_other = std::exchange(turn_ends, Clock::now() + kTurn);
    if (kind == TurnKind::soon) {
        work();
    } else {
        call_with_pauses(work);
    }
    turn_ends = ends_of_other;
    return true;
}

bool is_turn_over() { return !is_pausable() && turn_ends && Clock::now() >= *turn_ends; }

void want_another_turn() { another_is_wanted = true; }

bool take_wish_for_turn() { return std::exchange(another_is_wanted, false); }

}  // namespace tact
