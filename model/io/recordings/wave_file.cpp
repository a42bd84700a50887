#include "model/io/recordings/wave_file.h"

#include <sndfile.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <memory>
#include <nlohmann/json.hpp>

#include "model/io/recordings/memory_sound.h"
#include "model/io/recordings/wave_size.h"
#include "model/pattern/pattern.h"
#include "model/signal/resample.h"
#include "model/signal/waveform.h"
#include "model/text/atomic_file.h"
#include "model/text/json_fields.h"
#include "model/text/numbers.h"

namespace tact {

namespace fs = std::filesystem;

namespace {

struct Closer {
    void operator()(SNDFILE* sound) const { sf_close(sound); }
};
using Sound = std::unique_ptr<SNDFILE, Closer>;

fs::path sidecar_of(const fs::path& path) { return fs::path(path) += ".json"; }

// The options with what the sidecar says where they say nothing.
Expected<RecordingOptions> with_sidecar(RecordingOptions options, const fs::path& wave) {
    constexpr Range kChannels{1, 1024};  // libsndfile's own limit
    const fs::path path = sidecar_of(wave);
    std::error_code none;
    if (!fs::exists(path, none)) return options;
    const auto text = read_text_file(path);
    if (!text) return text.error();
    auto document = parse_json(*text, path.string());
    if (!document) return document.error();
    JsonReading reading{path.string(), {}};
    JsonObject object = object_at(reading, *document, "");
    const double scale_g = number_field(object, "scale_g", 0.0, limits::kScaleG);
    const int channel = whole_field(object, "channel", 0, kChannels);
    if (!reading.fault.empty()) return Error{reading.fault};
    if (!options.scale_g && scale_g > 0.0) options.scale_g = scale_g;
    if (!options.channel && channel > 0) options.channel = static_cast<std::size_t>(channel - 1);
    return options;
}

// What a header says that we do not read, or empty.
std::string header_fault(const SF_INFO& info, std::size_t channel) {
    const auto channels = static_cast<std::size_t>(info.channels);
    if (info.frames <= 0) return "expected at least one sample, got none";
    if (info.samplerate < kLowestRateHz || info.samplerate > kHighestRateHz) {
        return "expected a rate of 100 Hz to 10 MHz, got " + std::to_string(info.samplerate) +
               " Hz";
    }
    if (static_cast<double>(info.frames) > limits::kDurationS.high * info.samplerate) {
        return "expected at most 60 s, got " +
               grouped_digits(static_cast<std::size_t>(info.frames)) + " samples at " +
               std::to_string(info.samplerate) + " Hz";
    }
    if (channel >= channels) {
        return "expected channel " + std::to_string(channel + 1) + ", got a file of " +
               std::to_string(channels);
    }
    return {};
}

// The samples of one channel, 1 being full scale.
std::vector<double> read_channel(SNDFILE* sound, const SF_INFO& info, std::size_t channel) {
    constexpr sf_count_t kBlockFrames = 4096;
    const auto channels = static_cast<std::size_t>(info.channels);
    std::vector<double> block(static_cast<std::size_t>(kBlockFrames) * channels);
    std::vector<double> samples;
    samples.reserve(static_cast<std::size_t>(info.frames));
    while (const sf_count_t frames = sf_readf_double(sound, block.data(), kBlockFrames)) {
        for (std::size_t k = 0; k < static_cast<std::size_t>(frames); ++k) {
            samples.push_back(block[k * channels + channel]);
        }
    }
    return samples;
}

// The opened file, its header read, or why not.
Expected<std::shared_ptr<SNDFILE>> opened(const fs::path& path, SF_INFO& info) {
    const std::string name = path.string();
    const auto size = readable_size(path);
    if (!size) return size.error();
    std::ifstream stream(path, std::ios::binary);
    if (!stream) return Error{name + ": cannot be opened for reading"};
    if (const std::string fault = wave_size_fault(stream, *size); !fault.empty()) {
        return Error{name + ": " + fault};
    }
    std::shared_ptr<SNDFILE> sound(sf_open(path.c_str(), SFM_READ, &info), [](SNDFILE* open) {
        if (open != nullptr) sf_close(open);
    });
    if (!sound) return Error{name + ": expected a WAV file: " + sf_strerror(nullptr)};
    return sound;
}

// What is wrong with the samples in g, or empty.
std::string sample_fault(const std::vector<double>& samples_g, const SF_INFO& info) {
    if (samples_g.size() < static_cast<std::size_t>(info.frames)) {
        return "is truncated: expected " + std::to_string(info.frames) + " samples, got " +
               std::to_string(samples_g.size());
    }
    for (std::size_t k = 0; k < samples_g.size(); ++k) {
        if (std::abs(samples_g[k]) <= kMaxSampleG) continue;  // false for NaN
        return "sample " + std::to_string(k + 1) + " is " + shortest_digits(samples_g[k]) +
               ", expected a finite number of at most 1,000,000 g";
    }
    return {};
}

std::string rate_text(double rate_hz) {
    return grouped_digits(static_cast<std::size_t>(std::llround(rate_hz))) + " Hz";
}

// Rounded here: where libsndfile guards against overflow it cuts off instead.
std::vector<int> quantised(const std::vector<double>& samples, int bits) {
    const double steps = std::ldexp(1.0, bits - 1);
    std::vector<int> result;
    result.reserve(samples.size());
    for (const double sample : samples) {
        const double step = std::clamp(std::round(sample * steps), -steps, steps - 1.0);
        result.push_back(static_cast<int>(std::ldexp(step, 32 - bits)));  // libsndfile's 32 bits
    }
    return result;
}

bool write_samples(SNDFILE* sound, std::vector<double> samples, const WaveOptions& options) {
    for (double& sample : samples) sample /= options.scale_g;
    const auto count = static_cast<sf_count_t>(samples.size());
    if (options.encoding == WaveEncoding::float32) {
        return sf_writef_double(sound, samples.data(), count) == count;
    }
    const int bits = options.encoding == WaveEncoding::int16 ? 16 : 24;
    return sf_writef_int(sound, quantised(samples, bits).data(), count) == count;
}

}  // namespace

Expected<WaveChannels> read_wave_channels(const fs::path& path) {
    SF_INFO info{};
    const auto sound = opened(path, info);
    if (!sound) return sound.error();
    const auto options = with_sidecar({}, path);
    if (!options) return options.error();
    if (const auto fault = header_fault(info, 0); !fault.empty()) {
        return Error{path.string() + ": " + fault};
    }
    WaveChannels result{static_cast<double>(info.samplerate), {}, options->scale_g};
    for (std::size_t k = 0; k < static_cast<std::size_t>(info.channels); ++k) {
        sf_seek(sound->get(), 0, SEEK_SET);
        result.channels.push_back(read_channel(sound->get(), info, k));
        if (const auto fault = sample_fault(result.channels.back(), info); !fault.empty()) {
            return Error{path.string() + ": " + fault};
        }
    }
    return result;
}

Expected<Recording> read_wave_file(const fs::path& path, const RecordingOptions& asked) {
    const std::string name = path.string();
    SF_INFO info{};
    const auto sound = opened(path, info);
    if (!sound) return sound.error();
    const auto options = with_sidecar(asked, path);
    if (!options) return options.error();
    const std::size_t channel = options->channel.value_or(0);
    if (const auto fault = header_fault(info, channel); !fault.empty()) {
        return Error{name + ": " + fault};
    }
    Recording recording;
    recording.scale_g = options->scale_g.value_or(1.0);
    Waveform original{static_cast<double>(info.samplerate),
                      read_channel(sound->get(), info, channel)};
    for (double& sample : original.samples_g) sample *= recording.scale_g;
    if (const auto fault = sample_fault(original.samples_g, info); !fault.empty()) {
        return Error{name + ": " + fault};
    }
    recording.waveform = resampled(original, kModelRateHz);
    if (recording.waveform.samples_g.empty()) {
        return Error{name + ": expected at least one sample at 10 kHz, got a shorter file"};
    }
    if (original.rate_hz != kModelRateHz) {
        recording.remarks.push_back("resampled from " + rate_text(original.rate_hz) + " to " +
                                    rate_text(kModelRateHz));
    }
    if (info.channels > 1 && !options->channel) {
        recording.remarks.push_back("first of " + std::to_string(info.channels) + " channels used");
    }
    if (!options->scale_g) recording.remarks.push_back("full scale taken as 1 g");
    return recording;
}

Expected<Done> write_wave_file(const fs::path& path, const Waveform& waveform,
                               const WaveOptions& options) {
    const std::string name = path.string();
    const double peak = peak_g(waveform);
    if (options.encoding != WaveEncoding::float32 && peak > options.scale_g) {
        return Error{name + ": expected a peak within the full scale of " +
                     shortest_digits(options.scale_g) + " g, got " + shortest_digits(peak) + " g"};
    }
    MemorySound memory;
    SF_INFO info{};
    info.samplerate = static_cast<int>(std::lround(waveform.rate_hz));
    info.channels = 1;
    info.format = SF_FORMAT_WAV | (options.encoding == WaveEncoding::int16   ? SF_FORMAT_PCM_16
                                   : options.encoding == WaveEncoding::int24 ? SF_FORMAT_PCM_24
                                                                             : SF_FORMAT_FLOAT);
    Sound sound(open_for_writing(memory, info));
    if (!sound) return Error{name + ": cannot be encoded: " + sf_strerror(nullptr)};
    // Its time stamp would make every file another one.
    sf_command(sound.get(), SFC_SET_ADD_PEAK_CHUNK, nullptr, SF_FALSE);
    if (!write_samples(sound.get(), waveform.samples_g, options)) {
        return Error{name + ": cannot be encoded: " + sf_strerror(sound.get())};
    }
    sound.reset();  // completes the header

    // The sidecar first: of a new sidecar and an old recording, the next save makes a pair again.
    std::error_code none;
    if (options.scale_g != 1.0 || fs::exists(sidecar_of(path), none)) {
        const Json sidecar = {{"scale_g", options.scale_g}};
        auto written = write_atomically(sidecar_of(path), sidecar.dump() + "\n");
        if (!written) return written;
    }
    return write_atomically(path, memory.bytes);
}

}  // namespace tact
