// File > Paper: tables and figures of the publication for the open set and others, each with the
// ratings that it keeps.
//
// The program's own command makes them, in a process of its own: pictures are drawn as the window
// is, which one thread alone may do. So the window and a terminal write the same bytes.
//
// Input     the set as it is when the folder is chosen; sets in files that keep ratings
// Output    a folder with paper.html; the status line says where
// Left out  ratings in files beside a set, which "tactspace paper" takes.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "app/document/workspace.h"
#include "app/jobs/query.h"
#include "app/ui/ui.h"

namespace tact {

// A set beside the open one.
struct PaperSet {
    std::filesystem::path file;
    std::string name;
    std::string words;  // how many patterns, and whose ratings

    bool operator==(const PaperSet&) const = default;
};

struct PaperRequest {
    std::filesystem::path program;
    std::vector<std::filesystem::path> sets;
    std::filesystem::path written;  // one of them, which goes when all is made; or empty
    std::string along;              // as PaperCommand has it, as are the next
    std::vector<std::string> metrics_from;
    std::filesystem::path out;
};

struct PaperMade {
    std::filesystem::path page;
    std::string fault;  // empty: it is there
};

struct PaperState {
    std::filesystem::path program;  // itself; empty: nothing is started, as in tests
    std::vector<PaperSet> more;
    std::string along;  // the key of a parameter; empty: the one that joins most
    Query<PaperRequest, PaperMade> job;
    std::shared_ptr<const PaperMade> shown;  // the last that was told of
    double begun_s = 0.0;
};

// "12 patterns, ratings of 6 people", who are called synthetic where nobody was asked.
std::string words_on_ratings(const PatternSet& set);

// The menu's command.
void open_paper(Ui& ui);

// What the choosers answer. A set without ratings is refused with a reason.
void add_paper_set(Ui& ui, PaperState& paper, const std::filesystem::path& file);
void write_paper(Ui& ui, const Workspace& work, PaperState& paper,
                 const std::vector<std::string>& metrics_from, const std::filesystem::path& folder);

bool is_writing_paper(const PaperState& paper);

// Once a frame: tells what was made, or why it was not.
void take_paper(Ui& ui, PaperState& paper);

// `metrics`: names of those of one's own, which take part.
void draw_paper_dialog(Ui& ui, const Workspace& work, const std::vector<std::string>& metrics,
                       PaperState& paper);

// How long it has taken so far, and Cancel, where it is under way.
void draw_paper_progress(Ui& ui, PaperState& paper);

}  // namespace tact
