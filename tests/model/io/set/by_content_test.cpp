// A file is known by what is in it: endings, encodings and the sizes in its head may say otherwise.
#include <doctest/doctest.h>

#include <cmath>
#include <cstdint>
#include <string>

#include "model/io/set/load.h"
#include "model/signal/waveform.h"
#include "tests/support/temporary_folder.h"

namespace by_content_test {

using namespace tact;

namespace {

constexpr const char* kAhap =
    R"({"Version": 1.0, "Pattern": [{"Event": {"Time": 0.0, "EventType": "HapticContinuous",
    "EventDuration": 0.5, "EventParameters": [{"ParameterID": "HapticIntensity",
    "ParameterValue": 0.8}]}}]})";
constexpr const char* kXml =
    R"(<?xml version="1.0"?><vibration-effect><waveform-effect>
    <waveform-entry durationMs="100" amplitude="200"/></waveform-effect></vibration-effect>)";

std::string little(std::uint64_t value, std::size_t bytes) {
    std::string text;
    for (std::size_t k = 0; k < bytes; ++k) text += static_cast<char>(value >> 8 * k & 0xFF);
    return text;
}

std::string samples() {
    std::string data;
    for (int n = 0; n < 2400; ++n) {
        const auto sample = static_cast<std::int16_t>(20'000 * std::sin(0.02 * n));
        data += little(static_cast<std::uint16_t>(sample), 2);
    }
    return data;
}

// 0.05 s at 48 kHz; `more` stands before the format.
std::string wave(const std::string& form, std::uint64_t whole, std::uint64_t data,
                 const std::string& more = {}) {
    return form + little(whole, 4) + "WAVE" + more + "fmt " + little(16, 4) + little(1, 2) +
           little(1, 2) + little(48'000, 4) + little(96'000, 4) + little(2, 2) + little(16, 2) +
           "data" + little(data, 4) + samples();
}

std::string as_utf16(const std::string& ascii) {
    std::string bytes = "\xFF\xFE";
    for (const char c : ascii) bytes += std::string{c, '\0'};
    return bytes;
}

std::string fault_of(const Expected<Loaded>& loaded) {
    return loaded ? "" : loaded.error().message;
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != text.npos; }

}  // namespace

TEST_CASE("by content: samples are the same however a writer left the sizes") {
    const TemporaryFolder folder;
    const std::uint64_t bytes = samples().size();
    const auto plain = load_set(folder.write("plain.wav", wave("RIFF", 36 + bytes, bytes)));
    REQUIRE_MESSAGE(plain, plain.error().message);
    const auto& expected = *std::get<Measurement>(plain->set.vibrations[0].source).waveform;
    CHECK(expected.samples_g.size() == 500);
    const std::string sizes = "ds64" + little(28, 4) + little(72 + bytes, 8) + little(bytes, 8) +
                              little(2400, 8) + little(0, 4);
    for (const std::string& other :
         {wave("RIFF", 0, 0), wave("RIFF", 0xFFFFFFFF, 0xFFFFFFFF),
          wave("RIFF", 0x7FFFF024, 0x7FFFF000), wave("RF64", 0xFFFFFFFF, 0xFFFFFFFF, sizes),
          wave("BW64", 0xFFFFFFFF, 0xFFFFFFFF, sizes)}) {
        CAPTURE(other.substr(0, 8));
        const auto read = load_set(folder.write("other.wav", other));
        REQUIRE_MESSAGE(read, read.error().message);
        CHECK(std::get<Measurement>(read->set.vibrations[0].source).waveform->samples_g ==
              expected.samples_g);
    }
    // A size that is no writer's sign of an open end is a torn file.
    CHECK(has(fault_of(load_set(folder.write("torn.wav", wave("RIFF", 0x7FFFF023, 0x7FFFEFFF)))),
              "is truncated"));
}

TEST_CASE("by content: an ending that is wrong changes nothing but is told of sounds") {
    const TemporaryFolder folder;
    const std::uint64_t bytes = samples().size();
    const auto sound = load_set(folder.write("sound.ahap", wave("RIFF", 36 + bytes, bytes)));
    REQUIRE_MESSAGE(sound, sound.error().message);
    std::string told;
    for (const std::string& one : sound->remarks) told += one + "\n";
    CHECK(has(told, "is a WAV file by its content"));
    for (const char* name : {"a.ahap", "a.haptic", "a.json", "a.txt", "a.wav", "a", "a.dat"}) {
        CAPTURE(name);
        const auto effect = load_set(folder.write(name, kAhap));
        REQUIRE_MESSAGE(effect, effect.error().message);
        CHECK(effect->set.vibrations[0].effect.format == "ahap");
        CHECK(has(fault_of(load_set(folder.write(name, "1\n2\nx\n"))), "expected"));
    }
    const auto set = load_set(
        folder.write("set.txt", R"({"tactspace": 1, "name": "one", "patterns": [{"name": "p"}]})"));
    REQUIRE_MESSAGE(set, set.error().message);
    CHECK(set->set.name == "one");
}

TEST_CASE("by content: UTF-16, a mark at the head and blank lines are read") {
    const TemporaryFolder folder;
    for (const std::string& text : {std::string(kAhap), std::string(kXml)}) {
        const auto plain = load_set(folder.write("effect.json", text));
        REQUIRE_MESSAGE(plain, plain.error().message);
        for (const std::string& other :
             {as_utf16(text), "\xEF\xBB\xBF" + text, "\n \t\r\n\n" + text}) {
            const auto read = load_set(folder.write("effect.json", other));
            REQUIRE_MESSAGE(read, read.error().message);
            CHECK(read->set.vibrations[0].source == plain->set.vibrations[0].source);
        }
    }
    const std::string set = R"({"tactspace": 1, "name": "one", "patterns": [{"name": "p"}]})";
    const auto read = load_set(folder.write("set.tactspace.json", as_utf16(set)));
    REQUIRE_MESSAGE(read, read.error().message);
    CHECK(read->set.name == "one");
}

TEST_CASE("by content: strangers are told by what they are, alone and in a folder") {
    const TemporaryFolder folder;
    const auto fragment =
        folder.write("in/part.ahap", R"({"Event": {"Time": 0, "EventType": "HapticTransient"}})");
    const auto old = folder.write("in/old.vij", R"({"version": 1})");
    const auto stiff = folder.write("in/stiff.haps",
                                    R"({"m_version": "5", "m_vibration": {}, "m_stiffness": {}})");
    folder.write("in/good.ahap", kAhap);
    CHECK(has(fault_of(load_set(fragment)), "is a fragment of AHAP"));
    CHECK(has(fault_of(load_set(old)), "older Lofelt"));
    CHECK(has(fault_of(load_set(stiff)), "stiffness or texture alone"));
    const auto all = load_set(folder.path / "in");
    REQUIRE_MESSAGE(all, all.error().message);
    CHECK(all->set.vibrations.size() == 1);
    REQUIRE(all->left_out.size() == 3);
    std::string told;
    for (const std::string& one : all->left_out) told += one + "\n";
    for (const char* what : {"fragment of AHAP", "older Lofelt", "stiffness or texture alone"}) {
        CAPTURE(what);
        CHECK(has(told, what));
    }
}

}  // namespace by_content_test
