// Writing a participant's file: line by line, each on the disk before the next.
#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>
#include <utility>

#include "model/io/people/study_file.h"
#include "model/io/people/study_lines.h"
#include "model/text/atomic_file.h"
#include "model/text/utf8.h"

namespace tact {

namespace fs = std::filesystem;

namespace {

Error system_fault(const fs::path& path, const std::string& what) {
    return Error{path.string() + ": " + what + ": " + std::generic_category().message(errno)};
}

// Bytes of the text up to the end of its last whole line.
std::size_t whole_lines(std::string_view text) {
    const std::size_t last = text.rfind('\n');
    return last == text.npos ? 0 : last + 1;
}

}  // namespace

std::string study_file_name(const std::string& participant) {
    std::string name;
    bool is_good = false;
    for (const char sign : participant) {
        const bool is_plain = (sign >= 'a' && sign <= 'z') || (sign >= 'A' && sign <= 'Z') ||
                              (sign >= '0' && sign <= '9');
        is_good = is_good || is_plain;
        name += is_plain || sign == '-' ? sign : '_';
    }
    return is_good ? name + kStudyEnding : "";
}

Expected<Done> write_study_file(const fs::path& path, const StudyRecord& record) {
    auto log = StudyLog::begin(path, record.header);
    if (!log) return log.error();
    std::string lines = print_study(record);
    lines.erase(0, lines.find('\n') + 1);
    if (lines.empty()) return Done{};
    lines.pop_back();  // the end of the last line is the log's to write
    return log->append(lines);
}

Expected<StudyLog> StudyLog::begin(const fs::path& path, const StudyHeader& header) {
    const int descriptor = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_APPEND | O_CLOEXEC,
                                  mode_of_new(path, 0666));
    if (descriptor < 0 && errno == EEXIST) {
        return Error{path.string() + ": is there already, expected another code for participant " +
                     in_quotes(header.participant.code)};
    }
    if (descriptor < 0) return system_fault(path, "cannot be written");
    StudyLog log(path, descriptor);
    ::flock(descriptor, LOCK_EX | LOCK_NB);
    if (auto written = log.append(header_line(header)); !written) {
        ::unlink(path.c_str());
        return written.error();
    }
    sync_folder_of(path);
    return log;
}

Expected<StudyLog> StudyLog::resume(const fs::path& path, const StudyRecord& record) {
    const Expected<int> descriptor = open_alone(path, false);
    if (!descriptor) return descriptor.error();
    StudyLog log(path, *descriptor);
    // Read under the lock: what is appended to is what the person is asked from.
    const Expected<std::string> text = read_text_file(path);
    if (!text) return text.error();
    const Expected<StudyRecord> now = parse_study(*text, path.string());
    if (!now) return now.error();
    if (now->header != record.header || now->devices != record.devices ||
        answers_given(*now) != answers_given(record)) {
        return Error{path.string() + ": has changed meanwhile; expected the file as it was left"};
    }
    std::size_t end = whole_lines(*text);
    if (now->is_torn || end == text->size()) {
        if (::ftruncate(*descriptor, static_cast<off_t>(end)) != 0) {
            return system_fault(path, "cannot be written");
        }
    } else if (!write_all(*descriptor, "\n")) {  // all there but the end of the line
        return system_fault(path, "cannot be written");
    }
    return log;
}

Expected<Done> StudyLog::append(const std::string& line) {
    const off_t end = ::lseek(descriptor_, 0, SEEK_END);
    if (write_all(descriptor_, line + "\n") && ::fdatasync(descriptor_) == 0) return Done{};
    Error fault = system_fault(path_, "cannot be written");
    // A second try must not follow half a line.
    [[maybe_unused]] const int cut = end < 0 ? 0 : ::ftruncate(descriptor_, end);
    return fault;
}

StudyLog::StudyLog(StudyLog&& other) noexcept
    : path_(std::move(other.path_)), descriptor_(std::exchange(other.descriptor_, -1)) {}

StudyLog::~StudyLog() {
    if (descriptor_ >= 0) ::close(descriptor_);
}

}  // namespace tact
