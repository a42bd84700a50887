// Samples as they were written, read back at the model's rate.

#include "model/io/formats/samples/samples.h"

#include <cmath>

#include "model/io/recordings/acceleration_table.h"
#include "model/signal/resample.h"
#include "model/text/numbers.h"

namespace tact {

namespace {

Expected<Recording> table_back(const std::string& text, const std::string& name, double rate_hz) {
    auto table = parse_acceleration_table(text, name, true);
    if (!table) return table.error();
    if (table->axes.size() != 1) return Error{name + ": expected a single axis"};
    Recording recording;
    recording.waveform = resampled({rate_hz, std::move(table->axes.front())}, kModelRateHz);
    if (rate_hz != kModelRateHz) {
        const auto whole_hz = static_cast<std::size_t>(std::llround(rate_hz));
        recording.remarks.push_back("resampled from " + grouped_digits(whole_hz) +
                                    " Hz to 10,000 Hz");
    }
    return recording;
}

}  // namespace

Expected<Recording> wav_back(const WrittenEffect& written, const std::string& name,
                             const EffectTarget&) {
    return parse_wave({written.text, written.beside}, name);
}

Expected<Recording> csv_back(const WrittenEffect& written, const std::string& name,
                             const EffectTarget& target) {
    return table_back(written.text, name, target.sampled.rate_hz);
}

}  // namespace tact
