// What the map shows of the patterns' parameters, and of what other rooms mark in it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/document/workspace.h"
#include "app/map/map_state.h"
#include "app/ui/ui.h"
#include "viz/space/space_view.h"

namespace tact {

// Places of patterns that there are not (app/ask); no rows: none.
struct MapMaybes {
    Eigen::MatrixXd proposals{};
    std::vector<std::string> proposal_names{};
    std::optional<std::size_t> lit{};
    Eigen::MatrixXd track{};
    std::vector<std::string> track_words{};
    Eigen::MatrixXd cloud{};
    std::optional<Eigen::RowVectorXd> wanted{};
    std::optional<Eigen::RowVectorXd> reached{};
};

// What other rooms lay over the map; rows of the shown map.
struct MapMarks {
    std::vector<std::size_t> chosen{};        // a subset: others step back
    std::vector<SpaceLink> links{};           // pairs that are too close
    std::vector<PatternLook> looks{};         // instead of the patterns' own; empty: none
    std::vector<Eigen::Matrix3Xd> spread{};   // where each place might be as well
    std::optional<Eigen::MatrixXd> people{};  // the map of the ratings, laid over this one
    std::string people_text{};                // whose it is
    std::optional<std::size_t> hidden{};      // is not to be seen yet
    bool takes_place = false;                 // the left button says where something is to be
    MapMaybes maybes{};
};

// What a scene borrows while it is drawn.
struct MapDecor {
    std::vector<std::vector<std::size_t>> paths;
    std::vector<std::size_t> faint;
    MapMarks marks;
};

// Looks get new colours if the person asked for that.
MapDecor map_decor(const Ui& ui, ShownMap& shown_map, const MapMarks& marks,
                   std::vector<PatternLook>& looks);
void decorate(const MapDecor& decor, SpaceScene& scene);

// The link that opens the choices, for the row of the map's controls.
void draw_map_look(Ui& ui, ShownMap& shown_map);

// What the colours mean, in the upper right corner of the map.
void draw_map_legend(Ui& ui, ShownMap& shown_map, const Rect& area);

}  // namespace tact
