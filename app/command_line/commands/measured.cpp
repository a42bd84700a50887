// tactspace import, tactspace measure: recordings of patterns, and simulated ones, beside them.

#include <iostream>
#include <nlohmann/json.hpp>

#include "app/command_line/commands.h"
#include "app/command_line/output.h"
#include "model/io/folders/path_json.h"
#include "model/io/set/load.h"
#include "model/io/set/measured_files.h"
#include "model/io/set/set_file.h"
#include "model/set/measured_twin.h"
#include "model/tasks/set_import.h"
#include "model/text/json_fields.h"
#include "model/text/numbers.h"
#include "model/text/shown_text.h"
#include "model/text/utf8.h"

namespace tact {

namespace {

namespace fs = std::filesystem;

// One twin, and where it came from.
struct Imported {
    std::string recording;
    std::string name;
    std::string pattern;
    double lag_s = 0.0;
    double correlation = 0.0;
    double gain_db = 0.0;
    double peak_g = 0.0;
    std::vector<std::string> remarks;
};

Expected<PatternSet> load_one(const fs::path& path) {
    CommonOptions options;
    options.sets = {path};
    return load_for(options);
}

Imported report_on(const std::string& recording, const std::string& name, const Twin& twin) {
    const Alignment& alignment = twin.alignment;
    Imported report;
    report.recording = recording;
    report.name = name;
    report.pattern = std::get<Measurement>(twin.vibration.source).measures;
    report.lag_s = static_cast<double>(alignment.lag) / alignment.waveform.rate_hz;
    report.correlation = alignment.correlation;
    report.gain_db = alignment.gain_db;
    report.peak_g = peak_g(alignment.waveform);
    report.remarks = remarks_on(alignment);
    return report;
}

// The pattern that a recording measures: the one asked for, or by its file's name.
Expected<std::size_t> measured_place(const PatternSet& set, const ImportCommand& command,
                                     const fs::path& recording) {
    if (!command.pattern.empty()) return place_of(set, command.pattern);
    const std::string stem = valid_utf8(recording.stem().string());
    if (const auto place = guessed_intended(set, stem)) return *place;
    return Error{recording.string() + ": no pattern, or more than one, has a name like " +
                 in_quotes(stem) + "; --pattern NAME says which it measures"};
}

Expected<Imported> import_one(PatternSet& set, const ImportCommand& command, const fs::path& path) {
    const auto place = measured_place(set, command, path);
    if (!place) return place.error();
    auto read = read_twin(set, *place, path, command.recordings, command.options);
    if (!read) return read.error();
    const std::size_t at = insert_twin(set, read->twin->vibration);
    Imported report = report_on(path.string(), set.vibrations[at].name, *read->twin);
    report.remarks = std::move(read->remarks);
    return report;
}

std::string text_of(const std::vector<Imported>& all) {
    std::string text;
    for (const Imported& one : all) {
        const std::string numbers = "lag " + significant_digits(one.lag_s, 4) + " s, correlation " +
                                    fixed_digits(one.correlation, 3) + ", gain " +
                                    (one.gain_db < 0.0 ? "" : "+") + fixed_digits(one.gain_db, 1) +
                                    " dB, peak " + significant_digits(one.peak_g, 3) + " g";
        text += shown_text(one.name) + ": " +
                (one.recording.empty() ? "" : shown_text(one.recording) + ", ") + numbers;
        for (const std::string& remark : one.remarks) text += "; " + remark;
        text += "\n";
    }
    return text;
}

nlohmann::json json_of(const Imported& one, bool synthetic) {
    nlohmann::json fields = {
        {"name", one.name},       {"measures", one.pattern},        {"synthetic", synthetic},
        {"lag_s", one.lag_s},     {"correlation", one.correlation}, {"peak_g", one.peak_g},
        {"gain_db", one.gain_db}, {"remarks", one.remarks}};
    if (!one.recording.empty()) fields["recording"] = path_json(one.recording);
    return fields;
}

// The waveforms first: a set file never names a file that is not there.
Expected<Done> finish(PatternSet set, const fs::path& out, const std::vector<Imported>& all,
                      bool synthetic, bool json) {
    if (set.vibrations.size() > limits::kMaxPatterns) {
        return Error{"expected at most 10,000 patterns in all, got more with their twins"};
    }
    const Expected<Done> stored = store_measurements(set, out);
    if (!stored) return stored;
    const Expected<Done> written = write_set_file(out, set);
    if (!written) return written;
    return write_result({}, [&](std::ostream& stream) {
        if (!json) {
            stream << text_of(all);
            return;
        }
        nlohmann::json list = nlohmann::json::array();
        for (const Imported& one : all) list.push_back(json_of(one, synthetic));
        stream << text_of_json(list) << "\n";
    });
}

}  // namespace

Expected<Done> run(const ImportCommand& command) {
    Expected<PatternSet> set = load_one(command.set);
    if (!set) return set.error();
    std::vector<Imported> all;
    for (const fs::path& path : command.recordings) {
        Expected<Imported> one = import_one(*set, command, path);
        if (!one) return one.error();
        all.push_back(*std::move(one));
    }
    return finish(*std::move(set), command.out, all, false, command.json);
}

Expected<Done> run(const MeasureCommand& command) {
    Expected<PatternSet> set = load_one(command.set);
    if (!set) return set.error();
    std::vector<std::size_t> places;
    if (!command.pattern.empty()) {
        const auto place = place_of(*set, command.pattern);
        if (!place) return place.error();
        places = {*place};
    }
    std::vector<Imported> all;
    for (const Twin& twin : synthetic_twins(*set, places, command.actuator)) {
        const std::size_t at = insert_twin(*set, twin.vibration);
        all.push_back(report_on("", set->vibrations[at].name, twin));
    }
    if (all.empty()) {
        return Error{command.set.string() + ": expected a pattern that is no measurement itself"};
    }
    return finish(*std::move(set), command.out, all, true, command.json);
}

}  // namespace tact
