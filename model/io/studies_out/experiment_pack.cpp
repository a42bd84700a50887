#include "model/io/studies_out/experiment_pack.h"

#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "assets/assets.h"
#include "model/io/recordings/wave_file.h"
#include "model/io/tables/matrix_file.h"
#include "model/set/set_ratings.h"
#include "model/study/pairwise_study.h"
#include "model/text/json_fields.h"
#include "model/text/names.h"
#include "model/text/numbers.h"

namespace tact {

namespace {

struct Stimuli {
    std::vector<std::string> names;
    std::vector<std::string> files;  // below stimuli/
    double full_scale_g = 1.0;
};

Expected<Stimuli> add_stimuli(const PatternSet& set, std::vector<DatasetFile>& files) {
    Stimuli stimuli{study_patterns(set), {}, 0.0};
    std::vector<Waveform> waveforms;
    for (const std::string& name : stimuli.names) {
        waveforms.push_back(waveform_of(set.vibrations[*place_named(set, name)]));
        stimuli.full_scale_g = std::max(stimuli.full_scale_g, peak_g(waveforms.back()));
    }
    if (stimuli.full_scale_g == 0.0) stimuli.full_scale_g = 1.0;
    for (std::size_t k = 0; k < waveforms.size(); ++k) {
        char number[32];
        std::snprintf(number, sizeof number, "%02zu-", k + 1);
        stimuli.files.push_back(number + file_stem(stimuli.names[k]) + ".wav");
        Expected<WaveText> wave =
            wave_text(waveforms[k], {WaveEncoding::int16, stimuli.full_scale_g}, stimuli.names[k]);
        if (!wave) return wave.error();
        files.push_back({"stimuli/" + stimuli.files.back(), std::move(wave->bytes)});
    }
    return stimuli;
}

std::vector<Trial> trials_of(const StudyDesign& design, std::size_t patterns,
                             const std::string& participant) {
    return trial_list(plan_of(design, patterns, participant_seed(design.seed, participant)));
}

std::string trials_csv(const StudyDesign& design, const Stimuli& stimuli,
                       std::size_t participants) {
    std::string text = "participant,trial,left,right,left_file,right_file\n";
    for (std::size_t k = 1; k <= participants; ++k) {
        const std::string participant = packed_participant(k);
        std::size_t number = 0;
        for (const Trial& trial : trials_of(design, stimuli.names.size(), participant)) {
            text += participant + ',' + std::to_string(++number);
            for (const std::vector<std::string>* cells : {&stimuli.names, &stimuli.files}) {
                for (const std::size_t place : {trial.left, trial.right}) {
                    text += ',' + csv_field((*cells)[place]);
                }
            }
            text += '\n';
        }
    }
    return text;
}

Json study_json(const PatternSet& set, const Stimuli& stimuli, std::size_t participants) {
    Json json{{"name", set.name},
              {"fingerprint", study_fingerprint(set, stimuli.names)},
              {"patterns", stimuli.names},
              {"files", stimuli.files},
              {"full_scale_g", stimuli.full_scale_g},
              {"gap_s", set.study.gap_s},
              {"consent", consent_of(set.study)},
              {"instructions", instructions_of(set.study)}};
    for (std::size_t k = 1; k <= participants; ++k) {
        const std::string participant = packed_participant(k);
        Json trials = Json::array();
        for (const Trial& trial : trials_of(set.study, stimuli.names.size(), participant)) {
            trials.push_back({trial.left, trial.right});
        }
        json["participants"][participant] = trials;
    }
    return json;
}

std::string readme_of(PackFor what, const Stimuli& stimuli, std::size_t participants) {
    const std::string all = packed_participant(1) + " to " + packed_participant(participants);
    std::string text =
        "A study of how alike vibrations feel, pair by pair.\n\nThe stimuli are accelerations: "
        "full scale stands for " +
        significant_digits(stimuli.full_scale_g, 4) +
        " g, which a calibrated actuator reaches and others do not. Play them on the actuator's "
        "sound output, and keep its level: it decides what is felt.\n\n";
    if (what == PackFor::jspsych) {
        text +=
            "Make a folder jspsych here, and put jsPsych 7 or 8 into it: jspsych.js, jspsych.css, "
            "plugin-html-button-response.js and plugin-html-slider-response.js (of each package "
            "the file dist/index.browser.js, by these names). "
            "Serve this folder, and open experiment.html?participant=" +
            packed_participant(1) + " (" + all + "). At the end the browser saves the answers.\n";
    } else {
        text += "With PsychoPy installed: python experiment.py " + packed_participant(1) + " (" +
                all + "). The answers are written into answers/, line by line.\n";
    }
    return text +
           "\nThen:\n\n    tactspace study SET --unpack ANSWERS --out PEOPLE\n    tactspace study "
           "SET --collect PEOPLE --report REPORT\n\nANSWERS are the CSV files, or their folder. "
           "What was simulated stays marked synthetic.\n";
}

}  // namespace

std::string packed_participant(std::size_t number) {
    char code[32];
    std::snprintf(code, sizeof code, "P%02zu", number);
    return code;
}

Expected<std::vector<DatasetFile>> pack_files(const PatternSet& set, PackFor what,
                                              std::size_t participants) {
    const std::size_t patterns = study_patterns(set).size();
    if (patterns < 3) {
        return Error{"expected a study of three patterns at least, got " +
                     std::to_string(patterns)};
    }
    std::vector<DatasetFile> files;
    const Expected<Stimuli> stimuli = add_stimuli(set, files);
    if (!stimuli) return stimuli.error();
    const Json study = study_json(set, *stimuli, participants);
    files.push_back({"trials.csv", trials_csv(set.study, *stimuli, participants)});
    files.push_back({"study.json", text_of_json(study, 1) + "\n"});
    files.push_back({"README.txt", readme_of(what, *stimuli, participants)});
    if (what == PackFor::psychopy) {
        files.push_back({"experiment.py", std::string(asset("study/pack/experiment.py"))});
        return files;
    }
    files.push_back({"study.js", "const study = " + text_of_json(study) + ";\n"});
    for (const char* file : {"experiment.html", "experiment.js"}) {
        files.push_back({file, std::string(asset(std::string("study/pack/") + file))});
    }
    return files;
}

}  // namespace tact
