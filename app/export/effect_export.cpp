#include "app/export/export.h"

#include <algorithm>
#include <utility>

#include "app/ui/ui.h"
#include "model/export/exported_files.h"
#include "model/subset/set_subset.h"
#include "model/text/names.h"
#include "model/text/utc_time.h"

namespace tact {

namespace {

constexpr double kLossSubsetLimitS = 20.0;

const std::vector<std::size_t>* named_part(const ExportGround& ground, ExportWhich which) {
    if (which == ExportWhich::selected) return &ground.selected;
    if (which == ExportWhich::picked) return &ground.picked;
    return nullptr;
}

bool is_wanted(const ExportGround& ground, ExportWhich which, std::size_t k) {
    const std::vector<std::size_t>* part = named_part(ground, which);
    return part == nullptr || std::ranges::binary_search(*part, k);
}

ExportTarget target_of(const ExportGround& ground, const EffectChoice& choice) {
    if (is_sampled(choice.format)) return {choice.format, {}, choice.sampled};
    if (choice.actuator.empty()) return usual_target(choice.format, *ground.set);
    return {choice.format, bundled_actuator(choice.actuator), {}};
}

// What is predicted is all of the set, but for a selection by itself.
LossRequest loss_request(const ExportGround& ground, const EffectChoice& choice) {
    LossRequest request;
    std::vector<std::size_t> members;
    const auto& all = ground.set->vibrations;
    for (std::size_t k = 0; k < all.size(); ++k) {
        const bool wanted = is_wanted(ground, choice.which, k);
        const bool counts = wanted || choice.which == ExportWhich::picked;
        if (!is_held(all[k], choice.format)) {
            if (wanted) ++request.recordings;
            continue;
        }
        if (wanted) request.written.push_back(members.size());
        if (counts) members.push_back(k);
    }
    request.part = std::make_shared<const PatternSet>(part_of(*ground.set, members));
    request.target = target_of(ground, choice);
    // If there are few patterns, as many as the Subset tab picks would be all of them.
    const bool choosable = ground.subset_count < members.size();
    request.subset_count = choosable ? ground.subset_count : 0;
    request.objective = ground.objective;
    request.known = ground.known;
    request.date = utc_today();
    return request;
}

void ask(const Ui& ui, EffectExport& effects) {
    effects.without = false;
    if (has_jobs(ui)) effects.job.ask(effects.request, compute_loss, ui.wake);
}

std::vector<std::string> written_names(const EffectExport& effects) {
    return effect_file_names(part_of(*effects.request.part, effects.request.written),
                             effects.request.target.format);
}

}  // namespace

ExportTarget target_of(const EffectExport& effects) {
    return target_of(effects.ground, effects.choice);
}

std::optional<LiveLoss> compute_loss(const LossRequest& request, std::stop_token stop,
                                     std::atomic<float>& progress) {
    ExportLossOptions options;
    options.subset_count = request.subset_count;
    options.objective = request.objective;
    options.time_limit_s = kLossSubsetLimitS;
    options.known = request.known ? &request.known->prediction : nullptr;
    options.date = request.date;
    options.stop = stop;
    options.progress = [&progress](double share) { progress = static_cast<float>(share); };
    auto loss = export_loss(*request.part, request.target, options);
    if (!loss) return std::nullopt;
    return LiveLoss{request, *std::move(loss)};
}

void export_effects_dialog(Ui& ui, const Workspace& work, const ShownMap& shown_map,
                           const std::vector<std::string>& picked, std::size_t subset_count,
                           SubsetObjective objective, EffectExport& effects) {
    const PatternSet& set = work.document.set;
    ExportGround ground{
        std::make_shared<const PatternSet>(set), {}, {}, subset_count, objective, {}};
    const std::set<std::size_t>& others = work.selection.others;
    for (std::size_t k = 0; k < set.vibrations.size(); ++k) {
        if (k == work.selection.current || others.contains(k)) ground.selected.push_back(k);
        const bool is_picked = std::ranges::find(picked, set.vibrations[k].name) != picked.end();
        if (is_picked) ground.picked.push_back(k);
    }
    const auto& map = shown_map.transition.shown;
    if (map && !map->request.preview) ground.known = map;
    effects.ground = std::move(ground);
    const auto* part = named_part(effects.ground, effects.choice.which);
    if (part != nullptr && part->empty()) effects.choice.which = ExportWhich::all;
    effects.asked.reset();
    effects.answer.reset();
    effects.opened = effects.request.number;
    ui.dialog = kExportEffectsDialog;
}

void follow_effects(const Ui& ui, EffectExport& effects) {
    const auto latest = effects.job.latest();
    if (latest && latest->request.number > effects.opened) effects.answer = latest;
    if (effects.asked == effects.choice) return;
    effects.asked = effects.choice;
    const std::uint64_t number = effects.request.number + 1;
    effects.request = loss_request(effects.ground, effects.choice);
    effects.request.number = number;
    // Two predictions; one of them is known where the map is.
    const double predictions = effects.ground.known ? 1.0 : 2.0;
    effects.large = needs_asking(*effects.request.part) ||
                    predictions * expected_map_s(*effects.request.part) > kLongestUnaskedS;
    effects.without = effects.large;
    if (effects.large) {
        effects.job.cancel();
        return;
    }
    ask(ui, effects);
}

void predict_anyway(const Ui& ui, EffectExport& effects) { ask(ui, effects); }

void stop_predicting(EffectExport& effects) {
    effects.job.cancel();
    effects.without = true;
}

bool is_predicting_loss(const EffectExport& effects) { return effects.job.busy(); }

bool is_loss_current(const EffectExport& effects) {
    return effects.answer && effects.answer->request.number == effects.request.number;
}

void choose_effect_folder(Ui& ui, const Workspace& work, EffectExport& effects) {
    const TargetFormat format = effects.request.target.format;
    std::vector<std::string> names = with_second_files(written_names(effects), format);
    if (is_loss_current(effects)) names.emplace_back(kExportReport);
    const std::string set = work.document.set.name;
    ask_for_file(ui,
                 {.use = ChooserUse::save_folder,
                  .title = std::string("Export as ") + traits(effects.request.target.format).title +
                           " into a folder",
                  .extensions = {std::filesystem::path(names.front()).extension().string()},
                  .folders_too = true,
                  .file_names = names,
                  .take = [&](const std::filesystem::path& folder) { effects.export_to = folder; }},
                 work.document.path.parent_path(),
                 file_stem((set.empty() ? "untitled" : set) + " " +
                           traits(effects.request.target.format).key));
}

void continue_effect_export(Ui& ui, EffectExport& effects) {
    const std::filesystem::path folder = std::exchange(effects.export_to, {});
    const LossRequest& request = effects.request;
    const ExportLoss* loss = is_loss_current(effects) ? &effects.answer->loss : nullptr;
    ExportedFilesOptions options;
    options.without_loss = true;
    options.written = request.written;
    options.known = loss;
    ExportedFiles exported = *exported_files(*request.part, request.target, request.date, options);
    const std::vector<std::string>& names = exported.names;
    const ExportTarget& target = exported.target;
    std::vector<TextFile>& files = exported.files;
    if (loss != nullptr) {
        files.push_back(
            {kExportReport, export_report({*loss, *request.part, request.written, names})});
    }
    if (const auto written = write_files(folder, files); !written) {
        return complain(ui, "Not exported: " + written.error().message);
    }
    std::string text = "Exported " + std::to_string(names.size()) +
                       (names.size() == 1 ? " pattern" : " patterns") + " " + words_on(target) +
                       ", into " + folder.string();
    if (target.format == TargetFormat::wav) text += "; " + meaning_of(target);
    if (loss == nullptr) text += "; what that costs was not predicted";
    say(ui, text);
}

}  // namespace tact
