// Writing a participant's file: line by line, each on the disk before the next.
#include <system_error>
#include <utility>

#include "model/io/people/study_file.h"
#include "model/io/people/study_lines.h"
#include "model/text/atomic_file.h"
#include "model/text/utf8.h"

namespace tact {

namespace fs = std::filesystem;

namespace {

Error not_written(const fs::path& path, std::error_code why) {
    return Error{path.string() + ": cannot be written: " + why.message()};
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
    std::error_code fault;
    OpenFile file(path, FileUse::make, mode_of_new(path, 0666), fault);
    if (fault == std::errc::file_exists) {
        return Error{path.string() + ": is there already, expected another code for participant " +
                     in_quotes(header.participant.code)};
    }
    if (fault) return not_written(path, fault);
    StudyLog log(path, std::move(file));
    log.file_.lock();
    if (auto written = log.append(header_line(header)); !written) {
        remove_at_once(path.c_str());
        return written.error();
    }
    sync_folder_of(path);
    return log;
}

Expected<StudyLog> StudyLog::resume(const fs::path& path, const StudyRecord& record) {
    Expected<OpenFile> file = open_alone(path, false);
    if (!file) return file.error();
    StudyLog log(path, *std::move(file));
    // Read under the lock: what is appended to is what the person is asked from.
    const Expected<std::string> text = read_text_file(path);
    if (!text) return text.error();
    const Expected<StudyRecord> now = parse_study(*text, path.string());
    if (!now) return now.error();
    if (now->header != record.header || now->devices != record.devices ||
        answers_given(*now) != answers_given(record)) {
        return Error{path.string() + ": has changed meanwhile; expected the file as it was left"};
    }
    const std::size_t end = whole_lines(*text);
    const bool lacks_only_its_end = !now->is_torn && end < text->size();
    const std::error_code fault = lacks_only_its_end ? log.file_.write("\n") : log.file_.cut(end);
    if (fault) return not_written(path, fault);
    return log;
}

Expected<Done> StudyLog::append(const std::string& line) {
    std::error_code none;
    const std::uint64_t end = file_.facts(none).bytes;
    std::error_code fault = file_.write(line + "\n");
    if (!fault) fault = file_.sync_content();
    if (!fault) return Done{};
    // A second try must not follow half a line.
    if (!none) file_.cut(end);
    return not_written(path_, fault);
}

}  // namespace tact
