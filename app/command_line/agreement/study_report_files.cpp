#include "app/command_line/agreement/agreement.h"

#include <algorithm>
#include <iostream>
#include <optional>
#include <utility>

#include "app/command_line/output.h"
#include "app/document/workspace.h"
#include "app/report/report.h"
#include "app/session/program_version.h"
#include "app/session/session.h"
#include "assets/assets.h"
#include "model/common/fingerprint.h"
#include "model/evaluation/metric_comparison.h"
#include "model/io/people/exclusions_file.h"
#include "model/io/people/ratings_file.h"
#include "model/io/people/study_csv.h"
#include "model/io/people/study_tables.h"
#include "model/io/set/set_file.h"
#include "model/io/studies_out/preregistration_file.h"
#include "model/tasks/set_agreement.h"
#include "model/text/atomic_file.h"
#include "model/text/utc_time.h"

namespace tact {

namespace {

namespace fs = std::filesystem;

PatternSet rated_patterns_of(const PatternSet& set, const RatedSet& rated) {
    if (!rated.part) return set;
    PatternSet part = set;
    part.vibrations.clear();
    for (const std::size_t place : rated.rated) part.vibrations.push_back(set.vibrations[place]);
    return part;
}

// The matrices of what may carry a metric's agreement alone, where patterns differ in it.
std::vector<Nuisance> simple_reasons(const PatternSet& set) {
    std::vector<Nuisance> reasons;
    for (const char* name : {"level", "duration"}) {
        auto apart = nuisance_named(name, set);
        if (apart && order_pairs(apart->condensed).levels > 1) {
            reasons.push_back({name, *std::move(apart)});
        }
    }
    return reasons;
}

// As it was done, to be held against its preregistration.
DoneStudy done_study(const StudyCommand& command, const PatternSet& set, const CollectRule& rule,
                     const StudyTables& tables) {
    const StudyHeader& header = tables.records.front().header;
    DoneStudy done;
    done.set_fingerprint = header.set_fingerprint;
    done.model_fingerprint = fingerprint_text(model_fingerprint(set));
    done.patterns = header.patterns;
    done.people = participant_means(tables.results.study).size();
    done.repetitions = header.design.repetitions;
    done.attention_pairs = header.design.attention_pairs;
    done.attention = rule.attention;
    done.order = tables.results.order;
    done.scaling = tables.results.scaling;
    done.left_out_by_hand = command.who.exclude;
    const auto recorded = read_exclusions(study_folder_of(command));
    for (const Exclusion& one : recorded ? *recorded : std::vector<Exclusion>{}) {
        const auto& known = done.left_out_by_hand;
        if (std::ranges::find(known, one.participant) == known.end()) {
            done.left_out_by_hand.push_back(one.participant);
        }
    }
    return done;
}

struct ReportedStudy {
    StudyTables tables;
    std::string methods;
};

// As tactspace compare has them.
Expected<ReportedStudy> reported_study(const StudyCommand& command, const PatternSet& set,
                                       CollectedStudy study) {
    EvaluationParams params;
    params.threads = command.common.threads;
    const Expected<RatingStudy> spread = matched(study.results.study, names_of(set));
    if (!spread) return spread.error();
    MetricOptions options;
    options.threads = command.common.threads;
    options.progress = progress_line("comparing metrics");
    AgreementRequest request{{kMetrics.begin(), kMetrics.end()},
                             *compared_matrices(set, kMetrics, nullptr, options),
                             simple_reasons(set),
                             params};
    request.progress = progress_line("resampling");
    PeopleAgreement agreed = *people_agreement(*spread, std::move(request));
    if (!agreed.fault.empty()) return Error{agreed.fault};
    const RatedSet& rated = rated_part(agreed.people.rated);
    ReportedStudy reported;
    StudyTables& tables = reported.tables;
    tables.raters = inter_rater(study.results.study);
    tables.weights = individual_weights(
        study.results.study,
        command.weights.value_or(shown_weight_dimensions(rated.people.dissimilarity.size)));
    tables.effects = order_effects(counted_records(study.records, study.results));
    tables.records = std::move(study.records);
    tables.results = std::move(study.results);
    tables.people = rated.people;
    tables.k_chance = rated.k_chance;
    tables.labels = names_of(rated_patterns_of(set, agreed.people.rated));
    MetricTable& table = agreed.table;
    for (std::size_t k = 0; k < kMetrics.size(); ++k) {
        MetricOfStudy metric;
        metric.key = traits(kMetrics[k]).key;
        metric.matrix = among_rated(table.matrices[k], agreed.people.rated);
        metric.evaluation = table.evaluations[k];
        MdsParams map = standard_mds_params(metric.matrix.size, params.dimensions);
        map.threads = params.threads;
        metric.space = nonmetric_mds(metric.matrix, map);
        tables.metrics.push_back(std::move(metric));
    }
    tables.individuals = table.individuals;
    tables.uncertainty = table.uncertainty;
    tables.given = table.given;
    std::vector<LeftOutParticipant> left_out;
    for (const ParticipantSummary& person : tables.results.people) {
        if (!person.excluded.empty()) left_out.push_back({person.code, person.excluded});
    }
    const SetAgreement agreement{set.name.empty() ? "this study" : set.name,
                                 tables.labels.size(),
                                 std::move(agreed.people),
                                 std::move(left_out),
                                 {},
                                 std::move(table),
                                 tables.raters};
    reported.methods = methods_text({&agreement, 1});
    return reported;
}

std::vector<std::string> labels_of(const StudyTables& tables) {
    std::vector<std::string> labels;
    for (const std::string& said : sentences_of(tables.results.mark)) labels.push_back(said + ".");
    if (tables.results.order == StudyOrder::adaptive) {
        labels.emplace_back("Pairs were asked in adaptive order, not the publication's design.");
    }
    if (tables.results.scaling != RatingScaling::none) {
        labels.push_back(std::string("Each one's similarities are scaled: ") +
                         kScalingNames[static_cast<std::size_t>(tables.results.scaling)] + ".");
    }
    return labels;
}

Expected<Done> write_files(const fs::path& folder, const StudyTables& tables,
                           const std::string& page) {
    using Writer = void (*)(std::ostream&, const StudyTables&);
    for (const auto& [file, write] :
         {std::pair<const char*, Writer>{"participants.csv", write_participants_csv},
          {"reliability.csv", write_reliability_csv},
          {"pairs.csv", write_pairs_csv},
          {"table.csv", write_metrics_csv},
          {"differences.csv", write_differences_csv},
          {"maps.csv", write_maps_csv},
          {"weights.csv", write_weights_csv},
          {"dimensions.csv", write_dimensions_csv}}) {
        const auto written =
            write_result(folder / file, [&](std::ostream& stream) { write(stream, tables); });
        if (!written) return written;
    }
    const auto answers = write_result(folder / kAnswersFile, [&](std::ostream& stream) {
        write_study_csv(stream, tables.records, tables.results, StudyRows::everyone);
    });
    if (!answers) return answers;
    for (const char* script : {"reproduce.py", "reproduce.R", "mixed.R"}) {
        const auto written =
            write_atomically(folder / script, asset(std::string("study/") + script));
        if (!written) return written;
    }
    return write_atomically(folder / "report.html", page);
}

}  // namespace

Expected<Done> write_study_report(const StudyCommand& command, const PatternSet& set,
                                  CollectedStudy study) {
    std::optional<Preregistration> planned;
    if (!command.planned.empty()) {
        Expected<Preregistration> read = read_preregistration(command.planned);
        if (!read) return read.error();
        planned = *std::move(read);
    }
    const CollectRule rule = study.rule;
    std::vector<std::string> remarks = study.results.remarks;
    const bool has_changed = study.has_changed;
    const Expected<ReportedStudy> reported = reported_study(command, set, std::move(study));
    if (!reported) return reported.error();
    const StudyTables* const tables = &reported->tables;
    PatternSet rated = set;
    std::erase_if(rated.vibrations, [&tables](const Vibration& one) {
        return std::ranges::find(tables->labels, one.name) == tables->labels.end();
    });
    give_looks(rated);
    const std::string unrated =
        remark_on_unrated(unrated_patterns(*spread_over(tables->results.study, names_of(set))),
                          set.vibrations.size());
    if (!unrated.empty()) remarks.push_back(unrated);
    StudyReport report{.tables = *tables, .set = rated, .name = set.name};
    report.labels = labels_of(*tables);
    if (has_changed) {
        report.labels.emplace_back(
            "The patterns have changed since they were felt: what is "
            "compared with the ratings is of others.");
    }
    report.remarks = std::move(remarks);
    report.methods = reported->methods;
    if (planned) {
        report.planned_on = planned->date;
        report.planned = planned_and_done(*planned, done_study(command, set, rule, *tables));
    }
    report.program = kProgramVersion;
    report.date = utc_today();
    if (const auto made = make_folder(command.report); !made) return made;
    return write_files(command.report, *tables, study_report_page(report));
}

}  // namespace tact
