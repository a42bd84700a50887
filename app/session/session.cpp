#include "app/session/session.h"

#include <unistd.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <ctime>

#include "model/io/folders/path_json.h"
#include "model/system/calendar.h"
#include "model/text/atomic_file.h"
#include "model/text/json_fields.h"

namespace tact {

namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr int kFormat = 1;
constexpr std::size_t kKnownDevices = 20;
constexpr std::size_t kKnownLessons = 200;

fs::path settings_file(const fs::path& folder) { return folder / "session.json"; }
fs::path running_mark(const fs::path& folder) { return folder / "running"; }

// Each takes a member of the right type and leaves the default in place of any other.

void take(const json& from, const char* name, std::string& to) {
    if (const auto at = from.find(name); at != from.end() && at->is_string()) to = *at;
}

void take_bytes(const json& from, const char* name, std::string& to) {
    if (const auto at = from.find(name); at != from.end()) to = bytes_named(*at).value_or(to);
}

void take(const json& from, const char* name, bool& to) {
    if (const auto at = from.find(name); at != from.end() && at->is_boolean()) to = *at;
}

void take(const json& from, const char* name, double low, double high, double& to) {
    const auto at = from.find(name);
    if (at != from.end() && at->is_number()) to = std::clamp(at->get<double>(), low, high);
}

void take(const json& from, const char* name, int low, int high, int& to) {
    double number = to;
    take(from, name, low, high, number);
    to = static_cast<int>(number);
}

template <class Each>
void take_strings(const json& from, const char* name, Each each) {
    const auto at = from.find(name);
    if (at == from.end() || !at->is_array()) return;
    for (const json& item : *at) {
        if (item.is_string()) each(item.get<std::string>());
    }
}

void take_paths(const json& from, std::vector<fs::path>& to) {
    const auto at = from.find("recent_files");
    if (at == from.end() || !at->is_array()) return;
    for (const json& item : *at) {
        const std::optional<fs::path> path = path_of(item);
        if (path && to.size() < kRecentFiles) to.push_back(*path);
    }
}

// How the devices were used that have been chosen so far.
void take_devices(const json& from, Session& session) {
    take_bytes(from, "device", session.device);
    take(from, "full_scale_g", 1e-3, 1e3, session.full_scale_g);
    take(from, "whole_buffer_s", 0.02, 2.0, session.whole_buffer_s);
    const auto at = from.find("device_choices");
    if (at == from.end() || !at->is_array()) return;
    for (const json& item : *at) {
        DeviceChoice choice;
        if (!item.is_object() || session.device_choices.size() == kKnownDevices) continue;
        take_bytes(item, "id", choice.id);
        take(item, "channel", 1, 1024, choice.channel);
        take(item, "of_channels", 0, 1024, choice.of_channels);
        take(item, "latency_offset_s", -1.0, 1.0, choice.latency_offset_s);
        take_bytes(item, "calibration", choice.calibration);
        if (!choice.id.empty()) session.device_choices.push_back(choice);
    }
}

void take_settings(const json& from, Session& session) {
    take_paths(from, session.recent_files);
    if (const auto at = from.find("layout"); at != from.end() && at->is_object()) {
        for (const auto& [name, number] : at->items()) {
            if (number.is_number()) session.layout[name] = number.get<double>();
        }
    }
    take(from, "theme", session.theme);
    take(from, "lesson_language", session.lesson_language);
    take(from, "text_scale", 0.75, 2.0, session.text_scale);
    take(from, "window_width", 320, 16'384, session.window_width);
    take(from, "window_height", 240, 16'384, session.window_height);
    take(from, "window_maximised", session.window_maximised);
    take_strings(from, "dismissed_hints",
                 [&](const std::string& id) { session.dismissed_hints.insert(id); });
    if (const auto at = from.find("document"); at != from.end()) {
        session.document = path_of(*at).value_or(fs::path{});
    }
    take_devices(from, session);
    if (const auto at = from.find("lesson_steps"); at != from.end() && at->is_object()) {
        for (const auto& [lesson, step] : at->items()) {
            if (session.lesson_steps.size() == kKnownLessons) break;
            if (step.is_number_unsigned()) session.lesson_steps[lesson] = step.get<std::size_t>();
        }
    }
    if (const auto at = from.find("table_words"); at != from.end() && at->is_object()) {
        for (const auto& [names, words] : at->items()) {
            if (words.is_string()) session.table_words[names] = words.get<std::string>();
        }
    }
}

// The settings of an earlier run; those of another format, or none, are put aside by the owner.
void read_settings(Session& session) {
    const fs::path file = settings_file(session.folder);
    if (!is_there(file)) return;
    const Expected<std::string> text = read_text_file(file);
    const json read = text ? kept_sorted_json(*text) : json();
    if (read.is_object() && read.value("format", json()) == kFormat) {
        take_settings(read, session);
        return;
    }
    const fs::path aside = session.folder / "session-damaged.json";
    std::error_code none;
    if (session.is_first) fs::rename(file, aside, none);
    session.remarks.push_back("The settings could not be read and start afresh; the old ones are " +
                              aside.string() + ".");
}

json settings_of(const Session& session) {
    json devices = json::array();
    for (const DeviceChoice& choice : session.device_choices) {
        devices.push_back({{"id", bytes_json(choice.id)},
                           {"channel", choice.channel},
                           {"of_channels", choice.of_channels},
                           {"latency_offset_s", choice.latency_offset_s},
                           {"calibration", bytes_json(choice.calibration)}});
    }
    json recent = json::array();
    for (const fs::path& path : session.recent_files) recent.push_back(path_json(path));
    return {{"format", kFormat},
            {"recent_files", recent},
            {"layout", session.layout},
            {"theme", session.theme},
            {"lesson_language", session.lesson_language},
            {"lesson_steps", session.lesson_steps},
            {"text_scale", session.text_scale},
            {"window_width", session.window_width},
            {"window_height", session.window_height},
            {"window_maximised", session.window_maximised},
            {"dismissed_hints", session.dismissed_hints},
            {"document", path_json(session.document)},
            {"device", bytes_json(session.device)},
            {"device_choices", devices},
            {"full_scale_g", session.full_scale_g},
            {"table_words", session.table_words},
            {"whole_buffer_s", session.whole_buffer_s}};
}

bool make_folder(Session& session) {
    keep_new_files_private_in(session.folder);
    std::error_code failure;
    fs::create_directories(session.folder, failure);
    if (!failure) {
        keep_private(session.folder);
        return true;
    }
    session.remarks.push_back("Nothing will be kept after this run: " + session.folder.string() +
                              " cannot be made: " + failure.message() + ".");
    session.folder.clear();
    return false;
}

// Unsaved changes of this instance, or of an earlier one of its name.
bool holds_anything(const Session& session) {
    return is_there(session.autosave) || is_there(lesson_autosave(session.autosave));
}

// The first instance takes the folder, a later one a name by its process number.
void take_place(Session& session) {
    std::optional<FileLock> lock = try_lock(session.folder / "lock");
    session.is_first = lock.has_value();
    session.autosave = session.folder / "autosave.json";
    std::string name = std::to_string(getpid());
    for (int again = 2; !lock && again < 100; ++again) {
        session.autosave = session.folder / ("autosave-" + name + ".json");
        // A file there is of an earlier process of this number, and still to be recovered.
        if (!holds_anything(session)) lock = try_lock(session.folder / (name + ".lock"));
        name = std::to_string(getpid()) + "-" + std::to_string(again);
    }
    if (lock) session.lock = std::make_shared<FileLock>(*std::move(lock));
}

}  // namespace

fs::path state_folder() {
    // Nothing changes the environment while the program runs.
    const char* state = std::getenv("XDG_STATE_HOME");  // NOLINT(concurrency-mt-unsafe)
    if (state != nullptr && state[0] == '/') return fs::path(state) / "tactspace";
    const char* home = std::getenv("HOME");  // NOLINT(concurrency-mt-unsafe)
    if (home != nullptr && home[0] == '/') return fs::path(home) / ".local/state/tactspace";
    return {};
}

fs::path crash_report_file() {
    const fs::path folder = state_folder();
    return folder.empty() ? fs::path{} : folder / "crash.txt";
}

Session open_session(const fs::path& folder) {
    Session session;
    session.folder = folder;
    if (folder.empty() || !make_folder(session)) return session;
    take_place(session);
    if (!session.lock) {
        session.remarks.push_back("Nothing will be kept after this run: " + folder.string() +
                                  " cannot be written.");
    }
    read_settings(session);
    session.crash_report = take_crash_report(folder / "crash.txt");
    if (!session.is_first) {
        session.document.clear();  // it is open in the other instance
        return session;
    }
    session.ended_in_crash = is_there(running_mark(folder));
    [[maybe_unused]] const auto marked =  // without it a crash is not told, and nothing is lost
        write_atomically(running_mark(folder), std::to_string(getpid()) + "\n");
    recover_orphans(session);
    return session;
}

Expected<Done> write_session(const Session& session) {
    if (session.folder.empty() || !session.is_first) return Done{};
    return write_atomically(settings_file(session.folder),
                            text_of_json(settings_of(session), 2) + "\n", kPrivateFile);
}

Expected<Done> close_session(Session& session) {
    release_document(session);
    Expected<Done> written = write_session(session);
    std::error_code none;
    if (session.is_first && !session.folder.empty()) {
        fs::remove(running_mark(session.folder), none);
    } else if (!session.folder.empty() && !holds_anything(session)) {
        fs::remove(lock_of(session.autosave), none);
    }
    session.lock.reset();
    return written;
}

void remember_file(Session& session, const fs::path& path) {
    std::error_code failure;
    const fs::path absolute = fs::absolute(path, failure).lexically_normal();
    const fs::path& kept = failure ? path : absolute;
    std::erase(session.recent_files, kept);
    session.recent_files.insert(session.recent_files.begin(), kept);
    if (session.recent_files.size() > kRecentFiles) session.recent_files.resize(kRecentFiles);
}

std::vector<RecentFile> recent_files(const Session& session) {
    std::vector<RecentFile> files;
    for (const fs::path& path : session.recent_files) files.push_back({path, !is_there(path)});
    return files;
}

fs::path measured_folder(const Session& session) {
    if (session.folder.empty()) return {};
    std::error_code none;
    return fs::weakly_canonical(session.folder / "measured", none);
}

void keep_private(const std::filesystem::path& folder) {
    namespace fs = std::filesystem;
    constexpr auto kOthers = fs::perms::group_all | fs::perms::others_all;
    const auto tighten = [](const fs::path& path) {
        std::error_code none;
        fs::permissions(path, kOthers, fs::perm_options::remove, none);
    };
    tighten(folder);
    std::error_code fault;
    for (fs::recursive_directory_iterator entry(folder, fault), end; !fault && entry != end;
         entry.increment(fault)) {
        std::error_code none;
        if (!entry->is_symlink(none)) tighten(entry->path());
    }
}

std::filesystem::path unused_file(const std::filesystem::path& folder, const std::string& prefix,
                                  const std::string& ending) {
    const std::time_t now = std::time(nullptr);
    const std::tm local = local_parts(now).value_or(std::tm{});
    std::array<char, 32> stamp{};
    std::strftime(stamp.data(), stamp.size(), "%Y%m%d-%H%M%S", &local);
    const std::string name = prefix + stamp.data();
    std::filesystem::path file = folder / (name + ending);
    for (int n = 2; is_there(file); ++n) {
        file = folder / (name + "-" + std::to_string(n) + ending);
    }
    return file;
}

}  // namespace tact
