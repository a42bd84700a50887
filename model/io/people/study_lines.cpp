#include "model/io/people/study_lines.h"

#include <algorithm>
#include <charconv>
#include <nlohmann/json.hpp>
#include <string_view>

#include "model/io/set/study_json.h"
#include "model/text/json_fields.h"
#include "model/text/names.h"

namespace tact {

namespace {

constexpr const char* kKinds[] = {"pairwise", "sorting"};
constexpr const char* kFeltFirst[] = {"unknown", "left", "right"};
constexpr Range kPlays{0, 1e6};
constexpr Range kSeconds{0, 1e9};
constexpr Range kTurnedDownDb{0, 1000};
constexpr Range kBufferMs{0, 1e6};
constexpr Range kSerial{1, 1e6};  // of a trial or a round; nobody answers more

Json json_of(const StudyDevice& device) {
    Json fields = {{"name", device.name}, {"calibration", device.calibration}};
    if (!device.masking.empty()) fields["masking"] = device.masking;
    if (device.buffer_ms > 0.0) fields["buffer_ms"] = device.buffer_ms;
    if (is_rehearsal(device)) fields["rehearsal"] = true;
    return fields;
}

StudyDevice device_in(JsonObject object) {
    return {name_field(object, "name", ""), name_field(object, "calibration", ""),
            name_field(object, "masking", ""), number_field(object, "buffer_ms", 0.0, kBufferMs)};
}

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
    if (!header.versions.empty()) fields["set"]["versions"] = header.versions;
    fields["device"] = json_of(header.device);
    // As text: JSON's numbers are doubles to many readers.
    fields["seed"] = std::to_string(header.seed);
    fields["patterns"] = header.patterns;
    fields["design"] = json_of(header.design);
    fields["design"]["attention_pairs"] = header.design.attention_pairs;
    return fields;
}

std::uint64_t seed_field(JsonObject& object) {
    const std::string text = text_field(object, "seed", "1");
    std::uint64_t seed = 0;
    const char* const end = text.data() + text.size();
    const auto [last, fault] = std::from_chars(text.data(), end, seed);
    if (fault != std::errc() || last != end) {
        refuse(*object.reading, place_of(object, "seed"), "a whole number below 2^64", Json(text));
    }
    return seed;
}

Participant participant_of(JsonObject& object) {
    Participant participant;
    JsonObject fields = object_field(object, "participant");
    participant.code = name_field(fields, "code", "");
    if (fields.value == nullptr) return participant;
    for (const auto& [key, value] : fields.value->items()) {
        if (key == "code" || !value.is_string()) continue;
        participant.fields.emplace_back(key, text_field(fields, key, ""));
    }
    return participant;
}

std::vector<std::string> patterns_of(JsonObject& object) {
    std::vector<std::string> names;
    if (field(object, "patterns") == nullptr) {
        refuse(*object.reading, place_of(object, "patterns"), "names of patterns", nullptr);
    }
    for (const Json* name : array_field(object, "patterns", 2, limits::kMaxStudyPatterns)) {
        if (!name->is_string()) {
            refuse(*object.reading, place_of(object, "patterns"), "names of patterns", *name);
            return names;
        }
        names.push_back(name_at(*object.reading, *name, place_of(object, "patterns")));
    }
    if (const auto equal = first_equal(names)) {
        refuse(*object.reading, place_of(object, "patterns"), "names that differ",
               Json(names[equal->second]));
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
    header.set_name = name_field(set, "name", "");
    header.set_fingerprint = name_field(set, "fingerprint", "");
    header.device = device_in(object_field(object, "device"));
    header.seed = seed_field(object);
    header.patterns = patterns_of(object);
    for (const Json* version : array_field(set, "versions", 0, limits::kMaxStudyPatterns)) {
        header.versions.push_back(name_at(reading, *version, place_of(set, "versions")));
    }
    if (!header.versions.empty() && header.versions.size() != header.patterns.size()) {
        refuse(reading, place_of(set, "versions"), "a version for each pattern",
               *field(set, "versions"));
    }
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

PlaysReport plays_report(JsonObject object) {
    return {whole_field(object, "broken", 0, kPlays), whole_field(object, "dropouts", 0, kPlays),
            number_field(object, "turned_down_db", 0.0, kTurnedDownDb)};
}

// Nothing where there is nothing to be said.
void note_report(Json& fields, const char* key, const PlaysReport& report) {
    if (report == PlaysReport{}) return;
    fields[key] = {{"broken", report.broken},
                   {"dropouts", report.dropouts},
                   {"turned_down_db", report.turned_down_db}};
}

PairAnswer pair_answer_of(JsonObject& object, const StudyHeader& header) {
    PairAnswer answer;
    whole_field(object, "trial", 1, kSerial);
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
    answer.left = plays_report(object_field(object, "left_plays"));
    answer.right = plays_report(object_field(object, "right_plays"));
    answer.broken_in_training = whole_field(object, "broken_in_training", 0, kPlays);
    answer.first = static_cast<FeltFirst>(choice_field(object, "felt_first", 0, kFeltFirst));
    return answer;
}

// The group of every pattern; groups without patterns do not count.
Sorting groups_of(JsonObject& object, const StudyHeader& header) {
    Sorting sorting(header.patterns.size(), kUnsorted);
    const auto groups = array_field(object, "groups", 0, limits::kMaxStudyPatterns);
    std::size_t group = 0;
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
            std::size_t& own = sorting[static_cast<std::size_t>(found - header.patterns.begin())];
            if (own != kUnsorted) {
                refuse(*object.reading, place, "every pattern in one group, once", name);
            }
            own = group;
        }
        if (!groups[g]->empty()) ++group;
    }
    if (group == 0) {
        refuse(*object.reading, place_of(object, "groups"), "groups of patterns, one at least",
               Json(Json::array()));
    }
    return sorting;
}

SortingAnswer sorting_answer_of(JsonObject& object, const StudyHeader& header) {
    SortingAnswer answer;
    whole_field(object, "round", 1, kSerial);
    answer.asked_groups = whole_field(object, "asked_groups", 0, limits::kGroups);
    answer.groups = groups_of(object, header);
    answer.response_s = number_field(object, "response_s", 0.0, kSeconds);
    answer.at = text_field(object, "at", "");
    const auto plays = array_field(object, "plays", 0, limits::kMaxStudyPatterns);
    for (std::size_t k = 0; k < plays.size(); ++k) {
        const std::string place = place_of(object, "plays") + "/" + std::to_string(k);
        answer.plays.push_back(
            static_cast<int>(number_at(*object.reading, *plays[k], place, kPlays)));
    }
    if (!plays.empty() && plays.size() != header.patterns.size()) {
        refuse(*object.reading, place_of(object, "plays"), "a number for each pattern",
               plays.size());
    }
    answer.report = plays_report(object_field(object, "play_report"));
    return answer;
}

// Names of persons' making, such as of a device, may be no text.
std::string as_line(const Json& fields) { return text_of_json(fields); }

}  // namespace

std::string header_line(const StudyHeader& header) { return as_line(json_of_head(header)); }

std::string device_line(const DeviceChange& change) {
    return as_line({{"device", json_of(change.device)}, {"at", change.at}});
}

std::string answer_line(const StudyHeader& header, std::size_t serial, const PairAnswer& answer) {
    Json fields = {{"trial", serial + 1},
                   {"left", header.patterns[answer.trial.left]},
                   {"right", header.patterns[answer.trial.right]},
                   {"rating", answer.similarity},
                   {"plays_left", answer.plays_left},
                   {"plays_right", answer.plays_right},
                   {"response_s", answer.response_s},
                   {"at", answer.at}};
    if (answer.first != FeltFirst::unknown) {
        fields["felt_first"] = kFeltFirst[static_cast<std::size_t>(answer.first)];
    }
    note_report(fields, "left_plays", answer.left);
    note_report(fields, "right_plays", answer.right);
    if (answer.broken_in_training > 0) fields["broken_in_training"] = answer.broken_in_training;
    return as_line(fields);
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
    Json fields = {{"round", serial + 1},
                   {"asked_groups", answer.asked_groups},
                   {"groups", groups},
                   {"response_s", answer.response_s},
                   {"at", answer.at}};
    if (!answer.plays.empty()) fields["plays"] = answer.plays;
    note_report(fields, "play_report", answer.report);
    return as_line(fields);
}

std::string take_header(StudyRecord& record, const Json& value, const std::string& place) {
    JsonReading reading{place, {}};
    JsonObject object = object_at(reading, value, "");
    record.header = header_of(object);
    return reading.fault;
}

std::string take_line(StudyRecord& record, const Json& value, const std::string& place) {
    JsonReading reading{place, {}};
    JsonObject object = object_at(reading, value, "");
    const StudyHeader& header = record.header;
    if (field(object, "device") != nullptr) {
        const StudyDevice device = device_in(object_field(object, "device"));
        record.devices.push_back({answers_given(record), device, text_field(object, "at", "")});
    } else if (header.kind == StudyKind::pairwise) {
        PairAnswer answer = pair_answer_of(object, header);
        if (reading.fault.empty()) record.answers.push_back(std::move(answer));
    } else {
        SortingAnswer answer = sorting_answer_of(object, header);
        if (reading.fault.empty()) record.sortings.push_back(std::move(answer));
    }
    return reading.fault;
}

}  // namespace tact
