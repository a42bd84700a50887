// tactspace space: the map of a set.

#include <cstdio>
#include <iostream>
#include <nlohmann/json.hpp>

#include "app/command_line/commands.h"
#include "app/command_line/output.h"
#include "app/pictures/pictures.h"
#include "model/io/tables/matrix_file.h"
#include "model/map/mds.h"
#include "model/perceptual_model/perceptual_model.h"

namespace tact {

namespace {

nlohmann::json json_of(const std::vector<std::string>& labels, const PerceptualSpace& space) {
    nlohmann::json coordinates = nlohmann::json::array();
    for (Eigen::Index i = 0; i < space.points.rows(); ++i) {
        nlohmann::json point = nlohmann::json::array();
        for (Eigen::Index k = 0; k < space.points.cols(); ++k) point.push_back(space.points(i, k));
        coordinates.push_back(point);
    }
    return {{"labels", labels}, {"coordinates", coordinates}, {"stress1", space.stress1}};
}

// What to think of the map, on standard error.
void print_remarks(const PerceptualSpace& space) {
    std::fprintf(stderr, "tactspace: stress-1 %.4f, %s\n", space.stress1,
                 stress_label(space.stress1).c_str());
    const std::string remark = remark_on(space);
    if (!remark.empty()) std::fprintf(stderr, "tactspace: %s\n", remark.c_str());
}

}  // namespace

Expected<Done> run(const SpaceCommand& command) {
    PictureSize size;
    if (!command.image.empty()) {
        const Expected<PictureFormat> format = picture_format(command.image);
        if (!format) return format.error();
        size.format = *format;
    }
    const Expected<PatternSet> set = load_for(command.common);
    if (!set) return set.error();
    if (const Expected<Done> pair = need_a_pair(*set, command.common); !pair) return pair;
    PredictOptions options;
    options.threads = command.common.threads;
    options.progress = progress_line("comparing pairs");
    const Prediction prediction = *predict(model_waveforms(*set), set->model, options);

    const std::vector<std::string> labels = names_of(*set);
    MdsParams params = standard_mds_params(labels.size(), command.dimensions);
    params.threads = command.common.threads;
    if (command.starts >= 0) params.random_starts = command.starts;
    const PerceptualSpace space = nonmetric_mds(prediction.pm, params);
    print_remarks(space);
    const Expected<Done> written = write_result(command.out, [&](std::ostream& stream) {
        if (command.common.json) {
            stream << json_of(labels, space).dump() << "\n";
        } else {
            write_coordinates_csv(stream, labels, space.points);
        }
    });
    if (!written || command.image.empty()) return written;
    return write_picture(command.image, space_picture(*set, prediction.pm, space, size));
}

}  // namespace tact
