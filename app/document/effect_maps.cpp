#include "app/document/editing.h"

#include <algorithm>
#include <map>
#include <set>

#include "app/document/workspace.h"
#include "model/io/formats/read_effects.h"
#include "model/io/set/load.h"

namespace tact {

namespace {

using Sources = std::vector<Vibration>;  // one effect, as each map has read it

bool is_as_read(const Vibration& now, const Vibration& read) {
    return now.effect == read.effect && now.source == read.source;
}

// The files once more; nothing where they are not what they were.
Expected<Sources> read_again(const EffectFiles& files, const ActuatorMap& map) {
    auto loaded = load_sets(files.paths, map);
    if (!loaded) return loaded.error();
    const Sources& read = loaded->set.vibrations;
    const auto same = [](const Vibration& one, const Sources& before) {
        return one.name == before.front().name && one.effect.format == before.front().effect.format;
    };
    if (read.size() != files.read.size() || !std::ranges::equal(read, files.read, same)) {
        return Error{files.paths.front().string() + ": has changed since it was read"};
    }
    return std::move(loaded->set.vibrations);
}

struct Exchanged {
    std::size_t read = 0;
    std::size_t left = 0;  // edited since, or locked
};

// An effect as it was read before, and as it is read now.
struct Again {
    const Sources* before = nullptr;
    const Vibration* now = nullptr;
};

// What a vibration of the document was read as: by its note, too, where two files hold the same;
// null: it was edited since.
const Again* read_as(const Vibration& shown, const std::vector<Again>& all, bool by_note) {
    const auto is_it = [&](const Again& one) {
        return std::ranges::any_of(*one.before, [&](const Vibration& read) {
            return is_as_read(shown, read) && (!by_note || shown.note == read.note);
        });
    };
    const auto found = std::ranges::find_if(all, is_it);
    return found != all.end() ? &*found : nullptr;
}

void exchange(Vibration& shown, const std::vector<Again>& all, Exchanged& count) {
    const Again* same = read_as(shown, all, true);
    const bool has_its_note = same != nullptr;
    if (!has_its_note) same = read_as(shown, all, false);
    if (same == nullptr || shown.locked) {
        ++count.left;
        return;
    }
    if (has_its_note) shown.note = same->now->note;
    shown.source = same->now->source;
    shown.effect = same->now->effect;
    ++count.read;
}

}  // namespace

std::vector<MapInUse> maps_in_use(const Workspace& work) {
    struct Use {
        std::set<std::string> actuators;
        std::size_t patterns = 0;
    };
    std::map<std::string, Use> uses;
    for (const Vibration& one : work.document.set.vibrations) {
        if (one.effect.format.empty()) continue;
        uses[one.effect.format].actuators.insert(one.effect.actuator);
        ++uses[one.effect.format].patterns;
    }
    std::vector<MapInUse> all;
    for (const auto& [format, use] : uses) {
        MapInUse one{format, {}, use.patterns};
        for (const std::string& actuator : use.actuators) {
            one.actuators += (one.actuators.empty() ? "" : ", ") + actuator;
        }
        for (const EffectFiles& files : work.effects.files) {
            one.has_files |= std::ranges::any_of(files.read, [&](const Sources& read) {
                return read.front().effect.format == format;
            });
        }
        all.push_back(std::move(one));
    }
    return all;
}

void note_effect_files(Workspace& work, const std::vector<std::filesystem::path>& paths,
                       const std::vector<Vibration>& read) {
    const bool any =
        std::ranges::any_of(read, [](const Vibration& one) { return !one.effect.format.empty(); });
    if (!any) return;
    EffectFiles files{paths, {}};
    for (const Vibration& one : read) files.read.push_back({one});
    work.effects.files.push_back(std::move(files));
    work.effects.is_told = true;
}

void read_by_map(Ui& ui, Workspace& work, const std::string& format, const std::string& actuator) {
    const ActuatorMap& map = bundled_actuator(actuator);
    std::vector<Sources> fresh;
    for (const EffectFiles& files : work.effects.files) {
        auto read = read_again(files, map);
        if (!read) return complain(ui, "Not read again: " + read.error().message);
        fresh.push_back(*std::move(read));
    }
    std::vector<Again> all;
    for (std::size_t f = 0; f < fresh.size(); ++f) {
        for (std::size_t k = 0; k < fresh[f].size(); ++k) {
            const Vibration& one = fresh[f][k];
            const bool wanted = one.effect == EffectOrigin{format, actuator};
            if (wanted) all.push_back({&work.effects.files[f].read[k], &one});
        }
    }
    Exchanged count;
    for (Vibration& now : work.document.edit().vibrations) {
        const bool other = now.effect.format == format && now.effect.actuator != actuator;
        if (other) exchange(now, all, count);
    }
    for (std::size_t f = 0; f < fresh.size(); ++f) {
        for (std::size_t k = 0; k < fresh[f].size(); ++k) {
            Sources& known = work.effects.files[f].read[k];
            const Vibration& one = fresh[f][k];
            const bool is_new = std::ranges::none_of(
                known, [&](const Vibration& before) { return before.effect == one.effect; });
            if (one.effect.format == format && is_new) known.push_back(one);
        }
    }
    const std::string name = format_named(format)->name;
    document_changed(work);
    commit_step(ui, work, "Read " + name + " by " + actuator);
    std::string text =
        "Read " + patterns_text(count.read) + " of " + name + " by " + actuator + ".";
    if (count.left > 0) text += " " + patterns_text(count.left) + " edited since or locked: left.";
    say(ui, text);
}

}  // namespace tact
