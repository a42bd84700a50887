#include "model/io/people/exclusions_file.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>
#include <utility>

#include "model/io/people/study_file.h"
#include "model/text/atomic_file.h"
#include "model/text/json_fields.h"
#include "model/text/utf8.h"

namespace tact {

namespace fs = std::filesystem;

namespace {

constexpr int kFormat = 1;

Exclusion exclusion_of(JsonObject& object) {
    Exclusion one{name_field(object, "participant", ""), text_field(object, "because", ""),
                  text_field(object, "at", "")};
    for (const auto& [key, text] :
         {std::pair{"participant", &one.participant}, std::pair{"because", &one.because}}) {
        if (text->empty()) refuse(*object.reading, place_of(object, key), "a text", Json(*text));
    }
    return one;
}

void refuse_twice(JsonReading& reading, const std::vector<Exclusion>& all) {
    std::set<std::string> seen;
    for (const Exclusion& one : all) {
        if (seen.insert(one.participant).second) continue;
        refuse(reading, "/excluded", "each participant once", Json(one.participant));
    }
}

// What is wrong with a name that is to be recorded or taken back, or empty.
std::string fault_of_names(const std::vector<StudyRecord>& records,
                           const std::vector<std::string>& names) {
    for (const std::string& name : names) {
        const bool is_there = std::ranges::any_of(records, [&name](const StudyRecord& record) {
            return record.header.participant.code == name;
        });
        if (!is_there) return "expected the name of a participant, got " + in_quotes(name);
    }
    return {};
}

}  // namespace

Expected<std::vector<Exclusion>> parse_exclusions(std::string_view text, const std::string& file) {
    const Expected<Json> document = parse_json(text, file);
    if (!document) return document.error();
    JsonReading reading{file, {}, UnknownKeys::refused};
    JsonObject object = object_at(reading, *document, "");
    if (whole_field(object, "tactspace_exclusions", 0, {0, 1e9}) != kFormat) {
        refuse(reading, "/tactspace_exclusions", std::to_string(kFormat),
               document->is_object() ? document->value("tactspace_exclusions", Json()) : Json());
    }
    std::vector<Exclusion> all;
    Json unknown = Json::object();
    read_objects(object, "excluded", 0, kMaxExclusions, unknown,
                 [&](JsonObject& one, Json&) { all.push_back(exclusion_of(one)); });
    (void)unknown_fields(object);
    refuse_twice(reading, all);
    if (!reading.fault.empty()) return Error{reading.fault};
    return all;
}

std::string print_exclusions(const std::vector<Exclusion>& exclusions) {
    Json document = {{"tactspace_exclusions", kFormat}, {"excluded", Json::array()}};
    for (const Exclusion& one : exclusions) {
        document["excluded"].push_back(
            {{"participant", one.participant}, {"because", one.because}, {"at", one.at}});
    }
    return text_of_json(document, 2) + "\n";
}

Expected<std::vector<Exclusion>> read_exclusions(const fs::path& folder) {
    const fs::path file = folder / kExclusionsFile;
    std::error_code none;
    // A link to nowhere is no missing file: who is meant would count.
    if (!fs::exists(fs::symlink_status(file, none))) return std::vector<Exclusion>{};
    const Expected<std::string> text = read_text_file(file);
    if (!text) return text.error();
    return parse_exclusions(*text, file.string());
}

Expected<std::vector<std::string>> record_exclusions(const fs::path& folder, const CountRule& rule,
                                                     const std::string& at) {
    std::vector<std::string> said;
    const bool records_any = !rule.because.empty() && !rule.exclude.empty();
    if (!records_any && rule.include.empty()) return said;
    const auto records = read_study_folder(folder);
    if (!records) return records.error();
    auto all = read_exclusions(folder);
    if (!all) return all.error();
    for (const auto* names : {&rule.include, &rule.exclude}) {
        if (const std::string fault = fault_of_names(*records, *names); !fault.empty()) {
            return Error{folder.string() + ": " + fault};
        }
    }
    const std::vector<Exclusion> before = *all;
    for (const std::string& name : rule.include) {
        if (std::erase_if(*all, [&](const Exclusion& one) { return one.participant == name; }) >
            0) {
            said.push_back(name + " is no longer recorded as excluded in " + folder.string());
        }
    }
    for (const std::string& name : records_any ? rule.exclude : std::vector<std::string>{}) {
        const auto known = std::ranges::find(*all, name, &Exclusion::participant);
        if (known != all->end() && known->because == rule.because) continue;
        if (known != all->end()) all->erase(known);
        all->push_back({name, rule.because, at});
        said.push_back(name + " is recorded as excluded in " + (folder / kExclusionsFile).string());
    }
    if (*all == before) return said;
    if (const auto written = write_atomically(folder / kExclusionsFile, print_exclusions(*all));
        !written) {
        return written.error();
    }
    return said;
}

}  // namespace tact
