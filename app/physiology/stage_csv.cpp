#include "app/physiology/physiology.h"

#include <array>
#include <charconv>
#include <cmath>
#include <numeric>
#include <span>

#include "model/perceptual_model/rhythm_envelope.h"
#include "model/physiology/firing.h"

namespace tact {

namespace {

// A CSV text, number by number; numbers are the shortest that read back the same.
class Table {
  public:
    explicit Table(const std::string& header) : text_(header + "\n") {}

    Table& operator<<(double value) {
        char digits[32];
        const auto end = std::to_chars(digits, digits + sizeof digits, value).ptr;
        return cell({digits, static_cast<std::size_t>(end - digits)});
    }
    Table& operator<<(const char* value) { return cell(value); }

    void end_row() { text_.back() = '\n'; }

    const std::string& text() const { return text_; }

  private:
    Table& cell(std::string_view value) {
        text_ += value;
        text_ += ',';
        return *this;
    }

    std::string text_;
};

double time_of_sample_s(std::size_t n) { return static_cast<double>(n) / kModelRateHz; }
double time_of_step_s(std::size_t step) { return time_of_sample_s(step * kStepSamples); }

std::string input_csv(const Waveform& waveform) {
    Table table("time_s,acceleration_g");
    for (std::size_t n = 0; n < waveform.samples_g.size(); ++n) {
        (table << time_of_sample_s(n) << waveform.samples_g[n]).end_row();
    }
    return table.text();
}

std::string spectrum_csv(const NeuralCodingStages& stages, const PhysiologyTables& tables) {
    Table table(
        "frequency_hz,acceleration_g,skin_um,threshold_FA1_um,threshold_FA2_um,threshold_SA1_um,"
        "threshold_SA2_um");
    for (const Component& component : stages.components) {
        table << component.frequency_hz << component.amplitude_g << component.skin_um;
        for (const Curve& threshold : tables.threshold) {
            table << std::pow(10.0, at(threshold, component.frequency_hz));
        }
        table.end_row();
    }
    return table.text();
}

// A type that is not silent may follow nothing but what its filter leaks: that is no firing.
std::string activation_csv(const NeuralCodingStages& stages, const NeuralCodingParams& params) {
    Table table(
        "receptor,rate_imp_per_s,slope_sum_imp_per_s,radius_mm,grid_side,receptors,silent,"
        "only_leaks");
    const PerReceptor<Firing> firing = firing_of(stages, params);
    for (const Receptor receptor : kReceptors) {
        const std::size_t c = index_of(receptor);
        const Activation& activation = stages.code.activation[c];
        const ChannelStages& channel = stages.channel[c];
        table << traits(receptor).afferent << activation.rate_hz << activation.slope_sum
              << activation.radius_mm << 2.0 * channel.grid.half_width + 1.0
              << static_cast<double>(channel.grid.activated) << (channel.silent ? 1.0 : 0.0)
              << (firing[c] == Firing::leaks ? 1.0 : 0.0);
        table.end_row();
    }
    return table.text();
}

// One column a channel.
template <class Signal>
std::string channels_csv(const NeuralCodingStages& stages, const char* unit, Signal signal) {
    std::string header = "time_s";
    for (const Receptor receptor : kReceptors) {
        header += std::string(",") + traits(receptor).afferent + unit;
    }
    Table table(header);
    const std::size_t samples = stages.channel[0].perceived.size();
    for (std::size_t n = 0; n < samples; ++n) {
        table << time_of_sample_s(n);
        for (const ChannelStages& channel : stages.channel) table << signal(channel)[n];
        table.end_row();
    }
    return table.text();
}

std::string receptors_csv(const NeuralCodingStages& stages) {
    Table table("receptor,number,x_mm,y_mm,distance_mm,rate_imp_per_s,fires,spikes");
    for (const Receptor receptor : kReceptors) {
        const ChannelStages& channel = stages.channel[index_of(receptor)];
        for (std::size_t k = 0; k < channel.grid.receptors.size(); ++k) {
            const GridReceptor& place = channel.grid.receptors[k];
            const auto& train = channel.spike_count[k];
            table << traits(receptor).afferent << static_cast<double>(k) << channel.grid.x_mm(place)
                  << channel.grid.y_mm(place) << place.distance_mm << place.rate_hz << place.fires
                  << std::accumulate(train.begin(), train.end(), 0.0);
            table.end_row();
        }
    }
    return table.text();
}

// Steps without spikes are left out.
std::string spikes_csv(const NeuralCodingStages& stages) {
    Table table("receptor,number,step,time_s,spikes");
    for (const Receptor receptor : kReceptors) {
        const ChannelStages& channel = stages.channel[index_of(receptor)];
        for (std::size_t k = 0; k < channel.spike_count.size(); ++k) {
            for (std::size_t step = 0; step < channel.spike_count[k].size(); ++step) {
                const int count = channel.spike_count[k][step];
                if (count == 0) continue;
                table << traits(receptor).afferent << static_cast<double>(k)
                      << static_cast<double>(step) << time_of_step_s(step) << count;
                table.end_row();
            }
        }
    }
    return table.text();
}

// Layer 0 are the spikes; cells at zero are left out.
void add_layer_rows(Table& table, Receptor receptor, std::size_t step, std::size_t number,
                    const RelayLayer& layer) {
    for (int row = -layer.half_width; row <= layer.half_width; ++row) {
        for (int column = -layer.half_width; column <= layer.half_width; ++column) {
            const double value = layer.at(column, row);
            if (value == 0.0) continue;
            table << traits(receptor).afferent << static_cast<double>(step)
                  << static_cast<double>(number) << column << row << value;
            table.end_row();
        }
    }
}

// Made step by step: of a long vibration, all layers of all steps are gigabytes.
std::string layers_csv(const StageValues& values) {
    Table table("receptor,step,layer,column,row,value");
    for (const Receptor receptor : kReceptors) {
        const std::size_t c = index_of(receptor);
        for (std::size_t step = 0; step < values.neural.code.central_count[c].size(); ++step) {
            const auto layers = relay_layers(values.neural.channel[c], step, values.model.coding);
            for (std::size_t k = 0; k < layers.size(); ++k) {
                add_layer_rows(table, receptor, step, k, layers[k]);
            }
        }
    }
    return table.text();
}

std::string central_csv(const NeuralCode& code) {
    Table table("step,time_s,FA1,FA2,SA1,SA2");
    for (std::size_t step = 0; step < code.central_count[0].size(); ++step) {
        table << static_cast<double>(step) << time_of_step_s(step);
        for (const auto& counts : code.central_count) table << counts[step];
        table.end_row();
    }
    return table.text();
}

std::string signal_csv(const char* name, std::span<const double> signal) {
    Table table(std::string("time_s,") + name);
    for (std::size_t n = 0; n < signal.size(); ++n) {
        (table << time_of_sample_s(n) << signal[n]).end_row();
    }
    return table.text();
}

std::string brain_csv(const StageValues& values) {
    return signal_csv("predicted_brain_waveform",
                      predicted_brain_waveform(values.neural.code, values.model.channel_weight));
}

std::string envelope_csv(const StageValues& values) {
    return signal_csv("envelope",
                      rhythm_envelope(values.waveform.samples_g, values.model.envelope));
}

struct StageFile {
    Stage stage;
    const char* name;
    std::string (*text)(const StageValues&);
};

constexpr auto kFiles = std::to_array<StageFile>({
    {Stage::vibration, "input.csv",
     [](const StageValues& values) { return input_csv(values.waveform); }},
    {Stage::spectrum, "spectrum.csv",
     [](const StageValues& values) {
         return spectrum_csv(values.neural, values.model.coding.tables);
     }},
    {Stage::spectrum, "activation.csv",
     [](const StageValues& values) { return activation_csv(values.neural, values.model.coding); }},
    {Stage::filtered, "filtered.csv",
     [](const StageValues& values) {
         return channels_csv(
             values.neural, "_g", [](const ChannelStages& c) -> auto& { return c.filtered_g; });
     }},
    {Stage::filtered, "perceived.csv",
     [](const StageValues& values) {
         return channels_csv(
             values.neural, "", [](const ChannelStages& c) -> auto& { return c.perceived; });
     }},
    {Stage::receptors, "receptors.csv",
     [](const StageValues& values) { return receptors_csv(values.neural); }},
    {Stage::spikes, "spikes.csv",
     [](const StageValues& values) { return spikes_csv(values.neural); }},
    {Stage::networks, "layers.csv", layers_csv},
    {Stage::central, "central.csv",
     [](const StageValues& values) { return central_csv(values.neural.code); }},
    {Stage::brain, "brain_waveform.csv", brain_csv},
    {Stage::envelope, "envelope.csv", envelope_csv},
});

}  // namespace

StageValues stage_values(const Waveform& waveform, const PerceptualModelParams& model) {
    return {waveform, model, neural_coding_stages(waveform, model.coding, KeepLayers::none)};
}

std::vector<std::string> stage_csv_names(Stage stage) {
    std::vector<std::string> names;
    for (const StageFile& file : kFiles) {
        if (file.stage == stage) names.emplace_back(file.name);
    }
    return names;
}

std::vector<CsvFile> stage_csv(const StageValues& values, Stage stage) {
    std::vector<CsvFile> files;
    for (const StageFile& file : kFiles) {
        if (file.stage == stage) files.push_back({file.name, file.text(values)});
    }
    return files;
}

}  // namespace tact
