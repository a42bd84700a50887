// The open document with its undo steps, which own it: whatever writes the set is a step of undo.
//
// A gesture writes what edit() gives; commit() makes a step of it, and what was never committed
// becomes one as soon as anybody undoes or saves. A save is no step: it gives every state the name
// and the files of recordings that it gave, so that undo back to a save is back to the file.
//
// Places    where a set's map lay is known once its exact map was shown. Each state keeps its own,
//           so that undo turns the map back; one that a file holds is written as it stands there.
// Left out  what is one gesture, and what is said of it (editing.h).
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "app/document/history.h"
#include "app/session/document.h"

namespace tact {

class EditedDocument {
  public:
    using State = std::shared_ptr<const PatternSet>;

    // Views of the present state, to read.
    const PatternSet& set = now_.set;
    const std::filesystem::path& path = now_.path;
    const PatternSet& saved = now_.saved;
    const std::optional<std::uint64_t>& file_mark = now_.file_mark;
    const History<PatternSet>& history = history_;
    const State& committed = committed_;  // the set as of the last undo step

    EditedDocument();
    // The references are each object's own.
    EditedDocument(const EditedDocument& other);
    EditedDocument(EditedDocument&& other) noexcept;
    EditedDocument& operator=(const EditedDocument& other);
    EditedDocument& operator=(EditedDocument&& other) noexcept;
    ~EditedDocument() = default;

    // Another document takes the place of this one; nothing of this one can be undone.
    void open(Document document);

    // The set, to be changed by the gesture under way.
    PatternSet& edit() { return now_.set; }

    // What was changed since the last step becomes one, or with `joins` part of the last one where
    // that is there still. False: nothing was.
    bool commit(const std::string& label, bool joins = false);

    // False: there is no such step.
    bool undo();
    bool redo();

    // The document as a file should store it: with the places of its map where they are known.
    Document kept() const;

    // The set was written to the file as `stored`, which may have a name and other files of
    // recordings than the set had.
    void was_saved(const std::filesystem::path& file, const PatternSet& stored,
                   std::optional<std::uint64_t> mark);

    // The places of the current set's map; null: they are not known, or a gesture is under way.
    const MapPlaces* places() const;
    void note_places(MapPlaces places);

  private:
    struct Lying {
        MapPlaces shown;
        bool is_in_file = false;  // the state's own places are what its file has, or has not
    };

    bool show(const State& state);
    void end_gesture();
    bool is_committed() const { return now_.set == *committed_; }
    void amend(const PatternSet& before, const PatternSet& stored);
    void forget_places();

    Document now_;
    History<PatternSet> history_;
    State committed_;
    std::map<State, Lying> lying_;
};

}  // namespace tact
