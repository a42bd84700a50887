#include "model/io/effects_out/felt_error.h"

#include <algorithm>
#include <cmath>

#include "model/common/portable.h"
#include "model/design_space/spectral_lines.h"

namespace tact {

namespace {

constexpr double kRoundingDb = 1e-6;

}  // namespace

double felt_level_db(const FeltTone& tone) {
    if (!(tone.amplitude_g > 0.0)) return 0.0;
    const auto above_db =
        detectability_db({{tone.frequency_hz, tone.amplitude_g}}, default_tables());
    return std::max(above_db.value_or(0.0), 0.0);
}

double felt_error_db(const FeltTone& asked, const FeltTone& got) {
    const double asked_db = felt_level_db(asked);
    const double got_db = felt_level_db(got);
    double error_db = std::abs(asked_db - got_db);
    if (asked_db > 0.0 && got_db > 0.0) {
        const double ratio = got.frequency_hz / asked.frequency_hz;
        error_db = std::max(error_db, std::abs(20.0 * portable::log10(ratio)));
    }
    return error_db < kRoundingDb ? 0.0 : error_db;
}

}  // namespace tact
