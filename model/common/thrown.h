// What work threw, as the sentence a person reads: programs end with words, windows go on.
#pragma once

#include "model/common/expected.h"

namespace tact {

// Of the exception being handled: to be called in a catch.
Error thrown_error();

}  // namespace tact
