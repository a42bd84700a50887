#include "app/map/similar.h"

#include <algorithm>
#include <string>
#include <vector>

#include "app/document/editing.h"
#include "app/map/map_follow.h"
#include "model/text/numbers.h"
#include "viz/drawing/plot.h"

namespace tact {

namespace {

struct SimilarOne {
    std::size_t place = 0;  // in the document
    double pm = 0.0;
};

std::vector<SimilarOne> closest_to(const Workspace& work, const ShownMap& shown_map,
                                   std::size_t row) {
    const LiveMap& map = *shown_map.transition.shown;
    const auto& mapped = map.request.set->vibrations;
    std::vector<SimilarOne> all;
    for (std::size_t k = 0; k < mapped.size(); ++k) {
        const auto place = place_named(work.document.set, mapped[k].name);
        if (k != row && place) all.push_back({*place, map.prediction.pm(row, k)});
    }
    std::ranges::stable_sort(all, {}, &SimilarOne::pm);
    if (all.size() > kSimilarOnes) all.resize(kSimilarOnes);
    return all;
}

}  // namespace

void select_similar(Ui& ui, Workspace& work, const ShownMap& shown_map, std::size_t place) {
    const auto& all = work.document.set.vibrations;
    const auto& shown = shown_map.transition.shown;
    const auto row = shown ? place_named(*shown->request.set, all[place].name) : std::nullopt;
    if (!row) return say(ui, "It is not in the map yet.");
    const std::vector<SimilarOne> similar = closest_to(work, shown_map, *row);
    if (similar.empty()) return say(ui, "There is no other pattern.");
    select_only(work, place);
    std::string text = "Closest to " + all[place].name + ": ";
    for (const SimilarOne& one : similar) {
        work.selection.others.insert(one.place);
        text += (&one == &similar.front() ? "" : ", ") + all[one.place].name + " (" +
                significant(one.pm) + ")";
    }
    const bool preview = map_state(work, shown_map) != MapState::exact;
    say(ui, text + ", in PM" + (preview ? " of a preview." : "."));
}

}  // namespace tact
