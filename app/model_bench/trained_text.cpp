#include "app/model_bench/trained_text.h"

#include <algorithm>
#include <cmath>

#include "model/text/numbers.h"

namespace tact {

namespace {

constexpr std::size_t kLayerParameters = 2;
constexpr std::size_t kMixParameters = 2;  // the last ones

}  // namespace

std::string weight_text(double weight, double step) {
    int digits = 1;
    for (double ten = 10.0; digits < 3; ++digits, ten *= 10.0) {
        if (std::abs(step * ten - std::round(step * ten)) < 1e-9) break;
    }
    return fixed_digits(weight, digits);
}

std::vector<std::string> parameter_texts(const PerceptualModelParams& model, double step) {
    std::vector<std::string> texts;
    for (const double value : trained_values(model)) {
        texts.push_back(texts.size() < kLayerParameters ? fixed_digits(value, 0)
                                                        : weight_text(value, step));
    }
    return texts;
}

std::vector<std::string> parameter_texts(const TrainingGrid& grid, const GridPoint& point) {
    PerceptualModelParams none;
    none.channel_weight = {};
    none.nc_weight = none.oc_weight = 0.0;
    auto texts = parameter_texts(nearest_model(grid, point, none), 1.0 / grid.units);
    if (point.channel == kAny) std::fill(texts.begin(), texts.end() - kMixParameters, "any");
    return texts;
}

}  // namespace tact
