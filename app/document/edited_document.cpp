#include <algorithm>
#include <cmath>
#include <utility>

#include "app/document/editing.h"
#include "app/document/workspace.h"
#include "app/session/session.h"
#include "model/set/felt_versions.h"
#include "model/set/layers.h"

namespace tact {

namespace {

using State = EditedDocument::State;

Measurement* measurement_of(Vibration& vibration) {
    return std::get_if<Measurement>(&vibration.source);
}

// A recording lies in another file now.
struct Moved {
    Measurement from, to;
};

std::vector<Moved> moved_files(const PatternSet& before, const PatternSet& stored) {
    std::vector<Moved> moved;
    for (std::size_t k = 0; k < stored.vibrations.size(); ++k) {
        const auto from = recordings_in(before.vibrations[k]);
        const auto to = recordings_in(stored.vibrations[k]);
        for (std::size_t one = 0; one < std::min(from.size(), to.size()); ++one) {
            if (from[one]->path != to[one]->path) moved.push_back({*from[one], *to[one]});
        }
    }
    return moved;
}

bool is_file_of(const Moved& moved, const Measurement& measurement) {
    return moved.from.path == measurement.path && moved.from.scale_g == measurement.scale_g &&
           (moved.from.waveform == measurement.waveform ||
            *moved.from.waveform == *measurement.waveform);
}

void follow(const std::vector<Moved>& all, Measurement& measurement) {
    const auto moved = std::ranges::find_if(
        all, [&measurement](const Moved& one) { return is_file_of(one, measurement); });
    if (moved == all.end()) return;
    measurement.path = moved->to.path;
    measurement.scale_g = moved->to.scale_g;
}

// The places with the digits that a file stores.
MapPlaces rounded(MapPlaces places) {
    constexpr double kFine = 1e4;  // of a map's mean distance from its middle
    for (auto& [name, at] : places.at) {
        for (double& coordinate : at) coordinate = std::round(kFine * coordinate) / kFine;
    }
    return places;
}

}  // namespace

EditedDocument::EditedDocument() : committed_(std::make_shared<const PatternSet>()) {}

EditedDocument::EditedDocument(const EditedDocument& other)
    : now_(other.now_),
      history_(other.history_),
      committed_(other.committed_),
      lying_(other.lying_) {}

EditedDocument::EditedDocument(EditedDocument&& other) noexcept
    : now_(std::move(other.now_)),
      history_(std::move(other.history_)),
      committed_(other.committed_),
      lying_(std::move(other.lying_)) {}

EditedDocument& EditedDocument::operator=(const EditedDocument& other) {
    if (this != &other) *this = EditedDocument(other);
    return *this;
}

EditedDocument& EditedDocument::operator=(EditedDocument&& other) noexcept {
    now_ = std::move(other.now_);
    history_ = std::move(other.history_);
    committed_ = other.committed_;
    lying_ = std::move(other.lying_);
    return *this;
}

void EditedDocument::open(Document document) {
    now_ = std::move(document);
    history_.clear();
    committed_ = std::make_shared<const PatternSet>(now_.set);
    lying_.clear();
    const bool is_file = now_.file_mark && now_.set == now_.saved;
    lying_[committed_].is_in_file = is_file || !now_.set.map_places.at.empty();
}

bool EditedDocument::commit(const std::string& label, bool joins) {
    if (is_committed()) return false;
    now_.set.map_places.at.clear();  // those of the state before
    keep_versions(*committed_, now_.set);
    // What is in the file again has its places again: saving it changes no byte.
    const bool is_in_file = now_.set == now_.saved;
    if (is_in_file) now_.set.map_places = now_.saved.map_places;
    auto after = std::make_shared<const PatternSet>(now_.set);
    const bool moved =
        joins ? history_.join(committed_, after, label) : history_.commit(committed_, after, label);
    if (!moved) return false;
    committed_ = std::move(after);
    lying_[committed_].is_in_file = is_in_file;
    forget_places();
    return true;
}

// Whoever did not say that the gesture has ended loses nothing of it.
void EditedDocument::end_gesture() { commit("Change"); }

bool EditedDocument::show(const State& state) {
    if (!state) return false;
    now_.set = *state;
    committed_ = state;
    return true;
}

bool EditedDocument::undo() {
    end_gesture();
    return show(history_.undo());
}

bool EditedDocument::redo() {
    end_gesture();
    return show(history_.redo());
}

Document EditedDocument::kept() const {
    Document document = now_;
    const auto lying = lying_.find(committed_);
    if (!is_committed()) {
        document.set.map_places = {};
    } else if (lying != lying_.end() && !lying->second.is_in_file) {
        document.set.map_places = rounded(lying->second.shown);
    }
    return document;
}

// Every state has the name and the files that `stored` has and `before` had not.
void EditedDocument::amend(const PatternSet& before, const PatternSet& stored) {
    const std::vector<Moved> moved = moved_files(before, stored);
    const bool names = before.name.empty() && !stored.name.empty();
    std::map<State, State> amended{{committed_, std::make_shared<const PatternSet>(stored)}};
    const auto of = [&](const State& state) {
        if (const auto known = amended.find(state); known != amended.end()) return known->second;
        State result = state;
        if (names || !moved.empty()) {
            PatternSet changed = *state;
            if (names && changed.name.empty()) changed.name = stored.name;
            for (Vibration& vibration : changed.vibrations) {
                if (Measurement* measurement = measurement_of(vibration))
                    follow(moved, *measurement);
            }
            result = std::make_shared<const PatternSet>(std::move(changed));
        }
        return amended[state] = result;
    };
    history_.amend(of);
    committed_ = of(committed_);
    std::map<State, Lying> lying;
    for (auto& [state, lies] : lying_) lying[of(state)] = std::move(lies);
    lying_ = std::move(lying);
}

void EditedDocument::was_saved(const std::filesystem::path& file, const PatternSet& stored,
                               std::optional<std::uint64_t> mark) {
    end_gesture();
    amend(now_.set, stored);
    lying_[committed_].is_in_file = true;
    now_ = {stored, file, stored, mark};
}

const MapPlaces* EditedDocument::places() const {
    const auto lying = lying_.find(committed_);
    if (lying == lying_.end() || !is_committed()) return nullptr;
    if (!lying->second.shown.at.empty()) return &lying->second.shown;
    return committed_->map_places.at.empty() ? nullptr : &committed_->map_places;
}

void EditedDocument::note_places(MapPlaces places) {
    if (is_committed()) lying_[committed_].shown = std::move(places);
}

// Drops the places of states that no step leads to any more.
void EditedDocument::forget_places() {
    std::erase_if(lying_, [this](const auto& one) {
        return one.first != committed_ && one.first.use_count() == 1;
    });
}

namespace fs = std::filesystem;

namespace {

bool is_same_file(const fs::path& a, const fs::path& b) {
    std::error_code none;
    return a == b || fs::equivalent(a, b, none);
}

}  // namespace

std::string with_stop(std::string text) {
    if (!text.empty() && text.back() != '.') text += '.';
    return text;
}

void wait_for_autosave(const Workspace& work) {
    if (work.autosave_write.valid()) work.autosave_write.wait();
}

Expected<fs::path> keep_unsaved(Workspace& work) {
    wait_for_autosave(work);
    if (work.document.set == work.document.saved) return fs::path{};
    if (const Expected<Done> kept = autosave(work.session, work.document.kept()); !kept)
        return kept.error();
    return set_autosave_aside(work.session);
}

void refuse_to_replace(Ui& ui, const std::string& reason) {
    complain(ui,
             "This document stays open: its unsaved changes cannot be kept aside. Save it first, "
             "with File > Save as... " +
                 with_stop(reason));
}

bool is_changed_outside(const Document& document, const fs::path& file) {
    if (!document.file_mark || document.path.empty() || !is_there(file)) return false;
    if (!is_same_file(file, document.path)) return false;
    return content_mark(file) != document.file_mark;
}

}  // namespace tact
