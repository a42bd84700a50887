#include "model/io/recordings/wave_file.h"

#include <sndfile.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <sstream>
#include <string_view>
#include <utility>

#include "model/common/fingerprint.h"
#include "model/io/recordings/sound_file.h"
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

// A channel of its own, or all.
struct Wanted {
    std::size_t begin = 0;
    std::size_t end = 0;
};

// A WAV file in memory, its header read.
struct OpenWave {
    MemorySound memory;
    SF_INFO info{};
    Sound sound;
};

// The options with what the sidecar says where they say nothing, and a remark on it or none.
struct Told {
    RecordingOptions options;
    std::string remark;
};

Expected<Told> with_sidecar(RecordingOptions options, const WaveText& text, const std::string& file,
                            const OpenWave& wave) {
    constexpr Range kChannels{1, 1024};  // libsndfile's own limit
    if (text.sidecar.empty()) return Told{options, {}};
    const std::string sidecar = sidecar_of(file).string();
    auto document = parse_json(text.sidecar, sidecar);
    if (!document) return document.error();
    JsonReading reading{sidecar, {}, UnknownKeys::kept};
    JsonObject object = object_at(reading, *document, "");
    const double scale_g = number_field(object, "scale_g", 0.0, limits::kScaleG);
    const int channel = whole_field(object, "channel", 0, kChannels);
    const std::string of = text_field(object, "of", "");
    (void)unknown_fields(object);
    if (!reading.fault.empty()) return Error{reading.fault};
    Told told{options, {}};
    if (!options.scale_g && scale_g > 0.0) {
        told.options.scale_g = scale_g;
        if (!of.empty() && of != fingerprint_text(wave.memory.bytes)) {
            told.remark = "its .json was written for other samples, their full scale of " +
                          shortest_digits(scale_g) + " g may not be that of these";
        }
    }
    if (!options.channel && channel > 0) {
        told.options.channel = static_cast<std::size_t>(channel - 1);
    }
    return told;
}

// What a header says that we do not read, or empty. Before anything of the sizes in it is made.
std::string header_fault(const OpenWave& wave, Wanted wanted) {
    constexpr std::size_t kMostPerByte = 64;  // samples, however well they are packed
    const SF_INFO& info = wave.info;
    const auto channels = static_cast<std::size_t>(info.channels);
    const auto frames = static_cast<std::size_t>(std::max<sf_count_t>(info.frames, 0));
    if (frames == 0) return "expected at least one sample, got none";
    if (info.samplerate < kLowestRateHz || info.samplerate > kHighestRateHz) {
        return "expected a rate of 100 Hz to 10 MHz, got " + std::to_string(info.samplerate) +
               " Hz";
    }
    if (static_cast<double>(info.frames) > limits::kDurationS.high * info.samplerate) {
        return "expected at most 60 s, got " + grouped_digits(frames) + " samples at " +
               std::to_string(info.samplerate) + " Hz";
    }
    if (wanted.end > channels) {
        return "expected channel " + std::to_string(wanted.end) + ", got a file of " +
               std::to_string(channels);
    }
    if (frames / kMostPerByte > wave.memory.bytes.size()) {
        return "is truncated: expected " + grouped_digits(frames) + " samples";
    }
    const std::size_t count = wanted.end - wanted.begin;
    if (frames > kMaxDecodedSamples / count) {
        return "expected at most " + grouped_digits(kMaxDecodedSamples) + " samples, got " +
               grouped_digits(frames) + " of " + std::to_string(count) + " channels";
    }
    return {};
}

// Both files; a missing sidecar is empty.
Expected<WaveText> read_wave_text(const fs::path& path) {
    auto bytes = read_text_file(path, kMaxWaveBytes);
    if (!bytes) return bytes.error();
    const fs::path sidecar = sidecar_of(path);
    std::error_code none;
    if (!fs::exists(sidecar, none)) return WaveText{*std::move(bytes), {}};
    auto said = read_text_file(sidecar);
    if (!said) return said.error();
    // Nothing in it is a fault of its own: JSON has at least a word.
    return WaveText{*std::move(bytes), said->empty() ? " " : *std::move(said)};
}

// What libsndfile does not know: a BW64 is an RF64 by another name, and sizes of a stream that its
// writer never closed, which are 0 or sox's 0x7FFFF000, are those of one that says so.
void tell_plainly(std::string& bytes) {
    if (bytes.starts_with("BW64")) bytes.replace(0, 4, "RF64");
    std::uint32_t whole = 0;
    for (std::size_t k = 0; k < 4; ++k) {
        whole |= std::uint32_t{static_cast<unsigned char>(bytes[4 + k])} << 8 * k;
    }
    const bool is_of_sox = bytes.starts_with("RIFF") && whole > bytes.size();
    if (whole != 0 && !is_of_sox) return;  // what is whole need not be searched
    const std::string_view size =
        whole == 0 ? std::string_view("\0\0\0\0", 4) : std::string_view("\0\xF0\xFF\x7F", 4);
    const std::size_t data = bytes.find("data" + std::string(size));
    if (data == bytes.npos) return;
    for (const std::size_t at : {std::size_t{4}, data + 4}) bytes.replace(at, 4, 4, '\xFF');
}

Expected<std::unique_ptr<OpenWave>> opened(std::string&& bytes, const std::string& name) {
    const std::size_t size = bytes.size();
    std::istringstream stream(std::move(bytes));
    if (const std::string fault = wave_size_fault(stream, size); !fault.empty()) {
        return Error{name + ": " + fault};
    }
    auto wave = std::make_unique<OpenWave>();
    wave->memory.bytes = std::move(stream).str();
    tell_plainly(wave->memory.bytes);
    wave->sound.reset(open_for_reading(wave->memory, wave->info));
    if (!wave->sound) {
        const std::string why = sf_strerror(nullptr);
        // What the library says of a header without a rate, or with samples in two places.
        const bool is_about_itself = why.find("SF_INFO") != why.npos;
        return Error{name + ": expected a WAV file" +
                     (is_about_itself
                          ? " whose header has a rate, channels and one block of samples"
                          : ": " + why)};
    }
    return wave;
}

// The samples of the channels that are wanted, 1 being full scale, in one pass through the file.
std::vector<std::vector<double>> read_channels(OpenWave& wave, Wanted wanted) {
    constexpr std::size_t kBlockSamples = std::size_t{1} << 16;
    const auto channels = static_cast<std::size_t>(wave.info.channels);
    const auto block_frames = static_cast<sf_count_t>(1 + kBlockSamples / channels);
    std::vector<double> block(static_cast<std::size_t>(block_frames) * channels);
    std::vector<std::vector<double>> samples(wanted.end - wanted.begin);
    for (auto& one : samples) one.reserve(static_cast<std::size_t>(wave.info.frames));
    while (const sf_count_t frames =
               sf_readf_double(wave.sound.get(), block.data(), block_frames)) {
        for (std::size_t k = wanted.begin; k < wanted.end; ++k) {
            auto& one = samples[k - wanted.begin];
            for (std::size_t n = 0; n < static_cast<std::size_t>(frames); ++n) {
                one.push_back(block[n * channels + k]);
            }
        }
    }
    return samples;
}

// That a channel is silent, and the first one that is not.
std::string silence_words(OpenWave& wave, std::size_t channel) {
    const auto channels = static_cast<std::size_t>(wave.info.channels);
    const std::string silent =
        channels > 1 ? "channel " + std::to_string(channel + 1) + " is silent" : "it is silent";
    if (channels < 2 || sf_seek(wave.sound.get(), 0, SEEK_SET) != 0) return silent;
    std::vector<double> frame(channels);
    std::size_t heard = channels;
    while (sf_readf_double(wave.sound.get(), frame.data(), 1) == 1) {
        const auto loud = std::ranges::find_if(frame, [](double x) { return x != 0.0; });
        heard = std::min(heard, static_cast<std::size_t>(loud - frame.begin()));
    }
    if (heard == channels) return silent + ", and so are the others";
    return silent + ", channel " + std::to_string(heard + 1) + " is not";
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

void put_le32(std::string& bytes, std::size_t at, std::uint32_t value) {
    for (std::size_t k = 0; k < 4; ++k) bytes[at + k] = static_cast<char>(value >> (8 * k));
}

std::uint32_t le32(const std::string& bytes, std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t k = 0; k < 4; ++k) {
        value |= std::uint32_t{static_cast<std::uint8_t>(bytes[at + k])} << (8 * k);
    }
    return value;
}

// A format that is not PCM says how long its extension is, even where it has none; libsndfile
// leaves that out, and others warn of it.
void extend_format(std::string& bytes) {
    constexpr std::uint32_t kPlain = 16;
    const std::size_t at = bytes.find("fmt ");
    if (at == std::string::npos || at + 24 > bytes.size() || le32(bytes, at + 4) != kPlain) return;
    put_le32(bytes, at + 4, kPlain + 2);
    bytes.insert(at + 8 + kPlain, 2, '\0');
    put_le32(bytes, 4, le32(bytes, 4) + 2);
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

Expected<WaveChannels> read_wave_channels(const fs::path& path, std::size_t only,
                                          const ChannelFault& fault_of) {
    const auto refused = [&path](const std::string& why) {
        return Error{path.string() + ": " + why};
    };
    auto text = read_wave_text(path);
    if (!text) return text.error();
    const auto wave = opened(std::move(text->bytes), path.string());
    if (!wave) return wave.error();
    const SF_INFO& info = (*wave)->info;
    const auto count = static_cast<std::size_t>(info.channels);
    if (const auto fault = fault_of ? fault_of(count) : ""; !fault.empty()) return refused(fault);
    const auto told = with_sidecar({}, *text, path.string(), **wave);
    if (!told) return told.error();
    const Wanted wanted = only > 0 ? Wanted{only - 1, only} : Wanted{0, count};
    if (const auto fault = header_fault(**wave, wanted); !fault.empty()) return refused(fault);
    WaveChannels result{static_cast<double>(info.samplerate), read_channels(**wave, wanted),
                        told->options.scale_g, told->remark};
    for (const auto& channel : result.channels) {
        if (const auto fault = sample_fault(channel, info); !fault.empty()) return refused(fault);
    }
    return result;
}

Expected<Recording> read_wave_file(const fs::path& path, const RecordingOptions& asked) {
    auto text = read_wave_text(path);
    if (!text) return text.error();
    return parse_wave(*std::move(text), path.string(), asked);
}

Expected<Recording> parse_wave(WaveText text, const std::string& name,
                               const RecordingOptions& asked) {
    const auto wave = opened(std::move(text.bytes), name);
    if (!wave) return wave.error();
    const SF_INFO& info = (*wave)->info;
    const auto told = with_sidecar(asked, text, name, **wave);
    if (!told) return told.error();
    const RecordingOptions& options = told->options;
    const std::size_t channel = options.channel.value_or(0);
    const Wanted wanted{channel, channel + 1};
    if (const auto fault = header_fault(**wave, wanted); !fault.empty()) {
        return Error{name + ": " + fault};
    }
    Recording recording;
    recording.scale_g = options.scale_g.value_or(1.0);
    Waveform original{static_cast<double>(info.samplerate),
                      std::move(read_channels(**wave, wanted).front())};
    for (double& sample : original.samples_g) sample *= recording.scale_g;
    if (const auto fault = sample_fault(original.samples_g, info); !fault.empty()) {
        return Error{name + ": " + fault};
    }
    recording.waveform = resampled(original, kModelRateHz);
    if (recording.waveform.samples_g.empty()) {
        return Error{name + ": expected at least one sample at 10 kHz, got a shorter file"};
    }
    if (!told->remark.empty()) recording.remarks.push_back(told->remark);
    if (original.rate_hz != kModelRateHz) {
        recording.remarks.push_back("resampled from " + rate_text(original.rate_hz) + " to " +
                                    rate_text(kModelRateHz));
    }
    if (info.channels > 1 && !options.channel) {
        recording.remarks.push_back("first of " + std::to_string(info.channels) + " channels used");
    }
    if (!(peak_g(recording.waveform) > 0.0)) {
        recording.remarks.push_back(silence_words(**wave, channel));
    }
    if (!options.scale_g) recording.remarks.push_back("full scale taken as 1 g");
    return recording;
}

Expected<WaveText> wave_text(const Waveform& waveform, const WaveOptions& options,
                             const std::string& name) {
    const double peak = peak_g(waveform);
    if (!(peak <= kMaxSampleG)) {
        return Error{name + ": expected a peak of at most 1,000,000 g, got " +
                     shortest_digits(peak) + " g"};
    }
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
    if (options.encoding == WaveEncoding::float32) extend_format(memory.bytes);
    const Json sidecar = {{"scale_g", options.scale_g}, {"of", fingerprint_text(memory.bytes)}};
    return WaveText{std::move(memory.bytes), text_of_json(sidecar) + "\n"};
}

Expected<Done> write_wave_file(const fs::path& path, const Waveform& waveform,
                               const WaveOptions& options) {
    const auto text = wave_text(waveform, options, path.string());
    if (!text) return text.error();
    // Two files are not replaced at once. The sidecar says whose it is, so that a new one beside
    // the old samples, which a power cut may leave, is noticed.
    std::error_code none;
    if (options.scale_g != 1.0 || fs::exists(sidecar_of(path), none)) {
        auto written = write_atomically(sidecar_of(path), text->sidecar);
        if (!written) return written;
    }
    return write_atomically(path, text->bytes);
}

namespace {

constexpr std::uint64_t kOpenSize = 0xFFFFFFFF;     // of a stream, or: see the ds64 chunk
constexpr std::uint64_t kSoxOpenSize = 0x7FFFF000;  // as sox writes into a pipe

template <std::size_t kBytes>
std::uint64_t number(const std::array<char, kBytes>& bytes, std::size_t offset, std::size_t length,
                     bool big_endian) {
    std::uint64_t value = 0;
    for (std::size_t k = 0; k < length; ++k) {
        const std::size_t place = big_endian ? offset + k : offset + length - 1 - k;
        value = value << 8 | static_cast<unsigned char>(bytes[place]);
    }
    return value;
}

}  // namespace

std::string wave_size_fault(std::istream& stream, std::uint64_t file_bytes) {
    constexpr std::string_view kCut = "ends before its samples begin, expected a whole WAV file";
    std::array<char, 12> head{};
    stream.read(head.data(), head.size());
    const std::string_view form(head.data(), 4);
    if (!stream || (form != "RIFF" && form != "RIFX" && form != "RF64" && form != "BW64") ||
        std::string_view(head.data() + 8, 4) != "WAVE") {
        return "expected a WAV file (RIFF, RIFX, RF64 or BW64)";
    }
    const bool big_endian = form == "RIFX";
    const bool is_open = number(head, 4, 4, big_endian) == 0;  // a stream's writer never came back
    std::uint64_t data_bytes_64 = kOpenSize;
    for (std::uint64_t position = head.size();;) {
        std::array<char, 8> chunk{};
        stream.seekg(static_cast<std::streamoff>(position));
        if (!stream.read(chunk.data(), chunk.size())) return std::string(kCut);
        const std::string_view name(chunk.data(), 4);
        std::uint64_t bytes = number(chunk, 4, 4, big_endian);
        position += chunk.size();
        if (name == "ds64") {
            std::array<char, 16> sizes{};  // of the file and of the data
            if (!stream.read(sizes.data(), sizes.size())) return std::string(kCut);
            data_bytes_64 = number(sizes, 8, 8, false);
        }
        if (name == "data") {
            if ((form == "RF64" || form == "BW64") && bytes == kOpenSize) bytes = data_bytes_64;
            // libsndfile takes whatever follows for samples here.
            if (bytes == 0 && is_open && file_bytes > position) return {};
            if (bytes == 0) return "expected at least one sample, got none";
            if (bytes == kSoxOpenSize && file_bytes - position < bytes) return {};
            if (bytes == kOpenSize || bytes <= file_bytes - position) return {};
            return "is truncated: expected " + grouped_digits(bytes) +
                   " bytes of samples, as its header says, got " +
                   grouped_digits(file_bytes - position);
        }
        if (bytes > file_bytes - position) return std::string(kCut);
        position += bytes + bytes % 2;  // chunks start at even offsets
    }
}

}  // namespace tact
