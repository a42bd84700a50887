#include "devices/device_list.h"

#include <doctest/doctest.h>

#include "devices/audio/audio_names.h"

namespace device_list_test {

using namespace tact;

namespace {

DeviceInfo card(const std::string& name, int channels) {
    DeviceInfo info;
    info.id = audio_id("ALSA", name, 1);
    info.name = card_name(name);
    info.interface = "ALSA";
    info.channels = channel_names("ALSA", name, channels);
    return info;
}

std::vector<DeviceInfo> some_cards() {
    return {card("UMC204HD: USB Audio (hw:2,0)", 4),
            card("DualSense Wireless Controller: USB Audio (hw:3,0)", 4),
            card("HDA Intel PCH: ALC295 Analog (hw:0,0)", 2)};
}

}  // namespace

TEST_CASE("audio names: a card keeps its identity when it comes to another place") {
    CHECK(audio_id("ALSA", "UMC204HD: USB Audio (hw:2,0)", 1) ==
          audio_id("ALSA", "UMC204HD: USB Audio (hw:5,0)", 1));
    CHECK(audio_id("ALSA", "UMC204HD: USB Audio (hw:2,0)", 1) !=
          audio_id("ALSA", "UMC204HD: USB Audio (hw:5,0)", 2));
    CHECK(card_name("speakers (left)") == "speakers (left)");
}

TEST_CASE("audio names: servers are called what people call them") {
    CHECK(spoken_name("ALSA", "pulse") == "PulseAudio");
    CHECK(spoken_name("JACK", "system") == "JACK system");
    CHECK(spoken_name("ALSA", "UMC204HD: USB Audio (hw:2,0)") == "UMC204HD: USB Audio");
}

TEST_CASE("audio names: converters and other names of a card are not listed") {
    CHECK(is_alias("ALSA", "surround51"));
    CHECK(is_alias("ALSA", "dmix"));
    CHECK_FALSE(is_alias("ALSA", "pulse"));
    CHECK_FALSE(is_alias("ALSA", "UMC204HD: USB Audio (hw:2,0)"));
    CHECK_FALSE(is_alias("JACK", "front"));
}

TEST_CASE("audio names: the actuators of a DualSense are channels 3 and 4") {
    const DeviceInfo controller = some_cards()[1];
    CHECK(*find_channel(controller, "left actuator") == 3);
    CHECK(*find_channel(controller, "Right Actuator") == 4);
    CHECK(*find_channel(controller, "3") == 3);
}

TEST_CASE("devices: one is found by its id, its name, or what only its name has") {
    const auto cards = some_cards();
    CHECK(find_device(cards, "audio/ALSA/UMC204HD: USB Audio")->name == "UMC204HD: USB Audio");
    CHECK(find_device(cards, "dualsense")->channels[2] == "left actuator");
    CHECK(find_device(cards, "hda intel")->channels.size() == 2);
}

TEST_CASE("devices: where a name says too little, or nothing is there, an error says what is") {
    const auto cards = some_cards();
    const auto several = find_device(cards, "USB");
    REQUIRE_FALSE(several);
    CHECK(several.error().message.find("several devices are called \"USB\"") == 0);
    CHECK(several.error().message.find("audio/ALSA/UMC204HD: USB Audio") != std::string::npos);
    CHECK(find_device(cards, "Haptuator").error().message.find("no device is called") == 0);
    CHECK(find_device({}, "USB").error().message.find("Plug in") != std::string::npos);
}

TEST_CASE("devices: a channel that there is not is refused with those there are") {
    const DeviceInfo stereo = some_cards()[2];
    for (const char* wanted : {"0", "3", "-1", "2x", "", "left actuator"}) {
        const auto channel = find_channel(stereo, wanted);
        REQUIRE_FALSE(channel);
        CHECK(channel.error().message.find("expected 1 to 2, or one of \"left\", \"right\"") !=
              std::string::npos);
    }
}

}  // namespace device_list_test
