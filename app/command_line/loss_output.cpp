#include "app/command_line/loss_output.h"

#include "app/command_line/text_table.h"
#include "model/export/loss_words.h"
#include "model/text/shown_text.h"

namespace tact {

namespace {

std::string patterns_text(const ExportLoss& loss) {
    std::vector<TextRow> rows{{"pattern", "RMS error, g", "PSNR, dB", "PM from what was meant"}};
    for (const PatternLoss& one : loss.patterns) {
        if (one.recording) continue;
        rows.push_back({one.name, loss_number(one.rms_error_g), psnr_text(one), moved_text(one)});
    }
    return aligned(rows);
}

std::string set_text(const ExportLoss& loss) {
    std::vector<TextRow> rows{{"PM", "as it was meant", "as it comes back"}};
    for (const BeforeAfter& row : before_after_rows(loss)) {
        rows.push_back({row.what, row.before, row.after});
    }
    if (rows.size() == 1) return {};
    return "\n" + aligned(rows) + kAfterScale + "\n";
}

std::string pairs_text(const ExportLoss& loss) {
    if (loss.most_moved.empty()) return {};
    std::vector<TextRow> rows{{"pairs that moved most", "PM before", "after"}};
    for (const PairChange& one : loss.most_moved) {
        rows.push_back(
            {pair_text(loss, one.a, one.b), loss_number(one.before), loss_number(one.after)});
    }
    return "\n" + aligned(rows);
}

}  // namespace

std::string text_of(const ExportLoss& loss) {
    return "\n" + summary_of(loss) + "\n\n" + patterns_text(loss) + set_text(loss) +
           pairs_text(loss) + "\n" + shown_text(subset_verdict(loss)) + "\n";
}

}  // namespace tact
