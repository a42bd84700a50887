// tactspace snapshot: a view as a picture, without a window.

#include <iostream>

#include "app/command_line/commands.h"
#include "app/command_line/output.h"
#include "app/pictures.h"
#include "model/metric.h"
#include "model/perceptual_model.h"

namespace tact {

namespace {

Expected<Picture> picture_of_set(const SnapshotCommand& command, const PatternSet& set,
                                 const PictureSize& size) {
    if (command.view == "window") return window_picture(set, command.common.threads, size);
    if (const Expected<Done> pair = need_a_pair(set, command.common); !pair) return pair.error();
    PredictOptions options;
    options.threads = command.common.threads;
    options.progress = progress_line("comparing pairs");
    const Prediction prediction = *predict(model_waveforms(set), set.model, options);
    if (command.view == "matrix") {
        return matrix_picture(names_of(set), prediction.pm, traits(Metric::pm).name, size);
    }
    MdsParams params = standard_mds_params(set.vibrations.size(), 3);
    params.threads = command.common.threads;
    return space_picture(set, prediction.pm, nonmetric_mds(prediction.pm, params), size);
}

Expected<Picture> picture_of_pattern(const SnapshotCommand& command, const PatternSet& set,
                                     const PictureSize& size) {
    const std::string first = set.vibrations.empty() ? "" : set.vibrations[0].name;
    const Expected<std::size_t> place =
        place_of(set, command.pattern.empty() ? first : command.pattern);
    if (!place) return place.error();
    const Vibration& vibration = set.vibrations[*place];
    return command.view == "wave" ? wave_picture(vibration, size)
                                  : spectrum_picture(vibration, set.model.coding, size);
}

}  // namespace

Expected<Done> run(const SnapshotCommand& command) {
    const Expected<PictureFormat> format = picture_format(command.out);
    if (!format) return format.error();
    const Expected<PatternSet> set = load_for(command.common);
    if (!set) return set.error();
    PictureSize size;
    size.format = *format;
    size.width = command.width;
    size.height = command.height;
    size.scale = static_cast<float>(command.scale);
    size.dark = command.theme == "dark";
    const bool of_pattern = command.view == "wave" || command.view == "spectrum";
    const Expected<Picture> picture =
        of_pattern ? picture_of_pattern(command, *set, size) : picture_of_set(command, *set, size);
    if (!picture) return picture.error();
    return write_picture(command.out, *picture);
}

}  // namespace tact
