// tactspace render: waveforms of all patterns, a file each.

#include <algorithm>
#include <iostream>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "app/command_line/commands.h"
#include "app/command_line/output.h"
#include "app/folders.h"
#include "model/io/atomic_file.h"
#include "model/io/text_waveform.h"
#include "model/io/wave_file.h"

namespace tact {

namespace {

// A name as a file may have it: no separators, no leading dot, not empty, none twice.
std::string file_stem(const std::string& name, std::set<std::string>& taken) {
    std::string stem = name;
    for (char& c : stem) {
        if (c == '/' || c == '\\' || static_cast<unsigned char>(c) < 0x20) c = '_';
    }
    if (stem.empty() || stem.front() == '.') stem.insert(stem.begin(), '_');
    std::string unused = stem;
    for (int number = 2; !taken.insert(unused).second; ++number) {
        unused = stem + " " + std::to_string(number);
    }
    return unused;
}

Expected<Done> write_csv(const std::filesystem::path& path, const Waveform& waveform) {
    std::ostringstream text;
    text.precision(17);
    text << "time_s,acceleration_g\n";
    for (std::size_t n = 0; n < waveform.samples_g.size(); ++n) {
        text << static_cast<double>(n) / waveform.rate_hz << ',' << waveform.samples_g[n] << '\n';
    }
    return write_atomically(path, text.str());
}

}  // namespace

Expected<Done> run(const RenderCommand& command) {
    const Expected<PatternSet> set = load_for(command.common);
    if (!set) return set.error();
    if (const Expected<Done> made = make_folder(command.out); !made) return made;
    std::vector<Waveform> waveforms;
    double loudest_g = 0.0;
    for (const Vibration& vibration : set->vibrations) {
        waveforms.push_back(waveform_of(vibration));
        loudest_g = std::max(loudest_g, peak_g(waveforms.back()));
    }
    // One scale for all, so that their relative strength survives and nothing clips.
    WaveOptions wave;
    wave.scale_g = loudest_g > 0.0 ? loudest_g : 1.0;
    std::set<std::string> taken;
    nlohmann::json files = nlohmann::json::array();
    for (std::size_t k = 0; k < waveforms.size(); ++k) {
        const std::string stem = file_stem(set->vibrations[k].name, taken);
        const std::filesystem::path path = command.out / (stem + "." + command.format);
        Expected<Done> written = Done{};
        if (command.format == "wav") written = write_wave_file(path, waveforms[k], wave);
        if (command.format == "txt") written = write_text_waveform(path, waveforms[k]);
        if (command.format == "csv") written = write_csv(path, waveforms[k]);
        if (!written) return written;
        files.push_back(path.string());
    }
    std::cerr << "tactspace: wrote " << waveforms.size() << " files to " << command.out.string();
    if (command.format == "wav") std::cerr << ", " << wave.scale_g << " g at full scale";
    std::cerr << "\n";
    if (command.common.json) std::cout << nlohmann::json{{"files", files}}.dump() << "\n";
    return Done{};
}

}  // namespace tact
