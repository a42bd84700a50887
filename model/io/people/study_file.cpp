#include "model/io/people/study_file.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <system_error>
#include <unordered_map>
#include <utility>

#include "model/io/people/exclusions_file.h"
#include "model/io/people/ratings_text.h"
#include "model/io/people/study_lines.h"
#include "model/io/recordings/recording.h"
#include "model/text/atomic_file.h"
#include "model/text/json_fields.h"
#include "model/text/names.h"
#include "model/text/utf8.h"

namespace tact {

namespace fs = std::filesystem;

namespace {

Expected<std::vector<fs::path>> study_files(const fs::path& folder) {
    std::vector<fs::path> files;
    std::error_code fault;
    for (fs::directory_iterator entry(folder, fault), end; !fault && entry != end;
         entry.increment(fault)) {
        if (extension_of(entry->path()) == kStudyEnding) files.push_back(entry->path());
    }
    if (fault) return Error{folder.string() + ": cannot be read: " + fault.message()};
    std::ranges::sort(files, [](const fs::path& a, const fs::path& b) {
        return naturally_before(a.stem().string(), b.stem().string());
    });
    return files;
}

// Who is excluded in the folder; what is wrong with that, or empty.
std::string take_exclusions(const fs::path& folder, std::vector<StudyRecord>& records) {
    const auto exclusions = read_exclusions(folder);
    if (!exclusions) return exclusions.error().message;
    for (const Exclusion& one : *exclusions) {
        const auto found = std::ranges::find_if(records, [&one](const StudyRecord& record) {
            return record.header.participant.code == one.participant;
        });
        if (found == records.end()) {
            return (folder / kExclusionsFile).string() +
                   ": expected participants of the folder, got " + in_quotes(one.participant);
        }
        found->excluded = one.because;
    }
    return {};
}

// One participant without the others of their folder.
Expected<std::vector<StudyRecord>> read_alone(const fs::path& path) {
    Expected<StudyRecord> record = read_study_file(path);
    if (!record) return record.error();
    const auto exclusions = read_exclusions(path.parent_path());
    if (!exclusions) return exclusions.error();
    for (const Exclusion& one : *exclusions) {
        if (one.participant == record->header.participant.code) record->excluded = one.because;
    }
    return std::vector<StudyRecord>{*std::move(record)};
}

bool is_numbered(const Json& line) { return line.contains("trial") || line.contains("round"); }

// How often a participant has answered; what is too often is refused as it is read, as comparing
// every answer to a pair with every other takes the square of them.
struct AnswerCount {
    std::unordered_map<std::size_t, std::size_t> of_pair;
    std::unordered_map<std::string, std::size_t> line_of;  // of each numbered answer

    // What is wrong with a line of the file, or empty. The same number, answer and moment again is
    // one answer that a copy has doubled; without a number it may be a second repetition.
    std::string take_line(const Json& fields, std::size_t line) {
        if (!is_numbered(fields)) return {};
        const auto [known, is_new] = line_of.emplace(text_of_json(fields), line);
        if (is_new) return {};
        return "expected each answer once, got that of line " + std::to_string(known->second) +
               " again";
    }

    // What is wrong with the last answer of the record, or empty.
    std::string take_last(const StudyRecord& record) {
        if (record.sortings.size() > kMaxPasses) return "expected at most 100 rounds of sorting";
        if (record.answers.empty() || answered_ == record.answers.size()) return {};
        answered_ = record.answers.size();
        const auto& trial = record.answers.back().trial;
        const auto [first, second] = std::minmax(trial.left, trial.right);
        const std::size_t key = first * (kMaxRatedPatterns + 1) + second;
        if (++of_pair[key] <= kMaxPasses) return {};
        return "expected at most 100 ratings of a pair by a participant";
    }

  private:
    std::size_t answered_ = 0;
};

}  // namespace

std::string print_study(const StudyRecord& record) {
    std::string text = header_line(record.header) + "\n";
    auto change = record.devices.begin();
    const auto add = [&text](const std::string& line) { text += line + "\n"; };
    for (std::size_t k = 0; k <= answers_given(record); ++k) {
        for (; change != record.devices.end() && change->before <= k; ++change) {
            add(device_line(*change));
        }
        if (k == answers_given(record)) break;
        add(record.header.kind == StudyKind::pairwise
                ? answer_line(record.header, k, record.answers[k])
                : answer_line(record.header, k, record.sortings[k]));
    }
    return text;
}

Expected<StudyRecord> parse_study(std::string_view text, const std::string& file) {
    StudyRecord record;
    AnswerCount count;
    std::size_t line = 0;
    bool has_header = false;
    std::string_view rest = without_bom(text);
    while (!rest.empty()) {
        const std::size_t end = rest.find('\n');
        const std::string_view content = rest.substr(0, end);
        const bool is_last = end == rest.npos;
        rest.remove_prefix(is_last ? rest.size() : end + 1);
        ++line;
        const std::string place = file + ":" + std::to_string(line);
        if (content.find_first_not_of(" \t\r") == content.npos) continue;
        const Expected<Json> value = parse_json(content, place);
        // Torn in the middle of a write; a whole line that is wrong is another matter.
        if (!value && is_last && has_header) {
            record.is_torn = true;
            break;
        }
        if (!value) return value.error();
        std::string fault;
        if (has_header) {
            fault = take_line(record, *value, place);
            std::string often = fault.empty() ? count.take_last(record) : "";
            if (fault.empty() && often.empty()) often = count.take_line(*value, line);
            if (!often.empty()) fault = place + ": " + often;
        } else {
            fault = take_header(record, *value, place);
            has_header = true;
        }
        if (!fault.empty()) return Error{fault};
    }
    if (!has_header) return Error{file + ": is empty, expected the study of a participant"};
    return record;
}

Expected<StudyRecord> read_study_file(const fs::path& path) {
    const Expected<std::string> text = read_text_file(path);
    if (!text) return text.error();
    return parse_study(*text, path.string());
}

bool contains_study(const fs::path& folder) {
    const Expected<std::vector<fs::path>> files = study_files(folder);
    return files && !files->empty();
}

Expected<std::vector<StudyRecord>> read_study_folder(const fs::path& folder) {
    const Expected<std::vector<fs::path>> files = study_files(folder);
    if (!files) return files.error();
    if (files->empty()) {
        return Error{folder.string() + ": expected .jsonl files of participants, got none"};
    }
    std::vector<StudyRecord> records;
    for (const fs::path& file : *files) {
        Expected<StudyRecord> record = read_study_file(file);
        if (!record) return record.error();
        records.push_back(*std::move(record));
    }
    if (const std::string fault = take_exclusions(folder, records); !fault.empty()) {
        return Error{fault};
    }
    return records;
}

std::vector<StudyRecord> study_heads(const fs::path& folder) {
    std::vector<StudyRecord> heads;
    const Expected<std::vector<fs::path>> files = study_files(folder);
    if (!files) return heads;
    for (const fs::path& file : *files) {
        std::ifstream stream(file, std::ios::binary);
        std::string line;
        if (!std::getline(stream, line)) continue;
        Expected<StudyRecord> head = parse_study(line, file.string());
        if (head) heads.push_back(*std::move(head));
    }
    return heads;
}

std::vector<std::string> changes_on_disk(const fs::path& folder, const StudyHeader& now) {
    std::vector<StudyRecord> heads = study_heads(folder);
    std::erase_if(heads, [&now](const StudyRecord& head) { return head.header.kind != now.kind; });
    const StudyRecord* founder = founder_of(heads);
    return founder == nullptr ? std::vector<std::string>{} : changes_since(founder->header, now);
}

bool is_study(const fs::path& path) {
    std::error_code none;
    return fs::is_directory(path, none) ? contains_study(path) : extension_of(path) == kStudyEnding;
}

Expected<std::vector<StudyRecord>> read_studies(std::span<const fs::path> paths) {
    std::vector<StudyRecord> all;
    for (const fs::path& path : paths) {
        std::error_code none;
        auto records = fs::is_directory(path, none) ? read_study_folder(path) : read_alone(path);
        if (!records) return records;
        std::ranges::move(*records, std::back_inserter(all));
    }
    return all;
}

// Writing a participant's file: line by line, each on the disk before the next.

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
