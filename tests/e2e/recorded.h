// What the ear of the stories has recorded: raw interleaved floats.
#pragma once

#include <algorithm>
#include <fstream>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

inline constexpr double kRateHz = 48'000.0;
inline constexpr double kHeard = 1e-4;  // 80 dB below full scale

inline int failed(const std::string& why) {
    std::cout << "failed: " << why << "\n";
    return 1;
}

inline std::vector<float> samples_in(const std::string& file) {
    std::ifstream stream(file, std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(stream), {}};
    std::vector<float> samples(bytes.size() / sizeof(float));
    std::copy_n(bytes.data(), samples.size() * sizeof(float),
                reinterpret_cast<char*>(samples.data()));
    return samples;
}

inline std::vector<double> channel_of(const std::vector<float>& samples, std::size_t channels,
                                      std::size_t channel) {
    std::vector<double> one;
    for (std::size_t n = channel; n < samples.size(); n += channels) {
        one.push_back(static_cast<double>(samples[n]));
    }
    return one;
}
