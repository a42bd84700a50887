#include "model/io/people/study_file.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>

#include "model/io/recordings/recording.h"
#include "model/io/set/study_json.h"
#include "model/text/atomic_file.h"
#include "model/text/natural_order.h"
#include "model/text/utf8.h"

namespace tact {

namespace fs = std::filesystem;

namespace {

constexpr const char* kKinds[] = {"pairwise", "sorting"};
constexpr Range kPlays{0, 1e6};
constexpr Range kSeconds{0, 1e9};

Json json_of_head(const StudyHeader& header) {
    Json fields = {{"tactspace_study", kStudyFormat},
                   {"program", header.program},
                   {"kind", kKinds[static_cast<std::size_t>(header.kind)]},
                   {"synthetic", header.synthetic}};
    fields["participant"] = {{"code", header.participant.code}};
    for (const auto& [key, value] : header.participant.fields) {
        if (key != "code") fields["participant"][key] = value;
    }
    fields["consent"] = {{"given", header.consented}, {"text", consent_of(header.design)}};
    fields["begun"] = header.begun;
    fields["set"] = {{"name", header.set_name}, {"fingerprint", header.set_fingerprint}};
    fields["device"] = {{"name", header.device.name}, {"calibration", header.device.calibration}};
    if (!header.device.masking.empty()) fields["device"]["masking"] = header.device.masking;
    // As text: JSON's numbers are doubles to many readers.
    fields["seed"] = std::to_string(header.seed);
    fields["patterns"] = header.patterns;
    fields["design"] = json_of(header.design);
    return fields;
}

std::uint64_t seed_field(JsonObject& object) {
    const std::string text = text_field(object, "seed", "1");
    const bool is_number =
        !text.empty() && text.size() <= 20 && text.find_first_not_of("0123456789") == text.npos;
    if (!is_number) refuse(*object.reading, place_of(object, "seed"), "a whole number", Json(text));
    std::uint64_t seed = 0;
    for (const char digit : is_number ? text : "") {
        seed = 10 * seed + static_cast<std::uint64_t>(digit - '0');
    }
    return seed;
}

Participant participant_of(JsonObject& object) {
    Participant participant;
    JsonObject fields = object_field(object, "participant");
    participant.code = text_field(fields, "code", "");
    if (fields.value == nullptr) return participant;
    for (const auto& [key, value] : fields.value->items()) {
        if (key != "code" && value.is_string()) {
            participant.fields.emplace_back(key, value.get<std::string>());
        }
    }
    return participant;
}

std::vector<std::string> patterns_of(JsonObject& object) {
    std::vector<std::string> names;
    for (const Json* name : array_field(object, "patterns", 2, limits::kMaxStudyPatterns)) {
        if (!name->is_string()) {
            refuse(*object.reading, place_of(object, "patterns"), "names of patterns", *name);
            return names;
        }
        names.push_back(name->get<std::string>());
    }
    return names;
}

StudyHeader header_of(JsonObject& object) {
    StudyHeader header;
    JsonReading& reading = *object.reading;
    const int format = whole_field(object, "tactspace_study", 0, {0, 1e9});
    if (format != kStudyFormat && reading.fault.empty()) {
        reading.fault = reading.file +
                        ": expected the study of a participant, \"tactspace_study\": " +
                        std::to_string(kStudyFormat);
    }
    header.program = text_field(object, "program", "");
    header.kind = static_cast<StudyKind>(choice_field(object, "kind", 0, kKinds));
    header.synthetic = yes_no_field(object, "synthetic", false);
    header.participant = participant_of(object);
    JsonObject consent = object_field(object, "consent");
    header.consented = yes_no_field(consent, "given", false);
    const std::string consent_text = text_field(consent, "text", "");
    header.begun = text_field(object, "begun", "");
    JsonObject set = object_field(object, "set");
    header.set_name = text_field(set, "name", "");
    header.set_fingerprint = text_field(set, "fingerprint", "");
    JsonObject device = object_field(object, "device");
    header.device = {text_field(device, "name", ""), text_field(device, "calibration", ""),
                     text_field(device, "masking", "")};
    header.seed = seed_field(object);
    header.patterns = patterns_of(object);
    JsonObject design = object_field(object, "design");
    Json unknown = Json::object();
    header.design = study_design_of(design, unknown);
    // What the person agreed to stays, though a later version may say it otherwise.
    if (!consent_text.empty() && consent_text != consent_of(header.design)) {
        header.design.consent = consent_text;
    }
    return header;
}

// Position of a pattern named by a key.
std::size_t pattern_field(JsonObject& object, std::string_view key, const StudyHeader& header) {
    const std::string name = text_field(object, key, "");
    const auto found = std::ranges::find(header.patterns, name);
    if (found != header.patterns.end()) {
        return static_cast<std::size_t>(found - header.patterns.begin());
    }
    refuse(*object.reading, place_of(object, key), "the name of a pattern of the study",
           Json(name));
    return 0;
}

PairAnswer pair_answer_of(JsonObject& object, const StudyHeader& header) {
    PairAnswer answer;
    answer.trial.left = pattern_field(object, "left", header);
    answer.trial.right = pattern_field(object, "right", header);
    if (field(object, "rating") == nullptr) {
        refuse(*object.reading, place_of(object, "rating"), "a similarity from 0 to 100", Json());
    }
    answer.similarity = number_field(object, "rating", 0.0, limits::kSimilarity);
    answer.plays_left = whole_field(object, "plays_left", 0, kPlays);
    answer.plays_right = whole_field(object, "plays_right", 0, kPlays);
    answer.response_s = number_field(object, "response_s", 0.0, kSeconds);
    answer.at = text_field(object, "at", "");
    return answer;
}

SortingAnswer sorting_answer_of(JsonObject& object, const StudyHeader& header) {
    SortingAnswer answer;
    answer.groups.assign(header.patterns.size(), kUnsorted);
    answer.asked_groups = whole_field(object, "asked_groups", 0, limits::kGroups);
    const auto groups = array_field(object, "groups", 1, limits::kMaxStudyPatterns);
    for (std::size_t g = 0; g < groups.size(); ++g) {
        const std::string place = place_of(object, "groups") + "/" + std::to_string(g);
        if (!groups[g]->is_array()) refuse(*object.reading, place, "a list of names", *groups[g]);
        for (const Json& name : *groups[g]) {
            const std::string text = name.is_string() ? name.get<std::string>() : "";
            const auto found = std::ranges::find(header.patterns, text);
            if (found == header.patterns.end()) {
                refuse(*object.reading, place, "names of patterns of the study", name);
                continue;
            }
            answer.groups[static_cast<std::size_t>(found - header.patterns.begin())] = g;
        }
    }
    answer.response_s = number_field(object, "response_s", 0.0, kSeconds);
    answer.at = text_field(object, "at", "");
    return answer;
}

// One line after the first into the record; what is wrong with it, or empty.
std::string take_answer(StudyRecord& record, const Json& value, const std::string& place) {
    JsonReading reading{place, {}};
    JsonObject object = object_at(reading, value, "");
    const StudyHeader& header = record.header;
    if (header.kind == StudyKind::pairwise) {
        PairAnswer answer = pair_answer_of(object, header);
        if (reading.fault.empty()) record.answers.push_back(std::move(answer));
    } else {
        SortingAnswer answer = sorting_answer_of(object, header);
        if (reading.fault.empty()) record.sortings.push_back(std::move(answer));
    }
    return reading.fault;
}

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

}  // namespace

std::string header_line(const StudyHeader& header) { return json_of_head(header).dump(); }

std::string answer_line(const StudyHeader& header, std::size_t serial, const PairAnswer& answer) {
    const Json fields = {{"trial", serial + 1},
                         {"left", header.patterns[answer.trial.left]},
                         {"right", header.patterns[answer.trial.right]},
                         {"rating", answer.similarity},
                         {"plays_left", answer.plays_left},
                         {"plays_right", answer.plays_right},
                         {"response_s", answer.response_s},
                         {"at", answer.at}};
    return fields.dump();
}

std::string answer_line(const StudyHeader& header, std::size_t serial,
                        const SortingAnswer& answer) {
    Json groups = Json::array();
    for (std::size_t g = 0; g < answer.groups.size(); ++g) {
        Json names = Json::array();
        for (std::size_t k = 0; k < answer.groups.size(); ++k) {
            if (answer.groups[k] == g) names.push_back(header.patterns[k]);
        }
        if (!names.empty()) groups.push_back(names);
    }
    const Json fields = {{"round", serial + 1},
                         {"asked_groups", answer.asked_groups},
                         {"groups", groups},
                         {"response_s", answer.response_s},
                         {"at", answer.at}};
    return fields.dump();
}

Expected<StudyRecord> parse_study(std::string_view text, const std::string& file) {
    StudyRecord record;
    std::size_t line = 0;
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
        if (!value && is_last && line > 1) {
            record.is_torn = true;
            break;
        }
        if (!value) return value.error();
        if (line == 1) {
            JsonReading reading{place, {}};
            JsonObject object = object_at(reading, *value, "");
            record.header = header_of(object);
            if (!reading.fault.empty()) return Error{reading.fault};
            continue;
        }
        if (const std::string fault = take_answer(record, *value, place); !fault.empty()) {
            return Error{fault};
        }
    }
    if (line == 0) return Error{file + ": is empty, expected the study of a participant"};
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
    return records;
}

}  // namespace tact
