// What survives the program: recent files, layout, looks, and which document was open.
//
// The first running instance owns the folder. Another one reads the same settings but writes none,
// and keeps its unsaved changes (app/session/autosave.h) in a file of its own.
//
// Input     session.json in the state folder, written by any earlier run
// Output    settings; nothing missing or damaged there keeps the program from starting
// Left out  settings of single sets: those are in the set.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "app/session/file_lock.h"
#include "devices/device/device_info.h"
#include "model/common/expected.h"

namespace tact {

inline constexpr std::size_t kRecentFiles = 10;

struct Session {
    // Kept from one start to the next.
    std::vector<std::filesystem::path> recent_files;  // most recent first
    std::map<std::string, double> layout;
    std::string theme = "dark";
    double text_scale = 1.0;
    int window_width = 1600;  // screen coordinates
    int window_height = 1000;
    bool window_maximised = false;
    std::set<std::string> dismissed_hints;
    std::filesystem::path document;  // open when the program last ended; empty: none with a file
    std::string device;              // id of the one that plays; empty: silent
    std::vector<DeviceChoice> device_choices;  // what was chosen of it, and of others before it
    double full_scale_g = 1.0;
    // What was said of tables, as app/tables writes it, by the names of their columns.
    std::map<std::string, std::string> table_words;
    std::string lesson_language;  // in which lessons are shown; empty: each in its first
    // Where each was left, counted from 0, by its file or its path below assets/.
    std::map<std::string, std::size_t> lesson_steps;
    double whole_buffer_s = kBufferS;  // rendered ahead where nothing may have gaps

    // What belongs to this run.
    std::filesystem::path folder;                  // empty: nothing can be kept
    std::filesystem::path autosave;                // this instance's own
    bool is_first = true;                          // no other instance was running
    bool ended_in_crash = false;                   // the run before this one
    std::vector<std::filesystem::path> recovered;  // unsaved changes of instances that are gone
    std::optional<std::filesystem::path> crash_report;  // of a run before this one
    std::vector<std::string> remarks;                   // what was wrong and what was done about it
    std::shared_ptr<FileLock> lock;                     // shared, so that a session can be copied
    std::shared_ptr<FileLock> document_lock;            // of the open document, among windows
    std::filesystem::path document_lock_file;
};

// $XDG_STATE_HOME/tactspace or ~/.local/state/tactspace; empty without a home.
std::filesystem::path state_folder();

// Where the report of a crash is written while the program runs; empty where nothing can be kept.
std::filesystem::path crash_report_file();

// Never fails: what goes wrong is in the remarks.
Session open_session(const std::filesystem::path& folder);

// Writes the settings; nothing to do for another than the first instance.
Expected<Done> write_session(const Session& session);

// The program ends as it should. Unsaved changes stay in the autosave.
Expected<Done> close_session(Session& session);

// Puts a file at the head of the recent ones.
void remember_file(Session& session, const std::filesystem::path& path);

struct RecentFile {
    std::filesystem::path path;
    bool missing = false;  // its disk may be back tomorrow
};

std::vector<RecentFile> recent_files(const Session& session);

// Where waveforms are until their set is saved; empty where nothing can be kept.
std::filesystem::path measured_folder(const Session& session);

}  // namespace tact
