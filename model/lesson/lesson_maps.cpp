#include <cmath>

#include "model/dissimilarity/correlation.h"
#include "model/lesson/lesson_pairs.h"
#include "model/map/alienation.h"
#include "model/map/mds.h"
#include "model/set/set_ratings.h"
#include "model/study/ratings.h"

namespace tact {

std::optional<Dissimilarity> people_of(const PatternSet& set) {
    if (set.ratings.empty()) return std::nullopt;
    const auto study = study_of(set);
    if (!study) return std::nullopt;
    Dissimilarity mean = mean_ratings(*study);
    if (mean.size != set.vibrations.size()) return std::nullopt;
    return mean;
}

LessonMaps lesson_maps(const PatternSet& set, const Prediction& prediction, std::stop_token stop) {
    constexpr int kDimensions = 3;  // the paper's number of dimensions
    LessonMaps maps;
    const MdsParams params = standard_mds_params(set.vibrations.size(), kDimensions);
    const PerceptualSpace pm = nonmetric_mds(prediction.pm, params, stop);
    if (pm.verdict == MdsVerdict::fine) maps.pm_stress = pm.stress1;
    const auto people = people_of(set);
    if (!people) return maps;
    const double rho = spearman(prediction.pm.condensed, people->condensed);
    if (std::isfinite(rho)) maps.rho = rho;
    const PerceptualSpace rated = nonmetric_mds(*people, params, stop);
    if (rated.verdict == MdsVerdict::fine) maps.people_stress = rated.stress1;
    if (!maps.pm_stress || !maps.people_stress) return maps;
    if (const auto k = alienation(pm.points, rated.points)) maps.k = *k;
    return maps;
}

}  // namespace tact
