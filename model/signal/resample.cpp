#include "model/signal/resample.h"

#include <soxr.h>

#include <cassert>
#include <cmath>

namespace tact {

Waveform resampled(const Waveform& waveform, double rate_hz) {
    assert(rate_hz >= kLowestRateHz && rate_hz <= kHighestRateHz && "rate out of range");
    assert(waveform.rate_hz >= kLowestRateHz && waveform.rate_hz <= kHighestRateHz);
    if (waveform.rate_hz == rate_hz) return waveform;
    const double count = static_cast<double>(waveform.samples_g.size());
    const auto length = static_cast<std::size_t>(std::llround(count * rate_hz / waveform.rate_hz));
    Waveform result{rate_hz, std::vector<double>(length, 0.0)};
    if (length == 0) return result;
    const soxr_io_spec_t doubles = soxr_io_spec(SOXR_FLOAT64, SOXR_FLOAT64);
    const soxr_quality_spec_t quality = soxr_quality_spec(SOXR_VHQ, 0);
    const soxr_runtime_spec_t one_thread = soxr_runtime_spec(1);
    [[maybe_unused]] const soxr_error_t fault = soxr_oneshot(
        waveform.rate_hz, rate_hz, 1, waveform.samples_g.data(), waveform.samples_g.size(), nullptr,
        result.samples_g.data(), length, nullptr, &doubles, &quality, &one_thread);
    assert(fault == nullptr && "soxr refused rates within range");
    return result;
}

}  // namespace tact
