// tactspace library: what a folder holds, and what of it is like something.

#include <algorithm>
#include <iostream>
#include <nlohmann/json.hpp>

#include "app/command_line/commands.h"
#include "app/command_line/endings.h"
#include "app/command_line/output.h"
#include "app/rendering/rendering.h"
#include "model/io/folders/path_json.h"
#include "model/io/set/load.h"
#include "model/io/set/model_file.h"
#include "model/io/set/set_file.h"
#include "model/library/library.h"
#include "model/library/library_folder.h"
#include "model/library/like.h"
#include "model/text/json_fields.h"
#include "model/text/numbers.h"
#include "model/text/shown_text.h"
#include "model/text/utf8.h"

namespace tact {

namespace {

namespace fs = std::filesystem;

// One line of the answer.
struct Listed {
    std::size_t entry = 0;
    std::optional<LikeHit> like{};
    std::optional<double> shape_off{};
};

struct LibraryAnswer {
    Library library;
    std::string wanted{};  // its name; empty: nothing is
    std::optional<ExportTarget> target{};
    NumberMark mark{};  // of the model
    LikeAnswer like{};
    std::vector<Listed> listed{};
    std::size_t found = 0;  // before the limit
};

// The entry of this name; an Error unless there is exactly one.
Expected<Vibration> vibration_named(const Library& library, const std::string& name) {
    std::vector<const LibraryEntry*> named;
    for (const LibraryEntry& entry : library.entries) {
        if (entry.name == name) named.push_back(&entry);
    }
    if (named.size() == 1) return vibration_of(library, *named.front());
    if (named.empty()) {
        return Error{"--like: expected a file, or a name in the library, got " + in_quotes(name)};
    }
    return Error{"--like: expected one entry of this name, got " + grouped_digits(named.size()) +
                 ": " + in_quotes(name) + " is in " + valid_utf8(file_of(library, *named[0]).path) +
                 " and " + valid_utf8(file_of(library, *named[1]).path) +
                 "; name the file instead"};
}

Expected<Vibration> wanted_of(const LibraryCommand& command, const Library& library) {
    std::error_code none;
    if (!fs::exists(command.like, none)) return vibration_named(library, command.like);
    auto loaded = load_set(command.like);
    if (!loaded) return loaded.error();
    std::vector<Vibration>& all = loaded->set.vibrations;
    if (all.size() == 1) return std::move(all.front());
    return Error{"--like: expected a file with one effect or recording, got " +
                 grouped_digits(all.size()) + " in " + command.like};
}

Expected<Done> find_like(LibraryAnswer& answer, const LibraryCommand& command,
                         std::vector<std::size_t> among, std::stop_token stop) {
    auto wanted = wanted_of(command, answer.library);
    if (!wanted) return wanted.error();
    LikeQuestion question{*std::move(wanted), std::move(among), {}, {}};
    answer.wanted = question.wanted.name;
    if (!command.target.empty()) {
        auto target = export_target_named(command.target);
        if (!target) return Error{"--for: " + target.error().message};
        question.target = answer.target = *std::move(target);
    }
    if (!command.model.empty()) {
        auto model = read_model_file(command.model);
        if (!model) return model.error();
        question.model = model->model;
        answer.mark = mark_of(origin_of(*model));
    }
    auto like = most_alike(
        answer.library, question,
        {.threads = command.threads, .stop = stop, .progress = progress_line("comparing")});
    if (!like) return like.error();
    answer.like = *std::move(like);
    for (const LikeHit& hit : answer.like.hits) answer.listed.push_back({hit.entry, hit, {}});
    return Done{};
}

Expected<Done> find_shape(LibraryAnswer& answer, const std::vector<double>& strengths,
                          const std::vector<std::size_t>& among) {
    const auto shape = shape_through(strengths);
    if (!shape) return Error{"--shape: expected two strengths or more, and one of them above 0"};
    for (const std::size_t place : among) {
        const StrengthShape& other = answer.library.entries[place].shape;
        answer.listed.push_back({place, {}, shape_difference(*shape, other)});
    }
    std::ranges::stable_sort(answer.listed, {}, [](const Listed& one) { return *one.shape_off; });
    return Done{};
}

// Effects' actuator maps, and which recordings are synthetic.
Labels labels_of(const LibraryAnswer& answer) {
    Labels labels;
    labels.mark = answer.mark;
    for (const Listed& one : answer.listed) {
        const LibraryEntry& entry = answer.library.entries[one.entry];
        if (!entry.effect.actuator.empty()) ++labels.actuators[entry.effect.actuator];
        labels.mark.synthetic_patterns |= entry.synthetic;
    }
    labels.exported = answer.target;
    return labels;
}

std::string number_or_dash(const std::optional<double>& value, int digits) {
    return value ? significant_digits(*value, digits) : "-";
}

std::string table_of(const LibraryAnswer& answer) {
    const bool is_like = !answer.wanted.empty();
    const bool is_shape = !answer.listed.empty() && answer.listed.front().shape_off.has_value();
    std::vector<TextRow> rows{{"name"}};
    if (is_like) rows[0].insert(rows[0].end(), {"PM", "NC", "OC"});
    if (is_shape) rows[0].emplace_back("off");
    rows[0].insert(rows[0].end(), {"s", "peak g", "mean Hz", "ticks", "file"});
    for (const Listed& one : answer.listed) {
        const LibraryEntry& entry = answer.library.entries[one.entry];
        TextRow row{shown_text(entry.name) + (entry.synthetic ? " (synthetic)" : "") +
                    (one.like && !one.like->is_felt ? " (not felt)" : "")};
        if (one.like) {
            for (const double value : {one.like->pm, one.like->nc, one.like->oc})
                row.push_back(significant_digits(value, 5));
        }
        if (one.shape_off) row.push_back(fixed_digits(*one.shape_off, 3));
        row.insert(row.end(),
                   {significant_digits(entry.duration_s, 4), significant_digits(entry.peak_g, 3),
                    number_or_dash(entry.mean_hz, 3), std::to_string(entry.ticks),
                    shown_text(file_of(answer.library, entry).path)});
        rows.push_back(std::move(row));
    }
    return aligned(rows);
}

// Sentences below the table.
std::vector<std::string> words_on(const LibraryAnswer& answer) {
    std::vector<std::string> words;
    const Library& library = answer.library;
    words.push_back(counted(answer.listed.size(), "entry", "entries") + " of " +
                    counted(answer.found, "that was found", "that were found") + ", " +
                    counted(library.entries.size(), "entry", "entries") + " in the library. " +
                    counted(library.files_read, "file", "files") + " read now, " +
                    counted(reasons_left_out(library).size(), "file", "files") + " not readable");
    if (answer.wanted.empty()) return words;
    const LikeAnswer& like = answer.like;
    const std::size_t compared = like.hits.size() + (like.exported ? 1 : 0);
    words.push_back("PM here is of ranks among " + counted(compared, "comparison", "comparisons") +
                    " with " + shown_text(answer.wanted) +
                    ": it says which is nearer, not by how "
                    "much");
    if (!like.is_wanted_felt) {
        words.push_back(shown_text(answer.wanted) +
                        " is felt by no receptor: what is like it is so by rhythm alone");
    }
    if (like.exported) {
        words.push_back(shown_text(answer.wanted) + " itself " + words_on(*answer.target) +
                        ": PM " + significant_digits(like.exported->pm, 5) + ", and " +
                        counted(nearer_than_exported(like), "entry is", "entries are") + " nearer");
    }
    if (!like.too_long.empty()) {
        words.push_back(counted(like.too_long.size(), "entry is", "entries are") +
                        " too long to be compared");
    }
    if (!like.not_held.empty()) {
        words.push_back(counted(like.not_held.size(), "recording", "recordings") +
                        " cannot be exported so");
    }
    return words;
}

nlohmann::json json_of(const LibraryAnswer& answer) {
    const Library& library = answer.library;
    nlohmann::json entries = nlohmann::json::array();
    for (const Listed& one : answer.listed) {
        const LibraryEntry& entry = library.entries[one.entry];
        const LibraryFile& file = file_of(library, entry);
        nlohmann::json json = {{"name", entry.name},
                               {"file", path_json(file.path)},
                               {"place", entry.place},
                               {"note", entry.note},
                               {"licence", file.licence},
                               {"format", entry.effect.format},
                               {"actuator", entry.effect.actuator},
                               {"recording", entry.recording},
                               {"synthetic", entry.synthetic},
                               {"duration_s", entry.duration_s},
                               {"peak_g", entry.peak_g},
                               {"ticks", entry.ticks},
                               {"shape", entry.shape}};
        json["mean_hz"] = entry.mean_hz ? nlohmann::json(*entry.mean_hz) : nlohmann::json();
        if (one.like)
            json.update({{"pm", one.like->pm},
                         {"nc", one.like->nc},
                         {"oc", one.like->oc},
                         {"felt", one.like->is_felt}});
        if (one.shape_off) json["shape_off"] = *one.shape_off;
        entries.push_back(std::move(json));
    }
    nlohmann::json left_out = reasons_left_out(library);
    for (const std::string& unread : answer.like.unread) left_out.push_back(unread);
    nlohmann::json json = {{"library", path_json(library.folder)},
                           {"entries_in_library", library.entries.size()},
                           {"found", answer.found},
                           {"entries", std::move(entries)},
                           {"left_out", std::move(left_out)}};
    if (!answer.wanted.empty()) {
        json["like"] = answer.wanted;
        json["like_is_felt"] = answer.like.is_wanted_felt;
        json["compared"] = answer.like.hits.size() + (answer.like.exported ? 1 : 0);
        json["too_long"] = answer.like.too_long.size();
        json["not_held"] = answer.like.not_held.size();
        if (answer.like.exported) json["itself_pm"] = answer.like.exported->pm;
    }
    add_labels(json, labels_of(answer));
    return json;
}

Expected<Done> write_listed(const LibraryAnswer& answer, const fs::path& out) {
    PatternSet set;
    std::error_code none;
    set.name = valid_utf8(fs::weakly_canonical(answer.library.folder, none).filename().string());
    for (const Listed& one : answer.listed) {
        auto vibration = vibration_of(answer.library, answer.library.entries[one.entry]);
        if (!vibration) return vibration.error();
        vibration->name = unused_name(set, vibration->name);
        set.vibrations.push_back(*std::move(vibration));
    }
    set.duration_s = std::max(longest_s(set), limits::kDurationS.low);
    return write_set_file(out, set);
}

}  // namespace

Expected<Done> run(const LibraryCommand& command) {
    const Interrupt interrupt;
    if (!command.out.empty()) {
        if (const auto writable = writable_result(command.out); !writable) return writable;
    }
    auto library = open_library(command.folder, {.threads = command.threads,
                                                 .read_all = command.without_index,
                                                 .keep = !command.without_index,
                                                 .stop = interrupt.token(),
                                                 .progress = progress_line("reading")});
    if (!library) return library.error();
    for (const std::string& remark : library->remarks)
        std::cerr << "tactspace: " << shown_text(remark) << "\n";
    for (const std::string& reason : reasons_left_out(*library))
        std::cerr << "tactspace: " << shown_text(reason) << "\n";
    LibraryAnswer answer{*std::move(library)};
    const std::vector<std::size_t> among = found_by_words(answer.library, command.words);
    if (!command.like.empty()) {
        const auto found = find_like(answer, command, among, interrupt.token());
        if (!found) return found;
    } else if (!command.shape.empty()) {
        const auto found = find_shape(answer, command.shape, among);
        if (!found) return found;
    } else {
        for (const std::size_t place : among) answer.listed.push_back({place, {}, {}});
    }
    for (const std::string& unread : answer.like.unread)
        std::cerr << "tactspace: " << shown_text(unread) << "\n";
    answer.found = answer.listed.size();
    if (command.most > 0 && answer.listed.size() > command.most) answer.listed.resize(command.most);
    if (!command.out.empty()) {
        if (answer.listed.empty()) return Error{"--out: expected an entry to write, found none"};
        if (const auto written = write_listed(answer, command.out); !written) return written;
    }
    return write_result({}, [&](std::ostream& stream) {
        if (command.json) {
            stream << text_of_json(json_of(answer)) << "\n";
            return;
        }
        stream << text_of(labels_of(answer)) << table_of(answer);
        for (const std::string& words : words_on(answer)) stream << words << "\n";
    });
}

}  // namespace tact
