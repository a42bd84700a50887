// Samples: WAV with what its full scale is beside it, and CSV.
//
// Source    model/io/recordings/wave_file.h, text_waveform.h

#include <algorithm>
#include <cmath>

#include "model/io/effects_out/shares.h"
#include "model/io/formats/samples/samples.h"
#include "model/io/recordings/text_waveform.h"
#include "model/text/numbers.h"

namespace tact {

namespace {

int bits_of(WaveEncoding encoding) { return encoding == WaveEncoding::int16 ? 16 : 24; }

// Steps from 0 to the largest number.
double largest_whole(WaveEncoding encoding) { return std::ldexp(1.0, bits_of(encoding) - 1) - 1.0; }

// Whether half a step may be a hundredth, 0.1 dB, of what is just felt where the skin feels best.
bool is_felt_step(double step_g) {
    constexpr double kFinestHz = 200.0;
    return felt_level_db({0.5 * step_g / 0.01, kFinestHz}) > 0.0;
}

Waveform turned_down(Waveform waveform, double most_g, std::vector<std::string>& remarks) {
    const double peak = peak_g(waveform);
    if (!(peak > most_g)) return waveform;
    remarks.push_back("louder than full scale: scaled by " + significant_digits(most_g / peak, 3));
    for (double& sample : waveform.samples_g) {
        sample = std::clamp(sample * (most_g / peak), -most_g, most_g);
    }
    return waveform;
}

}  // namespace

double full_scale_of(double peak_g, WaveEncoding encoding) {
    if (!(peak_g > 0.0)) return 1.0;
    const double most = limits::kScaleG.high;
    if (encoding == WaveEncoding::float32) return std::clamp(peak_g, limits::kScaleG.low, most);
    const double whole = largest_whole(encoding);
    return std::clamp(peak_g * ((whole + 1.0) / whole), limits::kScaleG.low, most);
}

WrittenEffect write_csv(const Waveform& waveform, const EffectTarget&) {
    WrittenEffect written;
    written.text = waveform_csv(waveform);
    return written;
}

WrittenEffect write_wav(const Waveform& waveform, const EffectTarget& target) {
    WrittenEffect written;
    SampledAs as = target.sampled;
    if (as.full_scale_g == 0.0) as.full_scale_g = full_scale_of(peak_g(waveform), as.encoding);
    const Waveform fits = turned_down(waveform, as.full_scale_g, written.remarks);
    auto text = wave_text(fits, {as.encoding, as.full_scale_g}, target.name);
    if (!text) {
        written.remarks.push_back(text.error().message);
        return written;
    }
    written.text = std::move(text->bytes);
    written.beside = std::move(text->sidecar);
    if (as.encoding == WaveEncoding::float32) return written;
    const double step_g = as.full_scale_g / (largest_whole(as.encoding) + 1.0);
    if (!is_felt_step(step_g)) return written;
    written.remarks.push_back("accelerations are in steps of " + significant_digits(step_g, 2) +
                              " g");
    return written;
}

}  // namespace tact
