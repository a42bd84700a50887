#include "model/io/set/model_file.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "model/common/fingerprint.h"
#include "model/io/set/model_json.h"
#include "model/text/atomic_file.h"
#include "model/text/json_fields.h"
#include "model/text/numbers.h"
#include "model/text/utc_time.h"

namespace tact {

namespace {

constexpr const char* kFormatKey = "tactspace_model";
constexpr Range kCount{0, 1e15};

// JSON has no NaN: a rho that is undefined is null, and comes back as NaN.
double rho_field(JsonObject& object, std::string_view key) {
    const Json* value = field(object, key);
    if (value == nullptr || value->is_null()) return std::nan("");
    return number_field(object, key, 0.0, {-1.0, 1.0});
}

TrainedOn trained_on(JsonObject object) {
    TrainedOn set;
    set.name = name_field(object, "name", {});
    set.fingerprint = name_field(object, "fingerprint", {});
    const auto count = [&](const char* key) {
        return static_cast<std::size_t>(number_field(object, key, 0.0, kCount));
    };
    set.patterns = count("patterns");
    set.rated_pairs = count("rated_pairs");
    set.participants = count("participants");
    set.mark.synthetic = yes_no_field(object, "synthetic", false);
    set.mark.left_out = count("left_out");
    set.mark.rehearsals = count("rehearsals");
    set.rho_before = rho_field(object, "rho_before");
    set.rho_after = rho_field(object, "rho_after");
    set.felt = text_field(object, "felt", {});
    (void)unknown_fields(object);
    return set;
}

TrainingRecord record_in(JsonObject object) {
    constexpr std::size_t kMostSets = 10'000;
    TrainingRecord record;
    record.program = name_field(object, "program", {});
    record.date = name_field(object, "date", {});
    record.objective =
        static_cast<TrainingObjective>(choice_field(object, "objective", 0, kObjectiveNames));
    record.step = number_field(object, "step", record.step, {1e-6, 1.0});
    record.value = rho_field(object, "value");
    record.value_before = rho_field(object, "value_before");
    record.equally_good =
        static_cast<std::uint64_t>(number_field(object, "equally_good", 0.0, kCount));
    const std::string place = place_of(object, "sets");
    const auto sets = array_field(object, "sets", 0, kMostSets);
    for (std::size_t k = 0; k < sets.size(); ++k) {
        record.sets.push_back(
            trained_on(object_at(*object.reading, *sets[k], place + "/" + std::to_string(k))));
    }
    (void)yes_no_field(object, "synthetic", false);  // says what the sets say
    (void)unknown_fields(object);
    return record;
}

Json json_of(const TrainingRecord& record) {
    Json sets = Json::array();
    for (const TrainedOn& set : record.sets) {
        sets.push_back({{"name", set.name},
                        {"fingerprint", set.fingerprint},
                        {"patterns", set.patterns},
                        {"rated_pairs", set.rated_pairs},
                        {"participants", set.participants},
                        {"rho_before", set.rho_before},
                        {"rho_after", set.rho_after}});
        if (set.mark.synthetic) sets.back()["synthetic"] = true;
        if (set.mark.left_out > 0) sets.back()["left_out"] = set.mark.left_out;
        if (set.mark.rehearsals > 0) sets.back()["rehearsals"] = set.mark.rehearsals;
        if (!set.felt.empty()) sets.back()["felt"] = set.felt;
    }
    Json fields = {{"program", record.program},
                   {"date", record.date},
                   {"objective", kObjectiveNames[static_cast<std::size_t>(record.objective)]},
                   {"step", record.step},
                   {"value", record.value},
                   {"value_before", record.value_before},
                   {"equally_good", record.equally_good},
                   {"sets", sets}};
    if (is_partly_synthetic(record)) fields["synthetic"] = true;
    return fields;
}

constexpr std::size_t kNamedSets = 3;

std::string words_on(const TrainingRecord& record) {
    std::string sets;
    for (std::size_t k = 0; k < std::min(record.sets.size(), kNamedSets); ++k) {
        const TrainedOn& set = record.sets[k];
        sets += (k == 0 ? "" : "; ") + set.name + " (" +
                counted(set.patterns, "pattern", "patterns") + ", " +
                counted(set.rated_pairs, "pair", "pairs") + ", " +
                counted(set.participants, "person", "people") +
                (set.mark.left_out > 0 ? ", " + left_out_text(set.mark) : "") +
                (set.mark.synthetic ? ", synthetic: nobody was asked)" : ")");
    }
    if (record.sets.size() > kNamedSets) {
        sets += " and " + std::to_string(record.sets.size() - kNamedSets) + " more";
    }
    const std::string day = record.date.substr(0, record.date.find('T'));
    const bool absolute = record.objective == TrainingObjective::mean_absolute_rho;
    return "Trained on " + sets + (day.empty() ? "" : ", " + day) + ": mean " +
           (absolute ? "|rho| " : "rho ") + fixed_digits(record.value, 3) + ", was " +
           fixed_digits(record.value_before, 3) + ".";
}

}  // namespace

bool is_partly_synthetic(const TrainingRecord& record) {
    return std::ranges::any_of(record.sets,
                               [](const TrainedOn& set) { return set.mark.synthetic; });
}

std::string remark_on_synthetic(const ModelOrigin& origin) {
    return origin.synthetic ? "trained on synthetic ratings: nobody was asked" : "";
}

std::string remark_on_synthetic(const ModelFile& file) {
    return remark_on_synthetic(origin_of(file));
}

ModelOrigin origin_of(const ModelFile& file) {
    if (!file.training) return {};
    return {words_on(*file.training), is_partly_synthetic(*file.training), false};
}

std::string fingerprint_of(const TrainingSet& set) {
    std::uint64_t number = 0;
    for (const Waveform& waveform : set.waveforms) {
        number = mixed(number, std::span(waveform.samples_g));
    }
    for (const Judgement& judgement : set.study.judgements) {
        number = mixed(number, std::span<const double>(judgement.condensed));
    }
    return fingerprint_text(number);
}

TrainingRecord record_of(const Training& training, std::span<const TrainingSet> sets,
                         const std::string& program) {
    TrainingRecord record;
    record.program = program;
    record.date = utc_now();
    record.objective = training.objective;
    record.step = 1.0 / training.grid.units;
    record.value = training.best.value;
    record.value_before = training.value_before;
    record.equally_good = training.best.combinations;
    for (std::size_t s = 0; s < sets.size(); ++s) {
        const TrainedSet& trained = training.sets[s];
        record.sets.push_back({trained.name, fingerprint_of(sets[s]), trained.patterns,
                               trained.rated_pairs, participant_means(sets[s].study).size(),
                               trained.rho_before, trained.rho_after, mark_of(sets[s].study),
                               sets[s].study.fingerprint});
    }
    return record;
}

Expected<ModelFile> parse_model(std::string_view text, const std::string& file) {
    const auto document = parse_json(text, file);
    if (!document) return document.error();
    JsonReading reading{file, {}, UnknownKeys::refused};
    JsonObject object = object_at(reading, *document, "");
    const int format = whole_field(object, kFormatKey, 0, {0, 1'000'000});
    if (reading.fault.empty() && format == 0) {
        return Error{file + ": is no file of model parameters, expected \"" + kFormatKey +
                     "\": " + std::to_string(kModelFormat)};
    }
    if (reading.fault.empty() && format > kModelFormat) {
        return Error{file + ": made by a newer version (format " + std::to_string(format) +
                     ", this one reads " + std::to_string(kModelFormat) + ")"};
    }
    ModelFile result;
    JsonObject model = object_field(object, "model");
    Json unknown = Json::object();
    result.model = model_of(model, unknown);
    JsonObject training = object_field(object, "training");
    if (training.value != nullptr) result.training = record_in(training);
    (void)unknown_fields(object);
    if (!reading.fault.empty()) return Error{reading.fault};
    return result;
}

std::string print_model(const ModelFile& file) {
    Json document = {{kFormatKey, kModelFormat}, {"model", json_of(file.model)}};
    if (file.training) document["training"] = json_of(*file.training);
    return text_of_json(document, 2) + "\n";
}

Expected<ModelFile> read_model_file(const std::filesystem::path& path) {
    const auto text = read_text_file(path);
    if (!text) return text.error();
    return parse_model(*text, path.string());
}

Expected<Done> write_model_file(const std::filesystem::path& path, const ModelFile& file) {
    return write_atomically(path, print_model(file));
}

}  // namespace tact
