// tactspace predict: the dissimilarity of every pair.

#include <iostream>
#include <nlohmann/json.hpp>

#include "app/command_line/commands.h"
#include "app/command_line/output.h"
#include "app/pictures.h"
#include "model/io/matrix_file.h"
#include "model/perceptual_model.h"

namespace tact {

namespace {

// One of PM and its parts; NC alone costs no warping.
Dissimilarity predicted(const PatternSet& set, const std::string& metric,
                        const PredictOptions& options) {
    const std::vector<Waveform> waveforms = model_waveforms(set);
    if (metric == "pm") return predict(waveforms, set.model, options)->pm;
    const auto codes = pattern_codes(waveforms, set.model, options);
    return metric == "nc" ? nc_matrix(codes, set.model, options) : oc_matrix(codes, options);
}

void print_json(std::ostream& stream, const std::vector<std::string>& labels,
                const std::string& metric, const Dissimilarity& matrix) {
    const nlohmann::json json{
        {"labels", labels}, {"metric", metric}, {"condensed", matrix.condensed}};
    stream << json.dump() << "\n";
}

}  // namespace

Expected<Done> run(const PredictCommand& command) {
    const Expected<PatternSet> set = load_for(command.common);
    if (!set) return set.error();
    if (const Expected<Done> pair = need_a_pair(*set, command.common); !pair) return pair;
    PredictOptions options;
    options.threads = command.common.threads;
    options.progress = progress_line("comparing pairs");
    const Dissimilarity matrix = predicted(*set, command.metric, options);
    const std::vector<std::string> labels = names_of(*set);
    const Expected<Done> written = write_result(command.out, [&](std::ostream& stream) {
        if (command.common.json) {
            print_json(stream, labels, command.metric, matrix);
        } else {
            write_matrix_csv(stream, labels, matrix);
        }
    });
    if (!written || command.image.empty()) return written;
    return write_png(command.image.string(), matrix_picture(labels, matrix, command.metric, {}));
}

}  // namespace tact
