#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "model/io/recordings/acceleration_file.h"
#include "model/io/recordings/wave_file.h"
#include "model/io/set/load.h"
#include "model/io/set/spec_file.h"
#include "model/io/tables/checkpoint.h"
#include "tests/fuzz/readers.h"
#include "tests/support/zip_bytes.h"

namespace tact::fuzz {
namespace {

// A folder of this process, in memory where the system has such a place.
const std::filesystem::path& folder() {
    struct Folder {
        std::filesystem::path path;
        Folder() {
            std::error_code none;
            const std::filesystem::path memory = "/dev/shm";
            std::string name =
                ((std::filesystem::exists(memory, none) ? memory
                                                        : std::filesystem::temp_directory_path()) /
                 "tactspace_fuzz_XXXXXX")
                    .string();
            hold(::mkdtemp(name.data()) != nullptr, "there is room for a folder");
            path = name;
        }
        ~Folder() {
            std::error_code ignored;
            std::filesystem::remove_all(path, ignored);
        }
    };
    static const Folder made;
    return made.path;
}

std::filesystem::path written(std::string_view bytes, const char* name) {
    const auto path = folder() / name;
    std::ofstream(path, std::ios::binary).write(bytes.data(), std::ssize(bytes));
    return path;
}

bool wave(std::string_view bytes) {
    const auto path = written(bytes, "fuzz.wav");
    const bool channels = is_read(read_wave_channels(path));
    return is_read(read_wave_file(path)) || channels;
}

std::vector<std::string> wave_seeds() {
    std::vector<std::string> seeds;
    Waveform waveform;
    waveform.samples_g = {0.0, 0.5, -0.5, 0.25};
    for (const auto encoding : {WaveEncoding::float32, WaveEncoding::int16, WaveEncoding::int24}) {
        const auto path = folder() / "seed.wav";
        hold(write_wave_file(path, waveform, {encoding}), "a seed is written");
        std::ifstream file(path, std::ios::binary);
        seeds.emplace_back(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
        std::filesystem::remove(path);
    }
    return seeds;
}

bool recording(std::string_view bytes) {
    return is_read(read_acceleration_file(written(bytes, "fuzz.csv"), {}));
}
std::vector<std::string> recording_seeds() {
    std::string table = "time (s),x (g)\n";
    for (int k = 0; k < 40; ++k) {
        table += std::to_string(0.001 * k) + (k % 2 == 0 ? ",0.5\n" : ",-0.5\n");
    }
    return {table};
}

bool spec(std::string_view bytes) { return is_read(read_spec_file(written(bytes, "fuzz.json"))); }
std::vector<std::string> spec_seeds() {
    return {R"({"tactspace_design_space":1,"amplitude_g":[0.5,1],"rhythm":{"texts":["x-","xx"]}})"};
}

// What any command takes for its set, by content.
bool any_set(std::string_view bytes) { return is_read(load_set(written(bytes, "fuzz.json"))); }
std::vector<std::string> any_set_seeds() { return {R"({"tactspace":1,"patterns":[]})", "0\n1\n"}; }

bool zip(std::string_view bytes) { return is_read(load_set(written(bytes, "fuzz.zip"))); }
std::vector<std::string> zip_seeds() {
    const std::string timings = R"({"timings": [100, 50], "amplitudes": [255, 128]})";
    const std::vector<ZipMember> members{{"a/knock.json", timings}, {"plain.json", timings, false}};
    return {zip_of(members), zip_of(members, true)};
}

bool checkpoint(std::string_view bytes) {
    const auto path = written(bytes, "fuzz.tiles");
    const TileKey key{3, 2, 1, 1, 1};
    const auto opened = Checkpoint::open(path, key);
    if (!is_read(opened)) return false;
    for (const Part part : {Part::nc, Part::oc}) {
        static_cast<void>(opened->read(part, [](std::size_t, std::span<const double>) {}));
    }
    return true;
}

std::vector<std::string> checkpoint_seeds() {
    const auto path = folder() / "seed.tiles";
    {
        auto made = Checkpoint::open(path, {3, 2, 1, 1, 1});
        hold(made, "a seed is made");
        const std::vector<double> values(4, 1.5);
        static_cast<void>(made->append(Part::nc, 0, values));
    }
    std::ifstream file(path, std::ios::binary);
    std::string bytes{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    std::filesystem::remove(path);
    return {bytes};
}

}  // namespace

std::span<const Reader> file_readers() {
    static const std::vector<Reader> all{
        {"wave", wave, wave_seeds, {"RIFF", "WAVE", "fmt ", "data", "FORM", "AIFF"}},
        {"recording", recording, recording_seeds, {"time", "(g)", "(V)", ";"}},
        {"spec", spec, spec_seeds, {"\"rhythms\"", "\"amplitude_g\"", "\"from\"", "\"steps\""}},
        {"any_set", any_set, any_set_seeds, {"\"Pattern\"", "\"patterns\"", "RIFF"}},
        {"zip", zip, zip_seeds, {"PK\x01\x02", "PK\x03\x04", "PK\x05\x06", "PK\x06\x06", ".json"}},
        {"checkpoint", checkpoint, checkpoint_seeds, {}}};
    return all;
}

}  // namespace tact::fuzz
