// How wide the columns of the table are.

#include <algorithm>
#include <array>

#include "app/candidates/candidates_panel.h"

namespace tact {

namespace {

struct ColumnWidth {
    CandidateColumn column;
    float least_px;
    float most_px;
};

// In the order of the table; the width at a scale of 1.
constexpr std::array kColumnWidths{ColumnWidth{CandidateColumn::picture, 56.0F, 260.0F},
                                   ColumnWidth{CandidateColumn::name, 100.0F, 240.0F},
                                   ColumnWidth{CandidateColumn::amplitude, 38.0F, 72.0F},
                                   ColumnWidth{CandidateColumn::carrier, 42.0F, 90.0F},
                                   ColumnWidth{CandidateColumn::modulation, 48.0F, 84.0F},
                                   ColumnWidth{CandidateColumn::rhythm, 70.0F, 140.0F},
                                   ColumnWidth{CandidateColumn::duration, 40.0F, 72.0F},
                                   ColumnWidth{CandidateColumn::nearest, 54.0F, 110.0F},
                                   ColumnWidth{CandidateColumn::picked, 34.0F, 64.0F}};

constexpr std::array kFirstToGo{CandidateColumn::duration, CandidateColumn::picture,
                                CandidateColumn::rhythm, CandidateColumn::modulation};

// All a little narrower, before a column goes.
constexpr float kLeastSqueeze = 0.96F;

}  // namespace

std::vector<ColumnSpan> column_places(float width_px, float scale, float nearest_px) {
    std::vector<ColumnWidth> shown(kColumnWidths.begin(), kColumnWidths.end());
    for (ColumnWidth& column : shown) {
        if (column.column != CandidateColumn::nearest) continue;
        column.least_px = std::max(column.least_px, nearest_px);
        column.most_px = std::max(column.most_px, nearest_px);
    }
    const auto sum = [&shown](float ColumnWidth::*width) {
        float total = 0.0F;
        for (const ColumnWidth& column : shown) total += column.*width;
        return total;
    };
    for (const CandidateColumn gone : kFirstToGo) {
        if (kLeastSqueeze * scale * sum(&ColumnWidth::least_px) <= width_px) break;
        std::erase_if(shown, [gone](const ColumnWidth& c) { return c.column == gone; });
    }
    const float least = sum(&ColumnWidth::least_px);
    const float spread = sum(&ColumnWidth::most_px) - least;
    const float share = std::clamp((width_px / scale - least) / std::max(spread, 1.0F), 0.0F, 1.0F);
    const float most = scale * sum(&ColumnWidth::most_px);
    // What is left has no room either: all of it a little narrower, and nothing beyond the pane.
    const float squeeze = std::min(1.0F, width_px / std::max(1.0F, scale * least));
    std::vector<ColumnSpan> places;
    float at = 0.0F;
    for (const ColumnWidth& column : shown) {
        const bool is_picture = column.column == CandidateColumn::picture;
        const float left_over = is_picture ? std::max(0.0F, width_px - most) : 0.0F;
        const float width =
            left_over +
            squeeze * scale * (column.least_px + share * (column.most_px - column.least_px));
        places.push_back({column.column, at, at + width});
        at += width;
    }
    return places;
}

}  // namespace tact
