// The edits, each by itself: pattern in, pattern out, or what was expected of it. Private to the
// room; edited() checks numbers before and the result behind.
#pragma once

#include "model/common/expected.h"
#include "model/pattern/pattern.h"
#include "model/physiology/mechanoreceptor.h"

namespace tact {

enum class StretchOf { all, notes, curves };
Expected<Pattern> stretched(Pattern pattern, double factor, StretchOf what);
Expected<Pattern> reversed(Pattern pattern);
Expected<Pattern> repeated(const Pattern& pattern, int times);
Expected<Pattern> joined(Pattern first, Pattern second);
Expected<Pattern> mixed(Pattern first, Pattern second);
Expected<Pattern> trimmed(Pattern pattern);
Expected<Pattern> faded(Pattern pattern, double in_s, double out_s);
Expected<Pattern> normalised(Pattern pattern, double peak_g);
Expected<Pattern> felt_at(Pattern pattern, double above_threshold_db,
                          const PhysiologyTables& tables);
Expected<Pattern> quantised(Pattern pattern, double grid_s);
Expected<Pattern> transposed(Pattern pattern, double factor);
Expected<Pattern> thinned_curves(Pattern pattern, double percent);
Expected<Pattern> notes_found(const Pattern& pattern);

}  // namespace tact
