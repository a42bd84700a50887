// tactspace study: simulated participants, and what participants said as ratings.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <nlohmann/json.hpp>

#include "app/command_line/agreement/agreement.h"
#include "app/command_line/commands.h"
#include "app/command_line/output.h"
#include "app/command_line/people/people.h"
#include "app/command_line/rated_sets.h"
#include "app/session/program_version.h"
#include "app/session/session.h"
#include "model/io/people/agreement_json.h"
#include "model/io/people/study_csv.h"
#include "model/io/people/study_file.h"
#include "model/io/studies_out/psych_ds.h"
#include "model/io/studies_out/rdm_npz.h"
#include "model/io/tables/matrix_file.h"
#include "model/map/smacof.h"
#include "model/perceptual_model/perceptual_model.h"
#include "model/set/felt_versions.h"
#include "model/set/pattern_set.h"
#include "model/set/set_ratings.h"
#include "model/study/agreement.h"
#include "model/study/study_results.h"
#include "model/study/synthetic_study.h"
#include "model/text/atomic_file.h"
#include "model/text/json_fields.h"
#include "model/text/numbers.h"
#include "model/text/shown_text.h"
#include "model/text/utf8.h"

namespace tact {

namespace {

namespace fs = std::filesystem;

StudyDesign design_of(const StudyCommand& command, const PatternSet& set) {
    StudyDesign design = set.study;
    design.seed = command.seed.value_or(design.seed);
    design.repetitions = command.repetitions.value_or(design.repetitions);
    design.attention_pairs = command.attention_pairs.value_or(design.attention_pairs);
    if (command.adaptive) design.order = StudyOrder::adaptive;
    design.attention.above = command.attention_above.value_or(design.attention.above);
    design.attention.failures_allowed =
        command.failures_allowed.value_or(design.attention.failures_allowed);
    return design;
}

// The matrix of a file in the order of `names`. Errors: a name that is missing.
Expected<Dissimilarity> in_order(const LabelledMatrix& matrix, const fs::path& file,
                                 const std::vector<std::string>& names) {
    std::vector<std::size_t> place;
    for (const std::string& name : names) {
        const auto found = std::ranges::find(matrix.labels, name);
        if (found == matrix.labels.end()) {
            return Error{file.string() +
                         ": expected a row of every pattern of the study, got none "
                         "of " +
                         in_quotes(name)};
        }
        place.push_back(static_cast<std::size_t>(found - matrix.labels.begin()));
    }
    Dissimilarity result{names.size(), {}};
    for (std::size_t i = 0; i < place.size(); ++i) {
        for (std::size_t j = i + 1; j < place.size(); ++j) {
            result.condensed.push_back(matrix.dissimilarity(place[i], place[j]));
        }
    }
    return result;
}

// What the simulated participants feel: a map, a matrix, or PM's prediction of the set.
Expected<Dissimilarity> truth_for(const StudyCommand& command, const PatternSet& set,
                                  const std::vector<std::string>& names) {
    if (!command.from_matrix.empty()) {
        const Expected<LabelledMatrix> matrix = told_matrix(command.from_matrix, command.written);
        if (!matrix) return matrix.error();
        return in_order(*matrix, command.from_matrix, names);
    }
    if (!command.from_map.empty()) {
        const Expected<LabelledPoints> map = told_points(command.from_map, command.written);
        if (!map) return map.error();
        const LabelledMatrix matrix{map->labels, {map->labels.size(), distances(map->points)}};
        return in_order(matrix, command.from_map, names);
    }
    PredictOptions options;
    options.threads = command.common.threads;
    options.progress = progress_line("comparing pairs");
    return in_order(
        {names_of(set), predict(own_waveforms(set, options.threads), set.model, options)->pm},
        command.common.sets.front(), names);
}

std::string synthetic_code(std::size_t number) {
    char code[16];
    std::snprintf(code, sizeof code, "S%02zu", number);
    return code;
}

StudyHeader simulated_header(const StudyCommand& command, const PatternSet& set) {
    StudyHeader header;
    header.program = kProgramVersion;
    header.kind = command.sorting ? StudyKind::sorting : StudyKind::pairwise;
    header.synthetic = true;
    describe_set(header, set);
    header.device = {"none: simulated", "none", {}};
    header.design = set.study;
    return header;
}

// A study's design is fixed at its first participant.
std::string fault_of_design(const fs::path& folder, const StudyHeader& now) {
    const auto changes = changes_on_disk(folder, now);
    if (changes.empty()) return {};
    return folder.string() +
           ": has participants of another study, expected a folder of its own for this one: " +
           words_on_changes(changes);
}

Expected<Done> simulate(const StudyCommand& command, PatternSet set) {
    set.study = design_of(command, set);
    StudyHeader header = simulated_header(command, set);
    if (header.patterns.size() < 2) {
        return Error{"the study has fewer than two patterns of the set, expected two at least"};
    }
    if (const std::string fault = fault_of_design(command.out, header); !fault.empty()) {
        return Error{fault};
    }
    const Expected<Dissimilarity> truth = truth_for(command, set, header.patterns);
    if (!truth) return truth.error();
    if (const auto made = make_folder(command.out); !made) return made.error();
    const auto count = static_cast<std::size_t>(command.simulate);
    const auto blind =
        static_cast<std::size_t>(std::lround(command.inattentive * static_cast<double>(count)));
    for (std::size_t k = 1; k <= count; ++k) {
        header.participant.code = synthetic_code(k);
        header.seed = participant_seed(header.design.seed, header.participant.code);
        SyntheticRater rater{{}, *truth, k};
        rater.params.noise = command.noise;
        rater.params.bias = command.bias;
        rater.params.seed = static_cast<std::uint64_t>(header.design.seed);
        rater.params.lapses = k + blind > count ? 1.0 : command.lapses;
        const auto written = write_study_file(
            command.out / study_file_name(header.participant.code), simulated_study(header, rater));
        if (!written) return written.error();
    }
    std::cerr << "tactspace: " << count << " synthetic participants in " << command.out.string()
              << "; nobody was asked\n";
    return Done{};
}

const char* word_of(StudyKind kind) { return kind == StudyKind::pairwise ? "pairwise" : "sorting"; }

const char* word_of(StudyOrder order) { return order == StudyOrder::full ? "full" : "adaptive"; }

nlohmann::json json_of(const StudyResults& results, const OrderEffects& effects) {
    nlohmann::json people = nlohmann::json::array();
    for (const ParticipantSummary& person : results.people) {
        people.push_back({{"participant", person.code},
                          {"synthetic", person.synthetic},
                          {"rehearsal", person.rehearsal},
                          {"answers", person.answers},
                          {"not_felt", person.unfelt},
                          {"cut_short", person.cut_short},
                          {"wanted", person.wanted},
                          {"identical_pairs", person.attention},
                          {"excluded", person.excluded.empty() ? nlohmann::json()
                                                               : nlohmann::json(person.excluded)},
                          {"rho_with_others", person.rho_with_others},  // NaN becomes null
                          {"outlier", person.is_outlier},
                          {"repeat_rho", person.conduct.repeat_rho},
                          {"replays", person.conduct.replays},
                          {"median_response_s", person.conduct.median_response_s},
                          {"minutes", person.minutes}});
    }
    const Reliability& agreement = results.agreement;
    nlohmann::json json{{"kind", word_of(results.kind)},
                        {"order", word_of(results.order)},
                        {"synthetic", results.mark.synthetic},
                        {"scaling", kScalingNames[static_cast<std::size_t>(results.scaling)]},
                        {"left_out", results.mark.left_out},
                        {"rehearsals", results.mark.rehearsals},
                        {"labels", results.study.labels},
                        {"condensed", results.mean.condensed},
                        {"counted", agreement.is_of_one_person ? 1 : agreement.voices},
                        {"reliability", agreement.spearman_brown},
                        {"split_half", agreement.half_rho},
                        {"ceiling_of_mean", agreement.ceiling_of_mean},
                        {"one_with_others", agreement.one_with_others},
                        {"participants", people},
                        {"remarks", results.remarks},
                        {"shifts", json_of(effects)}};
    add_to(json, inter_rater(results.study));
    return json;
}

std::size_t counted_in(const StudyResults& results) {
    return static_cast<std::size_t>(std::ranges::count_if(
        results.people, [](const ParticipantSummary& person) { return person.excluded.empty(); }));
}

std::string head_of(const StudyResults& results, const OrderEffects& effects) {
    std::string text = results.kind == StudyKind::pairwise ? "pairs rated" : "patterns sorted";
    text += " by " + std::to_string(counted_in(results)) + " of " +
            std::to_string(results.people.size()) + " participants";
    if (results.mark.left_out > 0) text += ", " + left_out_text(results.mark);
    if (results.order == StudyOrder::adaptive) text += ", in adaptive order";
    if (results.mark.synthetic) text += "; SYNTHETIC: " + words_on_simulated(results.study);
    if (results.scaling != RatingScaling::none) {
        text += std::string("; each one's similarities scaled: ") +
                kScalingNames[static_cast<std::size_t>(results.scaling)];
    }
    const Reliability& agreement = results.agreement;
    if (agreement.voices < 2) return text + "\nagreement     not known of a single voice\n";
    text += std::string("\nagreement     ") +
            (agreement.is_of_one_person ? "of one person's repetitions: " : "") +
            "reliability of their mean " + fixed_digits(agreement.spearman_brown, 3) +
            " (split halves, Spearman-Brown)\n" + text_of(inter_rater(results.study));
    return text + "ceiling       rho " + fixed_digits(agreement.ceiling_of_mean, 3) +
           " for a metric of their mean; one of them reaches " +
           fixed_digits(agreement.one_with_others, 3) + " with the mean of the others\n" +
           text_of(effects);
}

std::vector<TextRow> people_table(const StudyResults& results) {
    std::vector<TextRow> rows{{"participant", "answers", "identical", "rho with others",
                               "rho of repeats", "replays", "median s", "minutes", ""}};
    for (const ParticipantSummary& person : results.people) {
        std::string identical;
        for (const double similarity : person.attention) {
            identical += (identical.empty() ? "" : " ") + fixed_digits(similarity, 0);
        }
        std::string note = person.excluded.empty() ? "" : "not counted";
        if (person.is_outlier) note = "outlier";
        rows.push_back(
            {person.code, std::to_string(person.answers) + "/" + std::to_string(person.wanted),
             identical.empty() ? "-" : identical, fixed_digits(person.rho_with_others, 3),
             fixed_digits(person.conduct.repeat_rho, 3), fixed_digits(person.conduct.replays, 1),
             fixed_digits(person.conduct.median_response_s, 1), fixed_digits(person.minutes, 1),
             note});
    }
    return rows;
}

std::vector<TextRow> matrix_table(const StudyResults& results) {
    const auto& labels = results.study.labels;
    std::vector<TextRow> rows{{""}};
    rows[0].insert(rows[0].end(), labels.begin(), labels.end());
    for (std::size_t i = 0; i < labels.size(); ++i) {
        TextRow row{labels[i]};
        for (std::size_t j = 0; j < labels.size(); ++j) {
            row.push_back(fixed_digits(results.mean(i, j), 1));
        }
        rows.push_back(row);
    }
    return rows;
}

// What the table and the lines above it were made by.
std::string foot_of(const StudyResults& results) {
    const bool all_halves = results.agreement.voices <= 12;
    return std::string(
               "rho: Spearman's, of each with the mean of the others, nothing is drawn; "
               "reliability: ") +
           (all_halves ? "all halves of" : "1,000 drawn halves of") +
           (results.agreement.is_of_one_person ? " the repetitions" : " those who count") +
           ", not tested; order, sides, practice: randomisation tests, two-sided, not corrected "
           "for "
           "how many there are\n";
}

std::string text_of(const StudyResults& results, const OrderEffects& effects) {
    std::string text = head_of(results, effects) + "\n" + aligned(people_table(results));
    for (const std::string& remark : results.remarks) text += shown_text(remark) + "\n";
    if (std::ranges::any_of(results.people, &ParticipantSummary::is_outlier)) {
        text += "outlier: rho with others below Tukey's lower fence, Q1 - 1.5 IQR; counts\n";
    }
    if (results.agreement.voices > 1) text += foot_of(results);
    return text + "\nmean dissimilarity, 100 - similarity\n" + aligned(matrix_table(results));
}

Expected<Done> collect(const StudyCommand& command, const PatternSet& set) {
    Expected<CollectedStudy> study = collected_study(command, set);
    if (!study) return study.error();
    const StudyResults& results = study->results;
    if (!command.out.empty()) {
        const StudyRows rows = command.everyone ? StudyRows::everyone : StudyRows::counted;
        const auto written = write_result(command.out, [&](std::ostream& stream) {
            write_study_csv(stream, study->records, results, rows);
        });
        if (!written) return written.error();
    }
    if (!command.matrix.empty()) {
        const auto written = write_result(command.matrix, [&](std::ostream& stream) {
            Dissimilarity mean = results.mean;
            tie_rounding_noise(mean.condensed);
            write_matrix_csv(stream, results.study.labels, mean, corner_text(results.mark));
        });
        if (!written) return written.error();
    }
    if (!command.rdms.empty()) {
        const auto written = write_atomically(command.rdms, rdm_npz(results.study));
        if (!written) return written;
    }
    if (!command.psych_ds.empty()) {
        const auto written =
            write_new_folder(command.psych_ds, psych_ds_files(dataset_of(set, *study)));
        if (!written) return written;
    }
    const OrderEffects effects = order_effects(counted_records(study->records, results));
    std::optional<IndividualWeights> weights;
    if (command.weights) weights = individual_weights(results.study, *command.weights);
    std::string text;
    if (command.common.json) {
        nlohmann::json json = json_of(results, effects);
        if (weights) json["individual_weights"] = json_of(*weights);
        text = text_of_json(json) + "\n";
    } else {
        text = text_of(results, effects) + (weights ? "\n" + text_of(*weights) : "");
    }
    if (!command.report.empty()) {
        const auto written = write_study_report(command, set, *std::move(study));
        if (!written) return written;
        std::cerr << "tactspace: wrote " << (command.report / "report.html").string() << "\n";
    }
    return write_result({}, [&text](std::ostream& stream) { stream << text; });
}

}  // namespace

Expected<Done> run(const StudyCommand& command) {
    Expected<PatternSet> set = load_for(command.common);
    if (!set) return set.error();
    if (const auto pair = need_a_pair(*set, command.common); !pair) return pair.error();
    if (!command.pack.empty() || !command.unpack.empty()) {
        set->study = design_of(command, *set);
        if (!command.pack.empty()) return pack_study(command, *set);
        StudyHeader header = simulated_header(command, *set);
        header.synthetic = false;
        return unpack_study(command, std::move(header));
    }
    return command.simulate > 0 ? simulate(command, *std::move(set)) : collect(command, *set);
}

}  // namespace tact
