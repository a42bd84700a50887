#include "model/physiology/receptor_grid.h"

#include <cassert>
#include <cmath>
#include <cstdlib>

namespace tact {

ReceptorGrid receptor_grid(const Activation& activation, Receptor type, double duration_s,
                           FireSharing share, int reach) {
    assert(activation.radius_mm <= kFingertipMm && "the grid would be larger than the skin");
    ReceptorGrid grid;
    grid.interval_mm = grid_interval_mm(type);
    grid.half_width = static_cast<int>(std::ceil(activation.radius_mm / grid.interval_mm));
    grid.activated = 0;
    double rate_sum_hz = 0.0;
    for (int row = -grid.half_width; row <= grid.half_width; ++row) {
        for (int column = -grid.half_width; column <= grid.half_width; ++column) {
            const double distance_mm =
                grid.interval_mm * std::sqrt(static_cast<double>(row * row + column * column));
            const bool centre = row == 0 && column == 0;
            if (distance_mm > activation.radius_mm && !centre) continue;
            const double rate_hz = rate_at_hz(activation, distance_mm);
            ++grid.activated;
            rate_sum_hz += rate_hz;
            if (std::abs(row) + std::abs(column) > reach) continue;
            grid.receptors.push_back({column, row, distance_mm, rate_hz, 0.0});
        }
    }
    const double total_fires =
        static_cast<double>(grid.activated) * activation.rate_hz * duration_s;
    for (GridReceptor& receptor : grid.receptors) {
        if (share == FireSharing::own) {
            receptor.fires = receptor.rate_hz * duration_s;
        } else if (rate_sum_hz > 0.0) {
            receptor.fires = total_fires * receptor.rate_hz / rate_sum_hz;
        }
    }
    return grid;
}

}  // namespace tact
