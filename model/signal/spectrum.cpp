#include "model/signal/spectrum.h"

#include <fftw3.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <complex>
#include <functional>
#include <iterator>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

#include "model/common/portable.h"

// FFTW asks the C library for its sines when it makes a plan, and so has other ones, and other last
// bits, on a processor without FMA. A program's own definition comes before the library's: this is
// the sincos of the whole process.
// It throws as little as that one is declared to, which differs between libraries.
extern "C" void sincos(double angle_rad, double* sine,
                       double* cosine) noexcept(noexcept(sincos(0.0, nullptr, nullptr))) {
    const std::complex<double> point = tact::portable::polar(1.0, angle_rad);
    *sine = point.imag();
    *cosine = point.real();
}

namespace tact {

namespace {

// FFTW's planner is not thread-safe; executing a plan is.
std::mutex planner_mutex;

struct Plan {
    fftw_plan plan = nullptr;

    Plan() = default;
    Plan(const Plan&) = delete;
    Plan& operator=(const Plan&) = delete;
    ~Plan() {
        if (!plan) return;
        const std::scoped_lock lock(planner_mutex);
        fftw_destroy_plan(plan);
    }
};

// To plan takes as long as to execute, and the patterns of a set have one length, or few where they
// are coded quickly. A plan is executed on arrays other than its own, of the same alignment.
struct KeptPlan {
    std::size_t samples = 0;
    std::shared_ptr<const Plan> plan;
};
using KeptPlans = std::vector<KeptPlan>;  // the one used last first
KeptPlans kept_forward;
KeptPlans kept_backward;
constexpr std::size_t kKeptSamples = 1'000'000;  // of all but the first; about 16 MB

// What there is no room for.
KeptPlans taken_out(KeptPlans& kept) {
    std::size_t samples = 0;
    const auto first = std::find_if(kept.begin() + 1, kept.end(), [&](const KeptPlan& one) {
        return (samples += one.samples) > kKeptSamples;
    });
    KeptPlans former(std::make_move_iterator(first), std::make_move_iterator(kept.end()));
    kept.erase(first, kept.end());
    return former;
}

std::shared_ptr<const Plan> plan_of(KeptPlans& kept, std::size_t samples,
                                    const std::function<fftw_plan()>& make) {
    KeptPlans former;  // goes after the lock, which the end of a plan takes
    const std::scoped_lock lock(planner_mutex);
    auto found = std::ranges::find(kept, samples, &KeptPlan::samples);
    if (found == kept.end()) {
        const auto made = std::make_shared<Plan>();
        made->plan = make();
        found = kept.insert(kept.end(), {samples, made});
    }
    std::rotate(kept.begin(), found, found + 1);
    former = taken_out(kept);
    return kept.front().plan;
}

template <class Value>
struct FftwDeleter {
    void operator()(Value* memory) const { fftw_free(memory); }
};

// FFTW's own allocation: its alignment decides which code runs, and so the last bits. For the same
// reason plans are made without SIMD: which kernels FFTW takes would depend on the machine.
template <class Value>
std::unique_ptr<Value[], FftwDeleter<Value>> fftw_array(std::size_t count) {
    return std::unique_ptr<Value[], FftwDeleter<Value>>(
        static_cast<Value*>(fftw_malloc(count * sizeof(Value))));
}

}  // namespace

double frequency_hz(const Spectrum& spectrum, std::size_t k) {
    return static_cast<double>(k) * spectrum.rate_hz / static_cast<double>(spectrum.samples);
}

std::vector<std::complex<double>> half_spectrum(std::span<const double> samples) {
    const std::size_t n = samples.size();
    if (n == 0) return {};
    const std::size_t bins = n / 2 + 1;
    const auto input = fftw_array<double>(n);
    const auto output = fftw_array<std::complex<double>>(bins);
    const auto plan = plan_of(kept_forward, n, [&] {
        return fftw_plan_dft_r2c_1d(static_cast<int>(n), input.get(),
                                    reinterpret_cast<fftw_complex*>(output.get()),
                                    FFTW_ESTIMATE | FFTW_NO_SIMD);
    });
    std::copy(samples.begin(), samples.end(), input.get());
    fftw_execute_dft_r2c(plan->plan, input.get(), reinterpret_cast<fftw_complex*>(output.get()));
    return {output.get(), output.get() + bins};
}

std::vector<double> samples_of(std::span<const std::complex<double>> half, std::size_t samples) {
    assert(half.size() == (samples == 0 ? 0 : samples / 2 + 1) && "half of another length");
    if (samples == 0) return {};
    const auto input = fftw_array<std::complex<double>>(half.size());
    const auto output = fftw_array<double>(samples);
    const auto plan = plan_of(kept_backward, samples, [&] {
        return fftw_plan_dft_c2r_1d(static_cast<int>(samples),
                                    reinterpret_cast<fftw_complex*>(input.get()), output.get(),
                                    FFTW_ESTIMATE | FFTW_NO_SIMD);
    });
    std::copy(half.begin(), half.end(), input.get());
    fftw_execute_dft_c2r(plan->plan, reinterpret_cast<fftw_complex*>(input.get()), output.get());
    std::vector<double> result(output.get(), output.get() + samples);
    for (double& sample : result) sample /= static_cast<double>(samples);
    return result;
}

Spectrum amplitude_spectrum(std::span<const double> samples_g, double rate_hz) {
    const std::size_t n = samples_g.size();
    if (n == 0) return {};
    const std::vector<std::complex<double>> half = half_spectrum(samples_g);
    const std::size_t bins = half.size();
    Spectrum spectrum{rate_hz, n, std::vector<double>(bins)};
    for (std::size_t k = 0; k < bins; ++k) {
        const bool unpaired = k == 0 || 2 * k == n;
        spectrum.amplitude_g[k] =
            (unpaired ? 1.0 : 2.0) * portable::abs(half[k]) / static_cast<double>(n);
    }
    return spectrum;
}

std::vector<double> zero_phase_filtered(std::span<const double> samples, double rate_hz,
                                        const std::function<double(double frequency_hz)>& gain) {
    std::vector<double> padded(samples.begin(), samples.end());
    padded.resize(2 * samples.size(), 0.0);
    std::vector<std::complex<double>> half = half_spectrum(padded);
    for (std::size_t k = 0; k < half.size(); ++k) {
        half[k] *= gain(static_cast<double>(k) * rate_hz / static_cast<double>(padded.size()));
    }
    padded = samples_of(half, padded.size());
    padded.resize(samples.size());
    return padded;
}

}  // namespace tact
