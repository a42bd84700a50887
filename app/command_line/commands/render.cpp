// tactspace render: waveforms of all patterns, a file each; as they are meant or as a device plays
// them, then with a report on what is lost.

#include <algorithm>
#include <iostream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "app/command_line/commands.h"
#include "app/command_line/output.h"
#include "app/session/session.h"
#include "model/io/folders/path_json.h"
#include "model/io/recordings/text_waveform.h"
#include "model/io/recordings/wave_file.h"
#include "model/io/tables/matrix_file.h"
#include "model/text/atomic_file.h"
#include "model/text/json_fields.h"
#include "model/text/names.h"
#include "model/text/numbers.h"

namespace tact {

namespace {

// What a device plays, with the report on each: two tables in the folder.
struct DeviceReport {
    std::ostringstream bands;
    std::ostringstream packets;
    nlohmann::json patterns = nlohmann::json::array();
};

void begin(DeviceReport& report) {
    report.bands.precision(17);
    report.packets.precision(17);
    report.bands << "pattern,low_hz,high_hz,intended_g2,rendered_g2,share_lost\n";
    report.packets << "pattern,at_s,share_lost,folded,noise\n";
}

void add(DeviceReport& report, const std::string& name, const Rendering& rendering) {
    nlohmann::json bands = nlohmann::json::array();
    for (const BandEnergy& band : rendering.bands) {
        report.bands << csv_field(name) << ',' << band.low_hz << ',' << band.high_hz << ','
                     << band.intended_g2 << ',' << band.rendered_g2 << ',' << band.share_lost
                     << '\n';
        bands.push_back({{"low_hz", band.low_hz},
                         {"high_hz", band.high_hz},
                         {"intended_g2", band.intended_g2},
                         {"rendered_g2", band.rendered_g2},
                         {"share_lost", band.share_lost}});
    }
    for (const RenderedFrame& frame : rendering.frames) {
        report.packets << csv_field(name) << ',' << frame.at_s << ',' << frame.share_lost << ','
                       << frame.folded << ',' << frame.noise << '\n';
    }
    report.patterns.push_back({{"pattern", name},
                               {"share_lost", rendering.share_lost},
                               {"share_added", rendering.share_added},
                               {"clipped", rendering.clipped},
                               {"warnings", rendering.warnings},
                               {"bands", bands}});
}

Expected<Done> write(const DeviceReport& report, const RenderedBy& by,
                     const std::filesystem::path& folder) {
    const auto bands = write_atomically(folder / "bands.csv", report.bands.str());
    if (!bands || traits(by.kind).language != Language::two_bands) return bands;
    return write_atomically(folder / "packets.csv", report.packets.str());
}

}  // namespace

Expected<Done> run(const RenderCommand& command) {
    const Expected<PatternSet> set = load_as_meant(command.common);
    if (!set) return set.error();
    const Expected<std::optional<RenderedBy>> by = rendered_by(command.common);
    if (!by) return by.error();
    if (const Expected<Done> made = make_folder(command.out); !made) return made;
    std::vector<Waveform> waveforms;
    double loudest_g = 0.0;
    DeviceReport report;
    begin(report);
    for (const Vibration& vibration : set->vibrations) {
        waveforms.push_back(waveform_of(vibration));
        if (*by) {
            Rendering made = rendering(**by, waveforms.back());
            add(report, vibration.name, made);
            waveforms.back() = std::move(made.waveform);
        }
        loudest_g = std::max(loudest_g, peak_g(waveforms.back()));
    }
    // One scale for all, so that their relative strength survives and nothing clips.
    WaveOptions wave;
    wave.scale_g = loudest_g > 0.0 ? loudest_g : 1.0;
    UnusedNames stems;
    if (*by) stems.taken = {"bands", "packets"};
    nlohmann::json files = nlohmann::json::array();
    for (std::size_t k = 0; k < waveforms.size(); ++k) {
        const std::string stem = stems.unused(file_stem(set->vibrations[k].name));
        const std::filesystem::path path = command.out / (stem + "." + command.format);
        Expected<Done> written = Done{};
        if (command.format == "wav") written = write_wave_file(path, waveforms[k], wave);
        if (command.format == "txt") written = write_text_waveform(path, waveforms[k]);
        if (command.format == "csv") written = write_atomically(path, waveform_csv(waveforms[k]));
        if (!written) return written;
        files.push_back(path_json(path));
    }
    std::cerr << "tactspace: wrote " << counted(waveforms.size(), "file", "files") << " to "
              << command.out.string();
    if (command.format == "wav") std::cerr << ", " << wave.scale_g << " g at full scale";
    std::cerr << "\n";
    if (*by) {
        if (const auto written = write(report, **by, command.out); !written) return written;
        std::cerr << "tactspace: " << sentence_on(**by) << "; what is lost stands in bands.csv\n";
    }
    if (command.common.json) {
        nlohmann::json answer{{"files", files}};
        if (*by) {
            add_labels(answer,
                       {.by = *by, .mark = {.synthetic_patterns = has_synthetic_patterns(*set)}});
            answer["patterns"] = report.patterns;
        }
        std::cout << text_of_json(answer) << "\n";
    }
    return Done{};
}

}  // namespace tact
