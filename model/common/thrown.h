// What work threw, as the sentence a person reads: programs end with words, windows continue.
#pragma once

#include "model/common/expected.h"

namespace tact {

// The exception being handled: call it in a catch.
Error thrown_error();

}  // namespace tact
