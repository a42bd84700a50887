// tactspace space: the map of a set, by a metric, by people or of a matrix; turned onto another
// map.

#include <cstdio>
#include <iostream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>

#include "app/command_line/commands.h"
#include "app/command_line/output.h"
#include "app/command_line/rated_sets.h"
#include "app/pictures/pictures.h"
#include "model/evaluation/metric_comparison.h"
#include "model/io/tables/matrix_file.h"
#include "model/map/alienation.h"
#include "model/map/mds.h"
#include "model/map/procrustes.h"
#include "model/text/json_fields.h"
#include "model/text/numbers.h"

namespace tact {

namespace {

// What is to be mapped.
struct Mappable {
    PatternSet set;
    Dissimilarity apart;
    std::string quantity;  // PM
    bool of_people = false;
    Labels labels{};  // of people and matrices without what is said of the model
};

// How a map lies upon another one.
struct OnOtherMap {
    std::vector<Eigen::Index> rows;  // of the patterns that both maps have
    Eigen::MatrixXd target;          // their places in the other map
    ProcrustesFit fit;
    double k = 0.0;
    PermutationTest protest;
    NumberMark mark{};  // of the other map
};

constexpr PermutationParams kProtest{10'000, 6, 0};

PatternSet rated_alone(PatternSet set, const std::vector<std::string>& unrated) {
    std::erase_if(set.vibrations, [&unrated](const Vibration& vibration) {
        return std::ranges::find(unrated, vibration.name) != unrated.end();
    });
    return set;
}

Expected<Mappable> people_of(const SpaceCommand& command) {
    if (command.common.sets.size() > 1) {
        return Error{"--people and --ratings: expected one set, got " +
                     std::to_string(command.common.sets.size())};
    }
    Expected<std::vector<RatedPatterns>> rated = load_rated(command.common, command.ratings);
    if (!rated) return rated.error();
    RatedPatterns& one = rated->front();
    std::istringstream remarks(text_on(one.left_out));
    for (std::string remark; std::getline(remarks, remark);) std::cerr << remark << "\n";
    const std::vector<std::string> unrated = unrated_patterns(one.study);
    Mappable result{rated_alone(one.set, unrated), {}, "ratings", true};
    result.labels.mark = mark_of(one.study);
    result.labels.edited = one.labels.edited;
    result.labels.gone = one.labels.gone;
    std::cerr << text_of(result.labels);
    // Nothing says where an unrated pattern lies.
    const Expected<RatingStudy> study = spread_over(one.study, names_of(one.set));
    const Dissimilarity mean = mean_ratings(*study);
    std::vector<std::size_t> places;
    for (std::size_t k = 0; k < mean.size; ++k) {
        if (std::ranges::find(unrated, one.study.labels[k]) == unrated.end()) places.push_back(k);
    }
    result.apart.size = places.size();
    for (std::size_t i = 0; i < places.size(); ++i) {
        for (std::size_t j = i + 1; j < places.size(); ++j) {
            result.apart.condensed.push_back(mean(places[i], places[j]));
        }
    }
    return result;
}

Expected<Mappable> mappable(const SpaceCommand& command) {
    if (command.people || !command.ratings.files.empty()) return people_of(command);
    const Expected<FeltSet> loaded = load_felt(command.common);
    if (!loaded) return loaded.error();
    const PatternSet& set = loaded->felt;
    if (const Expected<Done> pair = need_a_pair(set, command.common); !pair) return pair.error();
    if (!command.matrix.empty()) {
        Labels labels;
        Expected<Dissimilarity> read = dissimilarities_in(command.matrix, names_of(set),
                                                          command.ratings.written, &labels.mark);
        if (!read) return read.error();
        return Mappable{set, *std::move(read), command.matrix.filename().string(), false,
                        std::move(labels)};
    }
    const Expected<Metric> metric = metric_named(command.metric);
    if (!metric) return metric.error();
    MetricOptions options;
    options.threads = command.common.threads;
    options.progress = progress_line("comparing pairs");
    auto matrices = *compared_matrices(set, {&*metric, 1}, nullptr, options);
    return Mappable{set, std::move(matrices.front()), traits(*metric).name, false, loaded->labels};
}

// Errors: fewer than three patterns in common; maps that cannot lie upon each other.
Expected<OnOtherMap> aligned_to(const SpaceCommand& command, const std::vector<std::string>& names,
                                const Eigen::MatrixXd& points) {
    const std::filesystem::path& file = command.align_to;
    const Expected<LabelledPoints> other = told_points(file, command.ratings.written);
    if (!other) return other.error();
    const std::string where = "--align-to " + file.string() + ": ";
    if (other->points.cols() != points.cols()) {
        return Error{where + "expected a map of " + std::to_string(points.cols()) +
                     " dimensions, got " + std::to_string(other->points.cols())};
    }
    OnOtherMap result;
    std::vector<Eigen::Index> theirs;
    for (std::size_t k = 0; k < names.size(); ++k) {
        const auto found = std::ranges::find(other->labels, names[k]);
        if (found == other->labels.end()) continue;
        result.rows.push_back(static_cast<Eigen::Index>(k));
        theirs.push_back(found - other->labels.begin());
    }
    if (theirs.size() < 3) {
        return Error{where + "expected at least three patterns of the set, got " +
                     std::to_string(theirs.size())};
    }
    const Eigen::MatrixXd own = points(result.rows, Eigen::all);
    result.target = other->points(theirs, Eigen::all);
    PermutationParams params = kProtest;
    params.threads = command.common.threads;
    const auto k = alienation(own, result.target);
    const auto test = protest(result.target, own, params);
    if (!k || !test) return Error{where + (k ? test.error() : k.error()).message};
    result.mark = other->mark;
    result.k = *k;
    result.protest = *test;
    result.fit = procrustes(own, result.target);
    return result;
}

nlohmann::json json_of(const OnOtherMap& on) {
    nlohmann::json json{{"patterns", on.rows.size()},
                        {"procrustes_r", on.fit.correlation},
                        {"procrustes_m2", 1.0 - on.fit.correlation * on.fit.correlation},
                        {"protest_p", on.protest.p},
                        {"K", on.k}};
    if (on.mark != NumberMark{}) json["mark"] = corner_text(on.mark);
    return json;
}

// What has to be said of the coordinates: of the map, and of the one that it is turned onto.
std::string corner_of(const Mappable& of, const std::optional<OnOtherMap>& on) {
    const std::string own = corner_of(of.labels);
    if (!on || on->mark == NumberMark{}) return own;
    const std::string turned = "turned onto a map: " + corner_text(on->mark);
    return own.empty() ? turned : own + "; " + turned;
}

nlohmann::json json_of(const Mappable& of, bool of_matrix, const PerceptualSpace& space,
                       const std::optional<OnOtherMap>& alignment) {
    nlohmann::json coordinates = nlohmann::json::array();
    for (Eigen::Index i = 0; i < space.points.rows(); ++i) {
        nlohmann::json point = nlohmann::json::array();
        for (Eigen::Index k = 0; k < space.points.cols(); ++k) point.push_back(space.points(i, k));
        coordinates.push_back(point);
    }
    nlohmann::json json{
        {"labels", names_of(of.set)}, {"coordinates", coordinates}, {"stress1", space.stress1}};
    const bool labelled = !lines_of(of.labels).empty();
    if (of.of_people) json["synthetic"] = of.labels.mark.synthetic;
    if (labelled && of_matrix) json["mark"] = corner_of(of.labels);
    if (labelled && !of_matrix) add_labels(json, of.labels);
    if (alignment) json["aligned"] = json_of(*alignment);
    return json;
}

// What to think of the map, on standard error.
void print_remarks(const PerceptualSpace& space, const std::optional<OnOtherMap>& on) {
    std::fprintf(stderr, "tactspace: stress-1 %.4f, %s\n", space.stress1, fit_label(space).c_str());
    const std::string remark = remark_on(space);
    if (!remark.empty()) std::cerr << "tactspace: " << remark << "\n";
    if (!on) return;
    const double r = on->fit.correlation;
    std::fprintf(
        stderr,
        "tactspace: turned onto the other map by %zu patterns: Procrustes m2 %.4f (r %.4f), "
        "K %.4f\ntactspace: PROTEST p %.4f, one-sided, %s%s\n",
        on->rows.size(), 1.0 - r * r, r, on->k, on->protest.p,
        on->protest.is_exact ? "all orders of the patterns"
                             : (grouped_digits(on->protest.orders) + " orders").c_str(),
        on->protest.is_exact ? "" : ", seed 6");
    for (const std::string& said : sentences_of(on->mark)) {
        std::cerr << "tactspace: the other map: " << said << "\n";
    }
}

Expected<Done> draw(const SpaceCommand& command, const Mappable& of, const PerceptualSpace& space,
                    const std::optional<OnOtherMap>& alignment, const PictureSize& size) {
    SpaceMarks marks;
    marks.quantity = of.quantity;
    if (of.of_people)
        marks.source = of.labels.mark.synthetic ? "synthetic ratings" : "rated by people";
    if (!command.matrix.empty()) marks.source = "by " + of.quantity;
    marks.mark = corner_of(of, alignment);
    // Arrows from where the other map has them, if it has all.
    const bool has_all = alignment && alignment->target.rows() == space.points.rows();
    if (has_all) marks.before = &alignment->target;
    return write_picture(command.image, space_picture(of.set, of.apart, space, size, marks));
}

}  // namespace

Expected<Done> run(const SpaceCommand& command) {
    PictureSize size;
    if (!command.image.empty()) {
        const Expected<PictureFormat> format = picture_format(command.image);
        if (!format) return format.error();
        size.format = *format;
    }
    const Expected<Mappable> of = mappable(command);
    if (!of) return of.error();
    const std::vector<std::string> labels = names_of(of->set);
    MdsParams params = standard_mds_params(labels.size(), command.dimensions);
    params.threads = command.common.threads;
    if (command.starts >= 0) params.random_starts = command.starts;
    PerceptualSpace space = nonmetric_mds(of->apart, params);
    std::optional<OnOtherMap> alignment;
    if (!command.align_to.empty()) {
        Expected<OnOtherMap> on = aligned_to(command, labels, space.points);
        if (!on) return on.error();
        space.points = transformed(on->fit, space.points);
        alignment = *std::move(on);
    }
    print_remarks(space, alignment);
    const Expected<Done> written = write_result(command.out, [&](std::ostream& stream) {
        if (command.common.json) {
            stream << text_of_json(json_of(*of, !command.matrix.empty(), space, alignment)) << "\n";
        } else {
            write_coordinates_csv(stream, labels, space.points, corner_of(*of, alignment));
        }
    });
    if (!written || command.image.empty()) return written;
    return draw(command, *of, space, alignment, size);
}

}  // namespace tact
