#include "model/io/studies_out/psych_ds.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <sstream>

#include "model/io/people/study_csv.h"
#include "model/io/people/study_tables.h"
#include "model/io/set/set_file.h"
#include "model/text/csv.h"
#include "model/text/json_fields.h"
#include "model/text/names.h"
#include "model/text/numbers.h"

namespace tact {

namespace {

constexpr const char* kDescriptionFile = "dataset_description.json";

// A column in words; unit and levels where it has them.
struct Variable {
    const char* name;
    const char* description;
    const char* unit = "";
    std::vector<std::pair<const char*, const char*>> levels{};
};

using Levels = std::vector<std::pair<const char*, const char*>>;

const Levels& yes_no() {
    static const Levels levels{{"1", "yes"}, {"0", "no"}};
    return levels;
}

// All columns of answers and people in either kind of study, but for a participant's own fields.
const std::vector<Variable>& variables() {
    static const std::vector<Variable> all{
        {"participant", "Code of who was asked"},
        {"trial", "Place of the trial in this participant's session, from 1"},
        {"a", "Name of one pattern of the pair, the earlier in the set"},
        {"b", "Name of the other pattern of the pair"},
        {"side", "Which pattern was on the left", "", {{"a", "the first"}, {"b", "the second"}}},
        {"rating", "Similarity as it was given, 0 totally different to 100 totally the same",
         "points of 100"},
        {"replays", "How often a pattern was felt again"},
        {"response_s", "Time from the end of the trial's first play to the answer", "s"},
        {"attention", "The pair is a pattern with itself", "", yes_no()},
        {"round", "Round of sorting, from 1"},
        {"asked_groups", "Number of groups asked for; 0: as many as one likes"},
        {"group", "Group that the pattern was put into, from 1"},
        {"pattern", "Name of the pattern"},
        {"excluded", "The answer does not count", "", yes_no()},
        {"synthetic", "Nobody was asked: the answer was made by a program", "", yes_no()},
        {"rehearsal", "Nothing was felt", "", yes_no()},
        {"whole", "Both patterns were felt whole", "", yes_no()},
        {"why", "Reason for not counting; empty or NA: it counts"},
        {"device", "Name of the actuator"},
        {"fingerprint", "Fingerprint of the patterns that were felt"},
        {"at", "When the answer was given, UTC"},
        {"felt_first",
         "Which pattern was felt first",
         "",
         {{"a", "the first"}, {"b", "the second"}, {"NA", "not known"}}},
        {"scaling", "How this participant's similarities were scaled"},
        {"scaled", "Similarity after scaling", "points"},
        {"counted", "The participant counts", "", yes_no()},
        {"answers", "Number of answers"},
        {"wanted", "Number of answers of a whole session"},
        {"not_felt", "Answers about what was not felt whole"},
        {"identical",
         "Similarities that pairs of a pattern with itself were given, with blanks "
         "between",
         "points of 100"},
        {"minutes", "Time spent on answers", "min"},
        {"median_response_s", "Median of response_s", "s"},
        {"repeat_rho", "Spearman's rho between repetitions of the same pairs"},
        {"rho_with_others", "Spearman's rho with the mean of the others who count"},
        {"outlier", "rho_with_others is below Tukey's lower fence; counts all the same", "",
         yes_no()},
        {"begun", "When the session began, UTC"},
        {"calibration", "Calibration of the actuator"},
        {"masking", "Masking noise"},
        {"device_changes", "Number of actuators that were used"}};
    return all;
}

Json json_of(const Variable& variable) {
    Json json{
        {"@type", "PropertyValue"}, {"name", variable.name}, {"description", variable.description}};
    if (*variable.unit != '\0') json["unitText"] = variable.unit;
    for (const auto& [value, meaning] : variable.levels) {
        json["valueReference"].push_back(
            {{"@type", "DefinedTerm"}, {"termCode", value}, {"name", meaning}});
    }
    return json;
}

constexpr std::string_view kOwn = "own_";

Json described(const std::string& column) {
    const auto known = std::ranges::find(variables(), column, &Variable::name);
    if (known != variables().end()) return json_of(*known);
    if (column.starts_with(kOwn)) {
        return {{"@type", "PropertyValue"},
                {"name", column},
                {"description", "What participants were asked: " + column.substr(kOwn.size())}};
    }
    return {{"@type", "PropertyValue"}, {"name", column}, {"description", column}};
}

bool is_data(const DatasetFile& file) {
    return file.path.starts_with("data/") && file.path.ends_with(".csv");
}

std::vector<std::string> columns_of(const DatasetFile& file) {
    CsvReader reader{file.text};
    return next_record(reader).fields;
}

// The columns of all data files, each once, in the order in which they come.
std::vector<std::string> columns_of(const std::vector<DatasetFile>& files) {
    std::vector<std::string> all;
    for (const DatasetFile& file : files) {
        if (!is_data(file)) continue;
        for (const std::string& column : columns_of(file)) {
            if (std::ranges::find(all, column) == all.end()) all.push_back(column);
        }
    }
    return all;
}

std::string description_of(const StudyDataset& study) {
    const auto counted_people = std::ranges::count_if(
        study.results.people,
        [](const ParticipantSummary& person) { return person.excluded.empty(); });
    std::string text = study.results.kind == StudyKind::pairwise
                           ? "Ratings of how alike pairs of vibrations feel, by "
                           : "Vibrations sorted into groups by how alike they feel, by ";
    text += counted(study.results.people.size(), "participant", "participants") + "; " +
            std::to_string(counted_people) + (counted_people == 1 ? " counts." : " count.");
    if (study.results.mark.synthetic) {
        text += " SYNTHETIC: nobody was asked for some of the answers.";
    }
    if (study.results.mark.rehearsals > 0) text += " In rehearsals nothing was felt.";
    return text;
}

std::string readme_of(const StudyDataset& study) {
    return "# " + study.name + "\n\n" + description_of(study) +
           "\n\n- `data/`: the answers and the participants; every column is described in "
           "`dataset_description.json`. Who does not count is there, with `excluded` or `counted` "
           "and the reason.\n- `materials/`: the patterns that were felt, as a set of " +
           study.program +
           ".\n\nLicence, authors and contact are for those who publish this: add them to "
           "`dataset_description.json`.\n";
}

}  // namespace

std::vector<DatasetFile> psych_ds_files(const StudyDataset& study) {
    const std::string task = study.results.kind == StudyKind::pairwise ? "rating" : "sorting";
    const auto data = [&task](const char* what) {
        return "data/task-" + task + "_description-" + what + "_data.csv";
    };
    std::ostringstream answers;
    write_study_csv(answers, study.records, study.results, StudyRows::everyone);
    StudyTables tables;
    tables.records = study.records;
    tables.results = study.results;
    std::ostringstream people;
    write_participants_csv(people, tables);
    std::vector<DatasetFile> files{{data("answers"), answers.str()},
                                   {data("people"), people.str()}};
    files.push_back({"materials/" + file_stem(study.set.name.empty() ? "set" : study.set.name) +
                         ".tactspace.json",
                     print_set(study.set)});
    Json description{{"@context", "https://schema.org"},
                     {"@type", "Dataset"},
                     {"name", study.name},
                     {"description", description_of(study)},
                     {"dateCreated", study.date},
                     {"keywords", {"haptics", "vibration", "dissimilarity", "touch"}},
                     {"variableMeasured", Json::array()}};
    for (const std::string& column : columns_of(files)) {
        description["variableMeasured"].push_back(described(column));
    }
    files.push_back({kDescriptionFile, text_of_json(description, 2) + "\n"});
    files.push_back({"README.md", readme_of(study)});
    return files;
}

std::vector<std::string> psych_ds_faults(const std::vector<DatasetFile>& files) {
    std::vector<std::string> faults;
    const auto description = std::ranges::find(files, kDescriptionFile, &DatasetFile::path);
    if (description == files.end()) return {"expected dataset_description.json in the root"};
    const Json json = kept_json(description->text);
    if (!json.is_object()) return {"expected dataset_description.json to be an object of JSON"};
    const auto has = [&json](const char* key, const Json& value) {
        return json.contains(key) && json[key] == value;
    };
    if (!has("@context", "https://schema.org"))
        faults.emplace_back("expected schema.org's context");
    if (!has("@type", "Dataset")) faults.emplace_back("expected the type Dataset");
    for (const char* key : {"name", "description"}) {
        if (!json.contains(key) || !json[key].is_string() || json[key] == "") {
            faults.push_back(std::string("expected a text as ") + key);
        }
    }
    std::set<std::string> described;
    if (json.contains("variableMeasured") && json["variableMeasured"].is_array()) {
        for (const Json& one : json["variableMeasured"]) {
            if (one.is_string()) described.insert(one.get<std::string>());
            if (one.is_object()) described.insert(one.value("name", ""));
        }
    } else {
        faults.emplace_back("expected an array as variableMeasured");
    }
    static const std::regex kName("([a-z]+-[a-zA-Z0-9]+)(_[a-z]+-[a-zA-Z0-9]+)*_data\\.csv");
    std::size_t data_files = 0;
    for (const DatasetFile& file : files) {
        if (!is_data(file)) continue;
        const std::string name = file.path.substr(file.path.rfind('/') + 1);
        if (!std::regex_match(name, kName)) {
            faults.push_back("expected a name such as task-rating_data.csv, got " + name);
            continue;
        }
        ++data_files;
        for (const std::string& column : columns_of(file)) {
            if (!described.contains(column)) {
                faults.push_back("expected a description of the column " + column);
            }
        }
    }
    if (data_files == 0) faults.emplace_back("expected a data file below data");
    return faults;
}

}  // namespace tact
