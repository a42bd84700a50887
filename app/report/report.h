// Pages of results that stand alone: HTML.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/pictures/pictures.h"
#include "devices/calibration/rendering.h"
#include "model/common/distributions.h"
#include "model/common/expected.h"
#include "model/dissimilarity/dissimilarity.h"
#include "model/io/people/study_tables.h"
#include "model/map/mds.h"
#include "model/planning/preregistration.h"
#include "model/set/measured_twin.h"
#include "model/set/pattern_set.h"
#include "model/signal/waveform.h"
#include "model/subset/subset.h"
#include "model/subset/subset_stability.h"
#include "model/tasks/set_report.h"

namespace tact {

// Pages that stand alone: one HTML file that needs nothing beside it and asks nothing of a network.
//
// Source    HTML, the living standard; Content Security Policy 3
// Input     text, escaped here; what is called html is taken as it is
// Output    UTF-8; light or dark as the reader's system is, light on paper, A4 upright
// Left out  scripts.
// Exact     same input, same bytes.

// As text or as the value of an attribute. What is not UTF-8 becomes
// U+FFFD, a character that steers the page its number (model/text/shown_text.h).
std::string html_escaped(std::string_view text);

struct HtmlColumn {
    std::string heading;     // text
    bool is_number = false;  // set to the right
};

struct HtmlTable {
    std::vector<HtmlColumn> columns;
    std::vector<std::vector<std::string>> rows;  // html; one cell a column
    std::string kind{};                          // a class of the page's styles, or empty
};

// In a frame of its own, which scrolls where the table is wider than the page.
std::string html_of(const HtmlTable& table);

// Drawings of one thing on the grounds of both themes, as wide as there is room.
struct HtmlFigure {
    std::string id{};
    std::string alt{};      // text: what is seen, for who does not see it
    std::string caption{};  // html
    std::string light{};    // SVG documents, which share no names
    std::string dark{};
};
std::string html_of(const HtmlFigure& figure);

// A part of a page under a heading; `id` is what links lead to.
std::string html_section(const std::string& id, const std::string& heading,
                         const std::string& html);

struct HtmlPage {
    std::string title;    // text: of the window, and above the page
    std::string lead{};   // html: under the title, what the page is about
    std::string body{};   // html
    std::string foot{};   // html: what made the page
    std::string style{};  // CSS beside the frame's own
    std::string language = "en";
};

// The colours of the program's two themes are variables: --background, --pane, --field, --line,
// --text, --dim-text, --accent, --warning, --error. Elements of class "light" and "dark" are there
// in one of the two alone, "screen" not on paper.
std::string html_of(const HtmlPage& page);

// The map of a set on a page: drawings, as large as the page is wide.

struct HtmlMap {
    const PatternSet& set;
    const Dissimilarity& dissimilarity;
    const PerceptualSpace& space;
    SpaceMarks marks{};     // a map before, too: arrows lead from there
    std::string id{"map"};  // of its own in the page
    std::string alt{};      // text: what is seen, for who does not see it
    std::string caption{};  // html
};

// A figure with the map on the ground of either theme.
std::string html_of(const HtmlMap& map);

// A plan frozen in a folder: the file that a study is held against later, and a page to deposit.

// Makes the folder. An Error if there is a preregistration already: it is written once.
Expected<Done> write_preregistration(const std::filesystem::path& folder,
                                     const Preregistration& plan);

// The page about a set that one sends to a client: what feels the same, what to take instead.
//
// Input     what was computed of the set elsewhere; nothing here decides
// Output    one HTML page that stands alone: map, groups, subset, table of patterns with
//           players, matrix, what was assumed
// Valid     any n: a page of 1,000 patterns stays below 5 MB and opens at once. The matrix is a
//           table up to kMostMatrixRows and a picture beyond, lists are cut, players and rows of
//           the table are there as long as they have room, those of the picked ones first; the
//           page says what it leaves out
// Exact     same input, same bytes.

inline constexpr std::size_t kMostMatrixRows = 160;
inline constexpr std::size_t kMostListedPatterns = 1000;
inline constexpr std::size_t kMostNamed = 60;    // of one group
inline constexpr std::size_t kMostGroups = 40;   // of one table
inline constexpr std::size_t kMostClosest = 20;  // pairs

// What pairs of a set are held against, and where that is from.
struct CloserThan {
    double dissimilarity = 0.0;
    std::string words;   // "your 8", "Click and Tick"
    std::string source;  // "as far apart as the weakest pair of the 8 most distinct, proven"
};

struct Report {
    const PatternSet& set;               // as it is meant
    const PatternSet& felt;              // as a device plays it; the same set where none does
    const Dissimilarity& dissimilarity;  // of what is felt
    std::string quantity = "PM";         // what that is
    SubsetObjective objective = SubsetObjective::max_min;
    SubsetAnswer answer;
    std::optional<double> best_worth{};  // by the objective; where `answer.best` is an alternative
    const PerceptualSpace& space;        // of the whole set ...
    std::string space_of = "PM";         // ... by this
    AlikePatterns alike{};               // those closer than a pair that was chosen are no sign of
                                         // a confusion; no groups: not asked for
    std::vector<std::size_t> unfelt{};   // places that nobody feels: apart
    std::string left_out{};              // "1 not felt pattern left out"; of the picks
    CloserThan closer_than{};            // which
    const Stability* stability = nullptr;  // how sure: if it was asked
    std::optional<RenderedBy> by{};        // the device
    std::string program{};                 // "tactspace 0.1.0"
    std::string date{};                    // of the page
    NumberMark mark{};                     // of every number ...
    std::vector<std::string> labels{};     // ... in sentences, with further ones
};

std::string report_page(const Report& report);

// Default: the weakest pair of the most distinct patterns, and whether these are proven.
CloserThan closer_than_picked(const SubsetAnswer& answer);

// "Proven optimal: ..": what is known of the subset, as a sentence.
std::string proof_sentence(const Report& report);

// The sections of a report. Private to the report.

// The name of a vibration as html; the picked ones are marked by a ring.
std::string name_html(const Report& report, std::size_t place);
bool is_picked(const Report& report, std::size_t place);

// Names beside each other, as many as a group has room for.
std::string names_html(const Report& report, const std::vector<std::size_t>& places);
std::string pair_html(const Report& report, const ConfusablePair& pair);
// "And 12 more pairs."; empty: there are no more.
std::string and_more(std::size_t count, const std::string& what);

// "PM 34.5".
std::string value_text(const Report& report, double dissimilarity);

// A number that stands out, and what it is; `words` are html.
std::string tile(const std::string& number, const std::string& words);

std::string map_section(const Report& report);
std::string groups_section(const Report& report);
std::string alike_section(const Report& report);   // report_library.cpp; empty: not asked for
std::string closest_html(const Report& report);    // of large sets: a line a pair
std::string unfelt_section(const Report& report);  // empty: all are felt
// The matrix of more patterns than a table has room for; `most`: the largest value.
std::string matrix_picture(const Report& report, double most);
std::string closer_section(const Report& report);
std::string subset_section(const Report& report);
std::string patterns_section(const Report& report);  // report_patterns.cpp
std::string matrix_section(const Report& report);    // report_matrix.cpp
std::string assumed_section(const Report& report);   // report_assumed.cpp

// The first sentence of a note, which says where a pattern is from.
std::string first_sentence(const std::string& note);

// CSS of all of them.
std::string report_style();
std::string shade_styles();  // of the matrix's cells

// The page about a rating study that goes with its tables: who took part and who counts, how alike
// they rate, how well metrics agree with them, the maps.
//
// Input     what was computed of the study elsewhere; nothing here decides
// Output    one HTML page that stands alone; every number of it is in the CSV files beside
//           it (model/io/people/study_tables.h)
// Valid     tables of participants and metrics of any length
// Exact     same input, same bytes.

struct StudyReport {
    const StudyTables& tables;
    const PatternSet& set;  // the patterns that were rated, in the order of tables.labels
    std::string name{};     // of the whole set
    std::vector<std::string> labels{};   // sentences that every number is to be read with
    std::vector<std::string> remarks{};  // who is left out, which rules were on, who fell by them
    std::string methods{};               // a paragraph for a paper and its references, lines
    std::string planned_on{};            // of its preregistration; empty: none
    std::vector<PlannedAndDone> planned{};
    std::string program{};  // "tactspace 0.1.0"
    std::string date{};     // of the page
};

std::string study_report_page(const StudyReport& report);

// The parts of a study's page on how well metrics agree with people, and on how that was computed;
// and how the page writes numbers.
//
// Input     what was computed of the study elsewhere; nothing here decides
// Output    HTML
// Exact     same input, same bytes.

// Agreement, intervals, differences from PM, partial correlations, single people.
std::string metrics_section(const StudyReport& report);

// A paragraph for a paper and the list of what it cites, of lines as methods_text() has them.
std::string methods_html(const std::string& text);
std::string methods_section(const StudyReport& report);

// With `decimals` digits after the point, aligned in a column; with a true minus.
std::string shown(double value, int decimals = 3);
std::string shown(const Interval& interval);
std::string probability(double p);

// A list of sentences, which are text.
std::string items(const std::vector<std::string>& sentences);

// A waveform on a page: as a small picture, and to be heard.
//
// Source    RIFF WAVE, 16-bit PCM; data: URIs, RFC 2397; base64, RFC 4648

// Light where it is modulated faster than can be drawn, with an outline.
struct WaveThumbnail {
    std::string html;
    bool is_light = false;  // somewhere
};

// As a share of full scale, +-reach_g, over `end_s`: as the program's lists show it.
WaveThumbnail thumbnail_html(const Waveform& waveform, double reach_g, double end_s);

// As far as carriers go (1 kHz), with room for the filter; browsers play 3 kHz and more.
inline constexpr double kPlayerRateHz = 4000.0;

// All players of one page share a full scale, so that louder is stronger. One that is not ready
// waits until it is pressed: of ready ones a page may have about seventy.
std::string player_html(const Waveform& waveform, double full_scale_g, const std::string& name,
                        bool is_ready = true);

// What a player takes of the page.
std::size_t player_bytes(const Waveform& waveform);

std::string base64(std::string_view bytes);

// At the waveform's own rate; what is beyond full scale is cut off.
std::string wave_bytes(const Waveform& waveform, double full_scale_g);

}  // namespace tact
