#include "model/io/recordings/wave_file.h"

#include <doctest/doctest.h>

#include <sstream>

#include "tests/support/temporary_folder.h"
#include "tests/support/wave_bytes.h"

namespace wave_size_test {

namespace {

std::string fault(const std::string& bytes) {
    std::istringstream stream(bytes);
    return tact::wave_size_fault(stream, bytes.size());
}

WaveBytes ten_samples() {
    WaveBytes wave;
    wave.samples.assign(10, 0.25);
    return wave;
}

// RF64: sizes of 64 bits in a chunk of their own.
std::string rf64(std::uint64_t data_bytes) {
    const WaveBytes wave = ten_samples();
    std::string sizes;
    put_number(sizes, 0, 8);
    put_number(sizes, data_bytes, 8);
    put_number(sizes, 10, 8);
    put_number(sizes, 0, 4);
    std::string bytes = "RF64\xFF\xFF\xFF\xFFWAVE" + WaveBytes::chunk("ds64", sizes) +
                        WaveBytes::chunk("fmt ", wave.format()) + "data\xFF\xFF\xFF\xFF";
    return bytes + wave.data();
}

}  // namespace

TEST_CASE("wave size: a whole file is whole, with chunks of odd length before its samples") {
    CHECK(fault(ten_samples().file()).empty());
    CHECK(fault(rf64(20)).empty());
    CHECK(fault(ten_samples().file() + "whatever follows").empty());
}

TEST_CASE("wave size: missing samples are counted") {
    const std::string whole = ten_samples().file();
    CHECK(fault(whole.substr(0, whole.size() - 1)) ==
          "is truncated: expected 20 bytes of samples, as its header says, got 19");
    CHECK(fault(rf64(5'000'000'000)) ==
          "is truncated: expected 5,000,000,000 bytes of samples, as its header says, got 20");
    CHECK(contains(fault(whole.substr(0, 30)), "ends before its samples begin"));
}

TEST_CASE("wave size: a length that the writer of a stream left open is accepted") {
    std::string bytes = ten_samples().file();
    const std::size_t size_at = bytes.find("data") + 4;
    bytes.replace(size_at, 4, "\xFF\xFF\xFF\xFF");
    CHECK(fault(bytes).empty());
    bytes.replace(size_at, 4, std::string(4, '\0'));
    CHECK(fault(bytes) == "expected at least one sample, got none");
    // So has one that left open how long the whole is; but then there have to be samples.
    bytes.replace(4, 4, std::string(4, '\0'));
    CHECK(fault(bytes).empty());
    const auto read = tact::parse_wave({bytes, ""}, "open.wav");
    REQUIRE(read);
    CHECK(read->waveform.samples_g == std::vector<double>(10, 0.25));
    CHECK(fault(bytes.substr(0, size_at + 4)) == "expected at least one sample, got none");
}

TEST_CASE("wave size: other files are none") {
    CHECK(contains(fault(""), "expected a WAV file"));
    CHECK(contains(fault("RIFF\x04\0\0\0AVI "), "expected a WAV file"));
    CHECK(contains(fault("OggS............"), "expected a WAV file"));
}

}  // namespace wave_size_test
