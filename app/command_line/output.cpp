#include "app/command_line/output.h"

#include <unistd.h>

#include <algorithm>
#include <cassert>
#include <chrono>
#include <cstdio>
#include <iostream>
#include <memory>
#include <mutex>
#include <optional>
#include <streambuf>

#include "app/command_line/endings.h"
#include "app/progress/progress.h"
#include "app/rendering/rendering.h"
#include "devices/calibration/calibration_file.h"
#include "model/export/exported_set.h"
#include "model/export/loss_words.h"
#include "model/io/effects/actuator_map.h"
#include "model/io/recordings/recording.h"
#include "model/io/set/load.h"
#include "model/io/set/model_file.h"
#include "model/io/tables/matrix_file.h"
#include "model/subset/set_subset.h"
#include "model/text/atomic_file.h"
#include "model/text/numbers.h"
#include "model/text/shown_text.h"

namespace tact {

namespace {

// A stream into a file that appears whole or not at all.
class AtomicBuffer final : public std::streambuf {
  public:
    explicit AtomicBuffer(AtomicFile& file) : file_(file) { pending_.reserve(kPiece); }

    // What went wrong so far, after writing out what is pending.
    Expected<Done> finish() {
        write_pending();
        return state_;
    }

  protected:
    int_type overflow(int_type character) override {
        if (character != traits_type::eof())
            pending_.push_back(traits_type::to_char_type(character));
        if (pending_.size() >= kPiece) write_pending();
        return state_ ? 0 : traits_type::eof();
    }

    std::streamsize xsputn(const char* text, std::streamsize count) override {
        pending_.append(text, static_cast<std::size_t>(count));
        if (pending_.size() >= kPiece) write_pending();
        return state_ ? count : 0;
    }

  private:
    static constexpr std::size_t kPiece = std::size_t{1} << 20;

    void write_pending() {
        if (state_) state_ = file_.append(pending_);
        pending_.clear();
    }

    AtomicFile& file_;
    std::string pending_;
    Expected<Done> state_ = Done{};
};

// The count first, then a line for each file; an Error where that is not to be borne.
Expected<Done> tell_left_out(const Loaded& loaded, bool strict) {
    if (loaded.left_out.empty()) return Done{};
    const std::string counts = counts_text(loaded);
    std::cerr << "tactspace: " << counts << "\n";
    for (const std::string& one : loaded.left_out) {
        std::cerr << "tactspace: not read: " << one << "\n";
    }
    if (strict) return Error{"--strict: expected every file to be read, got " + counts};
    return Done{};
}

// Zeros that look like an answer: every pair is as good as another, and each of them "optimal".
void tell_of_weights(const PerceptualModelParams& model) {
    if (model.nc_weight > 0.0 || model.oc_weight > 0.0) return;
    std::cerr << "tactspace: the model weighs neither NC nor OC: all patterns are alike to it\n";
}

// The side of the sets that is asked for, and what is to be said of it.
Expected<PatternSet> loaded_side(const CommonOptions& options, Labels& labels) {
    std::optional<ActuatorMap> actuator;
    if (!options.actuator.empty()) {
        const Expected<ActuatorMap> named = actuator_named(options.actuator);
        if (!named) return named.error();
        actuator = *named;
    }
    Expected<Loaded> loaded = load_sets(options.sets, actuator);
    if (!loaded) return loaded.error();
    if (const Expected<Done> told = tell_left_out(*loaded, options.strict); !told) {
        return told.error();
    }
    for (const std::string& remark : loaded->remarks) std::cerr << "tactspace: " << remark << "\n";
    if (!options.model.empty()) {
        const Expected<ModelFile> file = read_model_file(options.model);
        if (!file) return file.error();
        loaded->set.model = file->model;
        loaded->set.model_origin = origin_of(*file);
    }
    const std::string remark = remark_on_synthetic(loaded->set.model_origin);
    labels.mark.synthetic_model = !remark.empty();
    if (!remark.empty()) {
        const std::string whose =
            options.model.empty() ? "the set's model" : options.model.string();
        std::cerr << "tactspace: " << whose << ": " << remark << "\n";
    }
    tell_of_weights(loaded->set.model);
    labels.only = options.only;
    PatternSet side = one_side(loaded->set, options.only);
    labels.mark.synthetic_patterns = has_synthetic_patterns(side);
    labels.actuators = actuators_of(side);
    if (options.only == Side::both) return side;
    std::cerr << "tactspace: only the " << side.vibrations.size() << " "
              << kSideNames[static_cast<std::size_t>(options.only)] << " of "
              << loaded->set.vibrations.size() << " patterns\n";
    return side;
}

}  // namespace

Expected<std::optional<RenderedBy>> rendered_by(const CommonOptions& options) {
    if (options.rendered_by.empty()) {
        if (options.rendered_calibration.empty()) return std::optional<RenderedBy>();
        return Error{std::string("--calibration: expected --rendered-by ") +
                     traits(ActuatorKind::voice_coil).key + " as well"};
    }
    const Expected<ActuatorKind> kind = actuator_kind_named(options.rendered_by);
    if (!kind) return kind.error();
    RenderedBy by{*kind, options.full_scale_g};
    by.level = options.rendered_level;
    if (options.rendered_calibration.empty()) return std::optional(std::move(by));
    Expected<Calibration> read = read_calibration(options.rendered_calibration);
    if (!read) return read.error();
    by.calibration = *std::move(read);
    if (is_calibrated(by)) return std::optional(std::move(by));
    return Error{std::string("--calibration: a ") + traits(*kind).name +
                 " has none, expected --rendered-by " + traits(ActuatorKind::voice_coil).key};
}

Expected<std::optional<ExportTarget>> exported_as(const CommonOptions& options) {
    if (options.exported_as.empty()) return std::optional<ExportTarget>();
    Expected<ExportTarget> target = export_target_named(options.exported_as);
    if (!target) return Error{"--exported-as: " + target.error().message};
    return std::optional(*std::move(target));
}

Expected<FeltSet> load_felt(const CommonOptions& options) {
    Expected<std::optional<RenderedBy>> by = rendered_by(options);
    if (!by) return by.error();
    Expected<std::optional<ExportTarget>> target = exported_as(options);
    if (!target) return target.error();
    Labels labels;
    Expected<PatternSet> set = loaded_side(options, labels);
    if (!set) return set.error();
    FeltSet result{*set, *std::move(set), std::move(labels)};
    const auto label_name = [&result](const std::string& words) {
        result.felt.name += (result.felt.name.empty() ? "" : ", ") + words;
    };
    if (*target) {
        ExportedSet exported = *exported_set(result.meant, **target, options.threads);
        **target = exported.target;
        result.felt = std::move(exported.back);
        label_name(words_on(**target));
        std::cerr << "tactspace: " << sentence_on(**target) << "\n";
        if (exported.recordings > 0) {
            std::cerr << "tactspace: " << exported.recordings
                      << " recordings stay as they are: no such file holds them\n";
        }
        result.labels.exported = *std::move(target);
    }
    if (!*by) return result;
    const std::string name = std::move(result.felt.name);
    result.felt = rendered_set(result.felt, **by, nullptr, {options.threads, {}})->played;
    result.felt.name = name;
    label_name(words_on(**by));
    result.labels.mark.uncalibrated = !is_calibrated(**by);
    result.labels.by = *std::move(by);
    std::cerr << "tactspace: " << sentence_on(*result.labels.by) << "\n";
    return result;
}

Expected<PatternSet> load_for(const CommonOptions& options) {
    Expected<FeltSet> set = load_felt(options);
    if (!set) return set.error();
    return std::move(set->felt);
}

Expected<PatternSet> load_as_meant(const CommonOptions& options) {
    Labels labels;
    return loaded_side(options, labels);
}

Expected<Done> need_a_pair(const PatternSet& set, const CommonOptions& options) {
    const std::size_t count = set.vibrations.size();
    if (count >= 2) return Done{};
    return Error{options.sets.front().string() + ": has " +
                 (count == 0 ? "no pattern" : "a single pattern") +
                 ", expected at least two to compare"};
}

Expected<NamedPair> pair_of(const PatternSet& set, const std::string& option,
                            const std::string& text) {
    for (std::size_t at = text.find(','); at != std::string::npos; at = text.find(',', at + 1)) {
        const auto a = place_named(set, text.substr(0, at));
        const auto b = place_named(set, text.substr(at + 1));
        if (a && b && *a != *b) return NamedPair{*a, *b};
    }
    const std::size_t comma = text.find(',');
    if (comma != std::string::npos) {
        for (const std::string& name : {text.substr(0, comma), text.substr(comma + 1)}) {
            const Expected<std::size_t> place = place_of(set, name);
            if (!place) return Error{option + ": " + place.error().message};
        }
    }
    return Error{option + ": expected two patterns with a comma between, got \"" + text + "\""};
}

Error unpickable(const Error& fault, std::size_t left_out) {
    const std::string words = left_out_words(left_out);
    return Error{fault.message + (words.empty() ? "" : "; " + words + " (--include-unfelt)")};
}

Expected<PictureFormat> picture_format(const std::filesystem::path& file) {
    const std::string ending = extension_of(file);
    if (ending != ".png" && ending != ".svg" && !ending.empty()) {
        return Error{file.string() + ": a picture's name ends in .png or .svg"};
    }
    if (const auto writable = writable_result(file); !writable) return writable.error();
    return ending == ".svg" ? PictureFormat::svg : PictureFormat::png;
}

Expected<Done> writable_result(const std::filesystem::path& out) {
    std::error_code none;
    // Who reads a pipe would see it end.
    const bool is_special = std::filesystem::exists(out, none) &&
                            !std::filesystem::is_regular_file(out, none) &&
                            !std::filesystem::is_directory(out, none);
    if (out.empty() || is_special) return Done{};
    const Expected<AtomicFile> file = AtomicFile::open(out);
    return file ? Expected<Done>(Done{}) : file.error();
}

Expected<Done> write_result(const std::filesystem::path& out,
                            const std::function<void(std::ostream&)>& write) {
    if (out.empty()) {
        write(std::cout);
        return flushed_output();
    }
    Expected<AtomicFile> file = AtomicFile::open(out);
    if (!file) return file.error();
    AtomicBuffer buffer(*file);
    std::ostream stream(&buffer);
    write(stream);
    if (const Expected<Done> written = buffer.finish(); !written) return written;
    return file->commit();
}

std::function<void(double)> progress_line(const std::string& what) {
    return progress_line_with(what, {});
}

void tell_search(SubsetOptions& options, const std::string& what, SubsetObjective objective) {
    struct SoFar {
        std::mutex mutex;
        std::string words;
    };
    const auto so_far = std::make_shared<SoFar>();
    options.so_far = [so_far, objective](const SubsetAnswer& now) {
        const std::scoped_lock lock(so_far->mutex);
        so_far->words = "; " + significant_digits(worth_of(now.best, objective), 4) +
                        " found, none is above " + significant_digits(now.bound, 4);
    };
    options.progress = progress_line_with(what, [so_far] {
        const std::scoped_lock lock(so_far->mutex);
        return so_far->words;
    });
}

std::function<void(double)> progress_line_with(const std::string& what,
                                               std::function<std::string()> said) {
    const bool terminal = isatty(STDERR_FILENO) != 0;
    const std::chrono::milliseconds interval(terminal ? 200 : 60'000);
    struct State {
        std::mutex mutex;
        std::chrono::steady_clock::time_point begin = std::chrono::steady_clock::now();
        std::chrono::steady_clock::time_point shown = begin;
    };
    return [what = shown_text(what), said = std::move(said), terminal, interval,
            state = std::make_shared<State>()](double share) {
        const std::scoped_lock lock(state->mutex);
        const auto now = std::chrono::steady_clock::now();
        const bool last = share >= 1.0;
        if (!last && now - state->shown < interval) return;
        state->shown = now;
        const std::chrono::duration<double> so_far = now - state->begin;
        // Work of the first second says too little about the rest.
        if (so_far.count() < 1.0) return;
        if (last) {
            if (terminal) std::fprintf(stderr, "\r\033[K");
            return;
        }
        const std::string left = time_left_text(so_far.count(), share);
        const std::string line = what + ": " + percent_done(share) +
                                 (left.empty() ? "" : ", " + left) +
                                 (said ? said() : std::string());
        std::fprintf(stderr, terminal ? "\r%s\033[K" : "%s\n", line.c_str());
    };
}

std::string aligned(const std::vector<TextRow>& exact) {
    std::vector<TextRow> rows;
    for (const TextRow& row : exact) rows.push_back(shown_texts(row));
    std::vector<std::size_t> widths(rows.empty() ? 0 : rows.front().size(), 0);
    for (const TextRow& row : rows) {
        assert(row.size() == widths.size() && "as many cells in every row");
        for (std::size_t k = 0; k < row.size(); ++k) widths[k] = std::max(widths[k], row[k].size());
    }
    std::string text;
    for (const TextRow& row : rows) {
        std::string line;
        for (std::size_t k = 0; k < row.size(); ++k) {
            const std::string blanks(widths[k] - row[k].size(), ' ');
            line += k == 0 ? row[k] + blanks : "  " + blanks + row[k];
        }
        text += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
    }
    return text;
}

std::string range_text(double low, double high, int digits) {
    if (std::isnan(low) || std::isnan(high)) return "-";
    return fixed_digits(low, digits) + " to " + fixed_digits(high, digits);
}

std::string csv_line(const TextRow& row) {
    std::string line;
    for (std::size_t k = 0; k < row.size(); ++k) line += (k == 0 ? "" : ",") + csv_field(row[k]);
    return line + "\n";
}

std::string csv_number(double value) {
    return std::isnan(value) ? std::string() : shortest_digits(value);
}

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
