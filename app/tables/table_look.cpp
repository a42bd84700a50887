#include "app/tables/tables.h"

#include <algorithm>
#include <array>
#include <utility>

#include "app/document/editing.h"
#include "app/progress/progress.h"
#include "app/tables/parts.h"
#include "app/ui/ui.h"
#include "model/signal/waveform.h"
#include "model/table/table.h"
#include "model/text/atomic_file.h"
#include "model/text/numbers.h"
#include "model/text/utf8.h"

namespace tact {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kHeadBytes = 1 << 18;  // by which a dialect is told (model/table/table)
constexpr std::array<const char*, 4> kAnswerUses{"pattern A", "pattern B", "rating", "participant"};
constexpr std::array<const char*, 4> kAxisUses{"time", "x", "y", "z"};

std::array<std::string*, 4> columns_of(TableWords& words) {
    if (words.kind == TableKind::ratings) {
        return {&words.answers.a, &words.answers.b, &words.answers.rating,
                &words.answers.participant};
    }
    return {&words.axes.time, &words.axes.x, &words.axes.y, &words.axes.z};
}

std::string told_name(const TableHead& head, std::size_t column) {
    const auto& names = head.rows.front();
    const std::string name{trimmed(names[column])};
    const auto is_same = [&name](const std::string& cell) { return trimmed(cell) == name; };
    // A number is no name: the table has none.
    const bool is_plain = !name.empty() && !number_in(name, head.dialect) &&
                          std::ranges::count_if(names, is_same) == 1;
    return is_plain ? name : std::to_string(column + 1);
}

void note_use(TableAnswer& answer, const std::optional<std::size_t>& place, const char* use) {
    if (place && *place < answer.uses.size()) answer.uses[*place] = use;
}

// `of_set`: what of the study is of the set's patterns.
std::string sentence_on(const RatingStudy& study, const RatingStudy& of_set) {
    const std::size_t rated = of_set.labels.size() - unrated_patterns(of_set).size();
    const std::size_t people = study.judgements.size();
    return counted(rated, "pattern", "patterns") + " of the set " + (rated == 1 ? "is" : "are") +
           " rated, by " + counted(people, "participant", "participants");
}

void show_head(TableAnswer& answer, const std::string& text, std::size_t first_line = 1) {
    answer.head = head_of_table(text, answer.request.words.written, kShownTableRows, first_line);
    answer.uses.assign(answer.head.rows.empty() ? 0 : answer.head.rows.front().size(), "");
}

void look_at_answers(TableAnswer& answer, const std::string& text) {
    const TableRequest& request = answer.request;
    show_head(answer, text);
    AnswerColumns told = request.words.answers;
    told.written = request.words.written;
    if (!answer.head.rows.empty()) {
        const AnswerPlaces places = answer_places(answer.head.rows.front(), told);
        note_use(answer, places.a, kAnswerUses[0]);
        note_use(answer, places.b, kAnswerUses[1]);
        note_use(answer, places.rating, kAnswerUses[2]);
        note_use(answer, places.participant, kAnswerUses[3]);
    }
    auto loaded =
        parse_ratings(text, request.file.filename().string(), request.words.scale, {}, told);
    if (!loaded) {
        answer.fault = loaded.error().message;
        return;
    }
    const Expected<RatingStudy> study = study_for(*request.set, *loaded);
    if (!study) {
        answer.fault = request.file.filename().string() + ": " + study.error().message;
        return;
    }
    answer.outcome = sentence_on(loaded->study, *study);
    answer.remarks = loaded->remarks;
    answer.ratings = *std::move(loaded);
}

AccelerationOptions options_of(const TableWords& words) {
    AccelerationOptions options;
    options.unit = words.unit;
    options.table = {words.axes, words.time_unit, words.written};
    return options;
}

void look_at_recording(TableAnswer& answer, const std::string& text) {
    const TableRequest& request = answer.request;
    const AccelerationOptions options = options_of(request.words);
    const TableText decoded = table_text(text);
    const auto table = parse_acceleration_table(decoded.text, request.file.filename().string(),
                                                true, options.table);
    show_head(answer, text, table ? table->first_line : 1);
    if (!table) {
        answer.fault = table.error().message;
        return;
    }
    note_use(answer, table->time_place, kAxisUses[0]);
    for (std::size_t k = 0; k < table->axis_places.size(); ++k) {
        note_use(answer, table->axis_places[k], kAxisUses[std::min<std::size_t>(k + 1, 3)]);
    }
    const auto recording = read_acceleration_file(request.file, options);
    // The sensitivity of a sensor, and which axis counts, the next dialog asks.
    if (!recording) {
        answer.fault = recording.error().message;
        return;
    }
    answer.outcome = "A recording of " + significant_digits(duration_s(recording->waveform), 3) +
                     " s, at most " + significant_digits(peak_g(recording->waveform), 3) + " g";
    answer.remarks = recording->remarks;
}

std::optional<TableAnswer> looked_at(const TableRequest& request, std::stop_token,
                                     std::atomic<float>&) {
    return answer_on(request);
}

std::optional<TablesAnswer> read_all(const TablesRequest& request, std::stop_token,
                                     std::atomic<float>&) {
    TablesAnswer answer{request, {}, {}, false};
    auto ratings = read_ratings(request.files, RatingScale::guess);
    if (ratings) {
        answer.ratings = *std::move(ratings);
    } else {
        answer.fault = ratings.error().message;
        answer.are_recordings = request.may_be_recordings && are_accelerations(request.files);
    }
    return answer;
}

void take_read(Ui& ui, Workspace& work, Layout& layout, TableState& table, ImportState& importing,
               const TablesAnswer& read) {
    const auto& files = read.request.files;
    if (read.request.document != work.document_number) {
        return complain(ui, files.front().filename().string() +
                                " was read for a set that is not open any more. Open that one, "
                                "then the file again.");
    }
    if (read.ratings) return take_ratings(ui, work, layout, files.front(), *read.ratings);
    std::error_code none;
    const bool is_single = files.size() == 1 && fs::is_regular_file(files.front(), none);
    if (!read.are_recordings && !is_single) return complain(ui, read.fault);
    say(ui, "");
    if (read.are_recordings) return import_recordings(ui, work, importing, files);
    open_table(ui, work, table, files.front());
}

}  // namespace

TableAnswer answer_on(const TableRequest& request) {
    TableAnswer answer;
    answer.request = request;
    const auto text = read_text_file(request.file, kMaxTableBytes);
    if (!text) {
        answer.fault = text.error().message;
        return answer;
    }
    if (request.words.kind == TableKind::ratings) look_at_answers(answer, *text);
    if (request.words.kind == TableKind::recording) look_at_recording(answer, *text);
    return answer;
}

std::span<const char* const> table_uses(TableKind kind) {
    return kind == TableKind::ratings ? kAnswerUses : kAxisUses;
}

void use_column(TableWords& words, const TableAnswer& answer, std::size_t column,
                std::string_view use) {
    const auto uses = table_uses(words.kind);
    const auto columns = columns_of(words);
    for (std::size_t k = 0; k < columns.size(); ++k) {
        columns[k]->clear();
        for (std::size_t place = 0; place < answer.uses.size(); ++place) {
            const std::string_view now = place == column ? use : answer.uses[place];
            const bool is_taken_over = place != column && now == use;
            if (now == uses[k] && !is_taken_over) *columns[k] = told_name(answer.head, place);
        }
    }
}

void open_table_dialog(Ui& ui, const Workspace& work, TableState& table) {
    ask_for_file(ui,
                 {.use = ChooserUse::open,
                  .title = "Open a table of ratings, or of a recording",
                  .extensions = {".csv", ".txt", ".tsv"},
                  .take = [&](const fs::path& file) { open_table(ui, work, table, file); }},
                 work.document.path.parent_path());
}

void open_table(Ui& ui, const Workspace& work, TableState& table, const fs::path& file,
                std::optional<TableKind> kind) {
    table.file = file;
    table.names = {};
    table.words = {};
    table.answer.reset();
    // The names are there at once; the rest is read in the background.
    table.names = head_of_table(head_of_file(file, kHeadBytes), {}, 1);
    table.words = remembered_words(work.session, table.names);
    if (kind) table.words.kind = *kind;
    ui.dialog = kTableDialog;
    look_at_table(ui, work, table);
}

void look_at_table(const Ui& ui, const Workspace& work, TableState& table) {
    table.job.ask({work.document_number, table.file, table.words,
                   std::make_shared<const PatternSet>(work.document.set)},
                  looked_at, ui.wake);
}

void load_ratings_dialog(Ui& ui, const Workspace& work, TableState& table) {
    ask_for_file(ui,
                 {.use = ChooserUse::open,
                  .title = "Load ratings: a table, or a folder with one for each participant",
                  .extensions = {".csv", ".txt"},
                  .folders_too = true,
                  .take = [&](const fs::path& path) { read_tables(ui, work, table, {path}); }},
                 work.document.path.parent_path());
}

void read_tables(Ui& ui, const Workspace& work, TableState& table,
                 const std::vector<fs::path>& files, bool may_be_recordings) {
    if (files.empty()) return;
    table.reading_job.ask({++table.asked, work.document_number, files, may_be_recordings}, read_all,
                          ui.wake, JobPolicy::finish);
    say(ui, "Reading " + files.front().filename().string() + "\u2026");
}

void follow_tables(Ui& ui, Workspace& work, Layout& layout, TableState& table,
                   ImportState& importing) {
    const auto answer = table.job.latest();
    if (answer && answer->request.file == table.file) table.answer = answer;
    if (table.asked == table.taken) return;
    if (const std::string failure = table.reading_job.failure(); !failure.empty()) {
        table.taken = table.asked;
        return complain(ui, "Not read: " + failure + ".");
    }
    const auto read = table.reading_job.latest();
    if (!read || read->request.number != table.asked) return;
    // What has to be asked waits for what is asked now.
    const bool is_free = ui.dialog == kNoDialog && !ui.chooser.is_open;
    if (!read->ratings && !is_free) return;
    table.taken = table.asked;
    take_read(ui, work, layout, table, importing, *read);
}

void take_table(Ui& ui, Workspace& work, Layout& layout, TableState& table,
                ImportState& importing) {
    const std::shared_ptr<const TableAnswer> answer = table.answer;
    if (!answer || answer->request.document != work.document_number) return;
    remember_words(work.session, table.names, answer->request.words);
    if (answer->request.words.kind == TableKind::recording) {
        return import_recordings(ui, work, importing, {table.file},
                                 options_of(answer->request.words));
    }
    if (answer->ratings) take_ratings(ui, work, layout, table.file, *answer->ratings);
}

}  // namespace tact
