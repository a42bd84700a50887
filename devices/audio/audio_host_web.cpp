// In a browser no output is listed, and nothing is opened.
#include "devices/audio/audio_host.h"

namespace tact {

AudioHost::AudioHost() = default;

AudioHost::~AudioHost() = default;

std::vector<DeviceInfo> AudioHost::outputs() { return {}; }

SoundServer::~SoundServer() = default;

}  // namespace tact
