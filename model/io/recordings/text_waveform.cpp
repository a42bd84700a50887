#include "model/io/recordings/text_waveform.h"

#include <cmath>
#include <sstream>

#include "model/pattern/pattern.h"
#include "model/signal/resample.h"
#include "model/signal/waveform.h"
#include "model/text/atomic_file.h"
#include "model/text/csv.h"
#include "model/text/numbers.h"
#include "model/text/utf8.h"

namespace tact {

Expected<Waveform> parse_text_waveform(std::string_view text, const std::string& file) {
    const std::size_t most = sample_count(limits::kDurationS.high, kModelRateHz);
    text = without_bom(text);
    Waveform waveform;
    std::size_t blank_line = 0;  // the first since the last sample; 0: none
    for (std::size_t line = 1; !text.empty(); ++line) {
        const std::size_t length = text.find('\n');
        std::string_view content = text.substr(0, length);
        text.remove_prefix(length == text.npos ? text.size() : length + 1);
        if (content.ends_with('\r')) content.remove_suffix(1);
        if (content.find_first_not_of(" \t") == content.npos) {
            if (blank_line == 0) blank_line = line;
            continue;
        }
        if (blank_line != 0) {
            return at_line(file, blank_line, "expected a number, got an empty line before others");
        }
        const auto sample = finite_number_in(content);
        if (!sample) {
            return at_line(file, line, "expected one finite number, got " + in_quotes(content));
        }
        if (std::abs(*sample) > kMaxSampleG) {
            return at_line(file, line, "expected at most 1,000,000 g, got " + in_quotes(content));
        }
        if (waveform.samples_g.size() == most) {
            return at_line(
                file, line,
                "expected at most " + grouped_digits(most) + " samples (60 s at 10 kHz)");
        }
        waveform.samples_g.push_back(*sample);
    }
    if (waveform.samples_g.empty()) {
        return at_line(file, 1, "expected at least one sample, got an empty file");
    }
    return waveform;
}

Expected<Waveform> read_text_waveform(const std::filesystem::path& path) {
    const auto text = read_text_file(path, kMaxTextWaveformBytes);
    if (!text) return text.error();
    return parse_text_waveform(*text, path.string());
}

std::string print_text_waveform(const Waveform& waveform) {
    std::string text;
    for (const double sample : resampled(waveform, kModelRateHz).samples_g) {
        append_digits(text, sample);
        text += '\n';
    }
    return text;
}

Expected<Done> write_text_waveform(const std::filesystem::path& path, const Waveform& waveform) {
    const double peak = peak_g(waveform);
    if (!(peak <= kMaxSampleG)) {
        return Error{path.string() + ": expected a peak of at most 1,000,000 g, got " +
                     shortest_digits(peak) + " g"};
    }
    return write_atomically(path, print_text_waveform(waveform));
}

std::string waveform_csv(const Waveform& waveform) {
    std::ostringstream text;
    text.precision(17);
    text << "time_s,acceleration_g\n";
    for (std::size_t n = 0; n < waveform.samples_g.size(); ++n) {
        text << static_cast<double>(n) / waveform.rate_hz << ',' << waveform.samples_g[n] << '\n';
    }
    return text.str();
}

}  // namespace tact
