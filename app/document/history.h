// Undo and redo as whole values: one gesture, one step.
//
// Whole values instead of commands: nothing has to know how to revert itself, and a value shares
// what is big (recorded waveforms) with its neighbours.
//
// Input     the value before and after a gesture, and what the gesture did ("Change amplitude")
// Output    the value to go back or forward to
// Left out  knowing what is one gesture: the caller commits when it ends, or has it join the last.
#pragma once

#include <cassert>
#include <cstddef>
#include <deque>
#include <memory>
#include <string>
#include <utility>

namespace tact {

inline constexpr std::size_t kHistorySteps = 200;

template <class Value>
class History {
  public:
    using State = std::shared_ptr<const Value>;

    explicit History(std::size_t limit = kHistorySteps) : limit_(limit) {}

    // Makes a step, forgets what could be redone and, at the limit, the oldest step. Equal values
    // are no step: false. Hand on the last `after` as the next `before`: then both steps share it.
    bool commit(State before, State after, std::string label) {
        assert(before && after && "a step lies between two values");
        if (before == after || *before == *after) return false;
        steps_.resize(done_);
        steps_.push_back({std::move(before), std::move(after), std::move(label)});
        if (steps_.size() > limit_) steps_.pop_front();
        done_ = steps_.size();
        return true;
    }

    // Moves the end of the last step, where one can be undone and ends at `before`; one that comes
    // back to where it began is dropped. Otherwise adds a step.
    bool join(State before, State after, std::string label) {
        if (done_ == 0 || steps_[done_ - 1].after != before) {
            return commit(std::move(before), std::move(after), std::move(label));
        }
        if (*before == *after) return false;
        steps_.resize(done_);
        steps_.back().after = std::move(after);
        if (*steps_.back().before == *steps_.back().after) steps_.pop_back();
        done_ = steps_.size();
        return true;
    }

    // The value to show from now on; null: there is no such step.
    State undo() { return done_ == 0 ? nullptr : steps_[--done_].before; }
    State redo() { return done_ == steps_.size() ? nullptr : steps_[done_++].after; }

    // What undo() or redo() would take back or do again; null: nothing.
    const std::string* undo_label() const {
        return done_ == 0 ? nullptr : &steps_[done_ - 1].label;
    }
    const std::string* redo_label() const {
        return done_ == steps_.size() ? nullptr : &steps_[done_].label;
    }

    // All steps from the oldest one on, those that could be redone behind those that are done.
    std::size_t size() const { return steps_.size(); }
    std::size_t done() const { return done_; }
    const std::string& label(std::size_t step) const { return steps_[step].label; }

    // Puts `of(state)` in the place of every value: what happened to all of them alike is no step.
    template <class Of>
    void amend(Of of) {
        for (Step& step : steps_) {
            step.before = of(step.before);
            step.after = of(step.after);
        }
    }

    void clear() {
        steps_.clear();
        done_ = 0;
    }

  private:
    struct Step {
        State before;
        State after;
        std::string label;
    };

    std::size_t limit_;
    std::size_t done_ = 0;  // steps before this one can be undone, from it on redone
    std::deque<Step> steps_;
};

// "Undo" and "Change amplitude of L-4-full" make "Undo change amplitude of L-4-full".
inline std::string menu_text(std::string verb, const std::string* label) {
    if (label == nullptr || label->empty()) return verb;
    std::string what = *label;
    const auto is_capital = [](char c) { return c >= 'A' && c <= 'Z'; };
    const bool is_acronym = what.size() > 1 && is_capital(what[1]);
    if (is_capital(what[0]) && !is_acronym) what[0] = static_cast<char>(what[0] - 'A' + 'a');
    return std::move(verb) + " " + what;
}

}  // namespace tact
