// Nothing comes under node or in a browser: whoever ends the work ends it at once.
#include "model/system/signal_watch.h"

namespace tact {

struct SignalWatch::Works {};

SignalWatch::SignalWatch(Heard) {}

SignalWatch::~SignalWatch() = default;

}  // namespace tact
