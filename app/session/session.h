// Document and session on the disk, autosave, locks, crash reports.
#pragma once

#include <sys/types.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

#include "devices/device/device.h"
#include "model/common/expected.h"
#include "model/io/folders/folder_files.h"
#include "model/lesson/lesson.h"
#include "model/set/pattern_set.h"

namespace tact {

// What a person works on: the set, where it is stored, and whether it is saved.

struct Document {
    PatternSet set;
    std::filesystem::path path;  // empty: never saved
    PatternSet saved;            // as it was last read or written: unsaved means set != saved
    // Mark of the file's bytes at that time; empty: unknown.
    std::optional<std::uint64_t> file_mark{};
};

// A lock between processes that ends with its holder, however that ends.
//
// Left out  waiting for a lock; locks on network file systems that do not know them.

class FileLock {
  public:
    explicit FileLock(int file) : file_(file) {}
    FileLock(FileLock&& other) noexcept : file_(std::exchange(other.file_, -1)) {}
    FileLock& operator=(FileLock&& other) noexcept {
        std::swap(file_, other.file_);
        return *this;
    }
    ~FileLock();

  private:
    int file_;
};

// Makes the file if need be. None: someone else holds it, or there can be no such file.
std::optional<FileLock> try_lock(const std::filesystem::path& path);

// What survives the program: recent files, layout, looks, and which document was open.
//
// The first running instance owns the folder. Another one reads the same settings but writes none,
// and keeps its unsaved changes in a file of its own.
//
// Input     session.json in the state folder, written by any earlier run
// Output    settings; nothing missing or damaged there keeps the program from starting
// Left out  settings of single sets: those are in the set.

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

// Unsaved changes outlive the program, whether it is closed, killed or crashes.
//
// The autosave holds the set and the path it belongs to in one file, so that no crash can pair a
// set with another one's path. Recordings are named by absolute path in it.
//
// Input     the document after each change; the caller waits for pauses
// Output    the document of the last run, or a set file of its own for what would be lost
// Left out  undo steps; versions before the last.

// Keeps the document if it has unsaved changes; otherwise forgets what was kept. An Error: they are
// only in memory.
Expected<Done> autosave(const Session& session, const Document& document);

struct Restored {
    std::optional<Document> document;  // none: nothing was open, or it cannot be read
    std::string remark;                // one sentence for the status line; may be empty
    bool is_error = false;             // of the remark
};

// The document of the last run with its unsaved changes. An autosave that cannot be read is kept
// aside.
Restored restore(Session& session);

// Moves unsaved changes of the last run, if any, to a recovered-YYYYMMDD-HHMMSS.tactspace.json
// that heads the recent files: for a start with another document. Empty: no changes.
Expected<std::filesystem::path> set_autosave_aside(Session& session);

// The same for instances that are gone; lists the new files in session.recovered. Called by
// open_session.
void recover_orphans(Session& session);

// The lock that the instance with this autosave holds while it runs.
std::filesystem::path lock_of(const std::filesystem::path& autosave_file);

// Programs that this one starts.

// Starts a program that is found as a shell finds it, without a terminal. What it says goes to a
// file; default: nowhere.
Expected<pid_t> started(std::vector<std::string> words,
                        const std::filesystem::path& said = "/dev/null");

// How it ended, as waitpid says it; none: it was asked to stop, or is nobody's child here.
std::optional<int> ended(pid_t process, const std::stop_token& stop);

// The file of the running program; empty where the system does not say.
std::filesystem::path running_program();

// What is known of a crash, written by the signal's handler where the next start finds it.
//
// A report has the version, the signal, the stack and the last commands by their names, and nothing
// of the content of a set. Addresses are those of the program's file: addr2line -Cfe tells lines.
//
// Source    signal-safety(7), backtrace(3), whose first call loads a library and is made
//           beforehand.
// Left out  SIGKILL and a loss of power; where a sanitizer or a debugger answers a signal, it stays
//           theirs.

// From now on a crash writes the file, over an older one. A path longer than 4,000 bytes is left.
void watch_for_crashes(const std::filesystem::path& file);

// For the report: the newest 16 are kept. The name is a literal, and stays where it is.
void note_command(const char* name);

// A report that nobody has been told of, moved to crash-YYYYMMDD-HHMMSS.txt beside it.
std::optional<std::filesystem::path> take_crash_report(const std::filesystem::path& file);

// The document's file, which others may write as well: what it held when it was last read or
// written here, and which of a person's windows have it open.
//
// Left out  windows of other people and on other machines: what they write is noticed all the same
//           before it is written over.

// Mark of the bytes of a file, to notice that they changed; empty: it cannot be read.
std::optional<std::uint64_t> content_mark(const std::filesystem::path& file);

// Takes the file for this window, and gives back the one taken before. False: another window has
// it. Without a state folder nobody knows.
bool hold_document(Session& session, const std::filesystem::path& file);
void release_document(Session& session);

// Folders to write into, and what is in them.

// Takes the folder and every file in it, old ones too, from all other users. A file whose
// permissions cannot be changed keeps them.
void keep_private(const std::filesystem::path& folder);
inline constexpr unsigned kPrivateFile = 0600;

// A name by the time of the clock on the wall, such as recovered-20260131-235959.json, or with -2,
// -3 ...: never one that is there.
std::filesystem::path unused_file(const std::filesystem::path& folder, const std::string& prefix,
                                  const std::string& ending);

// A lesson that is being written outlives the program as the document does: in a file beside the
// document's autosave, written whole or not at all, for this user alone.
//
// Input     the lesson after each change; the caller waits for pauses
// Output    the lesson of the last run, or a lesson file of its own for what would be lost
// Left out  its undo steps.

struct LessonDraft {
    Lesson lesson;               // with its set; recordings by absolute path
    std::filesystem::path path;  // of its file; empty: it has none
    std::size_t step = 0;        // that is written
};

// autosave-7.json of a document lies beside autosave-7.lesson.
std::filesystem::path lesson_autosave(const std::filesystem::path& autosave_file);

// Keeps the lesson; none: forgets what was kept. An Error: it is in memory alone.
Expected<Done> autosave_lesson(const Session& session, const std::optional<LessonDraft>& draft);

struct RestoredLesson {
    std::optional<LessonDraft> draft;  // none: no lesson was unsaved, or it cannot be read
    std::string remark;                // one sentence for the status line; may be empty
    bool is_error = false;             // of the remark
};

// The lesson of the last run. An autosave that cannot be read is kept aside.
RestoredLesson restore_lesson(Session& session);

// Moves an autosave to a recovered-YYYYMMDD-HHMMSS.tactlesson.json that heads the recent files; one
// that is no autosave keeps its bytes there. Empty: no such file.
Expected<std::filesystem::path> set_lesson_aside(Session& session,
                                                 const std::filesystem::path& lesson_file);

}  // namespace tact
