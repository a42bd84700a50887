// tactspace stages: everything a pattern goes through, as CSV files.

#include <iostream>
#include <nlohmann/json.hpp>

#include "app/command_line/commands.h"
#include "app/command_line/output.h"
#include "app/physiology/physiology.h"
#include "app/rendering/rendering.h"
#include "app/session/session.h"
#include "model/io/folders/path_json.h"
#include "model/text/atomic_file.h"
#include "model/text/json_fields.h"

namespace tact {

Expected<Done> run(const StagesCommand& command) {
    const Expected<PatternSet> set = load_for(command.common);
    if (!set) return set.error();
    const Expected<std::size_t> place = place_of(*set, command.pattern);
    if (!place) return place.error();
    // Padded as in its set: the stages are those behind the set's numbers.
    const StageValues values = stage_values(
        padded(waveform_of(set->vibrations[*place]), longest_samples(*set)), set->model);
    if (const Expected<Done> made = make_folder(command.out); !made) return made;
    nlohmann::json listed = nlohmann::json::array();
    for (const Stage stage : kStages) {
        for (const CsvFile& file : stage_csv(values, stage)) {
            const std::filesystem::path path = command.out / file.name;
            if (const auto written = write_atomically(path, file.text); !written) return written;
            listed.push_back(path_json(path));
            std::cerr << "tactspace: wrote " << path.string() << "\n";
        }
    }
    // Their columns are time series: what is to be said of the model stands beside them.
    const Labels labels{.mark = mark_of(set->model_origin)};
    if (const std::string mark = corner_of(labels); !mark.empty()) {
        const auto path = command.out / "model.txt";
        if (const auto written = write_atomically(path, mark + "\n"); !written) return written;
        listed.push_back(path.string());
    }
    if (command.common.json) {
        nlohmann::json json{{"pattern", command.pattern}, {"files", listed}};
        if (labels.mark.synthetic_model) json["synthetic_model"] = true;
        std::cout << text_of_json(json) << "\n";
    }
    return Done{};
}

}  // namespace tact
