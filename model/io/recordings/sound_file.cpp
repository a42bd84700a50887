#include "model/io/recordings/sound_file.h"

#include <sndfile.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <memory>
#include <string_view>
#include <utility>

#include "model/common/units.h"
#include "model/io/recordings/acceleration_file.h"
#include "model/io/recordings/wave_file.h"
#include "model/pattern/pattern.h"
#include "model/signal/resample.h"
#include "model/text/atomic_file.h"
#include "model/text/numbers.h"

namespace tact {

namespace fs = std::filesystem;

namespace {

using Channels = std::vector<std::vector<double>>;

struct SoundFileCloser {
    void operator()(SNDFILE* sound) const { sf_close(sound); }
};

// What a header says that is not read, or empty.
std::string sound_header_fault(const SF_INFO& info) {
    if (info.samplerate < kLowestRateHz || info.samplerate > kHighestRateHz) {
        return "expected a rate of 100 Hz to 10 MHz, got " + std::to_string(info.samplerate) +
               " Hz";
    }
    const double length_s = static_cast<double>(info.frames) / info.samplerate;
    if (length_s > limits::kDurationS.high) {
        return "expected at most 60 s of sound, got " + significant_digits(length_s, 4) +
               " s: cut out the part that is to be felt";
    }
    const auto frames = static_cast<std::size_t>(std::max<sf_count_t>(info.frames, 0));
    if (frames > kMaxDecodedSamples / static_cast<std::size_t>(std::max(info.channels, 1))) {
        return "expected at most " + grouped_digits(kMaxDecodedSamples) + " samples, got " +
               grouped_digits(frames) + " of " + std::to_string(info.channels) + " channels";
    }
    return {};
}

// As many frames as there are: of some formats the header only guesses.
Expected<WaveChannels> decoded(const fs::path& path) {
    constexpr std::size_t kBlockFrames = 4096;
    auto bytes = read_text_file(path, kMaxWaveBytes);
    if (!bytes) return bytes.error();
    MemorySound memory{*std::move(bytes)};
    SF_INFO info{};
    const std::unique_ptr<SNDFILE, SoundFileCloser> sound(open_for_reading(memory, info));
    if (!sound) return Error{path.string() + ": expected a sound file, as WAV, FLAC, Ogg or MP3"};
    if (const auto fault = sound_header_fault(info); !fault.empty()) {
        return Error{path.string() + ": " + fault};
    }
    const auto channels = static_cast<std::size_t>(info.channels);
    WaveChannels result{static_cast<double>(info.samplerate), Channels(channels), {}, {}};
    const auto most = static_cast<std::size_t>(limits::kDurationS.high * result.rate_hz) + 1;
    std::vector<double> block(kBlockFrames * channels);
    while (const sf_count_t frames = sf_readf_double(sound.get(), block.data(), kBlockFrames)) {
        for (std::size_t n = 0; n < static_cast<std::size_t>(frames) * channels; ++n) {
            result.channels[n % channels].push_back(block[n]);
        }
        const std::size_t count = result.channels[0].size();
        if (count > most || count > kMaxDecodedSamples / channels) {
            return Error{path.string() + ": expected at most 60 s of sound, got more"};
        }
    }
    return result;
}

double energy_of(const std::vector<double>& x) {
    double sum = 0.0;
    for (const double sample : x) sum += sample * sample;
    return sum;
}

// At both ends of the range: the rest position of clicks does not count.
std::size_t clipped_samples(const std::vector<double>& x) {
    if (x.empty()) return 0;
    const auto [least, most] = std::ranges::minmax(x);
    const double half = 0.5 * std::max(-least, most);
    return -least > half && most > half ? samples_at_rail(x) : 0;
}

std::vector<double> mixed(const Channels& channels, std::vector<std::string>& remarks) {
    if (channels.size() == 1) return channels[0];
    constexpr double kCancelled = 0.1;  // of the energy that is left, against one channel's
    std::vector<double> mix(channels[0].size(), 0.0);
    double energy = 0.0;
    for (const auto& channel : channels) {
        energy += energy_of(channel) / static_cast<double>(channels.size());
        for (std::size_t n = 0; n < mix.size(); ++n) {
            mix[n] += channel[n] / static_cast<double>(channels.size());
        }
    }
    remarks.push_back(std::to_string(channels.size()) + " channels are mixed");
    if (energy_of(mix) < kCancelled * energy) {
        remarks.emplace_back("its channels cancel each other: most of them is gone in the mix");
    }
    return mix;
}

void take_offset(std::vector<double>& x, std::vector<std::string>& remarks) {
    constexpr double kMuch = 0.01;  // of the peak
    double peak = 0.0;
    for (const double sample : x) peak = std::max(peak, std::abs(sample));
    double sum = 0.0;
    for (const double sample : x) sum += sample;
    const double mean = sum / static_cast<double>(x.size());
    if (std::abs(mean) > kMuch * peak) {
        remarks.push_back("a constant offset of " + significant_digits(mean, 3) + " is taken off");
    }
    for (double& sample : x) sample -= mean;
}

std::string samples_fault(const Channels& channels) {
    for (const auto& channel : channels) {
        for (std::size_t n = 0; n < channel.size(); ++n) {
            if (std::abs(channel[n]) <= kMaxSampleG) continue;  // false for NaN
            return "sample " + grouped_digits(n + 1) + " is " + shortest_digits(channel[n]) +
                   ", expected a finite number of at most 1,000,000";
        }
    }
    return {};
}

Expected<SoundFile> sound_of(const fs::path& path, const WaveChannels& read) {
    constexpr double kSilence = 1e-5;  // of full scale, -100 dB
    const auto refused = [&path](const std::string& why) {
        return Error{path.string() + ": " + why};
    };
    if (read.channels.empty() || read.channels[0].empty()) {
        return refused("expected at least one sample, got none");
    }
    if (const auto fault = samples_fault(read.channels); !fault.empty()) return refused(fault);
    SoundFile sound;
    sound.scale_g = read.scale_g;
    if (!read.remark.empty()) sound.remarks.push_back(read.remark);
    std::size_t clipped = 0;
    for (const auto& channel : read.channels) clipped += clipped_samples(channel);
    Waveform own{read.rate_hz, mixed(read.channels, sound.remarks)};
    take_offset(own.samples_g, sound.remarks);
    sound.duration_s = duration_s(own);
    if (sound.duration_s < limits::kDurationS.low)
        return refused("expected 1 ms of sound at least");
    if (!(peak_g(own) > kSilence)) {
        return refused(read.channels.size() > 1 ? "is silent, or its channels cancel each other"
                                                : "is silent");
    }
    if (clipped > 0) {
        sound.remarks.push_back("is clipped: " + counted(clipped, "sample", "samples") +
                                " at the largest or least value");
    }
    sound.waveform = resampled(own, kModelRateHz);
    return sound;
}

Expected<SoundFile> sound_of_recording(Expected<Recording> read) {
    if (!read) return read.error();
    SoundFile sound{std::move(read->waveform), 1.0, 0.0, std::move(read->remarks)};
    take_offset(sound.waveform.samples_g, sound.remarks);
    sound.duration_s = duration_s(sound.waveform);
    return sound;
}

// By what it begins with.
bool is_sound(std::string_view head, RecordingKind kind) {
    const auto begins = [head](std::string_view text) { return head.starts_with(text); };
    const bool is_mp3 = begins("ID3") || (head.size() > 1 && head[0] == '\xFF' &&
                                          (static_cast<unsigned char>(head[1]) & 0xE0U) == 0xE0U &&
                                          head[1] != '\xFE' && head[1] != '\xFF');
    return kind == RecordingKind::wave || begins("fLaC") || begins("OggS") || begins("FORM") ||
           begins(".snd") || begins("caff") || is_mp3;
}

}  // namespace

bool is_sound_file(const fs::path& path) {
    const std::string head = head_of_file(path);
    return is_sound(head, recording_kind(path, head));
}

Expected<SoundFile> read_sound_file(const fs::path& path) {
    const std::string head = head_of_file(path);
    const RecordingKind kind = recording_kind(path, head);
    if (kind == RecordingKind::wave) {
        const auto read = read_wave_channels(path);
        return read ? sound_of(path, *read) : Expected<SoundFile>(read.error());
    }
    if (!is_sound(head, kind) && extension_of(path) == ".csv") {
        return sound_of_recording(read_acceleration_file(path));
    }
    if (kind == RecordingKind::text) {
        auto sound = sound_of_recording(read_recording(path));
        if (sound && !(peak_g(sound->waveform) > 0.0)) return Error{path.string() + ": is silent"};
        return sound;
    }
    const auto read = decoded(path);
    return read ? sound_of(path, *read) : Expected<SoundFile>(read.error());
}

namespace {

MemorySound& of(void* user) { return *static_cast<MemorySound*>(user); }

sf_count_t length(void* user) { return static_cast<sf_count_t>(of(user).bytes.size()); }

sf_count_t tell(void* user) { return static_cast<sf_count_t>(of(user).position); }

sf_count_t seek(sf_count_t offset, int whence, void* user) {
    if (whence == SEEK_CUR) offset += tell(user);
    if (whence == SEEK_END) offset += length(user);
    of(user).position = static_cast<std::size_t>(std::max<sf_count_t>(offset, 0));
    return tell(user);
}

sf_count_t read(void* target, sf_count_t count, void* user) {
    MemorySound& memory = of(user);
    const std::size_t left = memory.bytes.size() - std::min(memory.position, memory.bytes.size());
    const std::size_t taken = std::min(left, static_cast<std::size_t>(count));
    std::memcpy(target, memory.bytes.data() + memory.position, taken);
    memory.position += taken;
    return static_cast<sf_count_t>(taken);
}

sf_count_t write(const void* source, sf_count_t count, void* user) {
    MemorySound& memory = of(user);
    const auto size = static_cast<std::size_t>(count);
    memory.bytes.resize(std::max(memory.bytes.size(), memory.position + size), '\0');
    std::memcpy(memory.bytes.data() + memory.position, source, size);
    memory.position += size;
    return count;
}

SNDFILE* opened_in(MemorySound& memory, int mode, SF_INFO& info) {
    static SF_VIRTUAL_IO calls{length, seek, read, write, tell};
    return sf_open_virtual(&calls, mode, &info, &memory);
}

}  // namespace

SNDFILE* open_for_reading(MemorySound& memory, SF_INFO& info) {
    return opened_in(memory, SFM_READ, info);
}

SNDFILE* open_for_writing(MemorySound& memory, SF_INFO& info) {
    return opened_in(memory, SFM_WRITE, info);
}

}  // namespace tact
